// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc/model.h"
#include "ifc/text.h"
#include "ifc/wall_geometry.h"

#include <algorithm>
#include <cmath>

namespace s2b::ifc
{
namespace
{

constexpr double kMargin_m = 0.05;  // by which a void is deeper than its wall on each side
constexpr double kLining_m = 0.05;  // width of a frame's face; generic, like the next three
constexpr double kLeafThickness_m = 0.04;
constexpr double kWindowDepth_m = 0.08;
constexpr double kGlassThickness_m = 0.02;

/// Frames narrow down in small openings, so that a leaf or pane remains.
double liningOf(const Opening& opening)
{
    return std::min({kLining_m, 0.15 * opening.width.value_m, 0.15 * opening.height.value_m});
}

std::vector<Eigen::Vector2d> rectangle(double x0, double z0, double x1, double z1)
{
    return {{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}};
}

/// IFC's doors open towards +y of their placement, and left and right are seen in that direction.
struct Swing
{
    bool isTurned = false;  ///< the door's placement looks to the wall's right
    std::string_view operation = "NOTDEFINED";
};

Swing swingOf(const Opening& opening)
{
    Swing swing;
    if (opening.leafState != LeafState::Open)
        return swing;
    swing.isTurned = !opening.opensToLeft;
    if (opening.leaves == 1)
        swing.operation = opening.hingeAtStart != swing.isTurned ? "SINGLE_SWING_LEFT" : "SINGLE_SWING_RIGHT";
    else if (opening.leaves == 2)
        swing.operation = "DOUBLE_DOOR_SINGLE_SWING";
    return swing;
}

std::vector<Property> commonOf(const Wall& host, const std::string& typeName)
{
    std::vector<Property> common = {{"Reference", {"IfcIdentifier", typeName}}, kExisting};
    if (host.isExternalKnown)
        common.push_back({"IsExternal", {"IfcBoolean", host.isExternal}});
    return common;
}

std::vector<Quantity> frameQuantities(const Opening& opening)
{
    const double width = opening.width.value_m;
    const double height = opening.height.value_m;
    return {{"Width", QuantityKind::Length, width},
            {"Height", QuantityKind::Length, height},
            {"Perimeter", QuantityKind::Length, 2.0 * (width + height)},
            {"Area", QuantityKind::Area, width * height}};
}

const char* leafStateName(LeafState state)
{
    switch (state)
    {
        case LeafState::Closed:
            return "Closed";
        case LeafState::Open:
            return "Open";
        case LeafState::Removed:
            return "Removed";
        case LeafState::Unknown:
            break;
    }
    return "Unknown";
}

}  // namespace

Model::Placed Model::addVoid(const Opening& opening, const Wall& host)
{
    const WallGeometry geometry(host);
    const std::string openingKey = key("opening", opening.id);
    const double width = opening.width.value_m;
    const double thickness = geometry.thickness_m();
    const double middle = opening.offset_m + 0.5 * width;
    const Eigen::Vector2d x = geometry.tangent(middle);
    const Eigen::Vector2d corner =
        geometry.at(middle, 0.0) - x * (0.5 * width) - Eigen::Vector2d(-x.y(), x.x()) * (0.5 * thickness);

    // An arc bends away from the void's straight box.
    double margin = kMargin_m;
    if (geometry.isArc())
    {
        const double radius = geometry.radius_m() - 0.5 * thickness;
        margin += radius - std::sqrt(std::max(0.0, radius * radius - 0.25 * width * width));
    }
    Placed hole;
    hole.placement =
        m_shapes.placement(m_walls.at(host.id).placement, {corner.x(), corner.y(), opening.sill.value_m}, x);
    Shapes::Representation representation;
    representation.body = {
        m_shapes.box({0.0, -margin, 0.0}, {width, thickness + 2.0 * margin, opening.height.value_m})};
    hole.instance = m_builder.add("IfcOpeningElement", {{"GlobalId", guid(openingKey + "/void")},
                                                        {"Name", nameOf("Opening", opening.id)},
                                                        {"ObjectPlacement", hole.placement},
                                                        {"Representation", m_shapes.shape(representation)},
                                                        {"Tag", std::to_string(opening.id.value)},
                                                        {"PredefinedType", Enumeration{"OPENING"}}});
    m_builder.add("IfcRelVoidsElement", {{"GlobalId", guid(openingKey + "/voids")},
                                         {"RelatingBuildingElement", m_walls.at(host.id).instance},
                                         {"RelatedOpeningElement", hole.instance}});
    const double area = width * opening.height.value_m;
    m_properties.addQuantities(hole.instance, openingKey + "/void", "Qto_OpeningElementBaseQuantities",
                               {{"Width", QuantityKind::Length, width},
                                {"Height", QuantityKind::Length, opening.height.value_m},
                                {"Depth", QuantityKind::Length, thickness},
                                {"Area", QuantityKind::Area, area},
                                {"Volume", QuantityKind::Volume, area * thickness}});
    return hole;
}

void Model::addDoor(const Opening& opening, const Wall& host, const Placed& hole)
{
    const std::string openingKey = key("opening", opening.id);
    const double width = opening.width.value_m;
    const double height = opening.height.value_m;
    const double thickness = host.thickness.value_m;
    const double lining = liningOf(opening);
    const Swing swing = swingOf(opening);

    const std::vector<Eigen::Vector2d> frame = {{0.0, 0.0},
                                                {lining, 0.0},
                                                {lining, height - lining},
                                                {width - lining, height - lining},
                                                {width - lining, 0.0},
                                                {width, 0.0},
                                                {width, height},
                                                {0.0, height}};
    Shapes::Representation representation;
    representation.body.push_back(m_shapes.paint(m_shapes.plate(frame, {}, 0.0, thickness), Style::Frame));
    if (opening.leafState != LeafState::Removed)
    {
        // Flush with the face that it opens to; in the middle where that is not known.
        const double depth = std::min(kLeafThickness_m, thickness);
        const double front = opening.leafState == LeafState::Open ? thickness - depth : 0.5 * (thickness - depth);
        const int leaves = std::max(1, opening.leaves);
        const double leafWidth = (width - 2.0 * lining) / leaves;
        for (int i = 0; i < leaves; ++i)
            representation.body.push_back(m_shapes.paint(
                m_shapes.box({lining + i * leafWidth, front, 0.0}, {leafWidth, depth, height - lining}), Style::Leaf));
    }

    const Instance placement =
        swing.isTurned ? m_shapes.placement(hole.placement, {width, thickness, 0.0}, -Eigen::Vector2d::UnitX())
                       : m_shapes.placement(hole.placement, Eigen::Vector3d::Zero());
    const Instance door = m_builder.add("IfcDoor", {{"GlobalId", guid(openingKey)},
                                                    {"Name", nameOf("Door", opening.id)},
                                                    {"ObjectPlacement", placement},
                                                    {"Representation", m_shapes.shape(representation)},
                                                    {"Tag", std::to_string(opening.id.value)},
                                                    {"OverallHeight", height},
                                                    {"OverallWidth", width},
                                                    {"PredefinedType", Enumeration{"DOOR"}},
                                                    {"OperationType", Enumeration{swing.operation}}});
    m_builder.add("IfcRelFillsElement", {{"GlobalId", guid(openingKey + "/fills")},
                                         {"RelatingOpeningElement", hole.instance},
                                         {"RelatedBuildingElement", door}});
    contain(host.storey, door);
    m_material.push_back(door);
    const std::string size = "Door " + millimetres(width, height);
    const std::string typeName = swing.operation == "NOTDEFINED" ? size : size + ' ' + std::string(swing.operation);
    assignType(typeName, "IfcDoorType",
               {{"PredefinedType", Enumeration{"DOOR"}}, {"OperationType", Enumeration{swing.operation}}}, door);
    m_properties.addShared(door, "Pset_DoorCommon", commonOf(host, typeName));
    m_properties.addQuantities(door, openingKey, "Qto_DoorBaseQuantities", frameQuantities(opening));
    addEvidence(door, openingKey, opening.id, &opening.evidence,
                {{"Width", opening.width}, {"Height", opening.height}, {"Sill", opening.sill}},
                {{"LeafState", {"IfcLabel", std::string(leafStateName(opening.leafState))}}});
}

void Model::addWindow(const Opening& opening, const Wall& host, const Placed& hole)
{
    const std::string openingKey = key("opening", opening.id);
    const double width = opening.width.value_m;
    const double height = opening.height.value_m;
    const double thickness = host.thickness.value_m;
    const double lining = liningOf(opening);
    const double depth = std::min(kWindowDepth_m, thickness);
    const double glass = std::min(kGlassThickness_m, 0.5 * depth);

    Shapes::Representation representation;
    representation.body.push_back(m_shapes.paint(
        m_shapes.plate(rectangle(0.0, 0.0, width, height), {rectangle(lining, lining, width - lining, height - lining)},
                       0.5 * (thickness - depth), depth),
        Style::Frame));
    representation.body.push_back(m_shapes.paint(
        m_shapes.box({lining, 0.5 * (thickness - glass), lining}, {width - 2.0 * lining, glass, height - 2.0 * lining}),
        Style::Glass));
    const Instance window =
        m_builder.add("IfcWindow", {{"GlobalId", guid(openingKey)},
                                    {"Name", nameOf("Window", opening.id)},
                                    {"ObjectPlacement", m_shapes.placement(hole.placement, Eigen::Vector3d::Zero())},
                                    {"Representation", m_shapes.shape(representation)},
                                    {"Tag", std::to_string(opening.id.value)},
                                    {"OverallHeight", height},
                                    {"OverallWidth", width},
                                    {"PredefinedType", Enumeration{"WINDOW"}},
                                    {"PartitioningType", Enumeration{"NOTDEFINED"}}});
    m_builder.add("IfcRelFillsElement", {{"GlobalId", guid(openingKey + "/fills")},
                                         {"RelatingOpeningElement", hole.instance},
                                         {"RelatedBuildingElement", window}});
    contain(host.storey, window);
    m_material.push_back(window);
    const std::string typeName = "Window " + millimetres(width, height);
    assignType(typeName, "IfcWindowType",
               {{"PredefinedType", Enumeration{"WINDOW"}}, {"PartitioningType", Enumeration{"NOTDEFINED"}}}, window);
    m_properties.addShared(window, "Pset_WindowCommon", commonOf(host, typeName));
    m_properties.addQuantities(window, openingKey, "Qto_WindowBaseQuantities", frameQuantities(opening));
    addEvidence(window, openingKey, opening.id, &opening.evidence,
                {{"Width", opening.width}, {"Height", opening.height}, {"Sill", opening.sill}});
}

void Model::addOpening(const Opening& opening)
{
    const Wall& host = *m_wallById.at(opening.host);
    const Placed hole = addVoid(opening, host);
    switch (opening.kind)
    {
        case OpeningKind::Door:
            return addDoor(opening, host, hole);
        case OpeningKind::Window:
            return addWindow(opening, host, hole);
        case OpeningKind::Plain:
            return addEvidence(hole.instance, key("opening", opening.id), opening.id, &opening.evidence,
                               {{"Width", opening.width}, {"Height", opening.height}, {"Sill", opening.sill}});
    }
}

void Model::addOpenings()
{
    for (const Opening& opening : m_building.openings)
        addOpening(opening);
}

}  // namespace s2b::ifc

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc/model.h"
#include "ifc/text.h"

#include <algorithm>
#include <cmath>

namespace s2b::ifc
{
namespace
{

struct RingSize
{
    double area_m2 = 0.0;
    double perimeter_m = 0.0;
};

RingSize sizeOf(const std::vector<Eigen::Vector2d>& ring)
{
    RingSize size;
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const Eigen::Vector2d a = ring[i] - ring[0];
        const Eigen::Vector2d b = ring[(i + 1) % ring.size()] - ring[0];
        twice += a.x() * b.y() - a.y() * b.x();
        size.perimeter_m += (b - a).norm();
    }
    size.area_m2 = 0.5 * std::abs(twice);
    return size;
}

RingSize sizeOf(const std::vector<std::vector<Eigen::Vector2d>>& rings)
{
    RingSize size;
    for (const auto& ring : rings)
    {
        const RingSize one = sizeOf(ring);
        size.area_m2 += one.area_m2;
        size.perimeter_m += one.perimeter_m;
    }
    return size;
}

/// The outline's lower-left corner, where its placement is.
Eigen::Vector2d cornerOf(const Polygon& polygon)
{
    Eigen::Vector2d corner = polygon.outer.front();
    for (const Eigen::Vector2d& p : polygon.outer)
        corner = corner.cwiseMin(p);
    return corner;
}

Polygon shifted(Polygon polygon, const Eigen::Vector2d& origin)
{
    for (Eigen::Vector2d& p : polygon.outer)
        p -= origin;
    for (auto& hole : polygon.holes)
        for (Eigen::Vector2d& p : hole)
            p -= origin;
    return polygon;
}

/// "400 x 300 mm", "D 400 mm", "I 260 x 254 mm, web 15 mm, flange 27 mm".
std::string sectionName(const Section& section)
{
    const Eigen::Vector2d box = boxOf(section);
    if (std::holds_alternative<CircleSection>(section))
        return "D " + millimetres(box.x());
    const auto* profile = std::get_if<ProfileSection>(&section);
    if (profile == nullptr)
        return millimetres(box.x(), box.y());
    const std::string name = std::string(shapeName(profile->shape)) + ' ' + millimetres(box.x(), box.y());
    return profile->shape == ProfileShape::L
               ? name + ", legs " + millimetres(profile->web_m)
               : name + ", web " + millimetres(profile->web_m) + ", flange " + millimetres(profile->flange_m);
}

}  // namespace

void Model::addColumns()
{
    for (const Column& column : m_building.columns)
    {
        const std::string columnKey = key("column", column.id);
        const double height = column.height.value_m;
        const Eigen::Vector2d x(std::cos(column.yaw_rad), std::sin(column.yaw_rad));
        // A circle has no direction of its own, and its placement is its centre (D3.6, 5).
        const bool isRound = std::holds_alternative<CircleSection>(column.section);
        Eigen::Vector2d origin = column.center;
        if (!isRound)
            origin -= Eigen::Rotation2Dd(column.yaw_rad) * (0.5 * boxOf(column.section));
        const Instance placement = storeyPlacement(column.storey, {origin.x(), origin.y(), column.base_m},
                                                   isRound ? Eigen::Vector2d(Eigen::Vector2d::UnitX()) : x);
        Shapes::Representation representation;
        representation.body = {m_shapes.column(column.section, height)};
        const double area = areaOf(column.section);
        const double perimeter = perimeterOf(column.section);
        const std::string typeName = "Column " + sectionName(column.section);
        m_shapes.paint(representation.body.front(), Style::Column);
        const Instance instance = m_builder.add("IfcColumn", {{"GlobalId", guid(columnKey)},
                                                              {"Name", nameOf("Column", column.id)},
                                                              {"ObjectPlacement", placement},
                                                              {"Representation", m_shapes.shape(representation)},
                                                              {"Tag", std::to_string(column.id.value)},
                                                              {"PredefinedType", Enumeration{"COLUMN"}}});
        contain(column.storey, instance);
        m_material.push_back(instance);
        assignType(typeName, "IfcColumnType", {{"PredefinedType", Enumeration{"COLUMN"}}}, instance);
        m_properties.addShared(instance, "Pset_ColumnCommon", {{"Reference", {"IfcIdentifier", typeName}}, kExisting});
        const double surface = perimeter * height + 2.0 * area;
        m_properties.addQuantities(instance, columnKey, "Qto_ColumnBaseQuantities",
                                   {{"Length", QuantityKind::Length, height},
                                    {"CrossSectionArea", QuantityKind::Area, area},
                                    {"OuterSurfaceArea", QuantityKind::Area, perimeter * height},
                                    {"GrossSurfaceArea", QuantityKind::Area, surface},
                                    {"NetSurfaceArea", QuantityKind::Area, surface},
                                    {"GrossVolume", QuantityKind::Volume, area * height},
                                    {"NetVolume", QuantityKind::Volume, area * height}});
        addEvidence(instance, columnKey, column.id, &column.evidence, {{"Height", column.height}},
                    {{"SectionProvenance", {"IfcLabel", std::string(provenanceName(column.sectionProvenance))}}});
    }
}

void Model::addSlabs()
{
    for (const Slab& slab : m_building.slabs)
    {
        const std::string slabKey = key("slab", slab.id);
        const double thickness = slab.thickness.value_m;
        const Eigen::Vector2d origin = cornerOf(slab.outline);
        const Polygon outline = shifted(slab.outline, origin);
        Shapes::Representation representation;
        representation.body = {m_shapes.paint(m_shapes.prism(outline, 0.0, thickness), Style::Slab)};
        representation.footPrint = m_shapes.outlines(outline);
        const Enumeration kind = {slab.kind == SlabKind::Floor ? "FLOOR" : "ROOF"};
        const Instance instance = m_builder.add(
            "IfcSlab",
            {{"GlobalId", guid(slabKey)},
             {"Name", nameOf("Slab", slab.id)},
             {"ObjectPlacement",
              storeyPlacement(slab.storey, {origin.x(), origin.y(), slab.top_m - thickness}, Eigen::Vector2d::UnitX())},
             {"Representation", m_shapes.shape(representation)},
             {"Tag", std::to_string(slab.id.value)},
             {"PredefinedType", kind}});
        contain(slab.storey, instance);
        m_material.push_back(instance);
        const std::string typeName = (slab.kind == SlabKind::Floor ? "Floor " : "Roof ") + millimetres(thickness);
        assignType(typeName, "IfcSlabType", {{"PredefinedType", kind}}, instance);
        m_properties.addShared(instance, "Pset_SlabCommon", {{"Reference", {"IfcIdentifier", typeName}}, kExisting});
        const RingSize gross = sizeOf(slab.outline.outer);
        const double net = gross.area_m2 - sizeOf(slab.outline.holes).area_m2;
        m_properties.addQuantities(instance, slabKey, "Qto_SlabBaseQuantities",
                                   {{"Width", QuantityKind::Length, thickness},
                                    {"Perimeter", QuantityKind::Length, gross.perimeter_m},
                                    {"GrossArea", QuantityKind::Area, gross.area_m2},
                                    {"NetArea", QuantityKind::Area, net},
                                    {"GrossVolume", QuantityKind::Volume, gross.area_m2 * thickness},
                                    {"NetVolume", QuantityKind::Volume, net * thickness}});
        addEvidence(instance, slabKey, slab.id, &slab.evidence, {{"Thickness", slab.thickness}});
    }
}

void Model::addSpaces()
{
    for (const Space& space : m_building.spaces)
    {
        const std::string spaceKey = key("space", space.id);
        const double height = space.height.value_m;
        const Eigen::Vector2d origin = cornerOf(space.outline);
        const Polygon outline = shifted(space.outline, origin);
        Shapes::Representation representation;
        representation.body = {m_shapes.paint(m_shapes.prism(outline, 0.0, height), Style::Space)};
        representation.footPrint = m_shapes.outlines(outline);
        const Instance instance = m_builder.add(
            "IfcSpace", {{"GlobalId", guid(spaceKey)},
                         {"Name", space.name},
                         {"ObjectPlacement", storeyPlacement(space.storey, {origin.x(), origin.y(), space.floor_m},
                                                             Eigen::Vector2d::UnitX())},
                         {"Representation", m_shapes.shape(representation)},
                         {"CompositionType", Enumeration{"ELEMENT"}},
                         {"PredefinedType", Enumeration{"INTERNAL"}}});
        const auto container = std::find_if(m_containers.begin(), m_containers.end(),
                                            [&](const Container& c) { return c.storey == space.storey; });
        container->spaces.push_back(instance);

        const RingSize gross = sizeOf(space.outline.outer);
        const RingSize holes = sizeOf(space.outline.holes);
        const double net = gross.area_m2 - holes.area_m2;
        m_properties.addQuantities(instance, spaceKey, "Qto_SpaceBaseQuantities",
                                   {{"Height", QuantityKind::Length, height},
                                    {"GrossPerimeter", QuantityKind::Length, gross.perimeter_m},
                                    {"NetPerimeter", QuantityKind::Length, gross.perimeter_m + holes.perimeter_m},
                                    {"GrossFloorArea", QuantityKind::Area, gross.area_m2},
                                    {"NetFloorArea", QuantityKind::Area, net},
                                    {"GrossVolume", QuantityKind::Volume, gross.area_m2 * height},
                                    {"NetVolume", QuantityKind::Volume, net * height}});
        addEvidence(instance, spaceKey, space.id, nullptr, {{"Height", space.height}});

        std::vector<ElementId> walls = space.boundedBy;
        std::sort(walls.begin(), walls.end());
        walls.erase(std::unique(walls.begin(), walls.end()), walls.end());
        for (const ElementId id : walls)
        {
            const Wall& wall = *m_wallById.at(id);
            const Enumeration side = {!wall.isExternalKnown ? "NOTDEFINED" : wall.isExternal ? "EXTERNAL" : "INTERNAL"};
            m_builder.add("IfcRelSpaceBoundary", {{"GlobalId", guid(spaceKey + '/' + key("wall", id))},
                                                  {"RelatingSpace", instance},
                                                  {"RelatedBuildingElement", m_walls.at(id).instance},
                                                  {"PhysicalOrVirtualBoundary", Enumeration{"PHYSICAL"}},
                                                  {"InternalOrExternalBoundary", side}});
        }
    }
}

}  // namespace s2b::ifc

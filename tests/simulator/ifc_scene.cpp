// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "ifc/ifc_reader.h"
#include "tests/simulator/layout.h"
#include "tests/simulator/scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace s2b::sim
{

namespace
{

constexpr double kFar_m = 500.0;  ///< coordinates beyond this get an origin of their own
constexpr double kPane_m = 0.2;   ///< a pane is larger than this both ways; frame profiles are not

bool isOneOf(const std::string& type, std::initializer_list<const char*> names)
{
    return std::any_of(names.begin(), names.end(),
                       [&](const char* name) { return type == name || type == std::string(name) + "StandardCase"; });
}

Label labelOf(const ifc::MeshElement& e)
{
    if (isOneOf(e.type, {"IfcWall", "IfcWallElementedCase"}))
        return Label::Wall;
    if (isOneOf(e.type, {"IfcColumn", "IfcPile"}))
        return Label::Column;
    if (isOneOf(e.type, {"IfcDoor"}))
        return Label::Door;
    if (isOneOf(e.type, {"IfcWindow", "IfcPlate", "IfcCurtainWall"}))
        return Label::Window;
    if (isOneOf(e.type, {"IfcBeam", "IfcMember"}))
        return Label::Beam;
    if (isOneOf(e.type, {"IfcStair", "IfcStairFlight", "IfcRamp", "IfcRampFlight", "IfcRailing"}))
        return Label::Stair;
    if (e.type == "IfcRoof" || e.predefinedType == "ROOF" || e.predefinedType == "ROOFING")
        return Label::Roof;
    if (e.type == "IfcCovering" && e.predefinedType == "CEILING")
        return Label::Ceiling;
    if (e.type == "IfcCovering" && e.predefinedType == "CLADDING")
        return Label::Wall;
    if (isOneOf(e.type, {"IfcSlab", "IfcCovering"}))
        return Label::Floor;
    if (isOneOf(e.type, {"IfcFurnishingElement", "IfcFurniture", "IfcSystemFurnitureElement", "IfcFlowTerminal",
                         "IfcLightFixture"}) ||
        e.type.ends_with("Terminal"))
        return Label::Furniture;
    return Label::Unassigned;
}

bool isSolid(const std::string& type)
{
    static const std::set<std::string> kAir{
        "IfcOpeningElement", "IfcOpeningStandardCase", "IfcSpace",          "IfcSpatialZone",
        "IfcGrid",           "IfcAnnotation",          "IfcVirtualElement", "IfcProjectionElement",
        "IfcSite",           "IfcReinforcingBar",      "IfcReinforcingMesh"};
    return !kAir.contains(type);
}

/// Whether a triangle of a window is its pane: vertical, and part of a face that is large both ways.
bool isPane(const std::array<Eigen::Vector3d, 3>& t)
{
    const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    if (!(std::abs(normal.z()) < 0.1))
        return false;
    const Eigen::Vector2d along(-normal.y(), normal.x());
    const auto extent = [&](const auto& f)
    {
        const auto [low, high] = std::minmax({f(t[0]), f(t[1]), f(t[2])});
        return high - low;
    };
    return extent([&](const Eigen::Vector3d& p) { return p.head<2>().dot(along); }) > kPane_m &&
           extent([](const Eigen::Vector3d& p) { return p.z(); }) > kPane_m;
}

}  // namespace

Scene readScene(const std::string& ifcPath)
{
    const ifc::IfcModel model = ifc::readIfc(ifcPath);
    Scene scene;
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300);
    Eigen::Vector3d high = -low;
    for (const ifc::MeshElement& e : model.elements)
    {
        const Label label = labelOf(e);
        if (!isSolid(e.type) || label == Label::Unassigned || label == Label::Furniture)
            continue;
        for (const Eigen::Vector3d& v : e.vertices)
        {
            low = low.cwiseMin(v);
            high = high.cwiseMax(v);
        }
    }
    if (low.x() > high.x())
        throw Error(ErrorCode::BadFile, "'" + ifcPath + "' has no walls, slabs or other building elements to scan");
    if (std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()) > kFar_m)
        scene.origin = ((low + high) / 2.0).array().floor();

    std::map<std::string, int> storeyIndex;
    for (const ifc::StoreyInfo& storey : model.storeys)
    {
        storeyIndex[storey.guid] = static_cast<int>(scene.storeys.size());
        scene.storeys.push_back({storey.guid, storey.name, storey.elevation_m - scene.origin.z()});
    }
    for (const ifc::MeshElement& e : model.elements)
    {
        if (!isSolid(e.type) || e.triangles.empty())
            continue;
        const Label label = labelOf(e);
        SceneElement element;
        element.type = e.type;
        element.guid = e.guid;
        element.name = e.name;
        element.host = e.hostGuid;
        element.colour = labelColour(label);
        const auto storey = storeyIndex.find(e.storeyGuid);
        element.storey = storey != storeyIndex.end() ? storey->second : -1;
        const std::uint32_t index = scene.addElement(std::move(element));
        const bool isGlazed = label == Label::Window || (label == Label::Door && e.isTransparent);
        for (const auto& t : e.triangles)
        {
            const std::array<Eigen::Vector3d, 3> p{e.vertices[t[0]] - scene.origin, e.vertices[t[1]] - scene.origin,
                                                   e.vertices[t[2]] - scene.origin};
            const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
            Surface surface{index, label, Material::Opaque};
            // What is above a slab is floor, what is below it is a ceiling.
            if (label == Label::Floor || label == Label::Roof)
                if (normal.z() < (label == Label::Roof ? -0.97 : -0.7) * normal.norm())
                    surface.label = Label::Ceiling;
            if (isGlazed && (e.type == "IfcPlate" || isPane(p)))
                surface.material = Material::Glass;
            scene.addTriangle(p[0], p[1], p[2], surface);
        }
    }

    // Ground at the storey nearest to the file's zero height.
    double ground = low.z() - scene.origin.z();
    double best = 1e300;
    for (const ifc::StoreyInfo& storey : model.storeys)
        if (std::abs(storey.elevation_m) < best)
        {
            best = std::abs(storey.elevation_m);
            ground = storey.elevation_m - scene.origin.z();
        }
    const Eigen::Vector3d a = low - scene.origin;
    const Eigen::Vector3d b = high - scene.origin;
    for (const Prop& prop : makeSurroundings(1, a.head<2>(), b.head<2>(), ground - 0.2))
    {
        SceneElement element;
        element.type = prop.kind;
        element.guid = "prop-" + std::to_string(scene.elements.size());
        element.isProp = true;
        element.colour = prop.colour;
        const Surface surface{scene.addElement(std::move(element)), prop.label, Material::Opaque};
        for (const PropBox& box : prop.boxes)
            scene.addBox(box, surface);
        for (const auto& t : prop.triangles)
            scene.addTriangle(t[0], t[1], t[2], surface);
    }
    return scene;
}

}  // namespace s2b::sim

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

constexpr double kSagitta_m = 0.001;  // of the facets of an arc wall with a sloped top

/// Outline in plan of an arc wall, with true arcs.
Ring arcRing(const Wall& wall, const WallGeometry& geometry)
{
    const double half = 0.5 * geometry.thickness_m();
    const double from = wall.bodyStart_m;
    const double to = wall.bodyEnd_m;
    const double middle = 0.5 * (from + to);
    Ring ring;
    ring.corners.push_back({geometry.at(from, -half), true, geometry.at(middle, -half)});
    ring.corners.push_back({geometry.at(to, -half)});
    ring.corners.push_back({geometry.at(to, half), true, geometry.at(middle, half)});
    ring.corners.push_back({geometry.at(from, half)});
    return ring;
}

/// An arc wall under a sloped top: a closed mesh of facets.
Instance facetedBody(const Wall& wall, const WallGeometry& geometry, Shapes& shapes)
{
    const double half = 0.5 * geometry.thickness_m();
    const double step = 2.0 * std::acos(1.0 - kSagitta_m / (geometry.radius_m() + half)) * geometry.radius_m();
    std::vector<Eigen::Vector2d> stations;  // s, top
    const std::vector<Eigen::Vector2d> edge = geometry.topEdge();
    for (std::size_t i = 0; i + 1 < edge.size(); ++i)
    {
        const int pieces = std::max(1, static_cast<int>(std::ceil((edge[i + 1].x() - edge[i].x()) / step)));
        for (int k = 0; k < pieces; ++k)
            stations.push_back(edge[i] + (edge[i + 1] - edge[i]) * k / pieces);
    }
    stations.push_back(edge.back());

    // Four corners per station: right bottom, left bottom, left top, right top.
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<int, 3>> triangles;
    const auto quad = [&](int a, int b, int c, int d)
    {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    };
    for (const Eigen::Vector2d& station : stations)
    {
        const Eigen::Vector2d right = geometry.at(station.x(), -half);
        const Eigen::Vector2d left = geometry.at(station.x(), half);
        const double top = station.y() - wall.base_m;
        vertices.emplace_back(right.x(), right.y(), 0.0);
        vertices.emplace_back(left.x(), left.y(), 0.0);
        vertices.emplace_back(left.x(), left.y(), top);
        vertices.emplace_back(right.x(), right.y(), top);
    }
    const int last = 4 * (static_cast<int>(stations.size()) - 1);
    quad(3, 2, 1, 0);
    for (int a = 0; a < last; a += 4)
        for (int k = 0; k < 4; ++k)
            quad(a + k, a + (k + 1) % 4, a + 4 + (k + 1) % 4, a + 4 + k);
    quad(last, last + 1, last + 2, last + 3);
    return shapes.mesh(vertices, triangles);
}

/// Elevation of a straight wall under a sloped top, in the local x-z plane.
std::vector<Eigen::Vector2d> elevation(const Wall& wall, const WallGeometry& geometry)
{
    std::vector<Eigen::Vector2d> ring = {{0.0, 0.0}, {geometry.length_m(), 0.0}};
    const std::vector<Eigen::Vector2d> edge = geometry.topEdge();
    for (auto it = edge.rbegin(); it != edge.rend(); ++it)
    {
        const Eigen::Vector2d p(it->x() - wall.bodyStart_m, it->y() - wall.base_m);
        // A gable may end at the base itself.
        if ((p - ring.back()).norm() > 1e-6 && (p - ring.front()).norm() > 1e-6)
            ring.push_back(p);
    }
    return ring;
}

}  // namespace

Instance Model::wallBody(const Wall& wall, Shapes::Representation& representation)
{
    const WallGeometry geometry(wall);
    if (geometry.isArc())
    {
        if (geometry.hasLevelTop())
            return m_shapes.prism(arcRing(wall, geometry), 0.0, wall.height.value_m);
        representation.bodyType = "Tessellation";
        return facetedBody(wall, geometry, m_shapes);
    }
    if (geometry.hasLevelTop())
        return m_shapes.box(Eigen::Vector3d::Zero(),
                            {geometry.length_m(), geometry.thickness_m(), wall.height.value_m});
    return m_shapes.plate(elevation(wall, geometry), {}, 0.0, geometry.thickness_m());
}

void Model::addWall(const Wall& wall)
{
    const WallGeometry geometry(wall);
    const std::string wallKey = key("wall", wall.id);
    const Instance placement =
        storeyPlacement(wall.storey, {geometry.origin().x(), geometry.origin().y(), wall.base_m}, geometry.xAxis());

    Shapes::Representation representation;
    representation.body = {m_shapes.paint(wallBody(wall, representation), Style::Wall)};
    const double length = wall.axisLength_m();
    representation.axis =
        geometry.isArc() ? m_shapes.arc(geometry.at(0.0, 0.0), geometry.at(0.5 * length, 0.0), geometry.at(length, 0.0))
                         : m_shapes.line(geometry.at(0.0, 0.0), geometry.at(length, 0.0));
    const Instance instance = m_builder.add("IfcWall", {{"GlobalId", guid(wallKey)},
                                                        {"Name", nameOf("Wall", wall.id)},
                                                        {"ObjectPlacement", placement},
                                                        {"Representation", m_shapes.shape(representation)},
                                                        {"Tag", std::to_string(wall.id.value)},
                                                        {"PredefinedType", Enumeration{"NOTDEFINED"}}});
    m_walls[wall.id] = {instance, placement};
    contain(wall.storey, instance);
    m_material.push_back(instance);
    const std::string typeName = "Wall " + millimetres(wall.thickness.value_m);
    assignType(typeName, "IfcWallType", {{"PredefinedType", Enumeration{"NOTDEFINED"}}}, instance);

    std::vector<Property> common = {{"Reference", {"IfcIdentifier", typeName}}, kExisting};
    if (wall.isExternalKnown)
        common.push_back({"IsExternal", {"IfcBoolean", wall.isExternal}});
    m_properties.addShared(instance, "Pset_WallCommon", common);

    const WallGeometry::Quantities q = geometry.quantities(m_openingsOf[wall.id]);
    std::vector<Quantity> quantities = {{"Length", QuantityKind::Length, geometry.length_m()},
                                        {"Width", QuantityKind::Length, geometry.thickness_m()}};
    if (geometry.hasLevelTop())  // IFC: only where it is the same along the wall
        quantities.push_back({"Height", QuantityKind::Length, wall.height.value_m});
    const bool isIfc4 = m_options.schema == "IFC4";  // the standard changed the spelling
    quantities.insert(quantities.end(),
                      {{isIfc4 ? "GrossFootprintArea" : "GrossFootPrintArea", QuantityKind::Area, q.grossFootprint_m2},
                       {isIfc4 ? "NetFootprintArea" : "NetFootPrintArea", QuantityKind::Area, q.netFootprint_m2},
                       {"GrossSideArea", QuantityKind::Area, q.grossSide_m2},
                       {"NetSideArea", QuantityKind::Area, q.netSide_m2},
                       {"GrossVolume", QuantityKind::Volume, q.grossVolume_m3},
                       {"NetVolume", QuantityKind::Volume, q.netVolume_m3}});
    m_properties.addQuantities(instance, wallKey, "Qto_WallBaseQuantities", quantities);
    addEvidence(instance, wallKey, wall.id, &wall.evidence, {{"Thickness", wall.thickness}, {"Height", wall.height}});
}

void Model::addWalls()
{
    for (const Wall& wall : m_building.walls)
        addWall(wall);
}

void Model::addJunctions()
{
    const auto end = [](JunctionEnd e)
    {
        return Enumeration{e == JunctionEnd::Start ? "ATSTART" : e == JunctionEnd::End ? "ATEND" : "ATPATH"};
    };
    std::size_t number = 0;
    for (const Junction& junction : m_building.junctions)
        m_builder.add(
            "IfcRelConnectsPathElements",
            {{"GlobalId", guid("junction/" + std::to_string(number++) + '/' + std::to_string(junction.wallA.value) +
                               '/' + std::to_string(junction.wallB.value))},
             {"RelatingElement", m_walls.at(junction.wallA).instance},
             {"RelatedElement", m_walls.at(junction.wallB).instance},
             {"RelatingPriorities", std::vector<int>{}},
             {"RelatedPriorities", std::vector<int>{}},
             {"RelatedConnectionType", end(junction.endB)},
             {"RelatingConnectionType", end(junction.endA)}});
}

}  // namespace s2b::ifc

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/extrude.h"

#include "core/geometry/polygon.h"
#include "core/geometry/rectangle.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/mark_domain_in_triangulation.h>

#include <unordered_map>

namespace s2b::validation
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Faces = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

constexpr double kLeaf_m = 0.05;

std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Ring>& rings)
{
    Triangulation triangulation;
    std::uint32_t next = 0;
    for (const Ring& ring : rings)
    {
        std::vector<Triangulation::Vertex_handle> handles;
        for (const Eigen::Vector2d& p : ring)
        {
            handles.push_back(triangulation.insert(Kernel::Point_2(p.x(), p.y())));
            handles.back()->info() = next++;
        }
        for (std::size_t i = 0; i < handles.size(); ++i)
            if (handles[i] != handles[(i + 1) % handles.size()])
                triangulation.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
    }
    std::unordered_map<Triangulation::Face_handle, bool> isInside;
    CGAL::mark_domain_in_triangulation(triangulation, boost::associative_property_map(isInside));
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto face : triangulation.finite_face_handles())
        if (isInside[face])
            triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    return triangles;
}

Mesh leafMesh(const BimElement& opening, const BimElement* host)
{
    OrientedRectangle leaf = host != nullptr && host->axis
                                 ? rectangleAlong(opening.plan.outer, host->axis->end - host->axis->start)
                                 : minimumRectangle(opening.plan.outer);
    leaf.half.y() = std::min(leaf.half.y(), 0.5 * kLeaf_m);
    const auto corners = leaf.corners();
    return extrudeUp({{corners.begin(), corners.end()}, {}}, opening.low_m, opening.high_m);
}

}  // namespace

Mesh extrude(const Polygon& section, const Eigen::Isometry3d& frame, double depth_m)
{
    std::vector<Ring> rings{section.outer};
    rings.insert(rings.end(), section.holes.begin(), section.holes.end());
    Mesh mesh;
    std::uint32_t count = 0;
    for (const double z : {0.0, depth_m})
        for (const Ring& ring : rings)
            for (const Eigen::Vector2d& p : ring)
                mesh.vertices.push_back(frame * Eigen::Vector3d(p.x(), p.y(), z));
    count = static_cast<std::uint32_t>(mesh.vertices.size() / 2);
    for (const auto& t : triangulate(rings))
    {
        mesh.triangles.push_back({t[0], t[2], t[1]});
        mesh.triangles.push_back({count + t[0], count + t[1], count + t[2]});
    }
    std::uint32_t first = 0;
    for (const Ring& ring : rings)
    {
        const auto n = static_cast<std::uint32_t>(ring.size());
        for (std::uint32_t i = 0; i < n; ++i)
        {
            const std::uint32_t a = first + i;
            const std::uint32_t b = first + (i + 1) % n;
            mesh.triangles.push_back({a, b, count + b});
            mesh.triangles.push_back({a, count + b, count + a});
        }
        first += n;
    }
    return mesh;
}

double volumeOf(const Mesh& mesh)
{
    if (mesh.vertices.empty())
        return 0.0;
    const Eigen::Vector3d& origin = mesh.vertices.front();
    double sum = 0.0;
    for (const auto& t : mesh.triangles)
        sum += (mesh.vertices[t[0]] - origin).dot((mesh.vertices[t[1]] - origin).cross(mesh.vertices[t[2]] - origin));
    return sum / 6.0;
}

Mesh wallMesh(const BimElement& wall, const std::vector<const BimElement*>& openings)
{
    // Its elevation is swept through its thickness.
    const Eigen::Vector2d u = (wall.axis->end - wall.axis->start).normalized();
    const Eigen::Vector2d left(-u.y(), u.x());
    const auto along = [&](const Eigen::Vector2d& p) { return (p - wall.axis->start).dot(u); };
    const auto elevation = [](double s0, double s1, double z0, double z1)
    { return Polygon{{{s0, z0}, {s1, z0}, {s1, z1}, {s0, z1}}, {}}; };
    const Polygon whole = elevation(0.0, (wall.axis->end - wall.axis->start).norm(), wall.low_m, wall.high_m);
    std::vector<Polygon> holes;
    for (const BimElement* opening : openings)
    {
        double low = 1e300;
        double high = -1e300;
        for (const Eigen::Vector2d& p : opening->plan.outer)
        {
            low = std::min(low, along(p));
            high = std::max(high, along(p));
        }
        holes.push_back(elevation(low, high, opening->low_m, opening->high_m));
    }
    // x along the wall, y up, so that z points to its right.
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.linear().col(0) << u, 0.0;
    frame.linear().col(1) = Eigen::Vector3d::UnitZ();
    frame.linear().col(2) << -left, 0.0;
    frame.translation() << wall.axis->start + 0.5 * wall.axis->thickness_m * left, 0.0;
    Mesh mesh;
    for (const Polygon& part : subtract(std::span(&whole, 1), holes))
    {
        const Mesh piece = extrude(part, frame, wall.axis->thickness_m);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), piece.vertices.begin(), piece.vertices.end());
        for (const auto& t : piece.triangles)
            mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    return mesh;
}

Mesh extrudeUp(const Polygon& plan, double low_m, double high_m)
{
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.translation().z() = low_m;
    return extrude(canonical(plan), frame, high_m - low_m);
}

void addMeshes(Bim& bim)
{
    std::vector<std::vector<const BimElement*>> openings(bim.elements.size());
    for (const BimElement& e : bim.elements)
        if (e.host >= 0)
            openings[static_cast<std::size_t>(e.host)].push_back(&e);
    for (std::size_t i = 0; i < bim.elements.size(); ++i)
    {
        BimElement& e = bim.elements[i];
        if (e.plan.outer.size() < 3 || e.high_m <= e.low_m)
            continue;
        if (e.elementClass == ElementClass::Wall && e.axis)
            e.mesh = wallMesh(e, openings[i]);
        else if (e.elementClass == ElementClass::Door || e.elementClass == ElementClass::Window)
            e.mesh = leafMesh(e, e.host >= 0 ? &bim.elements[static_cast<std::size_t>(e.host)] : nullptr);
        else
            e.mesh = extrudeUp(e.plan, e.low_m, e.high_m);
    }
}

}  // namespace s2b::validation

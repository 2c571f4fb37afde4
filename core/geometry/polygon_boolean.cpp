// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/geometry/polygon.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_repair/repair.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <list>

namespace s2b
{

namespace
{

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalRing = CGAL::Polygon_2<Kernel>;
using CgalPolygon = CGAL::Polygon_with_holes_2<Kernel>;
using CgalSet = CGAL::Polygon_set_2<Kernel>;

constexpr double kSmallestArea_m2 = 1e-6;
/// A corner nearer than this to the line between its neighbours does not bend [m].
constexpr double kSmallestBend_m = 1e-7;

CgalRing toCgal(const Ring& ring, const Eigen::Vector2d& origin)
{
    CgalRing result;
    for (const Eigen::Vector2d& p : ring)
    {
        if (!p.allFinite())
            throw Error(ErrorCode::Internal, "a polygon has coordinates that are not finite");
        result.push_back({p.x() - origin.x(), p.y() - origin.y()});
    }
    return result;
}

/// The union of the polygons. Any rings are made valid first: CGAL's sets take nothing else, and check nothing in a
/// release build.
CgalSet toSet(std::span<const Polygon> polygons, const Eigen::Vector2d& origin)
{
    std::list<CgalPolygon> valid;
    for (const Polygon& polygon : polygons)
    {
        if (polygon.outer.size() < 3)
            continue;
        CgalPolygon input(toCgal(polygon.outer, origin));
        for (const Ring& hole : polygon.holes)
        {
            if (hole.size() >= 3)
                input.add_hole(toCgal(hole, origin));
        }
        const auto repaired = CGAL::Polygon_repair::repair(input, CGAL::Polygon_repair::Even_odd_rule());
        for (const CgalPolygon& part : repaired.polygons_with_holes())
            valid.push_back(part);
    }
    CgalSet set;
    set.join(valid.begin(), valid.end());
    return set;
}

/// Without corners that do not bend, which rounding and former neighbours leave.
Ring withoutStraightCorners(Ring ring)
{
    bool changed = true;
    while (changed && ring.size() >= 3)
    {
        changed = false;
        for (std::size_t i = 0; i < ring.size() && ring.size() >= 3;)
        {
            const Eigen::Vector2d& a = ring[(i + ring.size() - 1) % ring.size()];
            const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
            const Eigen::Vector2d chord = b - a;
            const Eigen::Vector2d arm = ring[i] - a;
            const double length = chord.norm();
            const double bend = length > 0.0 ? std::abs(chord.x() * arm.y() - chord.y() * arm.x()) / length : 0.0;
            if (bend > kSmallestBend_m)
            {
                ++i;
                continue;
            }
            ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
            changed = true;
        }
    }
    return ring;
}

Ring toRing(const CgalRing& ring, const Eigen::Vector2d& origin)
{
    Ring result;
    for (const auto& p : ring)
        result.push_back(origin + Eigen::Vector2d(CGAL::to_double(p.x()), CGAL::to_double(p.y())));
    return withoutStraightCorners(std::move(result));
}

std::vector<Polygon> toPolygons(const CgalSet& set, const Eigen::Vector2d& origin)
{
    std::list<CgalPolygon> parts;
    set.polygons_with_holes(std::back_inserter(parts));
    std::vector<Polygon> polygons;
    for (const CgalPolygon& part : parts)
    {
        Polygon polygon;
        polygon.outer = toRing(part.outer_boundary(), origin);
        if (std::abs(signedArea(polygon.outer)) < kSmallestArea_m2)
            continue;
        for (const CgalRing& hole : part.holes())
        {
            Ring ring = toRing(hole, origin);
            if (std::abs(signedArea(ring)) >= kSmallestArea_m2)
                polygon.holes.push_back(std::move(ring));
        }
        polygons.push_back(canonical(polygon));
    }
    sortPolygons(polygons);
    return polygons;
}

/// A point of the polygons: differences to it are exact for coordinates of one building.
Eigen::Vector2d originOf(std::span<const Polygon> polygons)
{
    for (const Polygon& polygon : polygons)
    {
        if (!polygon.outer.empty())
            return polygon.outer.front();
    }
    return Eigen::Vector2d::Zero();
}

}  // namespace

std::vector<Polygon> unite(std::span<const Polygon> polygons)
{
    const Eigen::Vector2d origin = originOf(polygons);
    return toPolygons(toSet(polygons, origin), origin);
}

std::vector<Polygon> intersect(std::span<const Polygon> a, std::span<const Polygon> b)
{
    const Eigen::Vector2d origin = originOf(a);
    CgalSet set = toSet(a, origin);
    set.intersection(toSet(b, origin));
    return toPolygons(set, origin);
}

std::vector<Polygon> subtract(std::span<const Polygon> a, std::span<const Polygon> b)
{
    const Eigen::Vector2d origin = originOf(a);
    CgalSet set = toSet(a, origin);
    set.difference(toSet(b, origin));
    return toPolygons(set, origin);
}

}  // namespace s2b

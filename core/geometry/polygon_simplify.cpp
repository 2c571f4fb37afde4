// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/polygon.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Polyline_simplification_2/Squared_distance_cost.h>
#include <CGAL/Polyline_simplification_2/Stop_above_cost_threshold.h>
#include <CGAL/Polyline_simplification_2/simplify.h>

namespace s2b
{

namespace
{

namespace ps = CGAL::Polyline_simplification_2;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalRing = CGAL::Polygon_2<Kernel>;
using CgalPolygon = CGAL::Polygon_with_holes_2<Kernel>;

CgalRing toCgal(const Ring& ring, const Eigen::Vector2d& origin)
{
    CgalRing result;
    for (const Eigen::Vector2d& p : ring)
        result.push_back({p.x() - origin.x(), p.y() - origin.y()});
    return result;
}

Ring toRing(const CgalRing& ring, const Eigen::Vector2d& origin)
{
    Ring result;
    for (const auto& p : ring)
        result.push_back(origin + Eigen::Vector2d(p.x(), p.y()));
    return result;
}

}  // namespace

Polygon simplify(const Polygon& polygon, double tolerance)
{
    const Polygon input = canonical(polygon);
    if (input.outer.size() < 4 && input.holes.empty())
        return input;
    const Eigen::Vector2d origin = input.outer.front();
    CgalPolygon all(toCgal(input.outer, origin));
    for (const Ring& hole : input.holes)
        all.add_hole(toCgal(hole, origin));
    const CgalPolygon simple =
        ps::simplify(all, ps::Squared_distance_cost(), ps::Stop_above_cost_threshold(tolerance * tolerance));
    Polygon result;
    result.outer = toRing(simple.outer_boundary(), origin);
    for (const CgalRing& hole : simple.holes())
        result.holes.push_back(toRing(hole, origin));
    return canonical(result);
}

}  // namespace s2b

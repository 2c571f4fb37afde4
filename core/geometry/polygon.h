// SPDX-License-Identifier: GPL-3.0-or-later
/// Polygons with holes in plan (s2b::Polygon): measures, boolean operations, simplification, tracing of masks.
///
/// "Valid" below means as Polygon says: simple rings, outer counter-clockwise, holes clockwise and inside, first point
/// not repeated; rings may touch in single points. What the functions return is valid, and in a canonical order: each
/// ring begins at its lexicographically smallest point, rings and polygons are sorted by their first point.
#pragma once

#include "core/model/building.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace s2b
{

using Ring = std::vector<Eigen::Vector2d>;

/// Area, > 0 counter-clockwise. 0 for fewer than three points. Exact to rounding at any distance from the origin.
[[nodiscard]] double signedArea(std::span<const Eigen::Vector2d> ring);
/// Area without the holes.
[[nodiscard]] double area(const Polygon& polygon);
/// Length of all rings.
[[nodiscard]] double perimeter(const Polygon& polygon);
/// Centre of mass; of the outer ring's points when there is no area.
[[nodiscard]] Eigen::Vector2d centroid(const Polygon& polygon);
/// Whether p is inside: by crossings, so that it holds for any rings. Points on an edge count to one side of it.
[[nodiscard]] bool contains(const Polygon& polygon, const Eigen::Vector2d& p);

/// Brings rings into their direction and the canonical order, and drops repeated points and rings of fewer than three.
[[nodiscard]] Polygon canonical(const Polygon& polygon);

/// Sorts canonical polygons by their outer rings.
void sortPolygons(std::vector<Polygon>& polygons);

/// Boolean operations, exact but for the rounding of new corners to double (CGAL). The inputs may be any rings:
/// crossing and overlapping ones are taken by the even-odd rule, polygons of one list are united first. Parts below
/// 1e-6 m2 and corners that do not bend are dropped.
/// @throws Error{Internal} for coordinates that are not finite.
/// Cost: O(n log n) in the number of edges and crossings, about 10 us each.
[[nodiscard]] std::vector<Polygon> unite(std::span<const Polygon> polygons);
[[nodiscard]] std::vector<Polygon> intersect(std::span<const Polygon> a, std::span<const Polygon> b);
[[nodiscard]] std::vector<Polygon> subtract(std::span<const Polygon> a, std::span<const Polygon> b);

/// Fewer corners: removes those whose removal moves the boundary by at most `tolerance` [m], without letting rings
/// cross (CGAL's polyline simplification, Dyken et al. 2009). Every ring keeps at least three corners.
/// @param polygon  valid.
[[nodiscard]] Polygon simplify(const Polygon& polygon, double tolerance);

/// Outlines of the set cells of a mask, along the cells' edges, without collinear corners.
///
/// Cells belong together across edges, not across corners: two that touch in a corner are two polygons. One polygon per
/// connected region, with its holes.
/// @param mask    width * height values, row by row from the lowest y, not 0: set.
/// @param origin  lower-left corner of the first cell.
/// @param cell    edge of a cell [m], > 0.
/// @throws Error{Internal} when the mask's size is not width * height.
/// Cost: O(cells).
[[nodiscard]] std::vector<Polygon> traceMask(std::span<const std::uint8_t> mask, int width, int height,
                                             const Eigen::Vector2d& origin, double cell);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace s2b
{

/// A rectangle in plan of any direction: D3.6's horizontally oriented bounding box without its height (3.4.4, 4.1).
struct OrientedRectangle
{
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    Eigen::Vector2d axis = Eigen::Vector2d::UnitX();  ///< unit, along the first side
    Eigen::Vector2d half = Eigen::Vector2d::Zero();   ///< half lengths along axis and across it

    /// Unit, `axis` turned by +90 degrees.
    [[nodiscard]] Eigen::Vector2d across() const { return {-axis.y(), axis.x()}; }
    [[nodiscard]] double area() const { return 4.0 * half.x() * half.y(); }
    /// Counter-clockwise from the lower-left one, as seen with `axis` to the right.
    [[nodiscard]] std::array<Eigen::Vector2d, 4> corners() const
    {
        const Eigen::Vector2d u = half.x() * axis;
        const Eigen::Vector2d v = half.y() * across();
        return {center - u - v, center + u - v, center + u + v, center - u + v};
    }
    /// Whether it holds p, or p is at most `margin` beyond its sides.
    [[nodiscard]] bool contains(const Eigen::Vector2d& p, double margin = 0.0) const
    {
        const Eigen::Vector2d d = p - center;
        return std::abs(d.dot(axis)) <= half.x() + margin && std::abs(d.dot(across())) <= half.y() + margin;
    }
};

/// The smallest convex polygon around the points: counter-clockwise, without collinear corners, beginning at the
/// lexicographically smallest. One point for equal points, two for collinear ones, none for none.
/// @param points  finite.  Cost: O(N log N) (CGAL, exact predicates).
[[nodiscard]] std::vector<Eigen::Vector2d> convexHull(std::span<const Eigen::Vector2d> points);

/// The rectangle of the smallest area around the points (rotating calipers on the convex hull: one of its sides lies on
/// a side of the hull; D3.6, 3.6). The first side is the longer one, with axis.x > 0, or = 0 and axis.y > 0.
///
/// @param points  finite. Equal points give a rectangle without extent, collinear ones one without width.
/// @return Of equally small ones any, but always the same one. Without points one at the origin without extent.
/// Cost: O(N log N).
[[nodiscard]] OrientedRectangle minimumRectangle(std::span<const Eigen::Vector2d> points);

/// The smallest rectangle around the points with its first side along `direction` (not zero; any length), even where
/// that is the shorter one.
/// @return Without points one at the origin without extent.  Cost: O(N).
[[nodiscard]] OrientedRectangle rectangleAlong(std::span<const Eigen::Vector2d> points,
                                               const Eigen::Vector2d& direction);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rectangle.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/min_quadrilateral_2.h>

#include <iterator>
#include <limits>
#include <utility>

namespace s2b
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

std::vector<Point> hullOf(std::span<const Eigen::Vector2d> points, const Eigen::Vector2d& reference)
{
    std::vector<Point> input;
    input.reserve(points.size());
    for (const Eigen::Vector2d& p : points)
        input.emplace_back(p.x() - reference.x(), p.y() - reference.y());
    std::vector<Point> hull;
    CGAL::convex_hull_2(input.begin(), input.end(), std::back_inserter(hull));
    return hull;
}

Eigen::Vector2d vectorOf(const Point& p)
{
    return {p.x(), p.y()};
}

/// The directions of the sides that the smallest rectangle may have. CGAL's corners are rounded intersections: the
/// rectangle itself is measured again along its sides' direction.
Eigen::Vector2d directionOf(const std::vector<Point>& hull)
{
    if (hull.size() == 2)
        return vectorOf(hull[1]) - vectorOf(hull[0]);
    std::vector<Point> corners;
    CGAL::min_rectangle_2(hull.begin(), hull.end(), std::back_inserter(corners));
    const Eigen::Vector2d first = vectorOf(corners[1]) - vectorOf(corners[0]);
    const Eigen::Vector2d second = vectorOf(corners[2]) - vectorOf(corners[1]);
    return first.squaredNorm() >= second.squaredNorm() ? first : second;  // the longer one is rounded less
}

}  // namespace

std::vector<Eigen::Vector2d> convexHull(std::span<const Eigen::Vector2d> points)
{
    std::vector<Eigen::Vector2d> hull;
    for (const Point& p : hullOf(points, Eigen::Vector2d::Zero()))
        hull.push_back(vectorOf(p));
    return hull;
}

OrientedRectangle minimumRectangle(std::span<const Eigen::Vector2d> points)
{
    if (points.empty())
        return {};
    // Far from the origin, CGAL's products of coordinates would be rounded more than the points are.
    const Eigen::Vector2d reference = points.front();
    const std::vector<Point> hull = hullOf(points, reference);
    if (hull.size() < 2)
        return OrientedRectangle{reference, Eigen::Vector2d::UnitX(), Eigen::Vector2d::Zero()};
    std::vector<Eigen::Vector2d> corners;
    for (const Point& p : hull)
        corners.push_back(vectorOf(p));
    OrientedRectangle rectangle = rectangleAlong(corners, directionOf(hull));
    rectangle.center += reference;
    if (rectangle.half.x() < rectangle.half.y())
    {
        rectangle.axis = rectangle.across();
        std::swap(rectangle.half.x(), rectangle.half.y());
    }
    if (rectangle.axis.x() < 0.0 || (rectangle.axis.x() == 0.0 && rectangle.axis.y() < 0.0))
        rectangle.axis = -rectangle.axis;
    return rectangle;
}

OrientedRectangle rectangleAlong(std::span<const Eigen::Vector2d> points, const Eigen::Vector2d& direction)
{
    OrientedRectangle rectangle;
    rectangle.axis = direction.normalized();
    if (points.empty())
        return rectangle;
    const Eigen::Vector2d across = rectangle.across();
    const Eigen::Vector2d reference = points.front();
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector2d high = -low;
    for (const Eigen::Vector2d& p : points)
    {
        const Eigen::Vector2d d = p - reference;
        const Eigen::Vector2d local(d.dot(rectangle.axis), d.dot(across));
        low = low.cwiseMin(local);
        high = high.cwiseMax(local);
    }
    const Eigen::Vector2d middle = 0.5 * (low + high);
    rectangle.center = reference + middle.x() * rectangle.axis + middle.y() * across;
    rectangle.half = 0.5 * (high - low);
    return rectangle;
}

}  // namespace s2b

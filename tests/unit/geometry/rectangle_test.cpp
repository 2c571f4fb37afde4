// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rectangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace
{

using namespace s2b;
using Points = std::vector<Eigen::Vector2d>;

Points randomPoints(unsigned seed, std::size_t count, const Eigen::Vector2d& origin = Eigen::Vector2d::Zero())
{
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> place(-3.0, 3.0);
    std::normal_distribution<double> spread;
    Points points;
    for (std::size_t i = 0; i < count; ++i)
    {
        const double x = place(generator);
        points.push_back(origin + Eigen::Vector2d(x, 0.4 * x + spread(generator)));
    }
    return points;
}

/// The smallest rectangle along any line through two of the points: one side of the best lies on a hull's side.
double bruteForceArea(const Points& points)
{
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            best = std::min(best, rectangleAlong(points, points[i] - points[j]).area());
    return best;
}

TEST(MinimumRectangle, IsAsSmallAsTheBestOfAllDirectionsAndHoldsThePoints)
{
    for (unsigned seed = 0; seed < 40; ++seed)
    {
        const Points points = randomPoints(seed, 3 + seed);
        const OrientedRectangle rectangle = minimumRectangle(points);
        // The same sums in another order: some roundings of numbers below 100.
        EXPECT_NEAR(rectangle.area(), bruteForceArea(points), 1e-10) << seed;
        for (const Eigen::Vector2d& p : points)
            EXPECT_TRUE(rectangle.contains(p, 1e-12)) << seed;
        EXPECT_GE(rectangle.half.x(), rectangle.half.y());
        EXPECT_GE(rectangle.axis.x(), 0.0);
        EXPECT_NEAR(rectangle.axis.norm(), 1.0, 1e-12);
    }
}

TEST(MinimumRectangle, FindsATurnedRectangle)
{
    for (int degrees = -89; degrees <= 90; degrees += 13)
    {
        const double angle = degrees * std::numbers::pi / 180.0;
        const OrientedRectangle truth{{1.5, -7.0}, {std::cos(angle), std::sin(angle)}, {2.0, 0.4}};
        Points points;
        for (const Eigen::Vector2d& corner : truth.corners())
            points.push_back(corner);
        points.push_back(truth.center);
        const OrientedRectangle found = minimumRectangle(points);
        // Corners are rounded at 1e-15; the direction of a side of 4 m then at 1e-15.
        EXPECT_NEAR((found.center - truth.center).norm(), 0.0, 1e-12);
        EXPECT_NEAR((found.half - truth.half).norm(), 0.0, 1e-12);
        EXPECT_NEAR(std::abs(found.axis.dot(truth.across())), 0.0, 1e-12);
    }
}

TEST(MinimumRectangle, KeepsMillimetresFarFromTheOrigin)
{
    const Eigen::Vector2d origin(4.5e6, 5.4e6);
    const Points near = randomPoints(5, 60);
    const OrientedRectangle there = minimumRectangle(randomPoints(5, 60, origin));
    const OrientedRectangle here = minimumRectangle(near);
    // Spacing of doubles at 5e6 is 1e-9, times the rectangle's side of some metres.
    EXPECT_NEAR(there.area(), here.area(), 1e-7);
    EXPECT_NEAR((there.center - origin - here.center).norm(), 0.0, 1e-7);
}

TEST(MinimumRectangle, HandlesNoneOneEqualAndCollinearPoints)
{
    EXPECT_EQ(minimumRectangle({}).half, Eigen::Vector2d(0, 0));
    for (const std::size_t count : {1u, 9u})
    {
        const OrientedRectangle one = minimumRectangle(Points(count, {4, 5}));
        EXPECT_EQ(one.center, Eigen::Vector2d(4, 5));
        EXPECT_EQ(one.half, Eigen::Vector2d(0, 0));
        EXPECT_NEAR(one.axis.norm(), 1.0, 1e-15);
    }
    const OrientedRectangle line = minimumRectangle(Points{{0, 0}, {3, 4}, {1.5, 2}, {6, 8}});
    EXPECT_NEAR(line.half.x(), 5.0, 1e-12);
    EXPECT_NEAR(line.half.y(), 0.0, 1e-12);
    EXPECT_NEAR((line.center - Eigen::Vector2d(3, 4)).norm(), 0.0, 1e-12);
    const OrientedRectangle upright = minimumRectangle(Points{{2, 5}, {2, 1}});
    EXPECT_EQ(upright.axis, Eigen::Vector2d(0, 1));
}

TEST(RectangleAlong, HasItsFirstSideAlongTheDirectionEvenWhenShorter)
{
    const Points points{{0, 0}, {2, 0}, {2, 10}, {0, 10}, {1, 1}};
    const OrientedRectangle rectangle = rectangleAlong(points, {5, 0});
    EXPECT_EQ(rectangle.axis, Eigen::Vector2d(1, 0));
    EXPECT_EQ(rectangle.half, Eigen::Vector2d(1, 5));
    EXPECT_EQ(rectangle.center, Eigen::Vector2d(1, 5));
    EXPECT_EQ(rectangle.corners()[0], Eigen::Vector2d(0, 0));
    EXPECT_EQ(rectangle.corners()[2], Eigen::Vector2d(2, 10));
    EXPECT_EQ(rectangleAlong({}, {0, 2}).axis, Eigen::Vector2d(0, 1));
}

TEST(ConvexHull, IsCounterClockwiseWithoutCollinearCorners)
{
    const Points points{{1, 0}, {0, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 1}, {2, 0}};
    EXPECT_EQ(convexHull(points), (Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
    EXPECT_TRUE(convexHull({}).empty());
    EXPECT_EQ(convexHull(Points(4, {1, 2})), (Points{{1, 2}}));
    EXPECT_EQ(convexHull(Points{{3, 3}, {1, 1}, {2, 2}}), (Points{{1, 1}, {3, 3}}));
}

}  // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace
{

using namespace s2b;

/// A rectangle of many points, each moved by at most `noise`.
Polygon roughRectangle(double width, double height, double step, double noise, unsigned seed)
{
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> move(-noise, noise);
    Polygon polygon;
    const auto side = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
    {
        const int count = int(std::lround((b - a).norm() / step));
        for (int i = 0; i < count; ++i)
            polygon.outer.push_back(a + (b - a) * double(i) / count +
                                    Eigen::Vector2d(move(generator), move(generator)));
    };
    side({0, 0}, {width, 0});
    side({width, 0}, {width, height});
    side({width, height}, {0, height});
    side({0, height}, {0, 0});
    return polygon;
}

/// Distance of p to the nearest edge of the outer ring.
double distanceToBoundary(const Polygon& polygon, const Eigen::Vector2d& p)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.outer.size(); ++i)
    {
        const Eigen::Vector2d a = polygon.outer[i], edge = polygon.outer[(i + 1) % polygon.outer.size()] - a;
        const double t = std::clamp((p - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (a + t * edge - p).norm());
    }
    return nearest;
}

TEST(Simplify, LeavesTheCornersThatMatter)
{
    const Polygon rough = roughRectangle(6, 4, 0.1, 0.01, 1);
    const Polygon simple = simplify(rough, 0.05);
    // Four corners, and at most where noise of two points adds up.
    EXPECT_GE(simple.outer.size(), 4u);
    EXPECT_LE(simple.outer.size(), 8u);
    // No point of either boundary is farther than the tolerance from the other.
    for (const Eigen::Vector2d& p : rough.outer)
        EXPECT_LE(distanceToBoundary(simple, p), 0.05 + 1e-12);
    for (const Eigen::Vector2d& p : simple.outer)
        EXPECT_LT(distanceToBoundary(rough, p), 1e-12);  // its own points, but for rounding
    EXPECT_NEAR(area(simple), 24.0, 0.05 * perimeter(simple));
}

TEST(Simplify, WithoutToleranceKeepsWhatBends)
{
    const Polygon square{{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}, {{{0.5, 0.5}, {0.5, 1}, {1, 1}, {1, 0.5}}}};
    const Polygon simple = simplify(square, 0.0);
    EXPECT_EQ(area(simple), area(square));
    EXPECT_GE(simple.outer.size(), 4u);
    EXPECT_EQ(simple.holes.size(), 1u);
    EXPECT_EQ(simple.holes[0].size(), 4u);
}

TEST(Simplify, KeepsRingsApart)
{
    // The hole follows a bay of the outline at 2 cm: a coarser outline would run through it.
    Polygon polygon{{{0, 0}, {2, 0}, {2, 0.3}, {2.3, 0.3}, {2.3, 0}, {5, 0}, {5, 3}, {0, 3}},
                    {{{1.9, 0.32}, {1.9, 1}, {2.4, 1}, {2.4, 0.32}}}};
    const Polygon simple = simplify(polygon, 0.4);
    ASSERT_EQ(simple.holes.size(), 1u);
    for (const Eigen::Vector2d& p : simple.holes[0])
        EXPECT_TRUE(contains({simple.outer, {}}, p));
    EXPECT_GT(area(simple), 0.0);
}

TEST(Simplify, KeepsThreeCornersWhateverTheTolerance)
{
    Polygon circle;
    for (int i = 0; i < 100; ++i)
        circle.outer.emplace_back(std::cos(i * std::numbers::pi / 50), std::sin(i * std::numbers::pi / 50));
    const Polygon simple = simplify(circle, 100.0);
    EXPECT_GE(simple.outer.size(), 3u);
    EXPECT_GT(area(simple), 0.0);
    EXPECT_TRUE(simplify({}, 0.1).outer.empty());
    const Polygon triangle{{{0, 0}, {1, 0}, {0, 1}}, {}};
    EXPECT_EQ(simplify(triangle, 10.0).outer, triangle.outer);
}

}  // namespace

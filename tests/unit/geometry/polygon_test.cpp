// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{

using namespace s2b;

Ring box(double x0, double y0, double x1, double y1)
{
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// 4 m by 3 m with a hole of 1 m by 1 m.
const Polygon kFrame{box(0, 0, 4, 3), {box(1, 1, 2, 2)}};

TEST(PolygonMeasures, AreOfTheRingsWithoutTheHoles)
{
    EXPECT_EQ(signedArea(box(0, 0, 4, 3)), 12.0);
    EXPECT_EQ(signedArea(Ring{{0, 0}, {0, 1}, {1, 0}}), -0.5);
    EXPECT_EQ(area(kFrame), 11.0);
    EXPECT_EQ(perimeter(kFrame), 18.0);
    // (12 * (2, 1.5) - 1 * (1.5, 1.5)) / 11
    EXPECT_NEAR((centroid(kFrame) - Eigen::Vector2d(22.5 / 11, 1.5)).norm(), 0.0, 1e-14);
}

TEST(PolygonMeasures, DoNotDependOnTheDirectionOfTheRings)
{
    Polygon turned = kFrame;
    std::ranges::reverse(turned.outer);
    EXPECT_EQ(area(turned), 11.0);
    EXPECT_NEAR((centroid(turned) - centroid(kFrame)).norm(), 0.0, 1e-14);
    EXPECT_TRUE(contains(turned, {0.5, 0.5}));
}

TEST(PolygonMeasures, KeepPrecisionFarFromTheOrigin)
{
    const Eigen::Vector2d far(4.5e6, 5.4e6);
    Polygon moved = kFrame;
    for (Eigen::Vector2d& p : moved.outer)
        p += far;
    for (Eigen::Vector2d& p : moved.holes[0])
        p += far;
    EXPECT_EQ(area(moved), 11.0);                                               // whole numbers: no rounding at all
    EXPECT_NEAR((centroid(moved) - far - centroid(kFrame)).norm(), 0.0, 2e-9);  // the spacing of doubles there
    EXPECT_TRUE(contains(moved, far + Eigen::Vector2d(0.5, 1.5)));
    EXPECT_FALSE(contains(moved, far + Eigen::Vector2d(1.5, 1.5)));
}

TEST(PolygonMeasures, OfNothingArePlain)
{
    EXPECT_EQ(signedArea({}), 0.0);
    EXPECT_EQ(area({}), 0.0);
    EXPECT_EQ(centroid({}), Eigen::Vector2d(0, 0));
    EXPECT_FALSE(contains({}, {0, 0}));
    EXPECT_EQ(centroid({{{1, 1}, {3, 1}}, {}}), Eigen::Vector2d(2, 1));
}

TEST(PolygonContains, HasHolesOutside)
{
    EXPECT_TRUE(contains(kFrame, {0.5, 1.5}));
    EXPECT_TRUE(contains(kFrame, {3, 1.5}));
    EXPECT_FALSE(contains(kFrame, {1.5, 1.5}));
    EXPECT_FALSE(contains(kFrame, {-1, 1}));
    EXPECT_FALSE(contains(kFrame, {5, 1}));
    EXPECT_FALSE(contains(kFrame, {1, 4}));
}

TEST(PolygonContains, GivesAPointOnASharedEdgeToOnePolygon)
{
    const Polygon left{box(0, 0, 1, 2), {}};
    const Polygon right{box(1, 0, 3, 2), {}};
    const Polygon above{box(0, 2, 3, 4), {}};
    for (double t = 0.0; t <= 1.0; t += 0.125)
    {
        EXPECT_EQ(int(contains(left, {1, 2 * t * 0.99})) + int(contains(right, {1, 2 * t * 0.99})), 1) << t;
        const Eigen::Vector2d p(2.9 * t + 0.05, 2.0);
        EXPECT_EQ(int(contains(left, p)) + int(contains(right, p)) + int(contains(above, p)), 1) << t;
    }
}

TEST(CanonicalPolygon, HasDirectionsOrderAndNoRepeatedPoints)
{
    const Polygon messy{{{4, 3}, {4, 0}, {4, 0}, {0, 0}, {0, 3}, {4, 3}},
                        {box(2, 2, 3, 2.5), box(1, 1, 2, 2), {{0.5, 0.5}, {0.6, 0.6}}}};
    const Polygon result = canonical(messy);
    EXPECT_EQ(result.outer, box(0, 0, 4, 3));
    ASSERT_EQ(result.holes.size(), 2u);
    EXPECT_EQ(result.holes[0], (Ring{{1, 1}, {1, 2}, {2, 2}, {2, 1}}));
    EXPECT_EQ(result.holes[1].front(), Eigen::Vector2d(2, 2));
    EXPECT_TRUE(canonical({{{0, 0}, {1, 1}}, {}}).outer.empty());
}

}  // namespace

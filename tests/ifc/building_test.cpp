// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/building.h"

#include "sample_building.h"

#include <gtest/gtest.h>

#include <cmath>

namespace s2b
{
namespace
{

constexpr double kRounding = 1e-12;  // a few operations on numbers of the order of 10

Wall arcWall(double bulge)
{
    Wall wall;
    wall.start = {2.0, 0.0};
    wall.end = {0.0, 2.0};
    wall.bulge = bulge;
    wall.thickness.value_m = 0.2;
    wall.bodyEnd_m = wall.axisLength_m();
    return wall;
}

double signedArea(const std::vector<Eigen::Vector2d>& ring)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const Eigen::Vector2d& a = ring[i];
        const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
}

const double kQuarter = std::tan(M_PI / 8.0);  // bulge of a quarter circle

TEST(Wall, StraightLengthDirectionAndNormal)
{
    Wall wall;
    wall.start = {1.0, 1.0};
    wall.end = {4.0, 5.0};
    EXPECT_NEAR(wall.axisLength_m(), 5.0, kRounding);
    EXPECT_TRUE(wall.direction().isApprox(Eigen::Vector2d(0.6, 0.8), kRounding));
    EXPECT_TRUE(wall.normal().isApprox(Eigen::Vector2d(-0.8, 0.6), kRounding));
}

TEST(Wall, StraightOutlineFollowsBodyExtentAndIsCounterClockwise)
{
    Wall wall = test::oneWall().walls.front();
    wall.bodyStart_m = -0.1;
    wall.bodyEnd_m = 5.9;
    const auto ring = wall.outline();
    ASSERT_EQ(ring.size(), 4U);
    EXPECT_TRUE(ring[0].isApprox(Eigen::Vector2d(-0.1, -0.1), kRounding));
    EXPECT_TRUE(ring[2].isApprox(Eigen::Vector2d(5.9, 0.1), kRounding));
    EXPECT_NEAR(signedArea(ring), 6.0 * 0.2, kRounding);
}

TEST(Wall, ArcLengthAndTangent)
{
    const Wall wall = arcWall(kQuarter);  // about (0, 0), radius 2
    EXPECT_NEAR(wall.axisLength_m(), M_PI, kRounding);
    EXPECT_TRUE(wall.direction().isApprox(Eigen::Vector2d::UnitY(), kRounding));
    EXPECT_TRUE(wall.normal().isApprox(-Eigen::Vector2d::UnitX(), kRounding));
}

TEST(Wall, ClockwiseArcBendsToTheOtherSide)
{
    const Wall wall = arcWall(-kQuarter);  // about (2, 2)
    EXPECT_NEAR(wall.axisLength_m(), M_PI, kRounding);
    EXPECT_TRUE(wall.direction().isApprox(-Eigen::Vector2d::UnitX(), kRounding));
}

TEST(Wall, ArcOutlineIsCounterClockwiseForBothTurns)
{
    for (const double bulge : {kQuarter, -kQuarter, 1.0, 2.0, -2.0})
    {
        const Wall wall = arcWall(bulge);
        const double area = wall.axisLength_m() * 0.2;
        // Chords lie within 1 mm of the arcs: the area is off by less than that along both of them.
        EXPECT_NEAR(signedArea(wall.outline()), area, 0.001 * wall.axisLength_m()) << bulge;
    }
}

TEST(Wall, ArcOutlineKeepsToItsCircles)
{
    for (const Eigen::Vector2d& p : arcWall(kQuarter).outline())
        EXPECT_TRUE(std::abs(p.norm() - 1.9) < kRounding || std::abs(p.norm() - 2.1) < kRounding) << p.transpose();
}

TEST(Building, FindsStoreysAndWallsById)
{
    const Building building = test::sampleBuilding();
    ASSERT_NE(building.wall({14}), nullptr);
    EXPECT_EQ(building.wall({14})->id, ElementId{14});
    ASSERT_NE(building.storey({2}), nullptr);
    EXPECT_EQ(building.storey({2})->elevation_m, 3.1);
    EXPECT_EQ(building.wall({999}), nullptr);
    EXPECT_EQ(building.storey({}), nullptr);
}

}  // namespace
}  // namespace s2b

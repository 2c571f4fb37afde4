// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/frame.h"
#include "tests/support/stages.h"

#include <gtest/gtest.h>

#include <cmath>

namespace s2b
{
namespace
{

using test::cellsOf;
using test::HandMadeCloud;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kTolerance = 0.02 * kDegree;  // the promise of the frame: 3.5 mm over 10 m

HandMadeCloud twoRooms(double noise)
{
    HandMadeCloud cloud(0.02, noise);
    cloud.room({0, 0}, {5, 4});
    cloud.room({5.2, 0}, {8, 4});
    return cloud;
}

/// The turn that is left after the found one, modulo a quarter.
double error(double found, double truth)
{
    return std::abs(std::remainder(found - truth, std::numbers::pi / 2));
}

class DominantYaw : public testing::TestWithParam<double>
{
};

TEST_P(DominantYaw, IsFoundTo002Degrees)
{
    for (const double noise : {0.0, 0.003})
    {
        HandMadeCloud cloud = twoRooms(noise);
        cloud.move(GetParam() * kDegree, {31.4, -7.2, 1.0});
        const double yaw = findDominantYaw(cellsOf(cloud), {});
        EXPECT_LT(error(yaw, GetParam() * kDegree), kTolerance)
            << GetParam() << " degrees, " << 1000 * noise << " mm of noise: found " << yaw / kDegree;
        EXPECT_LE(std::abs(yaw), 45.001 * kDegree);
    }
}

INSTANTIATE_TEST_SUITE_P(Yaws, DominantYaw,
                         testing::Values(0.0, 0.3, 5.0, 12.345, 30.0, 44.9, 45.0, -44.9, -17.5, 60.0, 123.4));

TEST(DominantYaw, NeedsNoLabels)
{
    HandMadeCloud cloud = twoRooms(0.003);
    cloud.move(21.0 * kDegree);
    EXPECT_LT(error(findDominantYaw(cellsOf(cloud, false), {}), 21.0 * kDegree), kTolerance);
}

TEST(DominantYaw, FollowsTheLongerOfTwoDirections)
{
    HandMadeCloud cloud = twoRooms(0.0);
    cloud.wallFace({1, 1}, {1 + 2 * std::cos(0.5), 1 + 2 * std::sin(0.5)}, 0, 2.6);
    EXPECT_LT(error(findDominantYaw(cellsOf(cloud), {}), 0.0), kTolerance);
}

TEST(DominantYaw, IgnoresFurnitureAtAnotherAngle)
{
    HandMadeCloud cloud = twoRooms(0.0);
    // More vertical surface than the walls have.
    for (int i = 0; i < 30; ++i)
        cloud.wallFace({1, 1 + 0.07 * i}, {1 + 2.5 * std::cos(0.3), 1 + 0.07 * i + 2.5 * std::sin(0.3)}, 0, 2.0,
                       Label::Furniture);
    EXPECT_LT(error(findDominantYaw(cellsOf(cloud), {}), 0.0), kTolerance);
}

TEST(DominantYaw, IsZeroWithoutVerticalSurfaces)
{
    HandMadeCloud cloud;
    cloud.horizontal({0, 0}, {3, 3}, 0, Label::Floor);
    EXPECT_EQ(findDominantYaw(cellsOf(cloud), {}), 0.0);
}

TEST(RotateCells, TurnsPositionsAndNormalsBack)
{
    HandMadeCloud cloud = twoRooms(0.0);
    cloud.move(33.0 * kDegree);
    SurfaceCells cells = cellsOf(cloud);
    rotateCells(cells, 33.0 * kDegree);
    std::size_t walls = 0, along = 0;
    for (const SurfaceCell& c : cells.cells)
    {
        EXPECT_GT(c.position.x(), -1e-5f);
        EXPECT_LT(c.position.x(), 8.0f + 1e-5f);
        // Away from floor, ceiling and corners only the faces of walls along y are left.
        if (c.label == Label::Wall && std::abs(c.position.y() - 2.0f) < 1.0f && std::abs(c.position.z() - 1.3f) < 1.0f)
        {
            ++walls;
            along += std::abs(c.normal.x()) > 0.99f;
        }
    }
    EXPECT_GT(walls, 1000u);
    EXPECT_EQ(along, walls);
}

}  // namespace
}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/curved_runs.h"
#include "tests/support/stages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace s2b
{
namespace
{

using test::cellsOf;
using test::HandMadeCloud;

constexpr double kPi = std::numbers::pi;

Level levelOf(double ceiling = 2.6)
{
    Level level;
    level.ceiling_m = ceiling;
    level.ceilingSeen = true;
    return level;
}

std::vector<CurvedRun> runsOf(const HandMadeCloud& cloud, const WallParams& params = {})
{
    return findCurvedRuns(cellsOf(cloud), levelOf(), params, Context{});
}

std::size_t curvedWalls(const HandMadeCloud& cloud, bool withLabels)
{
    const WallResult r = test::storeyOf(cloud, withLabels).walls;
    return static_cast<std::size_t>(
        std::count_if(r.walls.begin(), r.walls.end(), [](const Wall& w) { return w.bulge != 0.0; }));
}

TEST(CurvedRuns, HaveTheirCircle)
{
    HandMadeCloud cloud(0.02, 0.003);
    cloud.mantle({4.0, 1.0}, 3.0, 0.0, 2.6, Label::Wall, 0.3, 1.5);
    const auto runs = runsOf(cloud);
    ASSERT_EQ(runs.size(), 1u);
    // A sagitta of 0.53 m, known to well below 1 mm: the radius to some millimetres.
    EXPECT_LT((runs[0].center - Eigen::Vector2d(4.0, 1.0)).norm(), 0.01);
    EXPECT_NEAR(runs[0].radius_m, 3.0, 0.01);
    EXPECT_NEAR(runs[0].begin_rad, 0.3, 0.03);  // ends to a place of 5 cm
    EXPECT_NEAR(runs[0].end_rad, 1.5, 0.03);
}

TEST(CurvedRuns, AreBothFacesOfAThinWall)
{
    HandMadeCloud cloud(0.02, 0.003);
    for (const double r : {3.0, 3.1})
        cloud.mantle({0.0, 0.0}, r, 0.0, 2.6, Label::Wall, 0.0, 1.2);
    auto runs = runsOf(cloud);
    ASSERT_EQ(runs.size(), 2u);
    std::vector<CurvedRun*> both{&runs[0], &runs[1]};
    alignRuns(both, 0.01);
    EXPECT_EQ(runs[0].center, runs[1].center);
    EXPECT_NEAR(std::abs(runs[0].radius_m - runs[1].radius_m), 0.1, 0.001);
}

TEST(CurvedRuns, EndWhereTheTangentGoesOnStraight)
{
    HandMadeCloud cloud(0.02, 0.003);
    cloud.mantle({0.0, 0.0}, 2.0, 0.0, 2.6, Label::Wall, 0.0, kPi / 2);
    cloud.wallFace({2.0, -3.0}, {2.0, 0.0}, 0.0, 2.6);
    cloud.wallFace({-3.0, 2.0}, {0.0, 2.0}, 0.0, 2.6);
    const auto runs = runsOf(cloud);
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_NEAR(runs[0].radius_m, 2.0, 0.005);
    // A straight line is within 6 mm of the circle for sqrt(2 * 2 * 0.006) = 0.15 m, 0.08 rad.
    EXPECT_NEAR(runs[0].begin_rad, 0.0, 0.11);
    EXPECT_NEAR(runs[0].end_rad, kPi / 2, 0.11);
}

TEST(CurvedRuns, AreNoPolygons)
{
    for (const int sides : {6, 8, 12, 16})
    {
        HandMadeCloud cloud(0.02, 0.003);
        const auto corner = [&](int i) -> Eigen::Vector2d
        { return {4 * std::cos(2 * kPi * i / sides), 4 * std::sin(2 * kPi * i / sides)}; };
        for (int i = 0; i < sides; ++i)
            cloud.wallFace(corner(i), corner(i + 1), 0.0, 2.6);
        EXPECT_TRUE(runsOf(cloud).empty()) << sides << " sides";
    }
}

TEST(CurvedRuns, AreNoPipesColumnsOrCurtains)
{
    HandMadeCloud cloud(0.02, 0.002);
    cloud.mantle({0.0, 0.0}, 0.06, 0.0, 2.6, Label::Wall);
    cloud.mantle({2.0, 0.0}, 0.40, 0.0, 2.6, Label::Wall);
    for (int i = 0; i < 16; ++i)  // a curtain: half circles of alternating sides
        cloud.mantle({4.0 + 0.2 * i, 0.0}, 0.1, 0.2, 2.4, Label::Wall, i % 2 ? kPi : 0.0, i % 2 ? 2 * kPi : kPi);
    EXPECT_TRUE(runsOf(cloud).empty());
}

TEST(CurvedRuns, AreNotLookedForWhenSwitchedOff)
{
    HandMadeCloud cloud;
    cloud.mantle({0.0, 0.0}, 3.0, 0.0, 2.6, Label::Wall, 0.0, 1.5);
    WallParams params;
    params.curved = false;
    EXPECT_TRUE(runsOf(cloud, params).empty());
}

TEST(CurvedWall, ReachesTheCeilingUnlikeACounter)
{
    for (const double top : {2.6, 1.1})
    {
        HandMadeCloud cloud(0.02, 0.002);
        cloud.fourWalls({0.0, 0.0}, {8.0, 7.0}, 0.0, 2.6);
        // Floor and ceiling up to the screen's faces; a desk has them above it.
        for (double x = 0.007; x < 8.0; x += 0.02)
            for (double y = 0.007; y < 7.0; y += 0.02)
            {
                const double r = std::hypot(x - 4.0, y - 1.0);
                const bool isWithin = r > 2.5 && r < 2.62 && std::abs(std::atan2(y - 1.0, x - 4.0) - 1.55) < 1.05;
                if (!isWithin)
                    cloud.point({x, y, 0.0}, Label::Floor);
                if (!isWithin || top < 2.0)
                    cloud.point({x, y, 2.6}, Label::Ceiling);
            }
        // A screen between the room's two halves, or a reception desk.
        cloud.mantle({4.0, 1.0}, 2.5, 0.0, top, Label::Wall, 0.5, 2.6);
        cloud.mantle({4.0, 1.0}, 2.62, 0.0, top, Label::Wall, 0.5, 2.6);
        EXPECT_EQ(curvedWalls(cloud, false), top > 2.0 ? 1u : 0u) << "top at " << top;
    }
}

}  // namespace
}  // namespace s2b

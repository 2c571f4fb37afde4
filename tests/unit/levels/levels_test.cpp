// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/levels/levels.h"
#include "tests/support/stages.h"

#include <gtest/gtest.h>

namespace s2b
{
namespace
{

using test::countCode;
using test::HandMadeCloud;
using test::levelsOf;

// Heights are medians of 10 cm columns, each the mean of the cells within 6 cm of each other: with perfect points the
// first cells of the walls may shift a column's mean by a fraction of that; 2 mm is what a level instrument reads.
constexpr double kTolerance = 0.002;

void expectLevel(const Level& level, double floor, double ceiling)
{
    EXPECT_NEAR(level.floor_m, floor, kTolerance);
    EXPECT_NEAR(level.ceiling_m, ceiling, kTolerance);
    EXPECT_TRUE(level.ceilingSeen);
}

class LevelsWithAndWithoutLabels : public testing::TestWithParam<bool>
{
};
INSTANTIATE_TEST_SUITE_P(Labels, LevelsWithAndWithoutLabels, testing::Bool(),
                         [](const auto& mode) { return mode.param ? "Labelled" : "GeometryOnly"; });

TEST_P(LevelsWithAndWithoutLabels, FindOneStorey)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {5, 4}, 0.137, 2.791);
    const LevelResult r = levelsOf(cloud, GetParam());
    ASSERT_EQ(r.levels.size(), 1u);
    expectLevel(r.levels[0], 0.137, 2.791);
    EXPECT_NEAR(r.levels[0].floorArea_m2, 20.0, 2.0);  // but for columns at the border, up to 18 m of them
    EXPECT_TRUE(r.diagnostics.empty());
}

TEST_P(LevelsWithAndWithoutLabels, FindOneStoreyIn10MillimetresOfNoise)
{
    HandMadeCloud cloud(0.02, 0.010);
    cloud.room({0, 0}, {5, 4}, 0.137, 2.791);
    const LevelResult r = levelsOf(cloud, GetParam());
    ASSERT_EQ(r.levels.size(), 1u);
    expectLevel(r.levels[0], 0.137, 2.791);
}

TEST_P(LevelsWithAndWithoutLabels, FindTwoStoreysWithASlabBetween)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {5, 4}, 0.0, 2.6);
    cloud.room({0, 0}, {5, 4}, 2.9, 5.4);
    const LevelResult r = levelsOf(cloud, GetParam());
    ASSERT_EQ(r.levels.size(), 2u);
    expectLevel(r.levels[0], 0.0, 2.6);
    expectLevel(r.levels[1], 2.9, 5.4);
}

TEST_P(LevelsWithAndWithoutLabels, FindAStoreyBelowASuspendedCeiling)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {5, 4}, 0.0, 2.4);       // suspended
    cloud.room({5.2, 0}, {11.2, 4}, 0.0, 2.8);  // slab, and more of it
    const LevelResult r = levelsOf(cloud, GetParam());
    ASSERT_EQ(r.levels.size(), 1u);
    expectLevel(r.levels[0], 0.0, 2.8);
}

TEST_P(LevelsWithAndWithoutLabels, TakeNoFurnitureTopForAStorey)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {6, 5});
    // 5 m2: more than minimumArea and minimumAreaShare, and with 1.95 m to the ceiling above it.
    cloud.horizontal({0.5, 0.5}, {3.0, 2.5}, 0.65, Label::Furniture);
    const LevelResult r = levelsOf(cloud, GetParam());
    ASSERT_EQ(r.levels.size(), 1u);
    expectLevel(r.levels[0], 0.0, 2.6);
}

TEST_P(LevelsWithAndWithoutLabels, TakeNoTerrainForAStorey)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {5, 4});
    // Ground round the building, ten times its area, without anything above it.
    for (const auto& [low, high] : {std::pair<Eigen::Vector2d, Eigen::Vector2d>{{-10, -6}, {10, -0.4}},
                                    std::pair<Eigen::Vector2d, Eigen::Vector2d>{{-10, 4.4}, {10, 9}}})
        cloud.horizontal(low, high, -0.6, Label::Unassigned);
    const LevelResult r = levelsOf(cloud, GetParam());
    ASSERT_EQ(r.levels.size(), 1u);
    expectLevel(r.levels[0], 0.0, 2.6);
}

TEST_P(LevelsWithAndWithoutLabels, FindAFloorWithoutItsCeiling)
{
    HandMadeCloud cloud;
    cloud.fourWalls({0, 0}, {5, 4}, 0.0, 2.6);
    cloud.horizontal({0, 0}, {5, 4}, 0.0, Label::Floor);
    const LevelResult r = levelsOf(cloud, GetParam());
    ASSERT_EQ(r.levels.size(), 1u);
    EXPECT_NEAR(r.levels[0].floor_m, 0.0, kTolerance);
    EXPECT_FALSE(r.levels[0].ceilingSeen);
    // The walls' tops, of which the last 2 % may be strays: 5 cm of 2.6 m.
    EXPECT_NEAR(r.levels[0].ceiling_m, 2.6, 0.06);
    EXPECT_EQ(countCode(r.diagnostics, "CeilingNotLevel"), 1u);
}

TEST_P(LevelsWithAndWithoutLabels, FindAFloorBelowASlopedRoof)
{
    HandMadeCloud cloud;
    cloud.fourWalls({0, 0}, {6, 4}, 0.0, 2.2);
    cloud.horizontal({0, 0}, {6, 4}, 0.0, Label::Floor);
    cloud.rectangle({0, 0, 2.2}, {6, 0, 0}, {0, 2, 1.5}, Label::Ceiling);
    cloud.rectangle({0, 4, 2.2}, {6, 0, 0}, {0, -2, 1.5}, Label::Ceiling);
    const LevelResult r = levelsOf(cloud, GetParam());
    ASSERT_EQ(r.levels.size(), 1u);
    EXPECT_NEAR(r.levels[0].floor_m, 0.0, kTolerance);
    EXPECT_FALSE(r.levels[0].ceilingSeen);
    EXPECT_NEAR(r.levels[0].ceiling_m, 3.7, 0.1);  // of the ridge, to a column of 10 cm at a slope of 3 in 4
    EXPECT_EQ(countCode(r.diagnostics, "CeilingNotLevel"), 1u);
}

TEST_P(LevelsWithAndWithoutLabels, KeepBothHalvesOfASplitLevel)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {5, 4}, 0.0, 2.6);
    cloud.room({5.2, 0}, {10.2, 4}, 1.4, 4.0);
    const LevelResult r = levelsOf(cloud, GetParam());
    ASSERT_EQ(r.levels.size(), 2u);
    expectLevel(r.levels[0], 0.0, 2.6);
    expectLevel(r.levels[1], 1.4, 4.0);
}

TEST_P(LevelsWithAndWithoutLabels, CountByAreaAndNotByPoints)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {6, 5});
    // A cabinet's top scanned from close by: as many points as the whole floor, 1 m2.
    HandMadeCloud top(0.003);
    top.horizontal({1, 1}, {2, 2}, 0.5, Label::Floor);
    for (const Eigen::Vector3f& p : top.cloud().points)
        cloud.point(p.cast<double>(), Label::Floor);
    const LevelResult r = levelsOf(cloud, GetParam());
    ASSERT_EQ(r.levels.size(), 1u);
    expectLevel(r.levels[0], 0.0, 2.6);
}

TEST(Levels, ExplainThatThereIsNothingHorizontal)
{
    HandMadeCloud cloud;
    cloud.fourWalls({0, 0}, {5, 4}, 0.0, 2.6);
    const LevelResult r = levelsOf(cloud);
    EXPECT_TRUE(r.levels.empty());
    EXPECT_EQ(countCode(r.diagnostics, "NoHorizontalSurface"), 1u);
}

/// Without a ceiling the ground around a house is the largest surface; the floor is a step above it.
TEST(Levels, AreAboveTheTerrainWhereNoCeilingWasSeen)
{
    HandMadeCloud cloud(0.04);
    cloud.horizontal({0, 0}, {6, 5}, 0.0, Label::Unassigned);
    cloud.fourWalls({0, 0}, {6, 5}, 0.0, 2.6);
    cloud.horizontal({-6, -6}, {12, -0.3}, -0.2, Label::Unassigned);
    cloud.horizontal({-6, 5.3}, {12, 11}, -0.2, Label::Unassigned);
    const CloudView bare = cloud.view(false);
    const LevelResult result = findLevels(buildSurfaceCells(bare, {}, {}, {}), {}, {});
    ASSERT_EQ(result.levels.size(), 1u);
    EXPECT_NEAR(result.levels[0].floor_m, 0.0, 0.01);
}

TEST(Levels, ExplainThatThereIsNoFloor)
{
    HandMadeCloud cloud;
    cloud.horizontal({0, 0}, {5, 4}, 2.6, Label::Ceiling);
    const LevelResult r = levelsOf(cloud);
    EXPECT_TRUE(r.levels.empty());
    EXPECT_EQ(countCode(r.diagnostics, "NoFloor"), 1u);
}

}  // namespace
}  // namespace s2b

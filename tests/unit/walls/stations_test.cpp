// SPDX-License-Identifier: GPL-3.0-or-later
/// What the scanner's stations decide that the points alone leave open.
#include "tests/support/plan_geometry.h"
#include "tests/support/stages.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace s2b
{
namespace
{

using test::HandMadeCloud;
using test::levelsOf;
using test::storeyOf;
using test::wallThrough;

const Eigen::Vector2d kAlongX = Eigen::Vector2d::UnitX(), kAlongY = Eigen::Vector2d::UnitY();

class Stations : public testing::TestWithParam<bool>
{
};
INSTANTIATE_TEST_SUITE_P(Labels, Stations, testing::Bool(),
                         [](const auto& mode) { return mode.param ? "Labelled" : "GeometryOnly"; });

/// A room of 6 m by 5 m whose floor and ceiling were seen in the middle only, as with furniture along the walls and
/// beams.
HandMadeCloud hallWithHiddenEdges()
{
    HandMadeCloud cloud;
    cloud.standAt({3, 2.5, 1.5});
    cloud.fourWalls({0, 0}, {6, 5}, 0, 2.6);
    cloud.horizontal({1.0, 1.0}, {5.0, 4.0}, 0, Label::Floor);
    cloud.horizontal({1.0, 1.0}, {5.0, 4.0}, 2.6, Label::Ceiling);
    return cloud;
}

TEST(Stations, PutTheUnseenBodyBehindTheFace)
{
    HandMadeCloud cloud = hallWithHiddenEdges();
    const auto result = storeyOf(cloud);
    ASSERT_EQ(result.walls.walls.size(), 4U);
    for (const Wall& w : result.walls.walls)
    {
        const Eigen::Vector2d middle = (w.start + w.end) / 2;
        EXPECT_TRUE(middle.x() < 0 || middle.x() > 6 || middle.y() < 0 || middle.y() > 5) << middle.transpose();
        EXPECT_EQ(w.evidence.facesSeen, 1);
    }
    // Nothing else in the cloud says it.
    cloud.forgetStations();
    EXPECT_TRUE(storeyOf(cloud).walls.walls.empty());
}

TEST(Stations, ServeWithoutTheirPointsToo)
{
    HandMadeCloud cloud = hallWithHiddenEdges();
    cloud.forgetStationOfPoints();
    EXPECT_EQ(storeyOf(cloud).walls.walls.size(), 4U);
}

TEST_P(Stations, KeepTheOuterFaceOfAThickExternalWall)
{
    // The ceiling was not seen near the wall, which is 0.5 m thick: its outer face has nothing of the storey beside it.
    HandMadeCloud cloud;
    cloud.standAt({3, 2.5, 1.5});
    cloud.fourWalls({0, 0}, {6, 5}, 0, 2.6);
    cloud.horizontal({0, 0}, {6, 4.6}, 0, Label::Floor);
    cloud.horizontal({0, 0}, {6, 4.6}, 2.6, Label::Ceiling);
    cloud.standAt({3, 9, 1.5});
    cloud.wallFace({-0.5, 5.5}, {6.5, 5.5}, 0, 2.6);
    const auto outer = [&]
    {
        const auto result = storeyOf(cloud, GetParam());
        const Wall* wall = wallThrough(result.walls.walls, {3, 5.25}, kAlongX);
        return wall ? wall->thickness : Dimension{};
    };
    EXPECT_EQ(outer().provenance, Provenance::Measured);
    EXPECT_NEAR(outer().value_m, 0.5, 0.002);
    if (GetParam())
        return;
    cloud.forgetStations();
    EXPECT_EQ(outer().provenance, Provenance::Assumed);
}

TEST_P(Stations, LeaveAFenceOutside)
{
    HandMadeCloud cloud;
    cloud.standAt({3, 2.5, 1.5});
    cloud.room({0, 0}, {6, 5});
    cloud.standAt({3, 9, 1.5});
    cloud.wallFace({0, 12}, {6, 12}, 0, 2.6, Label::Unassigned);
    EXPECT_EQ(storeyOf(cloud, GetParam()).walls.walls.size(), 4U);
}

TEST(Stations, KeepALowPartitionOfTwoFacesUnderOneCeiling)
{
    // Without labels: screens of an open-plan office, 0.15 m thick and 2 m high; the ceiling runs on above them.
    HandMadeCloud cloud;
    cloud.standAt({2, 2.5, 1.5});
    cloud.horizontal({0, 0}, {3.9, 5}, 0, Label::Floor);
    cloud.wallFace({3.9, 1}, {3.9, 4}, 0, 2.4);
    cloud.wallFace({0, 0}, {0, 5}, 0, 2.6);
    cloud.standAt({6, 2.5, 1.5});
    cloud.horizontal({4.05, 0}, {8, 5}, 0, Label::Floor);
    cloud.wallFace({4.05, 1}, {4.05, 4}, 0, 2.4);
    cloud.wallFace({8, 0}, {8, 5}, 0, 2.6);
    cloud.wallFace({0, 0}, {8, 0}, 0, 2.6);
    cloud.wallFace({0, 5}, {8, 5}, 0, 2.6);
    cloud.horizontal({0, 0}, {8, 5}, 2.6, Label::Ceiling);
    const auto result = storeyOf(cloud, false);
    const Wall* screen = wallThrough(result.walls.walls, {3.975, 2.5}, kAlongY);
    ASSERT_NE(screen, nullptr);
    EXPECT_NEAR(screen->thickness.value_m, 0.15, 0.002);
    EXPECT_EQ(screen->evidence.facesSeen, 2);
}

TEST(Stations, TellACeilingFromAFloor)
{
    // A hall that goes on above a suspended ceiling: that ceiling's upper side was not seen. Without stations it could
    // be the floor of another storey.
    HandMadeCloud cloud;
    cloud.standAt({2, 2.5, 1.5});
    cloud.room({0, 0}, {8, 5}, 0, 2.6);
    cloud.horizontal({0, 0}, {8, 5}, 5.4, Label::Ceiling);
    cloud.fourWalls({0, 0}, {8, 5}, 2.6, 5.4);
    EXPECT_EQ(levelsOf(cloud, false).levels.size(), 1U);
    cloud.forgetStations();
    EXPECT_EQ(levelsOf(cloud, false).levels.size(), 2U);
}

TEST(Stations, ThatContradictEachOtherDecideNothing)
{
    // Half of each cell's points claim to be measured from the mirrored place behind the wall.
    HandMadeCloud cloud = hallWithHiddenEdges();
    for (const double x : {0.0, 6.0})
    {
        cloud.standAt({2 * x - 3, 2.5, 1.5});
        cloud.wallFace({x, 0}, {x, 5}, 0, 2.6);
    }
    const auto result = storeyOf(cloud);
    EXPECT_EQ(wallThrough(result.walls.walls, {-0.1, 2.5}, kAlongY), nullptr);
}

}  // namespace
}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
/// One consistent plan: what holds at corners, T and X junctions and across doorways (docs/conventions.md).
#include "core/walls/topology.h"
#include "core/walls/evidence.h"
#include "core/walls/face.h"
#include "tests/support/plan_geometry.h"
#include "tests/support/stages.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace s2b
{
namespace
{

using test::HandMadeCloud;
using test::RoomGaps;
using test::storeyOf;
using test::wallThrough;

const Eigen::Vector2d kAlongX = Eigen::Vector2d::UnitX(), kAlongY = Eigen::Vector2d::UnitY();
constexpr double kExact = 1e-9;         // doubles of a few metres: what "exactly" can mean
constexpr double kNoOverlap_m2 = 1e-6;  // a thousandth of a millimetre over a metre

std::size_t countJunctions(const WallResult& walls, bool isCorner)
{
    return static_cast<std::size_t>(
        std::count_if(walls.junctions.begin(), walls.junctions.end(), [&](const Junction& j)
                      { return isCorner == (j.endA != JunctionEnd::Path && j.endB != JunctionEnd::Path); }));
}

void expectConsistent(const WallResult& walls)
{
    EXPECT_LT(test::largestJunctionGap(walls.walls, walls.junctions), kExact);
    EXPECT_LT(test::largestOverlap(walls.walls), kNoOverlap_m2);
    for (const Wall& w : walls.walls)
    {
        EXPECT_GT(test::bodyLength(w), 0.0);
        EXPECT_GT(w.thickness.value_m, 0.0);
    }
}

/// A house of one room of 5 m by 3.5 m with walls of 0.3 m, scanned from inside and outside.
HandMadeCloud house(double noise = 0.0)
{
    HandMadeCloud cloud(0.02, noise);
    cloud.room({0.3, 0.3}, {5.3, 3.8});
    cloud.fourWalls({0, 0}, {5.6, 4.1}, 0, 2.6);
    return cloud;
}

TEST(Topology, ClosesTheCornersOfARoom)
{
    for (const double noise : {0.0, 0.003})
    {
        const WallResult walls = storeyOf(house(noise)).walls;
        ASSERT_EQ(walls.walls.size(), 4u);
        expectConsistent(walls);
        EXPECT_EQ(countJunctions(walls, true), 4u);
        EXPECT_EQ(countJunctions(walls, false), 0u);
        for (const Wall& w : walls.walls)
        {
            EXPECT_NEAR(w.thickness.value_m, 0.3, 0.001);
            const bool isLong = std::abs(w.direction().x()) > 0.5;
            EXPECT_NEAR(w.axisLength_m(), isLong ? 5.3 : 3.8, 0.001);
            // The longer wall runs through to the other's far face, the shorter one ends at its near face.
            EXPECT_NEAR(test::bodyLength(w), isLong ? 5.6 : 3.5, 0.001);
        }
        // No hole is left in a corner.
        for (const Eigen::Vector2d& p : {Eigen::Vector2d(0.01, 0.01), Eigen::Vector2d(5.59, 0.01),
                                         Eigen::Vector2d(5.59, 4.09), Eigen::Vector2d(0.01, 4.09)})
            EXPECT_TRUE(test::isInSomeBody(walls.walls, p)) << p.transpose();
    }
}

TEST(Topology, CutsAPartitionAtTheWallsThatItEndsOn)
{
    HandMadeCloud cloud;
    cloud.room({0.3, 0.3}, {3.3, 3.8});
    cloud.room({3.5, 0.3}, {7.3, 3.8});
    cloud.fourWalls({0, 0}, {7.6, 4.1}, 0, 2.6);
    const WallResult walls = storeyOf(cloud).walls;
    ASSERT_EQ(walls.walls.size(), 5u);
    expectConsistent(walls);
    EXPECT_EQ(countJunctions(walls, true), 4u);
    EXPECT_EQ(countJunctions(walls, false), 2u);
    const Wall* partition = wallThrough(walls.walls, {3.4, 2}, kAlongY);
    ASSERT_NE(partition, nullptr);
    EXPECT_NEAR(partition->axisLength_m(), 3.8, 0.001);     // from axis to axis
    EXPECT_NEAR(test::bodyLength(*partition), 3.5, 0.001);  // from face to face
    EXPECT_NEAR(partition->bodyStart_m, 0.15, 0.001);
    // The long walls are not split by it.
    EXPECT_NEAR(test::bodyLength(*wallThrough(walls.walls, {3.4, 0.15}, kAlongX)), 7.6, 0.001);
}

TEST(Topology, FillsACrossingOfFourRooms)
{
    HandMadeCloud cloud;
    for (const double x : {0.3, 4.5})
        for (const double y : {0.3, 3.7})
            cloud.room({x, y}, {x + 4.0, y + 3.2});
    cloud.fourWalls({0, 0}, {8.8, 7.2}, 0, 2.6);
    const WallResult walls = storeyOf(cloud).walls;
    expectConsistent(walls);
    EXPECT_TRUE(test::isInSomeBody(walls.walls, {4.4, 3.6}));  // the middle of the crossing
    for (const Eigen::Vector2d& p :
         {Eigen::Vector2d(2, 3.6), Eigen::Vector2d(7, 3.6), Eigen::Vector2d(4.4, 2), Eigen::Vector2d(4.4, 5)})
        EXPECT_TRUE(test::isInSomeBody(walls.walls, p)) << p.transpose();
    for (const Eigen::Vector2d& room :
         {Eigen::Vector2d(2, 2), Eigen::Vector2d(7, 2), Eigen::Vector2d(2, 5), Eigen::Vector2d(7, 5)})
        EXPECT_FALSE(test::isInSomeBody(walls.walls, room)) << room.transpose();
    const Wall* across = wallThrough(walls.walls, {4.4, 2}, kAlongY);
    const Wall* along = wallThrough(walls.walls, {2, 3.6}, kAlongX);
    ASSERT_TRUE(across && along);
    EXPECT_NEAR(across->thickness.value_m, 0.2, 0.001);
    EXPECT_NEAR(along->thickness.value_m, 0.2, 0.001);
    // Each stretch reaches an exact common point with the crossing wall: at least one T there and one at each outer
    // wall.
    EXPECT_GE(countJunctions(walls, false), 4u);
}

/// Two ends of bodies from different faces may miss each other by centimetres; a passage is wider than that.
TEST(Topology, ClosesACrackWhateverIsSeenInIt)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {4, 3});
    Level level;
    level.ceiling_m = 2.6, level.ceilingSeen = true, level.ceilings = {2.6};
    const PlanMask mask(test::cellsOf(cloud), level);
    WallBody first;
    first.low = 1.4, first.high = 1.5, first.lowSeen = first.highSeen = true, first.begin = 0.5, first.end = 2.0;
    WallBody second = first;
    second.lowSeen = false, second.end = 3.5;
    for (const auto& [gap, count] : {std::pair(0.08, 1u), std::pair(0.4, 2u)})
    {
        second.begin = first.end + gap;
        EXPECT_EQ(mergeBodies({first, second}, mask, {}).size(), count) << gap << " m of open room between them";
    }
}

TEST(Topology, KeepsOneWallAcrossADoorway)
{
    HandMadeCloud cloud;
    RoomGaps west, east;
    west.east = east.west = {{1.0, 1.9, 0.0, 2.1}};
    cloud.room({0, 0}, {4, 3}, 0, 2.6, west);
    cloud.room({4.2, 0}, {8, 3}, 0, 2.6, east);
    const WallResult walls = storeyOf(cloud).walls;
    expectConsistent(walls);
    const Wall* before = wallThrough(walls.walls, {4.1, 0.5}, kAlongY);
    const Wall* after = wallThrough(walls.walls, {4.1, 2.5}, kAlongY);
    ASSERT_NE(before, nullptr);
    EXPECT_EQ(before, after);
}

TEST(Topology, KeepsOneWallAcrossACupboardThatHidesIt)
{
    HandMadeCloud cloud;
    RoomGaps gaps;
    gaps.south = {{1.5, 1.9, 0.0, 2.6}};  // 0.4 m of it, below walls.mergeGap, from both rooms
    RoomGaps other;
    other.north = gaps.south;
    cloud.room({0, 0}, {5, 3}, 0, 2.6, gaps);
    cloud.room({0, -3.2}, {5, -0.2}, 0, 2.6, other);
    const WallResult walls = storeyOf(cloud).walls;
    expectConsistent(walls);
    const Wall* before = wallThrough(walls.walls, {0.7, -0.1}, kAlongX);
    ASSERT_NE(before, nullptr);
    EXPECT_EQ(before, wallThrough(walls.walls, {3.5, -0.1}, kAlongX));
}

TEST(Topology, KeepsTwoWallsWhereTheRoomLiesBetween)
{
    // One room of 8 m by 5 m; two walls of one line stand in it with a passage of 1.2 m between them, open to the
    // ceiling.
    HandMadeCloud cloud;
    const std::vector<test::Gap> below{{4.0, 4.2, 0.0, 2.0}, {4.0, 4.2, 3.2, 5.0}};
    cloud.fourWalls({0, 0}, {8, 5}, 0, 2.6, {.south = {{4.0, 4.2, 0, 2.6}}, .north = {{4.0, 4.2, 0, 2.6}}});
    cloud.horizontal({0, 0}, {8, 5}, 0, Label::Floor, below);
    cloud.horizontal({0, 0}, {8, 5}, 2.6, Label::Ceiling, below);
    for (const double x : {4.0, 4.2})
    {
        cloud.wallFace({x, 0}, {x, 2}, 0, 2.6);
        cloud.wallFace({x, 3.2}, {x, 5}, 0, 2.6);
    }
    cloud.wallFace({4.0, 2}, {4.2, 2}, 0, 2.6);
    cloud.wallFace({4.0, 3.2}, {4.2, 3.2}, 0, 2.6);
    for (const bool withLabels : {true, false})
    {
        const WallResult walls = storeyOf(cloud, withLabels).walls;
        expectConsistent(walls);
        EXPECT_FALSE(test::isInSomeBody(walls.walls, {4.1, 2.6})) << "the passage is walled up";
        const Wall* before = wallThrough(walls.walls, {4.1, 1.0}, kAlongY);
        const Wall* after = wallThrough(walls.walls, {4.1, 4.0}, kAlongY);
        ASSERT_TRUE(before && after);
        EXPECT_NE(before, after);
        // The free ends stand where the points end, to a bin of the faces.
        EXPECT_NEAR(std::max(before->outline()[0].y(), before->outline()[1].y()), 2.0, Face::kBin_m);
        EXPECT_NEAR(std::min(after->outline()[0].y(), after->outline()[1].y()), 3.2, Face::kBin_m);
    }
}

TEST(Topology, KeepsACubicle)
{
    // A room of 4 m by 3 m with a WC cubicle of 0.9 m by 1.4 m in its corner, walls of 0.08 m (D3.6, 6.2, loses these).
    HandMadeCloud cloud;
    cloud.fourWalls({0, 0}, {4, 3}, 0, 2.6, {.south = {{0.9, 0.98, 0, 2.6}}, .west = {{1.4, 1.48, 0, 2.6}}});
    const std::vector<test::Gap> below{{0.9, 0.98, 0, 1.48}, {0, 0.98, 1.4, 1.48}};
    cloud.horizontal({0, 0}, {4, 3}, 0, Label::Floor, below);
    cloud.horizontal({0, 0}, {4, 3}, 2.6, Label::Ceiling, below);
    cloud.wallFace({0.9, 0}, {0.9, 1.4}, 0, 2.6);
    cloud.wallFace({0.98, 0}, {0.98, 1.48}, 0, 2.6);
    cloud.wallFace({0, 1.4}, {0.9, 1.4}, 0, 2.6);
    cloud.wallFace({0, 1.48}, {0.98, 1.48}, 0, 2.6);
    const WallResult walls = storeyOf(cloud).walls;
    expectConsistent(walls);
    const Wall* across = wallThrough(walls.walls, {0.94, 0.7}, kAlongY, 0.06);
    const Wall* along = wallThrough(walls.walls, {0.45, 1.44}, kAlongX, 0.06);
    ASSERT_TRUE(across && along);
    EXPECT_NEAR(across->thickness.value_m, 0.08, 0.001);
    EXPECT_NEAR(along->thickness.value_m, 0.08, 0.001);
}

TEST(Topology, MeetsAtASlant)
{
    // A room whose end wall stands at 60 degrees.
    HandMadeCloud cloud;
    const Eigen::Vector2d a(0, 0), b(6, 0), c(6 - 3.5 / std::tan(std::numbers::pi / 3), 3.5), d(0, 3.5);
    cloud.wallFace(a, b, 0, 2.6);
    cloud.wallFace(b, c, 0, 2.6);
    cloud.wallFace(c, d, 0, 2.6);
    cloud.wallFace(d, a, 0, 2.6);
    HandMadeCloud plates;
    plates.horizontal({0, 0}, {6, 3.5}, 0, Label::Floor);
    plates.horizontal({0, 0}, {6, 3.5}, 2.6, Label::Ceiling);
    for (std::size_t i = 0; i < plates.size(); ++i)
    {
        const Eigen::Vector3d p = plates.cloud().points[i].cast<double>();
        if (test::cross(c - b, p.head<2>() - b) > 0)
            cloud.point(p, plates.cloud().labels[i]);
    }
    const WallResult walls = storeyOf(cloud).walls;
    ASSERT_EQ(walls.walls.size(), 4u);
    EXPECT_LT(test::largestJunctionGap(walls.walls, walls.junctions), kExact);
    EXPECT_EQ(countJunctions(walls, true), 4u);
    EXPECT_LT(test::largestOverlap(walls.walls), kNoOverlap_m2);
}

TEST(Plan, DropsShortPiecesThatMeetNothing)
{
    const auto wall = [](double begin, double end)
    {
        PlanWall w;
        w.body.begin = w.axisBegin = begin;
        w.body.end = w.axisEnd = end;
        return w;
    };
    Plan plan;
    plan.walls = {wall(0, 0.4), wall(1, 5), wall(6, 6.4), wall(7, 7.7)};
    plan.junctions = {{2, false, 1, 1, {}}};
    dropFreePieces(plan, 0.6);
    ASSERT_EQ(plan.walls.size(), 3u);  // without the first: it is short and meets none
    EXPECT_EQ(plan.walls[0].body.end, 5);
    EXPECT_EQ(plan.junctions[0].wall, 1u);
    EXPECT_EQ(plan.junctions[0].other, 0u);
}

TEST(SeenShare, CountsPlacesByWhatCoversThem)
{
    // Of a wall of 2 m x 2 m a face covers the lower half.
    WallBody body;
    body.end = 2.0, body.top = 2.0, body.lowFaces = {0};
    Face face;
    face.end = 2.0;
    face.rows.assign(40, 0b11'1111'1111);
    face.area_m2 = 2.0;
    constexpr double cell_m = 0.02;
    EXPECT_NEAR(seenShare(body, {face}, cell_m), 0.5, 1e-9);
    face.area_m2 = 0.07;  // a tenth of what a surface seen from afar covers
    EXPECT_NEAR(seenShare(body, {face}, cell_m), 0.05, 1e-9);
    // A thin scan: every other place in both directions shows a point, and cells are as large as its spacing.
    for (std::size_t b = 0; b < face.rows.size(); ++b)
        face.rows[b] = b % 2 ? 0 : 0b01'0101'0101;
    face.area_m2 = 1.0;
    EXPECT_NEAR(seenShare(body, {face}, 0.1), 0.5, 0.05);
}

}  // namespace
}  // namespace s2b

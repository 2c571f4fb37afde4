// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/plan_geometry.h"
#include "tests/support/stages.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace s2b
{
namespace
{

using test::Gap;
using test::HandMadeCloud;
using test::RoomGaps;
using test::storeyOf;

// Edges of holes are read off points 2 cm apart, sorted into cells of 2 cm.
constexpr double kEdge_m = 0.02 + 1e-9;  // a cell, and its rounding

/// Two rooms of 4 m by 3 m with a partition of 0.2 m at x = 4 ... 4.2, and a hole in it: [y, y + width] x [sill, head].
struct HoleInPartition
{
    double y = 1.0, width = 0.9, sill = 0.0, head = 2.1;

    [[nodiscard]] HandMadeCloud cloud(double noise = 0.0) const
    {
        HandMadeCloud c(0.02, noise);
        RoomGaps west, east;
        west.east = east.west = {{y, y + width, sill, head}};
        c.room({0, 0}, {4, 3}, 0, 2.6, west);
        c.room({4.2, 0}, {8.2, 3}, 0, 2.6, east);
        return c;
    }
    /// Jambs, head and sill: what is seen of the wall's inside; and the floor when the hole reaches it.
    void addReveals(HandMadeCloud& c, Label label = Label::Wall) const
    {
        c.wallFace({4, y}, {4.2, y}, sill, head, label);
        c.wallFace({4, y + width}, {4.2, y + width}, sill, head, label);
        c.horizontal({4, y}, {4.2, y + width}, head, label);
        c.horizontal({4, y}, {4.2, y + width}, sill, sill > 0 ? label : Label::Floor);
    }
    /// Something that fills the hole, in the wall's middle.
    void addPanel(HandMadeCloud& c, Label label) const { c.wallFace({4.1, y}, {4.1, y + width}, sill, head, label); }
};

void expectHole(const test::StoreyResult& r, const Opening& o, const HoleInPartition& hole)
{
    const auto host =
        std::find_if(r.walls.walls.begin(), r.walls.walls.end(), [&](const Wall& w) { return w.id == o.host; });
    ASSERT_NE(host, r.walls.walls.end());
    EXPECT_NEAR(host->start.x(), 4.1, 0.001) << "in another wall";
    const Eigen::Vector2d from = host->start + host->direction() * o.offset_m,
                          to = from + host->direction() * o.width.value_m;
    EXPECT_NEAR(std::min(from.y(), to.y()), hole.y, kEdge_m);
    EXPECT_NEAR(o.width.value_m, hole.width, 2 * kEdge_m);
    EXPECT_NEAR(o.sill.value_m, hole.sill, kEdge_m);
    EXPECT_NEAR(o.sill.value_m + o.height.value_m, hole.head, kEdge_m);
}

TEST(Openings, FindAClosedDoorByItsLabel)
{
    const HoleInPartition hole;
    HandMadeCloud cloud = hole.cloud();
    hole.addPanel(cloud, Label::Door);
    const auto r = storeyOf(cloud);
    ASSERT_EQ(r.openings.openings.size(), 1u);
    const Opening& door = r.openings.openings[0];
    EXPECT_EQ(door.kind, OpeningKind::Door);
    EXPECT_EQ(door.leafState, LeafState::Closed);
    EXPECT_EQ(door.evidence.labelShare, 1.0);
    EXPECT_GT(door.evidence.points, 4000u);  // of 4725 on the leaf
    expectHole(r, door, hole);
}

TEST(Openings, FindAnOpenDoorByItsVoidAndItsLeaf)
{
    for (const bool hingeIsLow : {true, false})
        for (const bool opensEast : {true, false})
        {
            const HoleInPartition hole;
            HandMadeCloud cloud = hole.cloud();
            hole.addReveals(cloud);
            const double x = opensEast ? 4.2 : 4.0, y = hingeIsLow ? hole.y : hole.y + hole.width;
            cloud.wallFace({x, y}, {x + (opensEast ? 0.85 : -0.85), y}, 0.01, 2.05, Label::Door);
            const auto r = storeyOf(cloud);
            ASSERT_EQ(r.openings.openings.size(), 1u);
            const Opening& door = r.openings.openings[0];
            EXPECT_EQ(door.kind, OpeningKind::Door);
            EXPECT_EQ(door.leafState, LeafState::Open);
            EXPECT_EQ(door.leaves, 1);
            expectHole(r, door, hole);
            const Wall& host = *std::find_if(r.walls.walls.begin(), r.walls.walls.end(),
                                             [&](const Wall& w) { return w.id == door.host; });
            EXPECT_EQ(door.hingeAtStart, (host.direction().y() > 0) == hingeIsLow) << hingeIsLow << opensEast;
            EXPECT_EQ(door.opensToLeft, (host.normal().x() > 0) == opensEast) << hingeIsLow << opensEast;
        }
}

/// A leaf of 4 cm that stands out from a jamb at a right angle, to x > 4.2.
void addLeaf(HandMadeCloud& c, double hinge, double width, double top)
{
    for (const double y : {hinge - 0.02, hinge + 0.02})
        c.wallFace({4.2, y}, {4.2 + width, y}, 0.01, top, Label::Unassigned);
}

TEST(Openings, FindAnOpenLeafByItsShape)
{
    for (const bool hingeIsLow : {true, false})
    {
        const HoleInPartition hole;
        HandMadeCloud cloud = hole.cloud();
        hole.addReveals(cloud);
        addLeaf(cloud, hingeIsLow ? hole.y + 0.02 : hole.y + hole.width - 0.02, 0.85, 2.05);
        const auto r = storeyOf(cloud, false);
        ASSERT_EQ(r.openings.openings.size(), 1u);
        const Opening& door = r.openings.openings[0];
        EXPECT_EQ(door.kind, OpeningKind::Door);
        EXPECT_EQ(door.leafState, LeafState::Open);
        EXPECT_EQ(door.leaves, 1);
        const Wall& host =
            *std::find_if(r.walls.walls.begin(), r.walls.walls.end(), [&](const Wall& w) { return w.id == door.host; });
        EXPECT_EQ(door.hingeAtStart, (host.direction().y() > 0) == hingeIsLow);
        EXPECT_EQ(door.opensToLeft, host.normal().x() > 0);
        expectHole(r, door, hole);
    }
}

TEST(Openings, FindTheTwoLeavesOfADoubleDoorByTheirShape)
{
    const HoleInPartition hole{0.6, 1.8, 0.0, 2.1};
    HandMadeCloud cloud = hole.cloud();
    hole.addReveals(cloud);
    addLeaf(cloud, hole.y + 0.02, 0.88, 2.05);
    addLeaf(cloud, hole.y + hole.width - 0.02, 0.88, 2.05);
    const auto r = storeyOf(cloud, false);
    ASSERT_EQ(r.openings.openings.size(), 1u);
    EXPECT_EQ(r.openings.openings[0].kind, OpeningKind::Door);
    EXPECT_EQ(r.openings.openings[0].leafState, LeafState::Open);
    EXPECT_EQ(r.openings.openings[0].leaves, 2);
}

TEST(Openings, TakeNoWallBesideAHoleForItsLeaf)
{
    // It stands where a leaf would, and goes on above the head or beyond the leaf's width.
    for (const auto& [width, top] : {std::pair(0.85, 2.6), std::pair(2.5, 2.05)})
    {
        const HoleInPartition hole;
        HandMadeCloud cloud = hole.cloud();
        hole.addReveals(cloud);
        addLeaf(cloud, hole.y - 0.1, width, top);
        for (const Opening& o : storeyOf(cloud, false).openings.openings)
            EXPECT_NE(o.leafState, LeafState::Open) << width << " m wide, " << top << " m high";
    }
}

TEST(Openings, FindTheWindowBehindFurniture)
{
    // A cupboard hides the western face from the floor to above the sill; the eastern face was not seen at all.
    const HoleInPartition hole{0.8, 1.4, 0.9, 2.2};
    HandMadeCloud cloud;
    RoomGaps gaps;
    gaps.east = {{hole.y, hole.y + hole.width, hole.sill, hole.head},
                 {hole.y - 0.2, hole.y + hole.width + 0.1, 0.0, 0.9}};
    cloud.room({0, 0}, {4, 3}, 0, 2.6, gaps);
    hole.addReveals(cloud);
    cloud.wallFace({4.12, hole.y}, {4.12, hole.y + hole.width}, hole.sill, hole.head, Label::Unassigned);  // the pane
    const auto r = storeyOf(cloud, false);
    ASSERT_EQ(r.openings.openings.size(), 1u);
    const Opening& window = r.openings.openings[0];
    EXPECT_EQ(window.kind, OpeningKind::Window);
    EXPECT_NEAR(window.sill.value_m, hole.sill, kEdge_m);
    EXPECT_NEAR(window.width.value_m, hole.width, 2 * kEdge_m);
    EXPECT_NEAR(window.sill.value_m + window.height.value_m, hole.head, kEdge_m);
}

TEST(Openings, FindAWindowNextToACorner)
{
    // The pier between the window and the corner is narrower than the squares that faces are seen in.
    const HoleInPartition hole{0.03, 1.4, 0.9, 2.2};
    HandMadeCloud cloud;
    RoomGaps gaps;
    gaps.east = {{hole.y, hole.y + hole.width, hole.sill, hole.head}};
    cloud.room({0, 0}, {4, 3}, 0, 2.6, gaps);
    hole.addReveals(cloud);
    hole.addPanel(cloud, Label::Unassigned);
    const auto r = storeyOf(cloud, false);
    ASSERT_EQ(r.openings.openings.size(), 1u);
    EXPECT_EQ(r.openings.openings[0].kind, OpeningKind::Window);
    EXPECT_NEAR(r.openings.openings[0].width.value_m, hole.width, 2 * kEdge_m);
    EXPECT_NEAR(r.openings.openings[0].sill.value_m, hole.sill, kEdge_m);
}

TEST(Openings, MeasureADoorWithItsFrame)
{
    // A frame of 5 cm all around leaves a clear way of 0.8 m by 2.05 m; the faces end about the frame.
    const HoleInPartition hole;
    constexpr double frame = 0.05, front = 4.05, back = 4.15;
    HandMadeCloud cloud = hole.cloud();
    const double left = hole.y + frame, right = hole.y + hole.width - frame, top = hole.head - frame;
    for (const double x : {front, back})
    {
        cloud.wallFace({x, hole.y}, {x, left}, 0.0, hole.head, Label::Unassigned);
        cloud.wallFace({x, right}, {x, hole.y + hole.width}, 0.0, hole.head, Label::Unassigned);
        cloud.wallFace({x, left}, {x, right}, top, hole.head, Label::Unassigned);
    }
    for (const double y : {left, right})
        cloud.wallFace({front, y}, {back, y}, 0.0, top, Label::Unassigned);
    cloud.horizontal({front, left}, {back, right}, top, Label::Unassigned);
    cloud.horizontal({4, left}, {4.2, right}, 0.0, Label::Floor);
    const auto r = storeyOf(cloud, false);
    ASSERT_EQ(r.openings.openings.size(), 1u);
    EXPECT_EQ(r.openings.openings[0].kind, OpeningKind::Door);
    expectHole(r, r.openings.openings[0], hole);
}

TEST(Openings, FindADoorWhoseLeafIsGone)
{
    const HoleInPartition hole;
    for (const double noise : {0.0, 0.003})
    {
        HandMadeCloud cloud = hole.cloud(noise);
        hole.addReveals(cloud);
        const auto r = storeyOf(cloud);
        ASSERT_EQ(r.openings.openings.size(), 1u);
        EXPECT_EQ(r.openings.openings[0].kind, OpeningKind::Door);
        EXPECT_EQ(r.openings.openings[0].leafState, LeafState::Removed);
        expectHole(r, r.openings.openings[0], hole);
        // Its size alone says that it is a door, and the report says so.
        EXPECT_EQ(test::countCode(r.openings.diagnostics, "NoLeafSeen"), 1u);
    }
}

TEST(Openings, FindAWindowWithItsSill)
{
    const HoleInPartition hole{0.8, 1.4, 0.9, 2.2};
    HandMadeCloud cloud = hole.cloud();
    hole.addReveals(cloud);
    // A frame of 8 cm; the glass returns nothing.
    cloud.wallFace({4.1, hole.y}, {4.1, hole.y + hole.width}, hole.sill, hole.head, Label::Window,
                   {{0.08, hole.width - 0.08, 0.08, hole.head - hole.sill - 0.08}});
    const auto r = storeyOf(cloud);
    ASSERT_EQ(r.openings.openings.size(), 1u);
    EXPECT_EQ(r.openings.openings[0].kind, OpeningKind::Window);
    expectHole(r, r.openings.openings[0], hole);
}

TEST(Openings, FindAPlainOpening)
{
    const HoleInPartition hole{0.5, 2.0, 0.0, 2.3};  // too wide for a leaf
    HandMadeCloud cloud = hole.cloud();
    hole.addReveals(cloud);
    for (const bool withLabels : {true, false})
    {
        const auto r = storeyOf(cloud, withLabels);
        ASSERT_EQ(r.openings.openings.size(), 1u) << "labels " << withLabels;
        EXPECT_EQ(r.openings.openings[0].kind, OpeningKind::Plain);
        expectHole(r, r.openings.openings[0], hole);
    }
}

TEST(Openings, MakeNoHoleWhereNothingWasSeen)
{
    // The same void in both faces, but neither floor nor reveals: something stood in front of the wall.
    const HandMadeCloud cloud = HoleInPartition{}.cloud();
    for (const bool withLabels : {true, false})
        EXPECT_TRUE(storeyOf(cloud, withLabels).openings.openings.empty()) << "labels " << withLabels;
}

TEST(Openings, MakeNoDoorOnACupboard)
{
    HandMadeCloud cloud = HoleInPartition{1.0, 0.9, 0.0, 0.0}.cloud();
    // Door labels 0.45 m in front of the wall, on a cupboard's front.
    cloud.wallFace({3.55, 1.0}, {3.55, 2.0}, 0.1, 2.0, Label::Door);
    cloud.wallFace({3.55, 1.0}, {4.0, 1.0}, 0.0, 2.0, Label::Furniture);
    cloud.wallFace({3.55, 2.0}, {4.0, 2.0}, 0.0, 2.0, Label::Furniture);
    EXPECT_TRUE(storeyOf(cloud).openings.openings.empty());
}

TEST(Openings, FindTwoDoorsBesideEachOther)
{
    const HoleInPartition first{0.4, 0.9, 0.0, 2.1}, second{1.7, 0.8, 0.0, 2.1};
    HandMadeCloud cloud;
    RoomGaps west, east;
    west.east = east.west = {{0.4, 1.3, 0.0, 2.1}, {1.7, 2.5, 0.0, 2.1}};
    cloud.room({0, 0}, {4, 3}, 0, 2.6, west);
    cloud.room({4.2, 0}, {8.2, 3}, 0, 2.6, east);
    first.addReveals(cloud);
    second.addPanel(cloud, Label::Door);
    auto r = storeyOf(cloud);
    ASSERT_EQ(r.openings.openings.size(), 2u);
    // In order along the wall.
    const bool isUp = test::wallThrough(r.walls.walls, {4.1, 0.2}, Eigen::Vector2d::UnitY())->direction().y() > 0;
    expectHole(r, r.openings.openings[isUp ? 0 : 1], first);
    expectHole(r, r.openings.openings[isUp ? 1 : 0], second);
}

TEST(Openings, GiveOnlyTheKindsAskedFor)
{
    const HoleInPartition hole;
    HandMadeCloud cloud = hole.cloud();
    hole.addPanel(cloud, Label::Door);
    const SurfaceCells cells = test::cellsOf(cloud);
    Level level;
    level.ceiling_m = 2.6;
    level.ceilingSeen = true;
    std::uint32_t nextId = 2;
    const CellIndex index(cells, -0.2, 3.0);
    const WallResult walls = findWalls(cells, index, level, {1}, nextId, {}, {});
    for (const OpeningKind kind : {OpeningKind::Window, OpeningKind::Plain})
        EXPECT_TRUE(findOpenings(cells, index, level, walls.walls, {kind}, nextId, {}, {}).openings.empty());
    EXPECT_EQ(findOpenings(cells, index, level, walls.walls, {OpeningKind::Door}, nextId, {}, {}).openings.size(), 1u);
}

TEST(Openings, LieWithinTheirWall)
{
    // A door that reaches into the corner.
    const HoleInPartition hole{0.05, 0.9, 0.0, 2.1};
    HandMadeCloud cloud = hole.cloud();
    hole.addPanel(cloud, Label::Door);
    const auto r = storeyOf(cloud);
    ASSERT_EQ(r.openings.openings.size(), 1u);
    const Opening& o = r.openings.openings[0];
    const Wall& host =
        *std::find_if(r.walls.walls.begin(), r.walls.walls.end(), [&](const Wall& w) { return w.id == o.host; });
    EXPECT_GE(o.offset_m, host.bodyStart_m - 1e-9);
    EXPECT_LE(o.offset_m + o.width.value_m, host.bodyEnd_m + 1e-9);
    EXPECT_LE(o.sill.value_m + o.height.value_m, host.height.value_m + 1e-9);
}

/// Two rooms with a part missing in both faces of their partition, of whose jambs, head and floor nothing was seen;
/// and, if someone looked through, what the scanner in the one room saw in the other.
HandMadeCloud missingPart(bool looksThrough)
{
    HandMadeCloud cloud;
    const Gap gap{1.0, 1.9, 0.0, 2.1};
    RoomGaps west, east;
    west.east = east.west = {gap};
    cloud.standAt({1.5, 1.45, 1.5});
    cloud.room({0, 0}, {4, 3}, 0, 2.6, west);
    if (looksThrough)
        cloud.wallFace({8.2, 0.9}, {8.2, 2.0}, 0.2, 2.2);
    cloud.standAt({6, 1.45, 1.5});
    cloud.room({4.2, 0}, {8.2, 3}, 0, 2.6, east);
    return cloud;
}

TEST(Openings, AreWhereTheScannerLookedThrough)
{
    for (const bool withLabels : {true, false})
    {
        const auto r = storeyOf(missingPart(true), withLabels);
        ASSERT_EQ(r.openings.openings.size(), 1U) << "labels: " << withLabels;
        HoleInPartition hole;
        expectHole(r, r.openings.openings.front(), hole);
    }
}

TEST(Openings, AreNotWhereNobodyLooked)
{
    for (const bool withLabels : {true, false})
    {
        EXPECT_TRUE(storeyOf(missingPart(false), withLabels).openings.openings.empty());
        HandMadeCloud unknown = missingPart(true);
        unknown.forgetStations();
        EXPECT_TRUE(storeyOf(unknown, withLabels).openings.openings.empty());
    }
}

}  // namespace
}  // namespace s2b

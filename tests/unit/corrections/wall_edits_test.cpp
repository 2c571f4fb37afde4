// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/corrections/corrections.h"
#include "core/model/wall_axis.h"
#include "tests/unit/corrections/house.h"

#include <gmock/gmock.h>

namespace s2b
{
namespace
{

using namespace test;
using testing::HasSubstr;

constexpr double kExact_m = 1e-9;
constexpr ElementId kNew{13};  // the first free one

const Junction* junction(const Building& b, ElementId a, ElementId c)
{
    for (const Junction& j : b.junctions)
        if ((j.wallA == a && j.wallB == c) || (j.wallA == c && j.wallB == a))
            return &j;
    return nullptr;
}

TEST(SplitWall, SharesOutOpeningsAndJunctions)
{
    const Building b = splitWall(house(), kSouth, 4.0);
    ASSERT_EQ(b.walls.size(), 6u);
    EXPECT_NEAR(b.wall(kSouth)->axisLength_m(), 4.0, kExact_m);
    EXPECT_NEAR(b.wall(kNew)->axisLength_m(), 4.0, kExact_m);
    EXPECT_EQ(b.wall(kSouth)->end, b.wall(kNew)->start);
    EXPECT_NEAR(b.wall(kNew)->bodyEnd_m, 4.15, kExact_m);
    EXPECT_EQ(opening(b, kWindow).host, kSouth);
    EXPECT_TRUE(junction(b, kSouth, kNew));
    EXPECT_TRUE(junction(b, kNew, kEast));
    EXPECT_TRUE(junction(b, kNew, kPartition));  // at 5 m
    EXPECT_TRUE(junction(b, kSouth, kWest));
    EXPECT_FALSE(junction(b, kSouth, kEast));
    EXPECT_EQ(b.wall(kSouth)->evidence.points + b.wall(kNew)->evidence.points, 1000u);
    EXPECT_THAT(b.spaces[0].boundedBy, testing::Contains(kNew));
}

TEST(SplitWall, MovesOpeningsToTheSecondPart)
{
    const Building b = splitWall(house(), kSouth, 0.5);
    EXPECT_EQ(opening(b, kWindow).host, kNew);
    EXPECT_NEAR(opening(b, kWindow).offset_m, 0.5, kExact_m);
}

TEST(SplitWall, RefusesAPlaceWithinAnOpeningOrAtTheEnd)
{
    EXPECT_THAT(refusal([] { return splitWall(house(), kSouth, 1.5); }), HasSubstr("Window 8"));
    EXPECT_THAT(refusal([] { return splitWall(house(), kSouth, 7.99); }), HasSubstr("8.000 m long"));
    EXPECT_THAT(refusal([] { return splitWall(house(), kDoor, 1); }), HasSubstr("no wall"));
}

TEST(SplitWall, KeepsAnArcOnItsCircle)
{
    Building b = house();
    Wall arc = straightWall(ElementId{20}, {0, 0}, {4, 0}, 0.2, 0, 0);
    arc.bulge = 0.4;
    arc.bodyEnd_m = arc.axisLength_m();
    b.walls.push_back(arc);
    const Building c = splitWall(b, arc.id, 1.0);
    const WallAxis whole(arc), first(*c.wall(arc.id)), rest(*c.wall(ElementId{21}));
    EXPECT_NEAR(first.radius_m(), whole.radius_m(), kExact_m);
    EXPECT_NEAR(rest.radius_m(), whole.radius_m(), kExact_m);
    EXPECT_NEAR(first.length_m(), 1.0, kExact_m);
    EXPECT_NEAR(rest.length_m(), whole.length_m() - 1.0, kExact_m);
}

TEST(SplitWall, CutsASlopedTop)
{
    Building b = house();
    b.walls[0].topProfile = {{0, 2.5}, {8, 4.5}};
    b.walls[0].height.value_m = 4.5;
    const Building c = splitWall(b, kSouth, 4);
    EXPECT_NEAR(c.wall(kSouth)->height.value_m, 3.5, kExact_m);
    EXPECT_NEAR(c.wall(kNew)->topProfile.front().y(), 3.5, kExact_m);
    EXPECT_NEAR(c.wall(kNew)->height.value_m, 4.5, kExact_m);
}

TEST(MergeWalls, UndoesASplit)
{
    const Building b = mergeWalls(splitWall(house(), kSouth, 4.0), kSouth, kNew);
    EXPECT_EQ(b.walls.size(), 5u);
    EXPECT_EQ(b.junctions.size(), 6u);
    const Wall& w = *b.wall(kSouth);
    EXPECT_NEAR(w.axisLength_m(), 8.0, kExact_m);
    EXPECT_NEAR(w.bodyEnd_m, 8.15, kExact_m);
    EXPECT_NEAR(w.bodyStart_m, -0.15, kExact_m);
    EXPECT_NEAR(opening(b, kWindow).offset_m, 1.0, kExact_m);
    ASSERT_TRUE(junction(b, kSouth, kPartition));
    EXPECT_EQ(junction(b, kSouth, kPartition)->endB, JunctionEnd::Path);
    EXPECT_EQ(w.evidence.points, 1000u);
    EXPECT_NEAR(w.evidence.faceCoverage[0], 0.9, kExact_m);
}

TEST(MergeWalls, FillsAGapAndTurnsAnOpposedWall)
{
    Building b = house();
    b.walls.push_back(straightWall(ElementId{20}, {2, 2}, {1, 2}, 0.12, 0, 0));  // runs the other way
    Opening hole = opening(b, kDoor);
    hole.id = ElementId{21}, hole.host = ElementId{20}, hole.offset_m = 0.1, hole.width.value_m = 0.5;
    hole.hingeAtStart = true;
    b.openings.push_back(hole);
    b.walls.push_back(straightWall(ElementId{22}, {3, 2.01}, {4.5, 2.01}, 0.1, 0, 0));
    const Building c = mergeWalls(b, ElementId{20}, ElementId{22});
    const Wall& w = *c.wall(ElementId{20});
    EXPECT_NEAR(w.axisLength_m(), 3.5, kExact_m);
    EXPECT_NEAR(w.thickness.value_m, 0.1, kExact_m);  // of the longer one, both are measured
    const Opening& o = opening(c, ElementId{21});
    EXPECT_NEAR(WallAxis(w).at(o.offset_m + 0.25).x(), 2 - 0.35, kExact_m);
    EXPECT_FALSE(o.hingeAtStart);
}

TEST(MergeWalls, RefusesWhatIsNotOneLine)
{
    EXPECT_THAT(refusal([] { return mergeWalls(house(), kSouth, kEast); }), HasSubstr("90.0 degrees"));
    EXPECT_THAT(refusal([] { return mergeWalls(house(), kSouth, kNorth); }), HasSubstr("5.000 m apart"));
    EXPECT_THAT(refusal([] { return mergeWalls(house(), kSouth, kSouth); }), HasSubstr("itself"));
    EXPECT_THAT(refusal([] { return mergeWalls(house(), kSouth, kDoor); }), HasSubstr("no wall"));
}

TEST(AddWall, JoinsTheWallsThatItReaches)
{
    // Picked on its west face, some centimetres short of the long walls.
    const NewWall picked = wallThrough(kStorey, {2, 0.2}, {2, 4.8}, Eigen::Vector2d(2.12, 3), 0.2);
    EXPECT_NEAR(picked.thickness.value_m, 0.12, kExact_m);
    EXPECT_EQ(picked.thickness.provenance, Provenance::Corrected);
    EXPECT_NEAR(picked.start.x(), 2.06, kExact_m);
    const Building b = addWall(house(), picked);
    const Wall& w = b.walls.back();
    EXPECT_EQ(w.id, kNew);
    EXPECT_NEAR(w.start.y(), 0, kExact_m);
    EXPECT_NEAR(w.end.y(), 5, kExact_m);
    EXPECT_NEAR(w.bodyStart_m, 0.15, kExact_m);
    EXPECT_NEAR(w.bodyEnd_m, 4.85, kExact_m);
    EXPECT_EQ(w.height.value_m, 2.6);
    EXPECT_EQ(w.height.provenance, Provenance::Assumed);
    ASSERT_TRUE(junction(b, kNew, kSouth) && junction(b, kNew, kNorth));
    EXPECT_EQ(junction(b, kNew, kSouth)->endB, JunctionEnd::Path);
}

TEST(AddWall, PutsAnAssumedThicknessToTheLeft)
{
    const NewWall picked = wallThrough(kStorey, {2, 1}, {3, 1}, std::nullopt, 0.2);
    EXPECT_NEAR(picked.start.y(), 1.1, kExact_m);
    EXPECT_EQ(picked.thickness.provenance, Provenance::Assumed);
    EXPECT_EQ(addWall(house(), picked).junctions.size(), 6u);  // it reaches none
    EXPECT_THAT(refusal([] { return wallThrough(kStorey, {2, 1}, {2.05, 1}, {}, 0.2); }), HasSubstr("0.050 m apart"));
    EXPECT_THAT(refusal([] { return wallThrough(kStorey, {2, 1}, {3, 1}, Eigen::Vector2d(2.5, 5), 0.2); }),
                HasSubstr("4.000 m"));
    EXPECT_THAT(refusal([] { return addWall(Building{}, {kStorey, {0, 0}, {1, 0}, {}}); }), HasSubstr("Levels"));
}

TEST(AddWall, ClosesACorner)
{
    Building b = removeElement(house(), kEast);
    b = addWall(b, {kStorey, {8, 0.1}, {8, 4.7}, {0.3, Provenance::Corrected, 0}});
    const Wall& w = b.walls.back();
    ASSERT_TRUE(junction(b, w.id, kSouth));
    EXPECT_EQ(junction(b, w.id, kSouth)->endB, JunctionEnd::End);
    EXPECT_NEAR(b.wall(kSouth)->bodyEnd_m, 8.15, kExact_m);  // the longer one runs through, as it did
    EXPECT_NEAR(w.bodyStart_m, 0.15, kExact_m);
}

}  // namespace
}  // namespace s2b

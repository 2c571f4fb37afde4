// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/corrections/corrections.h"

#include "core/corrections/model.h"
#include "tests/unit/corrections/house.h"

#include <gmock/gmock.h>

namespace s2b
{
namespace
{

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kExact_m = 1e-9;

Building moved(ElementId id, double x)
{
    return moveElements(house(), {{id, Eigen::Affine3d(Eigen::Translation3d(x, 0, 0))}});
}

TEST(Corrections, NameWhatTheyMean)
{
    const Building b = house();
    EXPECT_EQ(nameOf(b, kDoor), "Door 7");
    EXPECT_EQ(nameOf(b, kRoomA), "0.01");
    EXPECT_EQ(nameOf(b, ElementId{99}), "");
    EXPECT_EQ(storeyOf(b, kDoor), kStorey);
    EXPECT_EQ(freeId(b), ElementId{13});
}

TEST(Corrections, TakeOutWhatHangsOnAnElement)
{
    const Building b = removeElement(house(), kPartition);
    EXPECT_EQ(b.walls.size(), 4u);
    EXPECT_EQ(b.openings.size(), 1u);
    EXPECT_EQ(b.junctions.size(), 4u);
    EXPECT_THAT(b.spaces[0].boundedBy, ElementsAre(kSouth, kNorth, kWest));
    const Building empty = removeElement(house(), kStorey);
    EXPECT_TRUE(empty.storeys.empty() && empty.walls.empty() && empty.openings.empty() && empty.columns.empty() &&
                empty.slabs.empty() && empty.spaces.empty() && empty.junctions.empty());
    EXPECT_THAT(refusal([] { return removeElement(house(), ElementId{99}); }), HasSubstr("99"));
}

TEST(Corrections, KeepNamesThatPeopleGive)
{
    Model m{house(), house(), {}};
    m = renameElement(m, kSouth, "Facade south");
    m = renameElement(m, kStorey, "Ground floor");
    m = renameElement(m, kRoomA, "Kitchen");
    EXPECT_EQ(nameOf(m, kSouth), "Facade south");
    EXPECT_EQ(m.corrected.storeys[0].name, "Ground floor");
    EXPECT_EQ(m.corrected.spaces[0].name, "Kitchen");
    m = renameElement(m, kSouth, "Wall 2");
    EXPECT_TRUE(m.names.empty());
    EXPECT_THAT(refusal([&] { return renameElement(m, ElementId{99}, "x"); }), HasSubstr("99"));
}

TEST(SetMeasure, KeepsTheFaceThatWasSeen)
{
    Building b = house();
    b.walls[0].evidence.facesSeen = 1;
    b.walls[0].evidence.faceCoverage = {0.9, 0.0};  // the left, inner face, y = 0.15
    const Building c = setMeasure(b, kSouth, Measure::Thickness, 0.5);
    EXPECT_NEAR(c.wall(kSouth)->start.y() + 0.25, 0.15, kExact_m);
    EXPECT_EQ(c.wall(kSouth)->thickness.provenance, Provenance::Corrected);
    EXPECT_NEAR(c.wall(kPartition)->start.y(), -0.1, kExact_m);
    EXPECT_NEAR(c.wall(kPartition)->bodyStart_m, 0.25, kExact_m);  // at the face, which is where it was
    EXPECT_NEAR(opening(c, kDoor).offset_m, 2.1, kExact_m);
    EXPECT_EQ(setMeasure(house(), kSouth, Measure::Thickness, 0.5).wall(kSouth)->start.y(), 0.0);
}

TEST(SetMeasure, SetsEveryClass)
{
    Building b = setMeasure(house(), kDoor, Measure::Width, 1.1);
    EXPECT_NEAR(opening(b, kDoor).offset_m, 1.9, kExact_m);  // about its middle
    b = setMeasure(b, kColumn, Measure::Depth, 0.5);
    EXPECT_EQ(measureOf(b, kColumn, Measure::Depth)->value_m, 0.5);
    EXPECT_EQ(column(b, kColumn).sectionProvenance, Provenance::Corrected);
    b = setMeasure(b, kFloor, Measure::Thickness, 0.25);
    EXPECT_EQ(b.slabs[0].thickness.provenance, Provenance::Corrected);
    b = setMeasure(b, kSouth, Measure::Height, 3.0);
    EXPECT_EQ(b.wall(kSouth)->height.value_m, 3.0);
    EXPECT_THAT(refusal([&] { return setMeasure(b, kPartition, Measure::Height, 1.5); }), HasSubstr("Door 7"));
    EXPECT_THAT(refusal([&] { return setMeasure(b, kDoor, Measure::Height, 2.7); }), HasSubstr("2.600"));
    EXPECT_THAT(refusal([&] { return setMeasure(b, kSouth, Measure::Thickness, 0); }), HasSubstr("Wall 2"));
    EXPECT_THAT(refusal([&] { return setMeasure(b, kSouth, Measure::Sill, 1); }), HasSubstr("no such dimension"));
    EXPECT_FALSE(measureOf(b, kSouth, Measure::Sill));
}

TEST(SetKind, ChangesOpeningsAndWallsIntoColumns)
{
    const Building b = setKind(house(), kDoor, ElementKind::Opening);
    EXPECT_EQ(opening(b, kDoor).kind, OpeningKind::Plain);
    EXPECT_THAT(refusal([] { return setKind(house(), kPartition, ElementKind::Column); }), HasSubstr("openings"));
    EXPECT_THAT(refusal([] { return setKind(house(), kDoor, ElementKind::Wall); }), HasSubstr("Door 7"));
    const Building c = setKind(house(), kWest, ElementKind::Column);
    EXPECT_EQ(kindOf(c, kWest), ElementKind::Column);
    EXPECT_EQ(c.junctions.size(), 4u);
    const Building back = setKind(c, kWest, ElementKind::Wall);
    EXPECT_NEAR(back.wall(kWest)->thickness.value_m, 0.3, kExact_m);
    EXPECT_NEAR(back.wall(kWest)->axisLength_m(), 4.7, kExact_m);
}

TEST(ResetElement, ReturnsToTheReconstructedStateToTheLastDigit)
{
    const Building found = house();
    Building b = moved(kEast, 0.5);
    EXPECT_THAT(correctedElements(found, b), ElementsAre(kSouth, kEast, kNorth));  // the neighbours were drawn
    b = resetElement(b, found, kEast);
    EXPECT_TRUE(correctedElements(found, b).empty());
    EXPECT_EQ(b.junctions.size(), 6u);

    b = resetElement(setMeasure(found, kDoor, Measure::Width, 0.8), found, kDoor);
    EXPECT_TRUE(correctedElements(found, b).empty());
}

TEST(ResetElement, BringsBackWhatWasTakenOut)
{
    const Building found = house();
    const Building b = resetElement(removeElement(found, kPartition), found, kPartition);
    EXPECT_FALSE(differs(found, b, kPartition));
    EXPECT_FALSE(differs(found, b, kDoor));
    EXPECT_EQ(b.junctions.size(), 6u);
    EXPECT_EQ(b.openings.size(), 2u);
    EXPECT_THAT(refusal([&] { return resetElement(removeElement(found, kPartition), found, kDoor); }),
                HasSubstr("Door 7"));
    const Building added = addWall(found, {kStorey, {1, 3}, {4, 3}, {0.1, Provenance::Assumed, 0}});
    EXPECT_THAT(refusal([&] { return resetElement(added, found, added.walls.back().id); }), HasSubstr("added by hand"));
}

TEST(PlacedByHand, TellsMovedElements)
{
    EXPECT_THAT(placedByHand({house(), moved(kPartition, 0.1), {}}), ElementsAre(kPartition));
    EXPECT_THAT(placedByHand({house(), setMeasure(house(), kDoor, Measure::Height, 2.0), {}}), ElementsAre());
}

TEST(MoveLevel, TakesWhatStandsOnTheFloor)
{
    const Building b = moveLevel(house(), kStorey, 0.1);
    EXPECT_NEAR(b.storeys[0].elevation_m, 0.1, kExact_m);
    EXPECT_NEAR(b.storeys[0].height.value_m, 2.5, kExact_m);  // the ceiling stays
    EXPECT_NEAR(b.wall(kSouth)->base_m, 0.1, kExact_m);
    EXPECT_NEAR(b.wall(kSouth)->height.value_m, 2.5, kExact_m);
    EXPECT_NEAR(opening(b, kDoor).height.value_m, 2.0, kExact_m);
    EXPECT_NEAR(opening(b, kWindow).sill.value_m, 0.8, kExact_m);
    EXPECT_NEAR(b.slabs[0].top_m, 0.1, kExact_m);
    EXPECT_NEAR(b.spaces[0].floor_m, 0.1, kExact_m);
    EXPECT_NEAR(moveLevel(house(), kStorey, 2.5).wall(kSouth)->height.value_m, 2.6, kExact_m);  // all goes along
}

TEST(AddLevel, EndsTheStoreyBelow)
{
    Building b = house();
    b.storeys[0].height.value_m = 5.5;
    b = addLevel(b, 2.8);
    ASSERT_EQ(b.storeys.size(), 2u);
    EXPECT_EQ(b.storeys[1].id, ElementId{13});
    EXPECT_EQ(b.storeys[1].name, "Level 1");
    EXPECT_NEAR(b.storeys[0].height.value_m, 2.8, kExact_m);
    EXPECT_THAT(refusal([&] { return addLevel(b, 2.9); }), HasSubstr("Level 1"));
    const Building lower = addLevel(house(), -3.0);
    EXPECT_NEAR(lower.storeys[0].height.value_m, 2.8, kExact_m);
    EXPECT_EQ(lower.storeys[0].name, "Level 1");
}

}  // namespace
}  // namespace s2b

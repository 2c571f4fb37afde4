// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/validation/sample_bims.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace s2b
{
namespace
{

using namespace test;
using ::testing::HasSubstr;

/// Two storeys of two walls each, on slabs; the walls reach 0.3 m below their floor and 0.2 m above their ceiling.
Bim twoStoreys()
{
    std::vector<BimElement> elements;
    for (int storey = 0; storey < 2; ++storey)
    {
        const double z = 3.0 * storey;
        for (const double y : {0.0, 4.0})
            elements.push_back(wall({0, y}, {5, y}, 0.2, z - 0.3, z + 2.7));
        elements.push_back(box(ElementClass::Slab, rectangle(0, 0.2, 5, 3.8), z - 0.3, z));
        for (auto e = elements.end() - 3; e != elements.end(); ++e)
            e->storey = storey;
    }
    Bim bim = bimOf(elements);
    bim.storeys = {{"0", "Ground", 0.0, true, true}, {"1", "Upper", 3.0, true, true}};
    return bim;
}

/// What stands on the ground floor sees: walls from the floor to the ceiling at 2.5 m, and the floor.
Points groundFloor(bool bothWalls)
{
    Points points;
    points.face({0, 0.1, 0}, {5, 0, 0}, {0, 0, 2.5});
    if (bothWalls)
        points.face({0, 3.9, 0}, {5, 0, 0}, {0, 0, 2.5});
    points.face({0, 0.2, 0}, {5, 0, 0}, {0, 3.6, 0}, Label::Floor);
    return points;
}

TEST(Visibility, WithoutACloudEverythingIsAskedFor)
{
    const Validation v = validate(twoStoreys(), bimOf({}), nullptr, {}, {});
    EXPECT_EQ(v.scores.at(ElementClass::Wall).truthCount, 4);
    EXPECT_FALSE(v.cloudToTruth.has_value());
}

TEST(Visibility, WallsAndStoreysWithoutPointsAreNotAskedFor)
{
    const Points points = groundFloor(false);
    const CloudView view = points.view();
    const Bim truth = twoStoreys();
    const Validation v = validate(truth, bimOf({wall({0, 0}, {5, 0}, 0.2, 0, 2.5)}), &view, {}, {});
    EXPECT_EQ(v.scores.at(ElementClass::Wall).truthCount, 1);
    EXPECT_EQ(v.scores.at(ElementClass::Wall).notSeenCount, 3);
    EXPECT_EQ(v.elements[0].outcome, Outcome::Matched);
    EXPECT_EQ(v.elements[1].outcome, Outcome::NotSeen);
    EXPECT_EQ(v.storeys.size(), 1U) << "nobody was upstairs";
    EXPECT_EQ(v.cloudToTruth->elements[1].verdict, Verdict::NoData);
}

TEST(Visibility, AWallThatIsSeenButNotFoundIsMissed)
{
    const Points points = groundFloor(true);
    const CloudView view = points.view();
    const Validation v = validate(twoStoreys(), bimOf({wall({0, 0}, {5, 0}, 0.2, 0, 2.5)}), &view, {}, {});
    EXPECT_EQ(v.elements[1].outcome, Outcome::Missed);
}

TEST(Visibility, HeightsAreComparedBetweenTheFloorAndTheCeilingThatWereSeen)
{
    const Points points = groundFloor(true);
    const CloudView view = points.view();
    const Bim result = bimOf({wall({0, 0}, {5, 0}, 0.2, 0, 2.5), wall({0, 4}, {5, 4}, 0.2, 0, 2.5)});
    const ClassScore s = validate(twoStoreys(), result, &view, {}, {}).scores.at(ElementClass::Wall);
    // The lowest and highest points lie half of their spacing (5 cm) from floor and ceiling: 2.45 of 2.45 m.
    EXPECT_NEAR(*s.iou, 1.0, 1e-6);
    EXPECT_NEAR(*s.iouFull, 2.5 / 3.0, 1e-6);
}

TEST(Visibility, AStoreyUnderARaisedFloorIsSurveyedByItsWalls)
{
    Points points;
    points.face({0, 0.1, 0.4}, {5, 0, 0}, {0, 0, 2.1});
    points.face({0, 3.9, 0.4}, {5, 0, 0}, {0, 0, 2.1});
    points.face({0, 0.2, 0.4}, {5, 0, 0}, {0, 3.6, 0}, Label::Floor);  // 40 cm above the slab
    const CloudView view = points.view();
    const Validation v = validate(twoStoreys(), bimOf({}), &view, {}, {});
    EXPECT_EQ(v.scores.at(ElementClass::Wall).truthCount, 2);
    EXPECT_EQ(v.storeys.size(), 1U);
}

TEST(Visibility, OneSideSeenIsOneSide)
{
    const Points points = groundFloor(true);
    const CloudView view = points.view();
    EXPECT_EQ(validate(twoStoreys(), bimOf({}), &view, {}, {}).scores.at(ElementClass::Wall).bothSidesCount, 0);
    Points more = groundFloor(true);
    more.face({0, -0.1, 0}, {5, 0, 0}, {0, 0, 2.5});
    const CloudView moreView = more.view();
    EXPECT_EQ(validate(twoStoreys(), bimOf({}), &moreView, {}, {}).scores.at(ElementClass::Wall).bothSidesCount, 1);
}

TEST(Visibility, AnOpenDoorCountsWhenItsWallWasSeen)
{
    Bim truth = twoStoreys();
    for (const int host : {0, 3})
    {
        BimElement door = box(ElementClass::Door, rectangle(2, -0.1, 3, 0.1), 3.0 * (host / 3), 3.0 * (host / 3) + 2.0);
        door.host = host;
        door.storey = host / 3;
        truth.elements.push_back(door);
    }
    addMeshes(truth);
    Points points;  // the wall around the opening, no leaf
    points.face({0, 0.1, 0}, {2, 0, 0}, {0, 0, 2.5});
    points.face({3, 0.1, 0}, {2, 0, 0}, {0, 0, 2.5});
    points.face({0, 0.2, 0}, {5, 0, 0}, {0, 3.6, 0}, Label::Floor);
    const CloudView view = points.view(true);
    const Validation v = validate(truth, bimOf({}), &view, {}, {});
    EXPECT_EQ(v.scores.at(ElementClass::Door).truthCount, 1);
    EXPECT_EQ(v.scores.at(ElementClass::Door).notSeenCount, 1);
}

TEST(Visibility, WhatTheTruthFileSaysStands)
{
    Bim truth = twoStoreys();
    for (BimElement& e : truth.elements)
        e.visibility = Visibility{};
    const Points points = groundFloor(false);
    const CloudView view = points.view();
    EXPECT_EQ(validate(truth, bimOf({}), &view, {}, {}).scores.at(ElementClass::Wall).truthCount, 4);
}

TEST(Visibility, ACloudOfAnotherPlaceIsRefused)
{
    Points points = groundFloor(true);
    points.origin = {1e6, 0, 0};
    const CloudView view = points.view();
    const std::string said =
        errorOf(ErrorCode::BadFile, [&] { (void)validate(twoStoreys(), twoStoreys(), &view, {}, {}); });
    EXPECT_THAT(said, HasSubstr("a.ifc and the cloud lie 1000 km apart"));
}

}  // namespace
}  // namespace s2b

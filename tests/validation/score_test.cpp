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

constexpr double kExact = 1e-9;  // rounding of a few products

Validation compare(const Bim& truth, const Bim& result)
{
    return validate(truth, result, nullptr, {}, {});
}

ClassScore wallScore(const Bim& truth, const Bim& result)
{
    return compare(truth, result).scores.at(ElementClass::Wall);
}

TEST(Score, OfAModelWithItselfIsPerfect)
{
    const Bim bim = bimOf({wall({0, 0}, {5, 0}, 0.2), wall({0, 0}, {3, 4}, 0.3),
                           box(ElementClass::Column, rectangle(2, 2, 2.4, 2.4), 0, 3),
                           box(ElementClass::Slab, rectangle(0, 0, 5, 4), -0.2, 0)});
    const Validation v = compare(bim, bim);
    for (const auto& [elementClass, s] : v.scores)
    {
        EXPECT_NEAR(*s.iou, 1.0, kExact) << className(elementClass);
        EXPECT_NEAR(*s.iouFull, 1.0, kExact);
        EXPECT_NEAR(*s.iouNearest, 1.0, kExact);
        EXPECT_DOUBLE_EQ(s.at50.f1, 1.0);
        EXPECT_NEAR(*s.centroid_m, 0.0, kExact);
        EXPECT_NEAR(*s.heightError_m, 0.0, kExact);
    }
    const ClassScore& walls = v.scores.at(ElementClass::Wall);
    EXPECT_NEAR(*walls.volumetricIou, 1.0, kExact);
    EXPECT_NEAR(*walls.axisEnd_m, 0.0, kExact);
    EXPECT_NEAR(*walls.thicknessError_m, 0.0, kExact);
    EXPECT_DOUBLE_EQ(walls.cornersAt.at(5).f1, 1.0);
    EXPECT_NEAR(*v.meanIou, 1.0, kExact);
    EXPECT_FALSE(v.scores.contains(ElementClass::Door)) << "there are none";
}

TEST(Score, IouOfAShiftedBoxIsWhatTheyShareOfWhatTheyCover)
{
    // 5 x 0.2 x 3 against the same, 1 m along: 4 of 6 m are shared.
    const ClassScore s = wallScore(bimOf({wall({0, 0}, {5, 0}, 0.2)}), bimOf({wall({1, 0}, {6, 0}, 0.2)}));
    EXPECT_NEAR(*s.iou, 4.0 / 6.0, kExact);
    EXPECT_NEAR(*s.centroid_m, 1.0, kExact);
    EXPECT_NEAR(*s.axisEnd_m, 1.0, kExact);
    EXPECT_NEAR(*s.volumetricIou, 4.0 / 6.0, kExact);
}

TEST(Score, HeightsCountAsPlansDo)
{
    // The same plan, 0 to 3 m against 1 to 5 m: 2 of 5 m.
    const ClassScore s = wallScore(bimOf({wall({0, 0}, {5, 0}, 0.2, 0, 3)}), bimOf({wall({0, 0}, {5, 0}, 0.2, 1, 5)}));
    EXPECT_NEAR(*s.iou, 0.4, kExact);
    EXPECT_NEAR(*s.heightError_m, 1.0, kExact);
    EXPECT_NEAR(*s.centroid_m, 1.5, kExact);
}

TEST(Score, TurnedBoxesShareTheRhombus)
{
    // Two walls of 0.2 m that cross at 30 degrees share a rhombus of 0.2 * 0.2 / sin(30) m2.
    const double turn = std::numbers::pi / 6.0;
    const Eigen::Vector2d u(std::cos(turn), std::sin(turn));
    const ClassScore s = wallScore(bimOf({wall({-5, 0}, {5, 0}, 0.2)}), bimOf({wall(-5 * u, 5 * u, 0.2)}));
    const double shared = 0.04 / std::sin(turn);
    EXPECT_NEAR(*s.iou, shared / (4.0 - shared), kExact);
}

TEST(Score, ThicknessIsResultMinusTruth)
{
    const Validation v = compare(bimOf({wall({0, 0}, {5, 0}, 0.20)}), bimOf({wall({0, 0.02}, {5, 0.02}, 0.24)}));
    EXPECT_NEAR(*v.elements.front().thicknessError_m, 0.04, kExact);
    EXPECT_NEAR(*v.scores.at(ElementClass::Wall).thicknessError_m, 0.04, kExact);
    EXPECT_NEAR(*v.elements.front().axisEnd_m, 0.02, kExact);
}

TEST(Score, DoesNotDependOnTheOrigins)
{
    const Bim truth = bimOf({wall({0, 0}, {5, 0}, 0.2)});
    Bim result = bimOf({wall({-99, -200}, {-94, -200}, 0.2, -7, -4)});
    result.origin = {100, 200, 7};
    Bim far = truth;
    far.origin = {3.2e7, 5.6e6, 300};
    Bim farResult = result;
    farResult.origin += far.origin;
    EXPECT_NEAR(*wallScore(truth, result).iou, 4.0 / 6.0, kExact);
    EXPECT_NEAR(*wallScore(far, farResult).iou, 4.0 / 6.0, 1e-8) << "the spacing of doubles at 3.2e7 is 4e-9";
}

TEST(Score, TellsMissedFromFalsePositive)
{
    const Validation v =
        compare(bimOf({wall({0, 0}, {5, 0}, 0.2), wall({0, 5}, {5, 5}, 0.2), wall({0, 9}, {5, 9}, 0.2)}),
                bimOf({wall({0, 9}, {5, 9}, 0.2), wall({0, 7}, {5, 7}, 0.2)}));
    const ClassScore& s = v.scores.at(ElementClass::Wall);
    EXPECT_NEAR(*s.iou, 1.0 / 3.0, kExact);
    EXPECT_NEAR(s.iouMatched, 1.0, kExact);
    EXPECT_NEAR(s.at50.precision, 0.5, kExact);
    EXPECT_NEAR(s.at50.recall, 1.0 / 3.0, kExact);
    EXPECT_NEAR(s.at50.f1, 0.4, kExact);
    ASSERT_EQ(v.elements.size(), 4U);
    EXPECT_EQ(v.elements[0].outcome, Outcome::Missed);
    EXPECT_EQ(v.elements[1].outcome, Outcome::Missed);
    EXPECT_EQ(v.elements[2].outcome, Outcome::Matched);
    EXPECT_EQ(v.elements[2].result, 0);
    EXPECT_EQ(v.elements[3].outcome, Outcome::FalsePositive);
    EXPECT_EQ(v.elements[3].result, 1);
}

TEST(Score, WhatATruthsFormatDoesNotKnowIsNotHeldAgainstAResult)
{
    const BimElement window = box(ElementClass::Window, rectangle(1, -0.1, 2, 0.1), 1.0, 2.0);
    const Bim result = bimOf({wall({0, 0}, {5, 0}, 0.2), window});
    Bim truth = bimOf({wall({0, 0}, {5, 0}, 0.2)});
    EXPECT_EQ(compare(truth, result).scores.at(ElementClass::Window).resultCount, 1);
    truth.schema = "CV4AEC";
    const Validation v = compare(truth, result);
    EXPECT_FALSE(v.scores.contains(ElementClass::Window));
    ASSERT_EQ(v.elements.size(), 2U);
    EXPECT_EQ(v.elements[1].outcome, Outcome::Excused);
    EXPECT_DOUBLE_EQ(v.scores.at(ElementClass::Wall).at50.f1, 1.0);
}

TEST(Score, APoorPairCountsInTheMeanButIsNoMatch)
{
    // 0.5 m of 9.5 m are shared: below minimumMatch.
    const Validation v = compare(bimOf({wall({0, 0}, {5, 0}, 0.2)}), bimOf({wall({4.5, 0}, {9.5, 0}, 0.2)}));
    EXPECT_NEAR(*v.scores.at(ElementClass::Wall).iou, 0.5 / 9.5, kExact);
    EXPECT_FALSE(v.scores.at(ElementClass::Wall).centroid_m.has_value());
    ASSERT_EQ(v.elements.size(), 2U);
    EXPECT_EQ(v.elements[0].outcome, Outcome::Missed);
    EXPECT_EQ(v.elements[1].outcome, Outcome::FalsePositive);
}

TEST(Score, WhatWasNotSeenIsNeitherAskedForNorHeldAgainstAResult)
{
    const Bim truth = bimOf({wall({0, 0}, {5, 0}, 0.2), notSeen(wall({0, 5}, {5, 5}, 0.2))});
    const Validation found = compare(truth, bimOf({wall({0, 0}, {5, 0}, 0.2), wall({0, 5}, {5, 5}, 0.2)}));
    const Validation left = compare(truth, bimOf({wall({0, 0}, {5, 0}, 0.2)}));
    for (const Validation* v : {&found, &left})
    {
        const ClassScore& s = v->scores.at(ElementClass::Wall);
        EXPECT_EQ(s.truthCount, 1);
        EXPECT_EQ(s.resultCount, 1);
        EXPECT_EQ(s.notSeenCount, 1);
        EXPECT_NEAR(*s.iou, 1.0, kExact);
        EXPECT_DOUBLE_EQ(s.at50.f1, 1.0);
        EXPECT_EQ(v->elements[1].outcome, Outcome::NotSeen);
    }
    ASSERT_EQ(found.elements.size(), 3U);
    EXPECT_EQ(found.elements[2].outcome, Outcome::Excused);
    EXPECT_EQ(left.elements.size(), 2U);
}

TEST(Score, APartOfWhatWasNotSeenIsExcusedToo)
{
    const Bim truth = bimOf({notSeen(wall({0, 0}, {10, 0}, 0.2))});
    const Validation v = compare(truth, bimOf({wall({1, 0}, {2, 0}, 0.2), wall({0, 3}, {5, 3}, 0.2)}));
    EXPECT_EQ(v.elements[1].outcome, Outcome::Excused);
    EXPECT_EQ(v.elements[2].outcome, Outcome::FalsePositive);
    EXPECT_FALSE(v.scores.at(ElementClass::Wall).iou.has_value()) << "nothing was asked for";
}

TEST(Score, AboveAndBelowWhatASurveySeesNothingIsCompared)
{
    // The truth reaches from -0.3 to 3.5 m, the survey saw 0 to 2.5 m, the result has 0 to 2.5 m.
    BimElement seen = wall({0, 0}, {5, 0}, 0.2, -0.3, 3.5);
    seen.visibility = Visibility{.counts = true, .bandLow_m = 0.0, .bandHigh_m = 2.5};
    const Validation v = compare(bimOf({seen}), bimOf({wall({0, 0}, {5, 0}, 0.2, 0, 2.5)}));
    const ClassScore& s = v.scores.at(ElementClass::Wall);
    EXPECT_NEAR(*s.iou, 1.0, kExact);
    EXPECT_NEAR(*s.iouFull, 2.5 / 3.8, kExact);
    EXPECT_NEAR(s.cornersAt.at(5).f1, 1.0, kExact)
        << "the lower corners are drawn to the floor, the upper to the ceiling";
}

TEST(Score, OneSidedWallsAreLeftOutOfThicknesses)
{
    BimElement both = wall({0, 0}, {5, 0}, 0.2);
    both.visibility = Visibility{.counts = true, .isBothSidesSeen = true, .bandLow_m = {}, .bandHigh_m = {}};
    BimElement one = wall({0, 5}, {5, 5}, 0.3);
    one.visibility = Visibility{.counts = true, .isBothSidesSeen = false, .bandLow_m = {}, .bandHigh_m = {}};
    const ClassScore s = wallScore(bimOf({both, one}), bimOf({wall({0, 0}, {5, 0}, 0.21), wall({0, 5}, {5, 5}, 0.15)}));
    EXPECT_EQ(s.bothSidesCount, 1);
    EXPECT_NEAR(*s.thicknessError_m, 0.01, kExact);
    EXPECT_NEAR(*s.iouBothSides, 0.2 / 0.21, kExact);
}

TEST(Score, NearestCentresMayBePoorPartners)
{
    // The nearest centre is that of a short wall beside, not of the one that overlaps.
    const ClassScore s =
        wallScore(bimOf({wall({0, 0}, {10, 0}, 0.2)}), bimOf({wall({0, 0}, {6, 0}, 0.2), wall({5, 1}, {5.5, 1}, 0.2)}));
    EXPECT_NEAR(*s.iou, 0.6, kExact);
    EXPECT_NEAR(*s.iouNearest, 0.0, kExact);
}

TEST(Score, DividingAWallCostsBoxIouButNoVolume)
{
    const Bim truth = bimOf({wall({0, 0}, {10, 0}, 0.2)});
    const ClassScore s = wallScore(truth, bimOf({wall({0, 0}, {6, 0}, 0.2), wall({6, 0}, {10, 0}, 0.2)}));
    EXPECT_NEAR(*s.iou, 0.6, kExact);
    EXPECT_NEAR(*s.volumetricIou, 1.0, kExact);
    EXPECT_NEAR(s.at50.precision, 0.5, kExact);
}

TEST(Score, OverlappingWallsFillTheirVolumeOnce)
{
    // A cross of two walls of 4 x 0.2 x 3 against one of them: the middle square counts once.
    const Bim cross = bimOf({wall({-2, 0}, {2, 0}, 0.2), wall({0, -2}, {0, 2}, 0.2)});
    EXPECT_NEAR(*wallScore(cross, bimOf({wall({-2, 0}, {2, 0}, 0.2)})).volumetricIou, 0.8 / 1.56, kExact);
}

TEST(Score, CornersAreCountedByTheirTrueDistance)
{
    // 3 cm to the side and 4 cm up: all corners are off by 5 cm, where the difference in x alone is 0.
    const ClassScore s =
        wallScore(bimOf({wall({0, 0}, {5, 0}, 0.2, 0, 3)}), bimOf({wall({0, 0.03}, {5, 0.03}, 0.2, 0.0401, 3.0401)}));
    EXPECT_DOUBLE_EQ(s.cornersAt.at(5).f1, 0.0);
    EXPECT_DOUBLE_EQ(s.cornersAt.at(10).f1, 1.0);
}

TEST(Score, AMissingWallCostsItsEightCorners)
{
    const ClassScore s =
        wallScore(bimOf({wall({0, 0}, {5, 0}, 0.3), wall({0, 5}, {5, 5}, 0.3)}), bimOf({wall({0.15, 0}, {5, 0}, 0.3)}));
    // Four corners are exact, four are 15 cm away.
    EXPECT_NEAR(s.cornersAt.at(10).precision, 0.5, kExact);
    EXPECT_NEAR(s.cornersAt.at(10).recall, 0.25, kExact);
    EXPECT_NEAR(s.cornersAt.at(20).precision, 1.0, kExact);
    EXPECT_NEAR(s.cornersAt.at(20).recall, 0.5, kExact);
}

Bim withStoreys(Bim bim, const std::vector<double>& elevations)
{
    for (const double z : elevations)
        bim.storeys.push_back({std::to_string(z), "Level " + std::to_string(bim.storeys.size()), z, true, true});
    return bim;
}

TEST(Score, StoreysAreComparedWithTheNearest)
{
    Bim truth = withStoreys(bimOf({wall({0, 0}, {5, 0}, 0.2)}), {0.0, 3.0, 6.0, 9.0});
    truth.storeys[3].isSurveyed = false;
    const Bim result = withStoreys(bimOf({wall({0, 0}, {5, 0}, 0.2)}), {0.01, 2.98, 4.5, 12.0});
    const Validation v = compare(truth, result);
    ASSERT_EQ(v.storeys.size(), 3U);
    EXPECT_NEAR(v.storeys[0].error_m, 0.01, kExact);
    EXPECT_EQ(v.storeys[0].result, 0);
    EXPECT_NEAR(v.storeys[1].error_m, 0.02, kExact);
    EXPECT_EQ(v.storeys[2].result, -1) << "the nearest is 1.5 m away";
    EXPECT_EQ(v.extraStoreys, 1);
}

TEST(Score, OnlyChosenStoreysCount)
{
    BimElement low = wall({0, 0}, {5, 0}, 0.2, 0, 2.8);
    low.storey = 0;
    BimElement high = wall({0, 0}, {5, 0}, 0.2, 3, 5.8);
    high.storey = 1;
    Bim truth = withStoreys(bimOf({low, high}), {0.0, 3.0});
    // Upstairs the result has nothing right.
    const Bim result =
        withStoreys(bimOf({wall({0, 0}, {5, 0}, 0.2, 0, 2.8), wall({0, 4}, {5, 4}, 0.2, 3, 5.8)}), {0.0, 3.2});
    EXPECT_NEAR(*wallScore(truth, result).iou, 0.5, kExact);
    selectStoreys(truth, std::vector<std::string>{"Level 0"});
    const Validation v = compare(truth, result);
    EXPECT_NEAR(*v.scores.at(ElementClass::Wall).iou, 1.0, kExact);
    EXPECT_DOUBLE_EQ(v.scores.at(ElementClass::Wall).at50.precision, 1.0);
    EXPECT_EQ(v.elements.back().outcome, Outcome::Excused);
    EXPECT_EQ(v.storeys.size(), 1U);
    EXPECT_EQ(v.extraStoreys, 0);
}

TEST(Score, AnUnknownStoreyIsNamedWithTheKnownOnes)
{
    Bim truth = withStoreys(bimOf({wall({0, 0}, {5, 0}, 0.2)}), {0.0, 3.0});
    const std::string said =
        errorOf(ErrorCode::BadParameter, [&] { selectStoreys(truth, std::vector<std::string>{"Attic"}); });
    EXPECT_THAT(said, HasSubstr("\"Attic\""));
    EXPECT_THAT(said, HasSubstr("Level 0, Level 1"));
}

TEST(Score, ModelsOnDifferentPlacesAreRefused)
{
    Bim result = bimOf({wall({0, 0}, {5, 0}, 0.2)}, "b.ifc");
    result.origin = {5000, 0, 0};
    const std::string said = errorOf(ErrorCode::BadFile, [&] { compare(bimOf({wall({0, 0}, {5, 0}, 0.2)}), result); });
    EXPECT_THAT(said, HasSubstr("a.ifc and b.ifc lie 4995.0 m apart"));
}

TEST(Score, ModelsInDifferentUnitsAreRefused)
{
    const std::string said = errorOf(
        ErrorCode::BadFile,
        [&] { compare(bimOf({wall({0, 0}, {5000, 0}, 200, 0, 3000)}), bimOf({wall({0, 0}, {5, 0}, 0.2)}, "b.ifc")); });
    EXPECT_THAT(said, HasSubstr("the length unit of one of them is wrong"));
}

TEST(Score, AnEmptyResultMissesEverything)
{
    const Validation v = compare(bimOf({wall({0, 0}, {5, 0}, 0.2)}), bimOf({}));
    const ClassScore& s = v.scores.at(ElementClass::Wall);
    EXPECT_DOUBLE_EQ(*s.iou, 0.0);
    EXPECT_DOUBLE_EQ(*s.volumetricIou, 0.0);
    EXPECT_DOUBLE_EQ(s.at50.f1, 0.0);
    EXPECT_FALSE(s.iouNearest.has_value());
}

}  // namespace
}  // namespace s2b

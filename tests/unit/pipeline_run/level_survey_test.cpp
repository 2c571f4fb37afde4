// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/level_survey.h"

#include "core/base/error.h"
#include "tests/support/hand_made_cloud.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace s2b
{
namespace
{

/// Two storeys of 2.6 m, far from the origin as a georeferenced scan.
test::HandMadeCloud twoStoreys()
{
    test::HandMadeCloud cloud(0.03);
    for (const double floor : {0.0, 2.9})
        cloud.room({0, 0}, {5, 4}, floor, floor + 2.6);
    return cloud;
}

TEST(SurveyLevels, FindsTheStoreysOfTheRunInWorldHeights)
{
    const test::HandMadeCloud cloud = twoStoreys();
    CloudView view = cloud.view();
    view.origin = {5.0e5, 5.4e6, 310.0};
    const LevelSurvey survey = surveyLevels(view, {}, {});
    const Building building = reconstruct(view, {}, {});
    ASSERT_EQ(survey.storeys.size(), building.storeys.size());
    ASSERT_EQ(survey.storeys.size(), 2U);
    for (std::size_t i = 0; i < survey.storeys.size(); ++i)
    {
        const Storey& storey = building.storeys[i];
        EXPECT_NEAR(survey.storeys[i].floor_m, building.frame.origin.z() + storey.elevation_m, 1e-9);
        EXPECT_NEAR(survey.storeys[i].ceiling_m - survey.storeys[i].floor_m, storey.height.value_m, 1e-9);
        EXPECT_TRUE(survey.storeys[i].ceilingSeen);
    }
    EXPECT_NEAR(survey.storeys[0].floor_m, 310.0, 0.01);
}

TEST(SurveyLevels, ProfileHoldsTheAreaOfFloorsAndCeilings)
{
    const test::HandMadeCloud cloud = twoStoreys();
    const HeightProfile profile = surveyLevels(cloud.view(), {}, {}).profile;
    EXPECT_LE(profile.low_m, 0.001);
    EXPECT_GE(profile.high_m(), 5.499);
    const auto areaNear = [&](double z)
    {
        double sum = 0;
        for (std::size_t i = 0; i < profile.area_m2.size(); ++i)
            if (std::abs(profile.low_m + (static_cast<double>(i) + 0.5) * profile.bin_m - z) < 0.05)
                sum += profile.area_m2[i];
        return sum;
    };
    for (const double z : {0.0, 2.6, 2.9, 5.5})
    {
        // 5 m x 4 m, in cells as large as the point spacing: a quarter of them has no point by chance.
        EXPECT_GT(areaNear(z), 0.6 * 20.0) << z;
        EXPECT_LT(areaNear(z), 1.1 * 20.0) << z;
    }
    EXPECT_LT(areaNear(1.3), 0.5) << "walls are not horizontal";
}

TEST(Reconstruct, TakesTheLevelsThatAreGiven)
{
    const test::HandMadeCloud cloud = twoStoreys();
    CloudView view = cloud.view();
    view.origin.z() = 310.0;
    PipelineOptions options;
    options.levels = {{312.9, 315.5}};  // the upper one alone
    const Building building = reconstruct(view, options, {});
    ASSERT_EQ(building.storeys.size(), 1U);
    EXPECT_NEAR(building.frame.origin.z() + building.storeys[0].elevation_m, 312.9, 1e-9);
    EXPECT_NEAR(building.storeys[0].height.value_m, 2.6, 1e-9);
    EXPECT_EQ(building.storeys[0].height.provenance, Provenance::Corrected);
    EXPECT_EQ(building.walls.size(), 4U);
    for (const Wall& wall : building.walls)
        EXPECT_NEAR(building.frame.origin.z() + wall.base_m, 312.9, 0.02);
}

TEST(Reconstruct, RefusesLevelsThatAreNotInOrder)
{
    const test::HandMadeCloud cloud = twoStoreys();
    for (const std::vector<StoreyHeights>& levels :
         {std::vector<StoreyHeights>{{2.9, 5.5}, {0.0, 2.6}}, std::vector<StoreyHeights>{{2.6, 2.6}}})
    {
        PipelineOptions options;
        options.levels = levels;
        EXPECT_THROW((void)reconstruct(cloud.view(), options, {}), Error);
    }
}

TEST(SurveyLevels, RefusesWhatARunRefuses)
{
    EXPECT_THROW((void)surveyLevels({}, {}, {}), Error);
    std::stop_source stop;
    stop.request_stop();
    Context context;
    context.cancel = stop.get_token();
    const test::HandMadeCloud cloud = twoStoreys();
    EXPECT_THROW((void)surveyLevels(cloud.view(), {}, context), Cancelled);
}

}  // namespace
}  // namespace s2b

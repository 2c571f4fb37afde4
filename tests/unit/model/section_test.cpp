// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section.h"
#include "core/geometry/polygon.h"

#include <gtest/gtest.h>

#include <numbers>

namespace s2b
{
namespace
{

const std::vector<Section> kSections{RectangleSection{0.4, 0.3},
                                     ProfileSection{ProfileShape::I, 0.30, 0.28, 0.011, 0.019},
                                     ProfileSection{ProfileShape::L, 0.25, 0.20, 0.020, 0.020},
                                     ProfileSection{ProfileShape::U, 0.10, 0.30, 0.010, 0.016},
                                     ProfileSection{ProfileShape::T, 0.30, 0.15, 0.011, 0.019}};

TEST(Section, HasTheAreaAndPerimeterOfItsOutline)
{
    for (const Section& s : kSections)
    {
        const Polygon outline{outlineOf(s), {}};
        EXPECT_GT(signedArea(outline.outer), 0.0);
        EXPECT_NEAR(areaOf(s), area(outline), 1e-12);
        EXPECT_NEAR(perimeterOf(s), perimeter(outline), 1e-12);
    }
    const Section circle = CircleSection{0.2};
    EXPECT_DOUBLE_EQ(areaOf(circle), std::numbers::pi * 0.04);
    EXPECT_NEAR(area({outlineOf(circle), {}}), areaOf(circle), 0.01 * areaOf(circle));
    EXPECT_DOUBLE_EQ(perimeterOf(circle), std::numbers::pi * 0.4);
}

TEST(Section, LiesInTheMiddleOfItsBox)
{
    for (const Section& s : kSections)
    {
        Eigen::Vector2d low(1, 1), high(-1, -1);
        for (const Eigen::Vector2d& p : outlineOf(s))
            low = low.cwiseMin(p), high = high.cwiseMax(p);
        EXPECT_LT((high - low - boxOf(s)).norm(), 1e-12);
        EXPECT_LT((high + low).norm(), 1e-12);
    }
}

TEST(Section, TellsWhatIsWrong)
{
    constexpr double smallest = 1e-4;
    for (const Section& s : kSections)
        EXPECT_EQ(faultOf(s, smallest), "");
    EXPECT_NE(faultOf(RectangleSection{0.4, 0.0}, smallest), "");
    EXPECT_NE(faultOf(CircleSection{}, smallest), "");
    EXPECT_NE(faultOf(ProfileSection{ProfileShape::I, 0.3, 0.3, 0.0, 0.02}, smallest), "");
    EXPECT_NE(faultOf(ProfileSection{ProfileShape::I, 0.3, 0.3, 0.3, 0.02}, smallest), "");
    EXPECT_NE(faultOf(ProfileSection{ProfileShape::U, 0.3, 0.3, 0.02, 0.15}, smallest), "");
    EXPECT_NE(faultOf(ProfileSection{ProfileShape::L, 0.3, 0.3, 0.02, 0.03}, smallest), "");
}

}  // namespace
}  // namespace s2b

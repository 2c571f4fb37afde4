// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/wall_axis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace s2b
{
namespace
{

constexpr double kExact = 1e-9;  // metres; rounding only

Wall wallOf(double bulge)
{
    Wall w;
    w.start = {1.0, 2.0};
    w.end = {4.0, -1.0};
    w.bulge = bulge;
    return w;
}

class WallAxes : public testing::TestWithParam<double>
{
};

TEST_P(WallAxes, RunFromStartToEnd)
{
    const Wall w = wallOf(GetParam());
    const WallAxis axis(w);
    EXPECT_NEAR(axis.length_m(), w.axisLength_m(), kExact);
    EXPECT_LT((axis.at(0) - w.start).norm(), kExact);
    EXPECT_LT((axis.at(axis.length_m()) - w.end).norm(), kExact);
    EXPECT_LT((axis.direction(0) - w.direction()).norm(), kExact);
    EXPECT_LT((axis.normal(0) - w.normal()).norm(), kExact);
}

TEST_P(WallAxes, ProjectBackWhatTheyPlace)
{
    const WallAxis axis(wallOf(GetParam()));
    for (const double share : {-0.05, 0.0, 0.3, 0.8, 1.05})
        for (const double d : {-0.4, 0.0, 0.3})
        {
            const Eigen::Vector2d q = axis.project(axis.at(share * axis.length_m(), d));
            EXPECT_NEAR(q.x(), share * axis.length_m(), kExact);
            EXPECT_NEAR(q.y(), d, kExact);
        }
}

TEST_P(WallAxes, HaveTheirNormalToTheLeft)
{
    const WallAxis axis(wallOf(GetParam()));
    const double s = 0.4 * axis.length_m(), step = 1e-5;
    const Eigen::Vector2d along = (axis.at(s + step) - axis.at(s - step)) / (2 * step);
    EXPECT_LT((along - axis.direction(s)).norm(), 1e-6);  // the difference quotient's own error
    EXPECT_LT((axis.at(s, 0.2) - axis.at(s) - 0.2 * axis.normal(s)).norm(), kExact);
}

INSTANTIATE_TEST_SUITE_P(Bulges, WallAxes, testing::Values(0.0, 0.2, -0.2, 1.0, -1.0, 2.0));

}  // namespace
}  // namespace s2b

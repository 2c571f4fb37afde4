// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/corrections/fit_motion.h"

#include <gtest/gtest.h>

namespace s2b
{
namespace
{

constexpr double kTolerance_m = 2e-4;

/// The corners of a wall, 100 m from the origin.
std::vector<Eigen::Vector3d> wall()
{
    std::vector<Eigen::Vector3d> points;
    for (const double x : {100.0, 104.0})
        for (const double y : {50.0, 50.1})
            for (const double z : {0.0, 2.6})
                points.emplace_back(x, y, z);
    return points;
}

/// Moved, and kept as CloudCompare does.
std::vector<Eigen::Vector3d> movedBy(const Eigen::Affine3d& m, const std::vector<Eigen::Vector3d>& points)
{
    std::vector<Eigen::Vector3d> moved;
    for (const Eigen::Vector3d& p : points)
        moved.emplace_back((m * p).cast<float>().cast<double>());
    return moved;
}

TEST(FitMotion, FindsWhatToolsDo)
{
    const Eigen::Affine3d shift(Eigen::Translation3d(0.3, -0.2, 0.05));
    const Eigen::Affine3d turn = shift * Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ());
    const Eigen::Affine3d grown = turn * Eigen::Scaling(1.2);
    const Eigen::Affine3d wider = shift * Eigen::Scaling(1.0, 1.5, 1.0);
    const Eigen::Affine3d mirrored = shift * Eigen::Scaling(1.0, -1.0, 1.0);
    for (const Eigen::Affine3d& m : {shift, turn, grown, wider, mirrored})
    {
        const auto fit = fitMotion(wall(), movedBy(m, wall()), kTolerance_m);
        ASSERT_TRUE(fit);
        for (const Eigen::Vector3d& p : wall())
            EXPECT_LT((*fit * p - m * p).norm(), kTolerance_m);
    }
}

TEST(FitMotion, TakesRoundingForNothing)
{
    const auto fit = fitMotion(wall(), movedBy(Eigen::Affine3d::Identity(), wall()), kTolerance_m);
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->matrix(), Eigen::Matrix4d::Identity());
}

TEST(FitMotion, FindsTheMotionOfAFlatOutline)
{
    const std::vector<Eigen::Vector3d> hole = {{0, 0, 0}, {0.9, 0, 0}, {0.9, 0, 2.1}, {0, 0, 2.1}};
    const Eigen::Affine3d wider = Eigen::Affine3d(Eigen::Translation3d(0.5, 0, 0)) * Eigen::Scaling(1.2, 1.0, 1.0);
    const auto fit = fitMotion(hole, movedBy(wider, hole), kTolerance_m);
    ASSERT_TRUE(fit);
    EXPECT_LT((*fit * hole[2] - wider * hole[2]).norm(), kTolerance_m);
}

TEST(FitMotion, FindsNoneWhereCornersWereMovedOneByOne)
{
    auto points = wall();
    points[3].x() += 0.1;
    EXPECT_FALSE(fitMotion(wall(), points, kTolerance_m));
    points.pop_back();
    EXPECT_FALSE(fitMotion(wall(), points, kTolerance_m));
    EXPECT_FALSE(fitMotion({}, {}, kTolerance_m));
}

}  // namespace
}  // namespace s2b

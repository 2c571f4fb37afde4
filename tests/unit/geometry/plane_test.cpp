// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/plane.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace
{

using namespace s2b;
using Points = std::vector<Eigen::Vector3f>;

/// A rectangle of 4 m by 2.5 m with normal noise, in the plane normal . p = offset.
Points noisyFace(const Eigen::Vector3d& normal, double offset, double sigma, int count, unsigned seed)
{
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> along(-2.0, 2.0);
    std::uniform_real_distribution<double> up(-1.25, 1.25);
    std::normal_distribution<double> noise(0.0, sigma);
    const Eigen::Vector3d u = normal.unitOrthogonal();
    const Eigen::Vector3d v = normal.cross(u);
    Points points;
    for (int i = 0; i < count; ++i)
    {
        const double a = along(generator);
        const double b = up(generator);
        points.push_back(((offset + noise(generator)) * normal + a * u + b * v).cast<float>());
    }
    return points;
}

TEST(FitPlane, FindsAFaceAmongClutter)
{
    const Eigen::Vector3d normal = Eigen::Vector3d(0.3, 0.9, 0.1).normalized();
    Points points = noisyFace(normal, 1.7, 0.003, 3000, 1);
    std::mt19937 generator(2);
    std::uniform_real_distribution<float> place(-3.0f, 3.0f);
    for (int i = 0; i < 2000; ++i)
        points.emplace_back(place(generator), place(generator), place(generator));
    const auto plane = fitPlane(points, {});
    ASSERT_TRUE(plane);
    // Standard errors: offset 0.003 / sqrt(3000) = 5.5e-5, tilt 5.5e-5 / 0.72 m; the clutter within 2 cm (about 1 % of
    // the inliers, spread 1.2 cm and over 6 m) adds as much again. 5 of them.
    EXPECT_LT(std::acos(std::min(1.0, plane->normal.dot(normal))), 1e-3);
    EXPECT_NEAR(plane->offset_m, 1.7, 1e-3);
    EXPECT_GT(plane->inlierShare, 0.6);
    EXPECT_LT(plane->inlierShare, 0.62);
    EXPECT_NEAR(plane->rms_m, 0.003, 5e-4);
    EXPECT_TRUE(std::is_sorted(plane->inliers.begin(), plane->inliers.end()));
    for (const std::size_t i : plane->inliers)
        EXPECT_LE(std::abs(plane->distance(points[i].cast<double>())), 0.02);
}

TEST(FitPlane, IsTheSameForASeedAndPointsUpItsLargestComponent)
{
    const Points points = noisyFace(Eigen::Vector3d(0, -1, 0), 2.0, 0.005, 500, 3);
    const auto first = fitPlane(points, {});
    const auto second = fitPlane(points, {});
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->normal, second->normal);
    EXPECT_EQ(first->offset_m, second->offset_m);
    EXPECT_EQ(first->inliers, second->inliers);
    EXPECT_GT(first->normal.y(), 0.99);
    EXPECT_NEAR(first->offset_m, -2.0, 2e-3);  // standard error 2.2e-4
}

TEST(FitPlane, OtherSeedsFindTheSameFace)
{
    const Eigen::Vector3d normal = Eigen::Vector3d(1, 0.2, 0).normalized();
    const Points points = noisyFace(normal, -3.0, 0.002, 800, 4);
    for (std::uint64_t seed = 0; seed < 20; ++seed)
    {
        PlaneOptions options;
        options.seed = seed << 28;  // also in the upper half
        const auto plane = fitPlane(points, options);
        ASSERT_TRUE(plane);
        EXPECT_NEAR(plane->offset_m, -3.0, 5e-4) << seed;  // standard error 7e-5
        EXPECT_EQ(plane->inliers.size(), points.size()) << seed;
    }
}

TEST(FitPlane, HasNoneWithoutThreePointsOffALine)
{
    EXPECT_FALSE(fitPlane({}, {}));
    EXPECT_FALSE(fitPlane(Points(2, {1, 2, 3}), {}));
    EXPECT_FALSE(fitPlane(Points(100, {1, 2, 3}), {}));
    Points line;
    for (int i = 0; i < 100; ++i)
        line.emplace_back(0.25f * float(i), 0.5f * float(i), 1.0f);
    EXPECT_FALSE(fitPlane(line, {}));
    const auto three = fitPlane(Points{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}}, {});
    ASSERT_TRUE(three);
    EXPECT_EQ(three->normal, Eigen::Vector3d(0, 0, 1));
    EXPECT_EQ(three->offset_m, 5.0);
}

}  // namespace

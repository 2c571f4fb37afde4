// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/flattest_direction.h"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace
{

using namespace s2b;

Eigen::Matrix3d covariance(const Eigen::Vector3d& variances, std::mt19937& generator)
{
    std::normal_distribution<double> gauss;
    Eigen::Quaterniond turn(gauss(generator), gauss(generator), gauss(generator), gauss(generator));
    const Eigen::Matrix3d axes = turn.normalized().toRotationMatrix();
    return axes * variances.asDiagonal() * axes.transpose();
}

TEST(FlattestDirection, AgreesWithEigen)
{
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> exponent(-9.0, 0.0);
    int compared = 0;
    for (int i = 0; i < 2000; ++i)
    {
        const double scale = std::pow(10.0, 3 * exponent(generator) / 9);
        const Eigen::Vector3d variances =
            scale * Eigen::Vector3d(std::pow(10.0, exponent(generator)), std::pow(10.0, exponent(generator) / 4), 1.0);
        const Eigen::Matrix3d c = covariance(variances, generator);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(c);
        const Eigen::Vector3d values = solver.eigenvalues();
        const FlattestDirection found = flattestDirection(c);
        EXPECT_NEAR(found.middle, values[1], 1e-7 * values[2]);
        if (values[1] - values[0] < 0.01 * values[2])
            continue;
        EXPECT_NEAR(found.least, values[0], 1e-9 * values[2]);
        EXPECT_NEAR(std::abs(found.direction.dot(solver.eigenvectors().col(0))), 1.0, 1e-10);
        EXPECT_NEAR(found.direction.norm(), 1.0, 1e-12);
        ++compared;
    }
    EXPECT_GT(compared, 1000);
}

TEST(FlattestDirection, OfAPlaneIsItsNormal)
{
    Eigen::Matrix3d c = Eigen::Matrix3d::Zero();
    c(0, 0) = 0.5, c(1, 1) = 0.5;
    const FlattestDirection found = flattestDirection(c);
    EXPECT_EQ(found.least, 0.0);
    EXPECT_NEAR(found.middle, 0.5, 1e-8);
    EXPECT_NEAR(std::abs(found.direction.z()), 1.0, 1e-12);
}

TEST(FlattestDirection, HasNoneWhereNothingIsFlat)
{
    EXPECT_TRUE(flattestDirection(Eigen::Matrix3d::Zero()).direction.isZero());
    Eigen::Matrix3d line = Eigen::Matrix3d::Zero();
    line(1, 1) = 2.0;
    EXPECT_TRUE(flattestDirection(line).direction.isZero());
    EXPECT_NEAR(flattestDirection(line).middle, 0.0, 1e-12);
    const FlattestDirection ball = flattestDirection(Eigen::Matrix3d::Identity());
    EXPECT_NEAR(ball.least, 1.0, 1e-4);
    EXPECT_NEAR(ball.middle, 1.0, 1e-4);
}

}  // namespace

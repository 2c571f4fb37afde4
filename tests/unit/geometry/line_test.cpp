// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace
{

using namespace s2b;

/// Points along a line through `origin` at `angle`, of normal noise across it.
std::vector<Eigen::Vector2d> noisyLine(const Eigen::Vector2d& origin, double angle, double length, double sigma,
                                       int count, unsigned seed)
{
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> along(0.0, length);
    std::normal_distribution<double> noise(0.0, sigma);
    const Eigen::Vector2d u(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d v(-u.y(), u.x());
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < count; ++i)
    {
        const double s = along(generator);
        points.push_back(origin + s * u + noise(generator) * v);
    }
    return points;
}

double angleBetween(const Eigen::Vector2d& a, double angle)
{
    return std::abs(std::asin(a.x() * std::sin(angle) - a.y() * std::cos(angle)));
}

TEST(FitLine, FindsLinesOfAnyDirection)
{
    for (int degrees = -85; degrees <= 90; degrees += 25)
    {
        const double angle = degrees * std::numbers::pi / 180.0;
        const LineFit fit = fitLine(noisyLine({3, -2}, angle, 4.0, 0.003, 4000, unsigned(degrees + 100)), {});
        // Standard error of the slope: 0.003 / (4 / sqrt(12) * sqrt(4000)) = 4e-5 rad; 5 of them.
        EXPECT_LT(angleBetween(fit.direction, angle), 2e-4) << degrees;
        // Standard error of the offset at the centroid: 0.003 / sqrt(4000) = 5e-5, and at (3, -2), 2 m away, 9e-5.
        EXPECT_LT(std::abs(fit.distance({3, -2})), 5e-4) << degrees;
        EXPECT_GE(fit.direction.x(), 0.0);
        EXPECT_NEAR(fit.direction.norm(), 1.0, 1e-12);
        // The biweight takes 5 to 10 % of a normal distribution's spread.
        EXPECT_NEAR(fit.rms_m, 0.003, 0.0004) << degrees;
    }
}

TEST(FitLine, IgnoresOutliersOnOneSide)
{
    std::vector<Eigen::Vector2d> points = noisyLine({0, 0}, 0.3, 5.0, 0.003, 800, 1);
    const std::vector<Eigen::Vector2d> shelf = noisyLine(Eigen::Vector2d(-0.06, 0.2), 0.3, 1.0, 0.02, 200, 2);
    points.insert(points.end(), shelf.begin(), shelf.end());
    const LineFit fit = fitLine(points, {});
    // 20 % of the points at 0.2 m would turn a plain fit by more than 1 degree; the line's own standard error is 7e-5.
    EXPECT_LT(angleBetween(fit.direction, 0.3), 5e-4);
    EXPECT_LT(std::abs(fit.distance({0, 0})), 1e-3);
    EXPECT_LT(fit.weight, 805.0);
}

TEST(FitLine, CountsWeights)
{
    // Two parallel lines of points: the heavier one's weight is what counts.
    std::vector<Eigen::Vector2d> points;
    std::vector<double> weights;
    for (int i = 0; i < 50; ++i)
    {
        points.emplace_back(0.1 * i, 0.0);
        weights.push_back(10.0);
        points.emplace_back(0.1 * i, 0.05);
        weights.push_back(1.0);
    }
    const LineFit fit = fitLine(points, weights);
    // A plain fit lies 0.05 / 11 = 4.5 mm off the heavier line, one without weights 25 mm; reweighting goes nearer.
    EXPECT_LT(std::abs(fit.distance({2.0, 0.0})), 0.004);
    std::vector<double> none(points.size(), 0.0);
    EXPECT_EQ(fitLine(points, none).weight, 0.0);
}

TEST(FitLine, KeepsMillimetresFarFromTheOrigin)
{
    const Eigen::Vector2d origin(4.5e6, 5.4e6);
    const LineFit fit = fitLine(noisyLine(origin, 1.1, 6.0, 0.002, 2000, 4), {});
    // Spacing of doubles there is 1e-9; standard errors as above.
    EXPECT_LT(angleBetween(fit.direction, 1.1), 2e-4);
    EXPECT_LT(std::abs(fit.distance(origin)), 5e-4);
}

TEST(FitLine, HasNoneWithoutTwoDifferentPoints)
{
    using Points = std::vector<Eigen::Vector2d>;
    EXPECT_EQ(fitLine(Points{}, {}).weight, 0.0);
    EXPECT_EQ(fitLine(Points{{1, 2}}, {}).direction, Eigen::Vector2d(0, 0));
    EXPECT_EQ(fitLine(Points(10, {1, 2}), {}).direction, Eigen::Vector2d(0, 0));
    const LineFit two = fitLine(Points{{1, 2}, {1, 3}}, {});
    EXPECT_EQ(two.direction, Eigen::Vector2d(0, 1));
    EXPECT_EQ(two.rms_m, 0.0);
}

TEST(FindOffset, IsTheMeanOfANoisyFace)
{
    std::mt19937 generator(3);
    std::normal_distribution<double> noise(2.5, 0.003);
    std::vector<double> offsets(3000);
    std::ranges::generate(offsets, [&] { return noise(generator); });
    const OffsetConsensus found = findOffset(offsets, {}, 0.02);
    // Standard error 0.003 / sqrt(3000) = 5.5e-5; 4 of them.
    EXPECT_NEAR(found.offset, 2.5, 2.2e-4);
    EXPECT_NEAR(found.rms_m, 0.003, 2e-4);  // relative standard error of an RMS: 1 / sqrt(2 * 3000) = 1.3 %
    EXPECT_EQ(found.count, 3000u);          // 0.02 is more than 6 sigma
    EXPECT_EQ(found.share, 1.0);
}

TEST(FindOffset, NoiseDoesNotThickenAWall)
{
    // Two faces 0.1 m apart in clutter: their distance is what the thickness comes from.
    std::mt19937 generator(9);
    std::normal_distribution<double> noise(0.0, 0.003);
    std::uniform_real_distribution<double> clutter(-0.5, 0.6);
    std::vector<double> left;
    std::vector<double> right;
    for (int i = 0; i < 2000; ++i)
    {
        left.push_back(noise(generator));
        right.push_back(0.1 + noise(generator));
        if (i % 4 == 0)
        {
            left.push_back(clutter(generator));
            right.push_back(clutter(generator));
        }
    }
    // Standard error of the difference: sqrt(2) * 0.003 / sqrt(2000) = 1e-4; 5 of them.
    EXPECT_NEAR(findOffset(right, {}, 0.02).offset - findOffset(left, {}, 0.02).offset, 0.1, 5e-4);
}

TEST(FindOffset, TakesTheHeaviestNotTheMostPoints)
{
    const std::vector<double> offsets{0.0, 0.001, 0.002, 5.0, 5.002};
    const std::vector<double> weights{1, 1, 1, 4, 4};
    const OffsetConsensus found = findOffset(offsets, weights, 0.01);
    EXPECT_NEAR(found.offset, 5.001, 1e-12);
    EXPECT_EQ(found.weight, 8.0);
    EXPECT_NEAR(found.share, 8.0 / 11.0, 1e-12);
    EXPECT_EQ(found.count, 2u);
}

TEST(FindOffset, OfEquallyHeavyOnesTheLowest)
{
    EXPECT_EQ(findOffset(std::vector<double>{3.0, 1.0, 2.0}, {}, 0.01).offset, 1.0);
}

TEST(FindOffset, DoesNotDependOnTheOrder)
{
    std::mt19937 generator(21);
    std::normal_distribution<double> noise(0.0, 0.01);
    std::uniform_real_distribution<double> anyWeight(0.1, 3.0);
    std::vector<std::pair<double, double>> points(500);
    std::ranges::generate(points, [&] { return std::pair(noise(generator), anyWeight(generator)); });
    const auto run = [&]
    {
        std::vector<double> offsets;
        std::vector<double> weights;
        for (const auto& [offset, weight] : points)
        {
            offsets.push_back(offset);
            weights.push_back(weight);
        }
        return findOffset(offsets, weights, 0.015);
    };
    const OffsetConsensus first = run();
    std::ranges::shuffle(points, generator);
    const OffsetConsensus second = run();
    EXPECT_EQ(first.offset, second.offset);
    EXPECT_EQ(first.weight, second.weight);
    EXPECT_EQ(first.rms_m, second.rms_m);
}

TEST(FindOffset, HandlesNoneOneAndEqualOnes)
{
    EXPECT_EQ(findOffset({}, {}, 0.01).weight, 0.0);
    const OffsetConsensus one = findOffset(std::vector<double>{1e6}, {}, 1e-6);
    EXPECT_EQ(one.offset, 1e6);
    EXPECT_EQ(one.count, 1u);
    const OffsetConsensus equal = findOffset(std::vector<double>(7, -2.0), {}, 0.01);
    EXPECT_EQ(equal.offset, -2.0);
    EXPECT_EQ(equal.rms_m, 0.0);
    EXPECT_EQ(equal.count, 7u);
    EXPECT_EQ(findOffset(std::vector<double>{1.0}, std::vector<double>{0.0}, 0.01).weight, 0.0);
}

}  // namespace

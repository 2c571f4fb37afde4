// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/circle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace
{

using namespace s2b;
using Points = std::vector<Eigen::Vector2d>;

/// Points on an arc from angle 0, with normal noise across it.
Points noisyArc(const Eigen::Vector2d& center, double radius, double sweep, double sigma, int count, unsigned seed)
{
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> angle(0.0, sweep);
    std::normal_distribution<double> noise(0.0, sigma);
    Points points;
    for (int i = 0; i < count; ++i)
    {
        const double a = angle(generator);
        const double r = radius + noise(generator);
        points.push_back(center + r * Eigen::Vector2d(std::cos(a), std::sin(a)));
    }
    return points;
}

constexpr double kFullTurn = 2.0 * std::numbers::pi;

TEST(FitCircle, FindsARoundColumn)
{
    const auto fit = fitCircle(noisyArc({3, 4}, 0.25, kFullTurn, 0.003, 1500, 1), {}, {});
    ASSERT_TRUE(fit);
    // Standard error of the radius 0.003 / sqrt(1500) = 8e-5, of the centre sqrt(2) times that; 5 of them.
    EXPECT_NEAR(fit->radius_m, 0.25, 4e-4);
    EXPECT_LT((fit->center - Eigen::Vector2d(3, 4)).norm(), 6e-4);
    EXPECT_NEAR(fit->rms_m, 0.003, 3e-4);  // relative standard error of an RMS of 1500: 1.8 %
    EXPECT_EQ(fit->inlierShare, 1.0);      // 0.02 is more than 6 sigma
    EXPECT_EQ(fit->arcCoverage, 1.0);      // 20 points a sector: an empty one has probability 1e-7
}

TEST(FitCircle, FindsAHalfHiddenColumnAmongClutter)
{
    Points points = noisyArc({-2, 1}, 0.2, kFullTurn / 2, 0.003, 600, 2);
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> place(-0.5, 0.5);
    for (int i = 0; i < 400; ++i)
        points.emplace_back(-2 + place(generator), 1 + place(generator));
    CircleOptions options;
    options.tolerance_m = 0.01;
    const auto fit = fitCircle(points, {}, options);
    ASSERT_TRUE(fit);
    // Clutter within 1 cm of the circle, some 20 points of a uniform spread, adds 5.8 mm / sqrt(20) / 30 = 4e-5 to the
    // standard errors of the half circle (about 4e-4 for the centre along its axis); 5 of them.
    EXPECT_NEAR(fit->radius_m, 0.2, 2e-3);
    EXPECT_LT((fit->center - Eigen::Vector2d(-2, 1)).norm(), 2e-3);
    EXPECT_GT(fit->inlierShare, 0.6);
    EXPECT_LT(fit->inlierShare, 0.66);
    EXPECT_GE(fit->arcCoverage, 0.5);
}

TEST(FitCircle, ASquareIsNoCircle)
{
    Points points;
    for (int i = 0; i < 400; ++i)
    {
        const double t = -0.2 + 0.001 * i;
        for (const double side : {-0.2, 0.2})
        {
            points.emplace_back(t, side);
            points.emplace_back(side, t);
        }
    }
    CircleOptions options;
    options.tolerance_m = 0.012;
    const auto fit = fitCircle(points, {}, options);
    ASSERT_TRUE(fit);
    // The most that a band of +-12 mm can hold of a square of 0.4 m: 8 pieces of about 70 mm of its 1.6 m.
    EXPECT_LT(fit->inlierShare, 0.5);
}

TEST(FitCircle, WithAKnownRadiusAShortArcHasItsCentre)
{
    const Points points = noisyArc({10, 10}, 0.3, 0.5, 0.002, 800, 5);
    CircleOptions options;
    options.tolerance_m = 0.01;
    options.knownRadius_m = 0.3;
    const auto fit = fitCircle(points, {}, options);
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->radius_m, 0.3);
    // Along the arc's tangent only its curvature tells: standard error 0.002 / sqrt(800) / (0.5 / sqrt(12)) = 5e-4.
    EXPECT_LT((fit->center - Eigen::Vector2d(10, 10)).norm(), 2.5e-3);
    EXPECT_LT(fit->arcCoverage, 0.1);
}

TEST(FitCircle, KeepsToTheLimitsOfTheRadius)
{
    // Two circles about one centre; the larger has more points.
    Points points = noisyArc({0, 0}, 0.5, kFullTurn, 0.002, 600, 6);
    const Points small = noisyArc({0, 0}, 0.2, kFullTurn, 0.002, 300, 7);
    points.insert(points.end(), small.begin(), small.end());
    CircleOptions options;
    const auto any = fitCircle(points, {}, options);
    options.maximumRadius_m = 0.4;
    const auto limited = fitCircle(points, {}, options);
    ASSERT_TRUE(any && limited);
    // Standard errors 0.002 / sqrt(600) and / sqrt(300): 1e-4; 5 of them.
    EXPECT_NEAR(any->radius_m, 0.5, 5e-4);
    EXPECT_NEAR(limited->radius_m, 0.2, 6e-4);
}

TEST(FitCircle, CountsWeights)
{
    Points points = noisyArc({0, 0}, 0.5, kFullTurn, 1e-12, 300, 8);
    std::vector<double> weights(points.size(), 1.0);
    const Points heavy = noisyArc({3, 0}, 0.2, kFullTurn, 1e-12, 100, 9);
    points.insert(points.end(), heavy.begin(), heavy.end());
    weights.resize(points.size(), 10.0);
    const auto fit = fitCircle(points, weights, {});
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->radius_m, 0.2, 1e-6);  // exact points: only the last step of the iteration remains
    EXPECT_NEAR(fit->inlierShare, 1000.0 / 1300.0, 1e-12);
}

TEST(FitCircle, IsTheSameForASeedAndKeepsMillimetresFarFromTheOrigin)
{
    const Eigen::Vector2d origin(4.5e6, 5.4e6);
    const Points points = noisyArc(origin, 0.25, kFullTurn, 0.003, 500, 10);
    const auto first = fitCircle(points, {}, {});
    const auto second = fitCircle(points, {}, {});
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->center, second->center);
    EXPECT_EQ(first->radius_m, second->radius_m);
    EXPECT_NEAR(first->radius_m, 0.25, 7e-4);  // 5 standard errors, 0.003 / sqrt(500)
    EXPECT_LT((first->center - origin).norm(), 1e-3);
}

TEST(FitCircle, HasNoneWithoutThreePointsOffALine)
{
    EXPECT_FALSE(fitCircle({}, {}, {}));
    EXPECT_FALSE(fitCircle(Points{{1, 1}}, {}, {}));
    EXPECT_FALSE(fitCircle(Points{{1, 1}, {2, 1}}, {}, {}));
    EXPECT_FALSE(fitCircle(Points(50, {1, 1}), {}, {}));
    Points line;
    for (int i = 0; i < 50; ++i)
        line.emplace_back(0.1 * i, 0.2 * i);
    EXPECT_FALSE(fitCircle(line, {}, {}));
    EXPECT_FALSE(fitCircle(line, std::vector<double>(line.size(), 0.0), {}));
}

TEST(FitCircle, SmallestSettingsWork)
{
    CircleOptions options;
    options.trials = 1;
    options.tolerance_m = 1e-9;
    const auto fit = fitCircle(Points{{1, 0}, {0, 1}, {-1, 0}}, {}, options);
    if (fit)  // the one draw may take a point twice
    {
        EXPECT_NEAR(fit->radius_m, 1.0, 1e-12);
    }
    options.trials = 100;
    ASSERT_TRUE(fitCircle(Points{{1, 0}, {0, 1}, {-1, 0}}, {}, options));
}

}  // namespace

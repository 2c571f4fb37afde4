// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/circle.h"

#include "core/base/random.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace s2b
{

namespace
{

constexpr int kRefineRounds = 20;
constexpr std::size_t kSectors = 72;

struct Circle
{
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double radius = 0.0;
    [[nodiscard]] double distance(const Eigen::Vector2d& p) const { return (p - center).norm() - radius; }
};

/// Relative to the first point, with weights filled in.
struct Sample
{
    std::vector<Eigen::Vector2d> points;
    std::vector<double> weights;
    std::vector<double> weightUpTo;  ///< sum of the weights before and of each point
    double totalWeight = 0.0;

    /// The point at a share in [0, 1) of all weight.
    [[nodiscard]] const Eigen::Vector2d& pointAt(double share) const
    {
        const auto at = std::ranges::upper_bound(weightUpTo, share * totalWeight) - weightUpTo.begin();
        return points[std::min(points.size() - 1, static_cast<std::size_t>(at))];
    }
};

/// The circle through three points; nothing for (nearly) collinear or equal ones.
std::optional<Circle> circumcircle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
    const Eigen::Vector2d ab = b - a;
    const Eigen::Vector2d ac = c - a;
    const double twiceArea2 = 2.0 * (ab.x() * ac.y() - ab.y() * ac.x());
    if (std::abs(twiceArea2) <= 1e-12 * (ab.squaredNorm() + ac.squaredNorm()))
        return std::nullopt;
    const Eigen::Vector2d toCenter = Eigen::Vector2d(ac.y() * ab.squaredNorm() - ab.y() * ac.squaredNorm(),
                                                     ab.x() * ac.squaredNorm() - ac.x() * ab.squaredNorm()) /
                                     twiceArea2;
    return Circle{a + toCenter, toCenter.norm()};
}

/// One of the two circles of a radius through two points; nothing when they are equal or too far apart.
std::optional<Circle> circleThrough(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double radius, bool left)
{
    const Eigen::Vector2d chord = b - a;
    const double half = 0.5 * chord.norm();
    if (!(half > 0.0) || half > radius)
        return std::nullopt;
    const Eigen::Vector2d normal = Eigen::Vector2d(-chord.y(), chord.x()).normalized();
    const double height = std::sqrt(radius * radius - half * half);
    return Circle{0.5 * (a + b) + (left ? height : -height) * normal, radius};
}

std::optional<Circle> draw(const Sample& sample, const CircleOptions& options, std::uint64_t trial)
{
    const auto pick = [&](std::uint64_t part) -> const Eigen::Vector2d&
    { return sample.pointAt(randomShare(options.seed, trial, part)); };
    if (options.knownRadius_m)
        return circleThrough(pick(0), pick(1), *options.knownRadius_m, randomBits(options.seed, trial, 2) % 2 == 0);
    return circumcircle(pick(0), pick(1), pick(2));
}

/// MSAC: an inlier counts the more the nearer it is.
double scoreOf(const Circle& circle, const Sample& sample, double tolerance)
{
    double score = 0.0;
    for (std::size_t i = 0; i < sample.points.size(); ++i)
    {
        const double share = circle.distance(sample.points[i]) / tolerance;
        score += sample.weights[i] * std::max(0.0, 1.0 - share * share);
    }
    return score;
}

/// One step of Gauss-Newton on the distances of the inliers. @return false when they don't determine it.
bool improve(Circle& circle, const Sample& sample, const CircleOptions& options)
{
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < sample.points.size(); ++i)
    {
        const Eigen::Vector2d arm = sample.points[i] - circle.center;
        const double residual = arm.norm() - circle.radius;
        if (std::abs(residual) > options.tolerance_m || arm.norm() == 0.0)
            continue;
        const Eigen::Vector3d row(-arm.x() / arm.norm(), -arm.y() / arm.norm(), options.knownRadius_m ? 0.0 : -1.0);
        normal += sample.weights[i] * row * row.transpose();
        right -= sample.weights[i] * row * residual;
    }
    if (options.knownRadius_m)
        normal(2, 2) = 1.0;  // leaves the radius alone
    const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
    if (solver.info() != Eigen::Success || !(solver.rcond() > 1e-10))
        return false;
    const Eigen::Vector3d step = solver.solve(right);
    circle.center += step.head<2>();
    circle.radius += step[2];
    return step.allFinite() && step.norm() > 1e-10;
}

bool isAllowed(const Circle& circle, const CircleOptions& options)
{
    if (!circle.center.allFinite() || !std::isfinite(circle.radius))
        return false;
    return options.knownRadius_m ||
           (circle.radius >= options.minimumRadius_m && circle.radius <= options.maximumRadius_m);
}

/// Refines while that makes the circle better: a step on a short arc can run away.
Circle refined(const Circle& drawn, const Sample& sample, const CircleOptions& options)
{
    Circle best = drawn;
    double bestScore = scoreOf(drawn, sample, options.tolerance_m);
    Circle current = drawn;
    for (int round = 0; round < kRefineRounds; ++round)
    {
        const bool goOn = improve(current, sample, options);
        const double score = scoreOf(current, sample, options.tolerance_m);
        if (!isAllowed(current, options) || score < 0.5 * bestScore)
            break;
        if (score >= bestScore)
        {
            best = current;
            bestScore = score;
        }
        if (!goOn)
            break;
    }
    return best;
}

CircleFit describe(const Circle& circle, const Sample& sample, double tolerance)
{
    CircleFit fit;
    fit.center = circle.center;
    fit.radius_m = circle.radius;
    double weight = 0.0;
    double squares = 0.0;
    std::bitset<kSectors> sectors;
    for (std::size_t i = 0; i < sample.points.size(); ++i)
    {
        const double distance = circle.distance(sample.points[i]);
        if (std::abs(distance) > tolerance || !(sample.weights[i] > 0.0))
            continue;
        weight += sample.weights[i];
        squares += sample.weights[i] * distance * distance;
        const Eigen::Vector2d arm = sample.points[i] - circle.center;
        const double turn = (std::atan2(arm.y(), arm.x()) + std::numbers::pi) / (2.0 * std::numbers::pi);
        sectors.set(std::min(kSectors - 1, static_cast<std::size_t>(turn * double(kSectors))));
    }
    fit.inlierShare = weight / sample.totalWeight;
    fit.rms_m = weight > 0.0 ? std::sqrt(squares / weight) : 0.0;
    fit.arcCoverage = double(sectors.count()) / double(kSectors);
    return fit;
}

}  // namespace

std::optional<CircleFit> fitCircle(std::span<const Eigen::Vector2d> points, std::span<const double> weights,
                                   const CircleOptions& options)
{
    Sample sample;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double weight = weights.empty() ? 1.0 : weights[i];
        if (!(weight > 0.0))
            continue;
        sample.points.push_back(points[i] - points.front());
        sample.weights.push_back(weight);
        sample.totalWeight += weight;
        sample.weightUpTo.push_back(sample.totalWeight);
    }
    if (sample.points.size() < 2)
        return std::nullopt;

    std::optional<Circle> best;
    double bestScore = 0.0;
    for (int trial = 0; trial < options.trials; ++trial)
    {
        const std::optional<Circle> circle = draw(sample, options, static_cast<std::uint64_t>(trial));
        if (!circle || !isAllowed(*circle, options))
            continue;
        const double score = scoreOf(*circle, sample, options.tolerance_m);
        if (score > bestScore)
        {
            best = circle;
            bestScore = score;
        }
    }
    if (!best)
        return std::nullopt;
    CircleFit fit = describe(refined(*best, sample, options), sample, options.tolerance_m);
    fit.center += points.front();
    return fit;
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/line.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace s2b
{

namespace
{

constexpr int kRounds = 20;
/// Of a normal distribution: standard deviation by median absolute deviation.
constexpr double kSigmaOfMad = 1.4826;
/// Tukey's constant: 95 % efficiency for normal noise.
constexpr double kBiweight = 4.685;

struct Weighted
{
    double value;
    double weight;
};

double weightOf(std::span<const double> weights, std::size_t i)
{
    return weights.empty() ? 1.0 : weights[i];
}

/// Where half of the weight is reached; the middle of two values when it is reached between them.
double weightedMedian(std::vector<Weighted> values)
{
    std::ranges::sort(values, {}, [](const Weighted& v) { return std::pair(v.value, v.weight); });
    double total = 0.0;
    for (const Weighted& v : values)
        total += v.weight;
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        sum += values[i].weight;
        if (2.0 * sum == total && i + 1 < values.size())
            return 0.5 * (values[i].value + values[i + 1].value);
        if (2.0 * sum >= total)
            return values[i].value;
    }
    return values.empty() ? 0.0 : values.back().value;
}

double biweight(double residual, double limit)
{
    const double u = residual / limit;
    return std::abs(u) >= 1.0 ? 0.0 : (1.0 - u * u) * (1.0 - u * u);
}

LineFit totalLeastSquares(std::span<const Eigen::Vector2d> points, std::span<const double> weights)
{
    LineFit fit;
    if (points.empty())
        return fit;
    // Relative to one of the points: far from the origin, products of coordinates would lose the millimetres.
    const Eigen::Vector2d reference = points.front();
    double sum = 0.0;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        sum += weights[i];
        mean += weights[i] * (points[i] - reference);
    }
    if (!(sum > 0.0))
        return fit;
    mean /= sum;
    Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const Eigen::Vector2d d = points[i] - reference - mean;
        moments += weights[i] * d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(moments);
    if (!(solver.eigenvalues()[1] > 0.0))
        return fit;  // one place
    fit.point = reference + mean;
    fit.direction = solver.eigenvectors().col(1);
    if (fit.direction.x() < 0.0 || (fit.direction.x() == 0.0 && fit.direction.y() < 0.0))
        fit.direction = -fit.direction;
    fit.weight = sum;
    double squares = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
        squares += weights[i] * std::pow(fit.distance(points[i]), 2);
    fit.rms_m = std::sqrt(squares / sum);
    return fit;
}

}  // namespace

LineFit fitLine(std::span<const Eigen::Vector2d> points, std::span<const double> weights)
{
    std::vector<double> current(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        current[i] = weightOf(weights, i);
    LineFit fit = totalLeastSquares(points, current);

    std::vector<Weighted> residuals(points.size());
    for (int round = 0; round < kRounds && fit.weight > 0.0; ++round)
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            residuals[i] = {std::abs(fit.distance(points[i])), weightOf(weights, i)};
        const double limit = kBiweight * kSigmaOfMad * weightedMedian(residuals);
        if (!(limit > 0.0))
            break;  // half of the weight lies on the line
        for (std::size_t i = 0; i < points.size(); ++i)
            current[i] = weightOf(weights, i) * biweight(residuals[i].value, limit);
        const LineFit next = totalLeastSquares(points, current);
        if (!(next.weight > 0.0))
            break;
        const double moved = std::abs(fit.distance(next.point)) + (next.direction - fit.direction).norm() * fit.rms_m;
        fit = next;
        if (moved < 1e-9)
            break;
    }
    return fit;
}

OffsetConsensus findOffset(std::span<const double> offsets, std::span<const double> weights, double tolerance)
{
    std::vector<Weighted> sorted;
    sorted.reserve(offsets.size());
    for (std::size_t i = 0; i < offsets.size(); ++i)
    {
        if (weightOf(weights, i) > 0.0)
            sorted.push_back({offsets[i], weightOf(weights, i)});
    }
    OffsetConsensus result;
    if (sorted.empty())
        return result;
    // By weight too: sums are then the same for any order of the input.
    std::ranges::sort(sorted, {}, [](const Weighted& w) { return std::pair(w.value, w.weight); });

    // Sums of whole prefixes, so that a window's weight does not depend on the windows before it.
    std::vector<double> prefix(sorted.size() + 1, 0.0);
    for (std::size_t i = 0; i < sorted.size(); ++i)
        prefix[i + 1] = prefix[i] + sorted[i].weight;
    std::size_t first = 0;
    std::size_t last = 0;
    double heaviest = -1.0;
    for (std::size_t begin = 0, end = 0; begin < sorted.size(); ++begin)
    {
        while (end < sorted.size() && sorted[end].value - sorted[begin].value <= 2.0 * tolerance)
            ++end;
        if (prefix[end] - prefix[begin] > heaviest)
        {
            heaviest = prefix[end] - prefix[begin];
            first = begin;
            last = end;
        }
    }

    using Difference = std::vector<Weighted>::difference_type;
    const std::vector<Weighted> window(sorted.begin() + Difference(first), sorted.begin() + Difference(last));
    result.offset = weightedMedian(window);
    for (int round = 0; round < kRounds; ++round)
    {
        std::vector<Weighted> deviations;
        for (const Weighted& w : sorted)
        {
            if (std::abs(w.value - result.offset) <= tolerance)
                deviations.push_back({std::abs(w.value - result.offset), w.weight});
        }
        const double limit = std::min(tolerance, kBiweight * kSigmaOfMad * weightedMedian(std::move(deviations)));
        if (!(limit > 0.0))
            break;  // half of the weight is at one offset
        double sum = 0.0;
        double moment = 0.0;
        for (const Weighted& w : sorted)
        {
            const double share = w.weight * biweight(w.value - result.offset, limit);
            sum += share;
            moment += share * (w.value - result.offset);
        }
        if (!(sum > 0.0))
            break;
        result.offset += moment / sum;
        if (std::abs(moment / sum) < 1e-9)
            break;
    }

    double squares = 0.0;
    for (const Weighted& w : sorted)
    {
        if (std::abs(w.value - result.offset) > tolerance)
            continue;
        result.weight += w.weight;
        squares += w.weight * std::pow(w.value - result.offset, 2);
        ++result.count;
    }
    result.share = result.weight / prefix.back();
    result.rms_m = result.weight > 0.0 ? std::sqrt(squares / result.weight) : 0.0;
    return result;
}

}  // namespace s2b

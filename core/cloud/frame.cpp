// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/frame.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace s2b
{
namespace
{

constexpr double kQuarter = std::numbers::pi / 2;
constexpr std::size_t kSamples = 1000000;    // cells that settle the slope to a few microradians
constexpr std::size_t kFewSamples = 200000;  // on the way there

bool isVertical(const SurfaceCell& c, double tolerance)
{
    return !c.normal.isZero() && std::abs(c.normal.z()) < tolerance;
}

/// Weight of a cell in the search for directions: what is surely not the building's does not count.
double weightOf(const SurfaceCells& cells, const SurfaceCell& c)
{
    if (!cells.hasLabels)
        return 1.0;
    switch (c.label)
    {
        case Label::Wall:
            return 1.0;
        case Label::Furniture:
        case Label::Stair:
            return 0.0;
        default:
            return 0.1;
    }
}

/// Peak of the directions modulo a quarter turn: histogram of quarter-degree bins, smoothed, then the mean around it.
double histogramPeak(const SurfaceCells& cells, double tolerance)
{
    constexpr std::size_t bins = 360;
    std::array<double, bins> histogram{};
    const auto folded = [](const Eigen::Vector3f& n)
    {
        const double a = std::fmod(static_cast<double>(std::atan2(n.y(), n.x())), kQuarter);
        return a < 0 ? a + kQuarter : a;
    };
    const std::size_t step = cells.cells.size() / kFewSamples + 1;
    for (std::size_t i = 0; i < cells.cells.size(); i += step)
        if (const SurfaceCell& c = cells.cells[i]; isVertical(c, tolerance))
            histogram[std::min(bins - 1, static_cast<std::size_t>(folded(c.normal) / kQuarter * bins))] +=
                weightOf(cells, c);
    std::size_t best = 0;
    double bestSum = 0;
    for (std::size_t i = 0; i < bins; ++i)
    {
        double sum = 0;
        for (int k = -6; k <= 6; ++k)
            sum +=
                histogram[(i + bins + static_cast<std::size_t>(k + static_cast<int>(bins))) % bins] * (7 - std::abs(k));
        if (sum > bestSum)
            bestSum = sum, best = i;
    }
    if (bestSum == 0)
        return 0;
    const double centre = (static_cast<double>(best) + 0.5) * kQuarter / bins;
    double sum = 0, weight = 0;
    for (std::size_t i = 0; i < cells.cells.size(); i += step)
    {
        const SurfaceCell& c = cells.cells[i];
        if (!isVertical(c, tolerance))
            continue;
        const double d = std::remainder(folded(c.normal) - centre, kQuarter);
        if (std::abs(d) < 0.05)
            sum += d * weightOf(cells, c), weight += weightOf(cells, c);
    }
    return centre + (weight > 0 ? sum / weight : 0);
}

/// Least squares of offset over position, summed over planes.
struct Slope
{
    double numerator = 0, denominator = 0;
};

/// Slope of the largest planes whose normals are near one of the current axes.
Slope slopeOfPlanes(const SurfaceCells& cells, double yaw, double tolerance, std::size_t mostSamples, std::size_t axis)
{
    const double co = std::cos(yaw), si = std::sin(yaw);
    Slope slope;
    struct Sample
    {
        double offset, along, weight;
    };
    std::vector<Sample> samples;
    const std::size_t step = cells.cells.size() / mostSamples + 1;
    for (std::size_t i = 0; i < cells.cells.size(); i += step)
    {
        const SurfaceCell& c = cells.cells[i];
        if (!isVertical(c, tolerance))
            continue;
        const double w = weightOf(cells, c);
        const double nx = co * c.normal.x() + si * c.normal.y(), ny = -si * c.normal.x() + co * c.normal.y();
        if (w == 0 || std::abs(axis == 0 ? nx : ny) < 0.985)
            continue;
        const double x = co * c.position.x() + si * c.position.y(), y = -si * c.position.x() + co * c.position.y();
        // Offset along the normal and position along the plane, such that d offset / d along is a turn of the axes.
        axis == 0 ? samples.push_back({-x, y, w}) : samples.push_back({y, x, w});
    }
    std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b)
              { return std::tie(a.offset, a.along) < std::tie(b.offset, b.along); });
    // Windows of 6 cm, the heaviest first, taking their samples out.
    constexpr double window = 0.06;
    std::vector<char> used(samples.size(), 0);
    for (int plane = 0; plane < 12; ++plane)
    {
        double sum = 0, bestSum = 0;
        std::size_t first = 0, bestFirst = 0, bestLast = 0;
        for (std::size_t i = 0; i < samples.size(); ++i)
        {
            sum += used[i] ? 0 : samples[i].weight;
            while (samples[i].offset - samples[first].offset > window)
                sum -= used[first] ? 0 : samples[first].weight, ++first;
            if (sum > bestSum)
                bestSum = sum, bestFirst = first, bestLast = i;
        }
        if (bestSum < 50)
            break;
        double w = 0, ma = 0, mo = 0;
        for (std::size_t i = bestFirst; i <= bestLast; ++i)
            if (!used[i])
                w += samples[i].weight, ma += samples[i].weight * samples[i].along,
                    mo += samples[i].weight * samples[i].offset;
        ma /= w, mo /= w;
        for (std::size_t i = bestFirst; i <= bestLast; ++i)
            if (!used[i])
            {
                const double a = samples[i].along - ma;
                slope.numerator += samples[i].weight * a * (samples[i].offset - mo);
                slope.denominator += samples[i].weight * a * a;
                used[i] = 1;
            }
    }
    return slope;
}

/// Mean slope of the largest planes against the current axes.
double slopeOfLargestPlanes(const SurfaceCells& cells, double yaw, double tolerance, std::size_t mostSamples,
                            const Context& context)
{
    std::array<Slope, 2> slopes;
    parallelChunks(2, 1, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t axis = begin; axis < end; ++axis)
                           slopes[axis] = slopeOfPlanes(cells, yaw, tolerance, mostSamples, axis);
                   });
    const double denominator = slopes[0].denominator + slopes[1].denominator;
    return denominator > 0 ? (slopes[0].numerator + slopes[1].numerator) / denominator : 0;
}

}  // namespace

double findDominantYaw(const SurfaceCells& cells, const FrameParams& params, const Context& context)
{
    double yaw = histogramPeak(cells, params.verticalTolerance);
    for (const std::size_t samples : {kFewSamples, kFewSamples, kFewSamples, kSamples})
        yaw += slopeOfLargestPlanes(cells, yaw, params.verticalTolerance, samples, context);
    return std::remainder(yaw, kQuarter);
}

void rotateCells(SurfaceCells& cells, double yaw_rad)
{
    const double co = std::cos(yaw_rad), si = std::sin(yaw_rad);
    for (SurfaceCell& c : cells.cells)
    {
        const auto turn = [&](Eigen::Vector3f& v)
        {
            const double x = v.x(), y = v.y();
            v.x() = static_cast<float>(co * x + si * y);
            v.y() = static_cast<float>(-si * x + co * y);
        };
        turn(c.position);
        turn(c.normal);
    }
}

}  // namespace s2b

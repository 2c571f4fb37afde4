// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/axis_sort.h"

#include "core/walls/plan_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

namespace s2b
{
namespace
{

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kBins = 180;

bool isCandidate(const SurfaceCell& c, const Level& level)
{
    return !c.normal.isZero() && std::abs(c.normal.z()) < 0.3f && c.position.z() > level.floor_m + 0.05 &&
           c.position.z() < level.highestCeiling_m() + 0.05;
}

/// A cell that may be of a wall, and the direction of its normal in [0, pi): within a histogram's bin, a float says it.
struct Candidate
{
    std::uint32_t cell = 0;
    float angle_rad = 0.0f;
};

float angleOf(const SurfaceCell& c)
{
    constexpr auto pi = static_cast<float>(kPi);
    const float a = std::atan2(c.normal.y(), c.normal.x());
    return a < 0 ? a + pi : (a >= pi ? a - pi : a);
}

/// Between directions in [0, pi).
double turn(double a, double b)
{
    const double d = std::abs(a - b);
    return std::min(d, kPi - d);
}

/// Peaks of the normals' directions, in the order of their weight; at least `apart` from each other.
std::vector<double> findDirections(const SurfaceCells& cells, const std::vector<Candidate>& candidates, double apart)
{
    std::array<double, kBins> histogram{};
    double total = 0;
    for (const Candidate& c : candidates)
    {
        const double w = wallWeight(cells, cells.cells[c.cell]);
        histogram[std::min(kBins - 1, static_cast<std::size_t>(static_cast<double>(c.angle_rad) / kPi * kBins))] += w;
        total += w;
    }
    std::vector<std::pair<double, double>> peaks;  // weight, angle
    for (std::size_t i = 0; i < kBins; ++i)
    {
        double sum = 0;
        for (std::size_t k = 0; k <= 8; ++k)
            sum += histogram[(i + kBins + k - 4) % kBins];
        peaks.emplace_back(sum, (static_cast<double>(i) + 0.5) * kPi / kBins);
    }
    std::sort(peaks.begin(), peaks.end(),
              [](const auto& a, const auto& b) { return std::tie(b.first, a.second) < std::tie(a.first, b.second); });
    std::vector<double> directions;
    for (const auto& [weight, angle] : peaks)
        if (weight > 0.004 * total && weight > 0 &&
            std::none_of(directions.begin(), directions.end(), [&, a = angle](double d) { return turn(a, d) < apart; }))
            directions.push_back(angle);
    return directions;
}

}  // namespace

double wallWeight(const SurfaceCells& cells, const SurfaceCell& cell)
{
    if (!cells.hasLabels)
        return 1.0;
    if (!cells.hasGuesses)
        return cell.label == Label::Wall ? 1.0 : 0.0;
    // Where a model does not know, sees glass, or takes an upright surface for a part of floors and roofs, its shape
    // decides.
    switch (cell.label)
    {
        case Label::Wall:
            return 1.0;
        case Label::Column:
        case Label::Door:
        case Label::Furniture:
            return 0.0;
        default:
            return 0.7;
    }
}

std::vector<AxisSet> sortByAxis(const SurfaceCells& cells, const Level& level, const WallParams& params,
                                const Context& context)
{
    std::vector<Candidate> candidates;
    for (const SurfaceCell& c : cellsOf(cells, level))
        if (isCandidate(c, level) && wallWeight(cells, c) > 0)
            candidates.push_back({static_cast<std::uint32_t>(&c - cells.cells.data()), angleOf(c)});
    // |n . axis| > 1 - tolerance on both sides: sets twice that far apart don't overlap.
    const double halfWidth = std::acos(1.0 - params.normalTolerance);
    const std::vector<double> directions = findDirections(cells, candidates, halfWidth);

    std::vector<PlanEntry> entries;
    for (const Candidate& c : candidates)
    {
        const auto angle = static_cast<double>(c.angle_rad);
        std::uint32_t best = 0;
        double bestTurn = halfWidth;
        for (std::uint32_t k = 0; k < directions.size(); ++k)
            if (const double t = turn(angle, directions[k]); t < bestTurn)
                bestTurn = t, best = k + 1;
        if (best > 0)
            entries.push_back(planEntry(cells, c.cell, best - 1));
    }
    sortByPlace(entries, context);
    std::vector<AxisSet> sets(directions.size());
    for (std::size_t k = 0; k < directions.size(); ++k)
        sets[k].angle_rad = directions[k];
    for (std::size_t i = 0; i < entries.size();)
    {
        const PlanEntry first = entries[i];
        PlanPixel pixel;
        Eigen::Vector2d sum = Eigen::Vector2d::Zero(), doubled = Eigen::Vector2d::Zero();
        double points = 0;
        for (; i < entries.size() && entries[i].place == first.place; ++i)
        {
            const SurfaceCell& c = cells.cells[entries[i].cell];
            const double w = wallWeight(cells, c);
            const Eigen::Vector2d n = c.normal.head<2>().cast<double>().normalized();
            pixel.weight += w;
            points += w * c.count;
            sum += w * c.count * c.position.head<2>().cast<double>();
            doubled += w * Eigen::Vector2d(n.x() * n.x() - n.y() * n.y(), 2 * n.x() * n.y());
        }
        pixel.position = sum / points;
        const double a = std::atan2(doubled.y(), doubled.x()) / 2;
        pixel.normal = {std::cos(a), std::sin(a)};
        sets[first.group()].pixels.push_back(pixel);
    }
    return sets;
}

}  // namespace s2b

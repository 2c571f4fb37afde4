// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/axis_sort.h"

#include "core/base/floor_to_int.h"

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

double angleOf(const SurfaceCell& c)
{
    const double a = std::atan2(static_cast<double>(c.normal.y()), static_cast<double>(c.normal.x()));
    return a < 0 ? a + kPi : (a >= kPi ? a - kPi : a);
}

double turn(double a, double b)
{
    return std::abs(std::remainder(a - b, kPi));
}

/// Peaks of the normals' directions, in the order of their weight; at least `apart` from each other.
std::vector<double> findDirections(const SurfaceCells& cells, const std::vector<std::uint32_t>& candidates,
                                   double apart)
{
    std::array<double, kBins> histogram{};
    double total = 0;
    for (const std::uint32_t i : candidates)
    {
        const double w = wallWeight(cells, cells.cells[i]);
        histogram[std::min(kBins - 1, static_cast<std::size_t>(angleOf(cells.cells[i]) / kPi * kBins))] += w;
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

std::vector<AxisSet> sortByAxis(const SurfaceCells& cells, const Level& level, const WallParams& params)
{
    std::vector<std::uint32_t> candidates;
    for (const SurfaceCell& c : cellsOf(cells, level))
        if (isCandidate(c, level) && wallWeight(cells, c) > 0)
            candidates.push_back(static_cast<std::uint32_t>(&c - cells.cells.data()));
    // |n . axis| > 1 - tolerance on both sides: sets twice that far apart don't overlap.
    const double halfWidth = std::acos(1.0 - params.normalTolerance);
    const std::vector<double> directions = findDirections(cells, candidates, halfWidth);

    struct Entry
    {
        std::uint32_t set;
        std::int32_t x, y;
        std::uint32_t cell;
    };
    std::vector<Entry> entries;
    for (const std::uint32_t i : candidates)
    {
        const double a = angleOf(cells.cells[i]);
        std::uint32_t best = 0;
        double bestTurn = halfWidth;
        for (std::uint32_t k = 0; k < directions.size(); ++k)
            if (turn(a, directions[k]) < bestTurn)
                bestTurn = turn(a, directions[k]), best = k + 1;
        if (best == 0)
            continue;
        const Eigen::Vector3f& p = cells.cells[i].position;
        entries.push_back({best - 1, floorToInt(static_cast<double>(p.x()) / cells.size_m),
                           floorToInt(static_cast<double>(p.y()) / cells.size_m), i});
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b)
              { return std::tie(a.set, a.y, a.x, a.cell) < std::tie(b.set, b.y, b.x, b.cell); });
    std::vector<AxisSet> sets(directions.size());
    for (std::size_t k = 0; k < directions.size(); ++k)
        sets[k].angle_rad = directions[k];
    for (std::size_t i = 0; i < entries.size();)
    {
        const Entry& first = entries[i];
        PlanPixel pixel;
        Eigen::Vector2d sum = Eigen::Vector2d::Zero(), doubled = Eigen::Vector2d::Zero();
        double points = 0;
        for (; i < entries.size() && entries[i].set == first.set && entries[i].x == first.x && entries[i].y == first.y;
             ++i)
        {
            const SurfaceCell& c = cells.cells[entries[i].cell];
            const double w = wallWeight(cells, c), a = 2 * angleOf(c);
            pixel.weight += w;
            points += w * c.count;
            sum += w * c.count * c.position.head<2>().cast<double>();
            doubled += w * Eigen::Vector2d(std::cos(a), std::sin(a));
        }
        pixel.position = sum / points;
        const double a = std::atan2(doubled.y(), doubled.x()) / 2;
        pixel.normal = {std::cos(a), std::sin(a)};
        sets[first.set].pixels.push_back(pixel);
    }
    return sets;
}

}  // namespace s2b

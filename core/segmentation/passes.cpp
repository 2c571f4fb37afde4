// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/passes.h"

#include <algorithm>
#include <cmath>

namespace s2b
{
namespace
{

constexpr double kBelowFloor_m = 0.1;  // of a slab whose underside was not seen

/// Height that a share of the cells is below.
double heightOfShare(std::vector<float>& z, double share)
{
    const auto at = z.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(z.size() - 1) * share);
    std::nth_element(z.begin(), at, z.end());
    return static_cast<double>(*at);
}

struct Box
{
    Eigen::Vector2f low, high;

    [[nodiscard]] bool holds(const Eigen::Vector3f& p, float reach) const
    {
        return p.x() >= low.x() - reach && p.x() <= high.x() + reach && p.y() >= low.y() - reach &&
               p.y() <= high.y() + reach;
    }
};

/// The part of a storey in one half of its box, halved again until it is small enough.
void addTiles(const SurfaceCells& cells, const std::vector<std::uint32_t>& storey, std::vector<std::uint32_t> own,
              const SegmentPass& like, const SegmentParams& params, std::vector<SegmentPass>& passes)
{
    Box box{cells.cells[own.front()].position.head<2>(), cells.cells[own.front()].position.head<2>()};
    for (const std::uint32_t i : own)
    {
        box.low = box.low.cwiseMin(cells.cells[i].position.head<2>());
        box.high = box.high.cwiseMax(cells.cells[i].position.head<2>());
    }
    const Eigen::Vector2f size = box.high - box.low;
    const auto reach = static_cast<float>(params.overlap_m);
    // Tiles no wider than what is seen around them would cost more than they save.
    const bool isLarge = own.size() > params.largestPass || static_cast<double>(size.maxCoeff()) > params.largestTile_m;
    if (isLarge && size.maxCoeff() > 4.0f * reach)
    {
        const Eigen::Index axis = size.x() >= size.y() ? 0 : 1;
        const float middle = (box.low[axis] + box.high[axis]) / 2;
        std::vector<std::uint32_t> first, rest;
        for (const std::uint32_t i : own)
            (cells.cells[i].position[axis] < middle ? first : rest).push_back(i);
        own = {};
        addTiles(cells, storey, std::move(first), like, params, passes);
        addTiles(cells, storey, std::move(rest), like, params, passes);
        return;
    }
    SegmentPass pass = like;
    pass.inside = own.size();
    pass.cells = std::move(own);
    if (pass.inside < storey.size())
    {
        // Both lists ascend: what is not the tile's own and near enough is seen too.
        std::size_t next = 0;
        for (const std::uint32_t i : storey)
            if (next < pass.inside && pass.cells[next] == i)
                ++next;
            else if (box.holds(cells.cells[i].position, reach))
                pass.cells.push_back(i);
    }
    passes.push_back(std::move(pass));
}

}  // namespace

std::vector<SegmentPass> planPasses(const SurfaceCells& cells, std::vector<Level> levels, const SegmentParams& params,
                                    const Context& context)
{
    if (levels.empty())
    {
        std::vector<float> z;
        z.reserve(cells.cells.size());
        for (const SurfaceCell& c : cells.cells)
            z.push_back(c.position.z());
        levels.emplace_back();
        levels[0].floor_m = heightOfShare(z, 0.02);
        levels[0].ceiling_m = heightOfShare(z, 0.98);
    }
    std::vector<double> tops;
    for (std::size_t i = 0; i + 1 < levels.size(); ++i)
    {
        const Level& level = levels[i];
        const double floor = levels[i + 1].floor_m, ceiling = level.highestCeiling_m();
        // Through the middle of the slab: of a thin one both surfaces are within centimetres.
        tops.push_back(level.ceilingSeen && ceiling < floor ? 0.5 * (ceiling + floor)
                                                            : std::min(level.ceilingLimit_m, floor - kBelowFloor_m));
    }
    std::vector<std::vector<std::uint32_t>> storeys(levels.size());
    for (std::size_t i = 0; i < cells.cells.size(); ++i)
    {
        const auto z = static_cast<double>(cells.cells[i].position.z());
        const auto storey = static_cast<std::size_t>(std::ranges::upper_bound(tops, z) - tops.begin());
        storeys[storey].push_back(static_cast<std::uint32_t>(i));
    }
    std::vector<SegmentPass> passes;
    for (std::size_t s = 0; s < storeys.size(); ++s)
    {
        context.checkCancelled();
        if (storeys[s].empty())
            continue;
        SegmentPass like;
        like.floor_m = levels[s].floor_m;
        like.ceiling_m = levels[s].highestCeiling_m();
        addTiles(cells, storeys[s], storeys[s], like, params, passes);
    }
    return passes;
}

}  // namespace s2b

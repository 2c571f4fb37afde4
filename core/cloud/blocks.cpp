// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/blocks.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>
#include <utility>

namespace s2b
{
namespace
{

constexpr std::size_t kPointChunk = 1u << 18;

struct Bounds
{
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
};

Bounds findBounds(const CloudView& cloud, const KeptRegion& region, const Context& context)
{
    Bounds all;
    std::mutex mutex;
    std::atomic<std::size_t> firstBad{std::numeric_limits<std::size_t>::max()};
    parallelChunks(cloud.count, kPointChunk, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       Bounds b;
                       for (std::size_t i = begin; i < end; ++i)
                       {
                           const Eigen::Vector3f p = pointAt(cloud, i);
                           if (!p.allFinite())
                           {
                               std::size_t seen = firstBad.load();
                               while (i < seen && !firstBad.compare_exchange_weak(seen, i))
                               {
                               }
                               return;
                           }
                           if (!region.contains(p))
                               continue;
                           b.low = b.low.cwiseMin(p.cast<double>());
                           b.high = b.high.cwiseMax(p.cast<double>());
                       }
                       const std::lock_guard lock(mutex);
                       all.low = all.low.cwiseMin(b.low);
                       all.high = all.high.cwiseMax(b.high);
                   });
    context.checkCancelled();
    if (firstBad != std::numeric_limits<std::size_t>::max())
        throw Error(ErrorCode::BadCoordinates,
                    "point " + std::to_string(firstBad) +
                        " has coordinates that are not finite numbers; remove such points first");
    if (!(all.low.x() <= all.high.x()))
        throw Error(ErrorCode::EmptyCloud, "the cloud has no points to work on");
    return all;
}

}  // namespace

Blocks sortIntoBlocks(const CloudView& cloud, const KeptRegion& region, const Context& context)
{
    const Bounds bounds = findBounds(cloud, region, context);
    Blocks blocks;
    blocks.low = (bounds.low / kBlock_m).array().floor().cast<int>();
    const Eigen::Array3i high = (bounds.high / kBlock_m).array().floor().cast<int>();
    blocks.size = high - blocks.low + 1;
    const double gridSize = blocks.size.cast<double>().prod();
    if (gridSize > 4e8)
        throw Error(ErrorCode::BadCoordinates,
                    "the cloud spans " + std::to_string((bounds.high - bounds.low).maxCoeff()) +
                        " m; remove the points far outside the building, or turn the clutter filter on");
    const auto blockOf = [low = blocks.low, size = blocks.size](const Eigen::Vector3f& p) -> std::size_t
    {
        const auto along = [&](int axis)
        { return static_cast<std::size_t>(floorToInt(static_cast<double>(p[axis]) / kBlock_m) - low[axis]); };
        return along(0) +
               static_cast<std::size_t>(size.x()) * (along(1) + static_cast<std::size_t>(size.y()) * along(2));
    };
    const std::size_t count = static_cast<std::size_t>(gridSize);
    std::vector<std::atomic<std::uint32_t>> cursor(count + 1);
    const auto overPoints = [&](const auto& visit)
    {
        parallelChunks(cloud.count, kPointChunk, context,
                       [&](std::size_t begin, std::size_t end)
                       {
                           for (std::size_t i = begin; i < end; ++i)
                           {
                               const Eigen::Vector3f p = pointAt(cloud, i);
                               if (region.contains(p))
                                   visit(i, blockOf(p));
                           }
                       });
        context.checkCancelled();
    };
    overPoints([&](std::size_t, std::size_t b) { cursor[b].fetch_add(1, std::memory_order_relaxed); });
    blocks.start.resize(count + 1);
    std::uint32_t sum = 0;
    for (std::size_t b = 0; b < count; ++b)
    {
        blocks.start[b] = sum;
        const std::uint32_t n = cursor[b].load(std::memory_order_relaxed);
        if (n > 0)
            blocks.occupied.push_back(static_cast<std::uint32_t>(b));
        cursor[b].store(sum, std::memory_order_relaxed);
        sum += n;
    }
    blocks.start[count] = sum;
    blocks.order.resize(sum);
    overPoints([&](std::size_t i, std::size_t b)
               { blocks.order[cursor[b].fetch_add(1, std::memory_order_relaxed)] = static_cast<PointIndex>(i); });
    return blocks;
}

double estimateSpacing(const CloudView& cloud, const Blocks& blocks)
{
    constexpr double edge = 0.08;
    std::vector<std::pair<double, std::uint32_t>> perBlock;  // points per occupied cell, points
    const std::size_t step = std::max<std::size_t>(1, blocks.occupied.size() / 400);
    for (std::size_t k = 0; k < blocks.occupied.size(); k += step)
    {
        const std::uint32_t b = blocks.occupied[k];
        const std::uint32_t n = blocks.start[b + 1] - blocks.start[b];
        std::vector<std::uint64_t> keys(n);
        for (std::uint32_t j = 0; j < n; ++j)
        {
            const Eigen::Array3d c =
                (pointAt(cloud, blocks.order[blocks.start[b] + j]).cast<double>() / edge).array().floor();
            const auto part = [](double v)
            { return static_cast<std::uint64_t>(static_cast<std::int64_t>(v) + (1 << 20)); };
            keys[j] = part(c.x()) | part(c.y()) << 21 | part(c.z()) << 42;
        }
        std::sort(keys.begin(), keys.end());
        const auto distinct = std::unique(keys.begin(), keys.end()) - keys.begin();
        perBlock.emplace_back(static_cast<double>(n) / static_cast<double>(distinct), n);
    }
    std::sort(perBlock.begin(), perBlock.end());
    std::uint64_t total = 0;
    for (const auto& [density, n] : perBlock)
        total += n;
    std::uint64_t sum = 0;
    for (const auto& [density, n] : perBlock)
    {
        sum += n;
        if (2 * sum >= total)
            return std::clamp(edge / std::sqrt(density), 0.001, 0.5);
    }
    return 0.02;
}

}  // namespace s2b

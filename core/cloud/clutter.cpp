// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/clutter.h"

#include "core/base/parallel.h"
#include "core/geometry/dbscan.h"
#include "core/geometry/rectangle.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <vector>

namespace s2b
{
namespace
{

constexpr std::size_t kChunk = 1u << 18;
constexpr double kGap_m = 4.0;          // between parts of one survey, at most
constexpr double kSmallestPart = 0.05;  // of the largest part's size, for one that stands apart

struct Extent
{
    Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity());
    Eigen::Vector3f high = Eigen::Vector3f::Constant(-std::numeric_limits<float>::infinity());
};

Extent extentOf(const CloudView& cloud, const Context& context)
{
    Extent all;
    std::mutex mutex;
    parallelChunks(cloud.count, kChunk, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       Extent e;
                       for (std::size_t i = begin; i < end; ++i)
                       {
                           const Eigen::Vector3f p(cloud.xyz[3 * i], cloud.xyz[3 * i + 1], cloud.xyz[3 * i + 2]);
                           if (!p.allFinite())
                               continue;  // reported where the cells are built
                           e.low = e.low.cwiseMin(p);
                           e.high = e.high.cwiseMax(p);
                       }
                       const std::lock_guard lock(mutex);
                       all.low = all.low.cwiseMin(e.low);
                       all.high = all.high.cwiseMax(e.high);
                   });
    return all;
}

/// Drops the parts that stand apart and are small: what was seen through windows, far away.
std::vector<Eigen::Vector3d> mainParts(const std::vector<Eigen::Vector3d>& voxels, double gap)
{
    const std::vector<int> part = dbscan(voxels, gap, 1);
    std::map<int, std::size_t> sizes;
    std::size_t largest = 0;
    for (const int p : part)
        largest = std::max(largest, ++sizes[p]);
    std::vector<Eigen::Vector3d> kept;
    for (std::size_t i = 0; i < voxels.size(); ++i)
        if (static_cast<double>(sizes[part[i]]) >= kSmallestPart * static_cast<double>(largest))
            kept.push_back(voxels[i]);
    return kept;
}

}  // namespace

KeptRegion findDenseRegion(const CloudView& cloud, const ClutterParams& params, const Context& context)
{
    KeptRegion region;
    if (!params.enabled || cloud.count == 0)
        return region;
    const Extent extent = extentOf(cloud, context);
    context.checkCancelled();
    if (!(extent.low.x() <= extent.high.x()))
        return region;
    // Stray returns kilometres away must not cost memory: the grid gets coarser instead.
    double voxel = params.voxelSize_m;
    Eigen::Array3i size;
    const auto resize = [&]
    {
        const Eigen::Array3d n = ((extent.high - extent.low).cast<double>().array() / voxel).floor() + 1.0;
        if (n.prod() > 5e7)
            return false;
        size = n.cast<int>();
        return true;
    };
    while (!resize())
        voxel *= 2;
    const auto index = [&](const Eigen::Vector3f& p) -> std::size_t
    {
        const Eigen::Array3i v = ((p - extent.low).cast<double>().array() / voxel).cast<int>().min(size - 1);
        return static_cast<std::size_t>(v.x()) +
               static_cast<std::size_t>(size.x()) *
                   (static_cast<std::size_t>(v.y()) +
                    static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(v.z()));
    };
    std::vector<std::atomic<std::uint32_t>> counts(static_cast<std::size_t>(size.cast<double>().prod()));
    parallelChunks(cloud.count, kChunk, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t i = begin; i < end; ++i)
                       {
                           const Eigen::Vector3f p(cloud.xyz[3 * i], cloud.xyz[3 * i + 1], cloud.xyz[3 * i + 2]);
                           if (p.allFinite())
                               counts[index(p)].fetch_add(1, std::memory_order_relaxed);
                       }
                   });
    context.checkCancelled();
    // The voxel of the median point is the cloud's own measure of density.
    std::vector<std::uint32_t> occupied;
    std::uint64_t total = 0;
    for (const auto& c : counts)
        if (const std::uint32_t n = c.load(std::memory_order_relaxed))
            occupied.push_back(n), total += n;
    std::sort(occupied.begin(), occupied.end());
    std::uint64_t sum = 0;
    double typical = 1;
    for (const std::uint32_t n : occupied)
    {
        sum += n;
        if (2 * sum >= total)
        {
            typical = n;
            break;
        }
    }
    const double limit = params.minimumDensity * typical;
    std::vector<Eigen::Vector3d> dense;  // lower corners of voxels
    double zMin = std::numeric_limits<double>::infinity(), zMax = -zMin;
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
        if (counts[i].load(std::memory_order_relaxed) < std::max(2.0, limit))
            continue;
        const auto nx = static_cast<std::size_t>(size.x()), ny = static_cast<std::size_t>(size.y());
        const Eigen::Vector3d low =
            extent.low.cast<double>() + voxel * Eigen::Vector3d(static_cast<double>(i % nx),
                                                                static_cast<double>(i / nx % ny),
                                                                static_cast<double>(i / nx / ny));
        dense.push_back(low);
    }
    std::vector<Eigen::Vector2d> corners;
    for (const Eigen::Vector3d& low : mainParts(dense, std::max(kGap_m, 3 * voxel)))
    {
        for (int k = 0; k < 4; ++k)
            corners.emplace_back(low.x() + (k & 1 ? voxel : 0), low.y() + (k & 2 ? voxel : 0));
        zMin = std::min(zMin, low.z());
        zMax = std::max(zMax, low.z() + voxel);
    }
    if (corners.empty())
        return region;
    const OrientedRectangle box = minimumRectangle(corners);
    region.everything = false;
    region.center = box.center;
    region.axis = box.axis;
    region.half = box.half + Eigen::Vector2d::Constant(params.margin_m);
    region.zMin = zMin - params.margin_m;
    region.zMax = zMax + params.margin_m;
    return region;
}

}  // namespace s2b

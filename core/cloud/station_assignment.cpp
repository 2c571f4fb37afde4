// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/station_assignment.h"

#include "core/base/parallel.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace s2b
{
namespace
{

constexpr std::size_t kPointChunk = 1u << 18;
constexpr double kVoxel_m = 0.05, kMostVoxels = 5e8;
constexpr std::size_t kMostTries = 6;  // stations looked for from one voxel
constexpr double kOwnSurface = 1.5;    // voxels: noise spreads a surface over two
constexpr double kGrazing = 8;         // voxels that a ray at a slant may stay near its own surface
constexpr std::size_t kSamples = 20000;

/// Which voxels hold points, as bits, and a number for each that does.
class Occupancy
{
public:
    Occupancy(const Eigen::Vector3d& low, const Eigen::Vector3d& high)
        : m_low(low),
          m_voxel_m(std::max(kVoxel_m,
                             std::cbrt((high - low + Eigen::Vector3d::Constant(2 * kVoxel_m)).prod() / kMostVoxels))),
          m_size(((high - low) / m_voxel_m).array().floor().cast<std::int64_t>() + 1),
          m_words(static_cast<std::size_t>((m_size.prod() + 63) / 64))
    {
    }
    [[nodiscard]] double voxel_m() const { return m_voxel_m; }
    /// -1 outside.
    [[nodiscard]] std::int64_t voxelOf(const Eigen::Vector3d& p) const
    {
        const Eigen::Array<std::int64_t, 3, 1> v = ((p - m_low) / m_voxel_m).array().floor().cast<std::int64_t>();
        if ((v < 0).any() || (v >= m_size).any())
            return -1;
        return v.x() + m_size.x() * (v.y() + m_size.y() * v.z());
    }
    [[nodiscard]] Eigen::Vector3d centreOf(std::int64_t voxel) const
    {
        const std::int64_t x = voxel % m_size.x(), y = voxel / m_size.x() % m_size.y(),
                           z = voxel / m_size.x() / m_size.y();
        return m_low +
               m_voxel_m * (Eigen::Vector3d(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)) +
                            Eigen::Vector3d::Constant(0.5));
    }
    void set(std::int64_t voxel)
    {
        m_words[static_cast<std::size_t>(voxel / 64)].fetch_or(1ull << (voxel % 64), std::memory_order_relaxed);
    }
    [[nodiscard]] bool holds(std::int64_t voxel) const
    {
        return voxel >= 0 && (word(static_cast<std::size_t>(voxel / 64)) >> (voxel % 64) & 1) != 0;
    }
    /// After the last set(): numbers the occupied voxels from 0 on.
    std::size_t number()
    {
        m_before.resize(m_words.size());
        std::uint32_t sum = 0;
        for (std::size_t i = 0; i < m_words.size(); ++i)
        {
            m_before[i] = sum;
            sum += static_cast<std::uint32_t>(std::popcount(word(i)));
        }
        return sum;
    }
    [[nodiscard]] std::size_t numberOf(std::int64_t voxel) const
    {
        const auto i = static_cast<std::size_t>(voxel / 64);
        return m_before[i] + static_cast<std::size_t>(std::popcount(word(i) & ((1ull << (voxel % 64)) - 1)));
    }
    [[nodiscard]] std::size_t words() const { return m_words.size(); }
    [[nodiscard]] std::uint64_t word(std::size_t i) const { return m_words[i].load(std::memory_order_relaxed); }

private:
    Eigen::Vector3d m_low;
    double m_voxel_m;
    Eigen::Array<std::int64_t, 3, 1> m_size;
    std::vector<std::atomic<std::uint64_t>> m_words;
    std::vector<std::uint32_t> m_before;
};

/// @param skipped  voxels at the beginning that may be occupied
bool isClear(const Occupancy& occupancy, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double skipped)
{
    const double length = (to - from).norm(), step = 0.5 * occupancy.voxel_m();
    const Eigen::Vector3d along = (to - from) / std::max(length, 1e-9);
    for (double d = skipped * occupancy.voxel_m(); d < length; d += step)
        if (occupancy.holds(occupancy.voxelOf(from + d * along)))
            return false;
    return true;
}

std::uint16_t stationOf(const Occupancy& occupancy, const Eigen::Vector3d& p, const StationView& stations)
{
    // The nearest few, by insertion: nearly all of them are farther than the ones found already.
    std::array<std::pair<double, std::uint16_t>, kMostTries> nearest;
    std::size_t count = 0;
    for (std::size_t k = 0; k < stations.positions.size(); ++k)
    {
        const double d = (stations.positions[k] - p).squaredNorm();
        if (count == kMostTries && d >= nearest[count - 1].first)
            continue;
        std::size_t at = count < kMostTries ? count++ : count - 1;
        for (; at > 0 && nearest[at - 1].first > d; --at)
            nearest[at] = nearest[at - 1];
        nearest[at] = {d, static_cast<std::uint16_t>(k)};
    }
    for (std::size_t i = 0; i < count; ++i)
        if (isClear(occupancy, p, stations.positions[nearest[i].second], kOwnSurface))
            return nearest[i].second;
    return StationView::kUnknown;
}

Eigen::Vector3d at(const CloudView& cloud, std::size_t i)
{
    return {cloud.xyz[3 * i], cloud.xyz[3 * i + 1], cloud.xyz[3 * i + 2]};
}

/// Calls visit(point, voxel) for every finite point, on all threads.
template <typename Visit>
void overPoints(const CloudView& cloud, const Occupancy& occupancy, const Context& context, const Visit& visit)
{
    parallelChunks(cloud.count, kPointChunk, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t i = begin; i < end; ++i)
                           if (const Eigen::Vector3d p = at(cloud, i); p.allFinite())
                               if (const std::int64_t voxel = occupancy.voxelOf(p); voxel >= 0)
                                   visit(i, voxel);
                   });
    context.checkCancelled();
}

/// Nothing for a cloud without a finite point.
std::optional<Occupancy> occupancyOf(const CloudView& cloud, const Context& context)
{
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (std::size_t i = 0; i < cloud.count; ++i)
        if (const Eigen::Vector3d p = at(cloud, i); p.allFinite())
            low = low.cwiseMin(p), high = high.cwiseMax(p);
    if (!(low.x() <= high.x()))
        return std::nullopt;
    std::optional<Occupancy> occupancy(std::in_place, low, high);
    overPoints(cloud, *occupancy, context, [&](std::size_t, std::int64_t voxel) { occupancy->set(voxel); });
    return occupancy;
}

}  // namespace

std::vector<std::uint16_t> nearestVisibleStations(const CloudView& cloud, const Context& context)
{
    std::vector<std::uint16_t> ofPoint(cloud.count, StationView::kUnknown);
    std::optional<Occupancy> occupancy;
    if (!cloud.stations.empty())
        occupancy = occupancyOf(cloud, context);
    if (!occupancy)
        return ofPoint;
    std::vector<std::uint16_t> ofVoxel(occupancy->number());
    parallelChunks(occupancy->words(), 4096, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t i = begin; i < end; ++i)
                           for (std::uint64_t bits = occupancy->word(i); bits != 0; bits &= bits - 1)
                           {
                               const auto voxel = static_cast<std::int64_t>(64 * i) + std::countr_zero(bits);
                               ofVoxel[occupancy->numberOf(voxel)] =
                                   stationOf(*occupancy, occupancy->centreOf(voxel), cloud.stations);
                           }
                   });
    context.checkCancelled();
    overPoints(cloud, *occupancy, context,
               [&](std::size_t i, std::int64_t voxel) { ofPoint[i] = ofVoxel[occupancy->numberOf(voxel)]; });
    return ofPoint;
}

double hiddenShare(const CloudView& cloud, const Context& context)
{
    const std::optional<Occupancy> occupancy = occupancyOf(cloud, context);
    if (!occupancy)
        return 0;
    const std::size_t step = std::max<std::size_t>(1, cloud.count / kSamples);
    std::size_t hidden = 0, asked = 0;
    for (std::size_t i = 0; i < cloud.count; i += step)
    {
        const std::uint16_t station = cloud.stations.of(i);
        if (station == StationView::kUnknown || !at(cloud, i).allFinite())
            continue;
        ++asked;
        hidden += !isClear(*occupancy, at(cloud, i), cloud.stations.positions[station], kGrazing);
    }
    return asked == 0 ? 0.0 : static_cast<double>(hidden) / static_cast<double>(asked);
}

}  // namespace s2b

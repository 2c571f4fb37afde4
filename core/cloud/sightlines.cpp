// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/sightlines.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace s2b
{
namespace
{

constexpr std::size_t kPointChunk = 1u << 18;
constexpr double kLargestMaps = 32e6;  // squares, of all stations together
constexpr double kLeastCosine = 0.34;  // 20 degrees off the plate
constexpr double kCentimetre_m = 0.01;

}  // namespace

Sightlines::Sightlines(const CloudView& cloud, double yaw_rad, const Eigen::Vector3d& shift, const Context& context)
{
    if (cloud.stations.empty())
        return;
    const double co = std::cos(yaw_rad), si = std::sin(yaw_rad);
    const auto turned = [&](const Eigen::Vector3d& p)
    { return Eigen::Vector3d(co * p.x() + si * p.y(), -si * p.x() + co * p.y(), p.z()); };
    for (const Eigen::Vector3d& p : cloud.stations.positions)
        m_positions.push_back(turned(p) + shift);
    m_side = static_cast<std::size_t>(
        std::clamp(std::sqrt(kLargestMaps / static_cast<double>(m_positions.size())), 16.0, 512.0));
    m_range_cm = std::vector<std::atomic<std::uint16_t>>(m_positions.size() * m_side * m_side);
    parallelChunks(
        cloud.count, kPointChunk, context,
        [&](std::size_t begin, std::size_t end)
        {
            for (std::size_t i = begin; i < end; ++i)
            {
                const std::uint16_t station = cloud.stations.of(i);
                if (station == StationView::kUnknown)
                    continue;
                const Eigen::Vector3d p(cloud.xyz[3 * i], cloud.xyz[3 * i + 1], cloud.xyz[3 * i + 2]);
                const Eigen::Vector3d ray = turned(p - cloud.stations.positions[station]);
                const double range = ray.norm();
                if (!(range > kCentimetre_m))
                    continue;
                const auto range_cm = static_cast<std::uint16_t>(std::min(65535.0, range / kCentimetre_m));
                std::atomic<std::uint16_t>& longest = m_range_cm[station * m_side * m_side + squareOf(ray)];
                std::uint16_t seen = longest.load(std::memory_order_relaxed);
                while (range_cm > seen && !longest.compare_exchange_weak(seen, range_cm, std::memory_order_relaxed))
                {
                }
            }
        });
    context.checkCancelled();
}

std::size_t Sightlines::squareOf(const Eigen::Vector3d& direction) const
{
    // Octahedral map (Cigolle et al., A Survey of Efficient Representations for Independent Unit Vectors, 2014).
    const double sum = std::abs(direction.x()) + std::abs(direction.y()) + std::abs(direction.z());
    double u = direction.x() / sum, v = direction.y() / sum;
    if (direction.z() < 0)
    {
        const double folded = (1 - std::abs(v)) * (u < 0 ? -1.0 : 1.0);
        v = (1 - std::abs(u)) * (v < 0 ? -1.0 : 1.0);
        u = folded;
    }
    const auto index = [&](double w)
    { return std::min(m_side - 1, static_cast<std::size_t>((w + 1) / 2 * static_cast<double>(m_side))); };
    return index(u) + m_side * index(v);
}

std::vector<std::uint32_t> Sightlines::near(const Eigen::Vector3d& p, double reach_m) const
{
    std::vector<std::pair<double, std::uint32_t>> order;
    for (std::uint32_t k = 0; k < m_positions.size(); ++k)
        if (const double d = (m_positions[k] - p).norm(); d < reach_m)
            order.emplace_back(d, k);
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> stations;
    for (const auto& [d, k] : order)
        stations.push_back(k);
    return stations;
}

bool Sightlines::passed(const Eigen::Vector3d& p, const Eigen::Vector3d& n, double beyond_m,
                        const std::vector<std::uint32_t>& stations) const
{
    return std::any_of(stations.begin(), stations.end(),
                       [&](std::uint32_t k)
                       {
                           const Eigen::Vector3d ray = p - m_positions[k];
                           const double distance = ray.norm(), cosine = std::abs(n.dot(ray));
                           if (!(cosine > kLeastCosine * distance))
                               return false;
                           const std::uint16_t seen =
                               m_range_cm[k * m_side * m_side + squareOf(ray)].load(std::memory_order_relaxed);
                           return kCentimetre_m * seen > distance + beyond_m * distance / cosine;
                       });
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/point_cloud.h"

#include <Eigen/Core>

#include <atomic>
#include <cstdint>
#include <vector>

namespace s2b
{

/// How far each station saw, by direction: what tells empty from unseen. Where a ray went on beyond a place, that place
/// is empty; where none did, it was hidden, or something is there.
///
/// Directions fall into the squares of an octahedral map (about 0.4 degrees wide, 3 to 4 cm at 5 m), each with the
/// longest range of its points; wider ones with more than about 120 stations, which keeps the memory below 64 MB.
class Sightlines
{
public:
    /// Of a cloud without stations: empty.
    Sightlines() = default;
    /// Of the points whose station is known; none of them is left out, also not those outside the building.
    /// @param yaw_rad, shift  take the cloud to the building frame: turned by -yaw about the vertical, then moved
    /// Cost: one pass over the points. Independent of their order and of the threads.
    Sightlines(const CloudView& cloud, double yaw_rad, const Eigen::Vector3d& shift, const Context& context);

    [[nodiscard]] bool empty() const noexcept { return m_positions.empty(); }
    /// Stations within `reach_m` of p (building frame), the nearest first.
    [[nodiscard]] std::vector<std::uint32_t> near(const Eigen::Vector3d& p, double reach_m) const;
    /// Did a ray from one of the stations pass through p, and through the plate about it: unit normal n, going on for
    /// `beyond_m` along n? Rays that meet the plate at less than 20 degrees don't count.
    [[nodiscard]] bool passed(const Eigen::Vector3d& p, const Eigen::Vector3d& n, double beyond_m,
                              const std::vector<std::uint32_t>& stations) const;

private:
    /// Square of a direction (any length but 0) in a station's map.
    [[nodiscard]] std::size_t squareOf(const Eigen::Vector3d& direction) const;

    std::vector<Eigen::Vector3d> m_positions;  ///< building frame
    std::size_t m_side = 0;                    ///< squares along a side of a map
    std::vector<std::atomic<std::uint16_t>> m_range_cm;
};

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace s2b
{

/// Where floor and ceiling of a storey were seen, in plan: the evidence that there is room and no wall.
///
/// Seen floor or ceiling is free space between them; nothing seen is either the inside of a wall or unseen.
class PlanMask
{
public:
    enum Layer : std::uint8_t
    {
        Floor = 1,
        Ceiling = 2
    };

    /// @param cells  building frame, metres
    PlanMask(const SurfaceCells& cells, const Level& level);

    [[nodiscard]] double pixel_m() const noexcept { return m_pixel; }
    [[nodiscard]] bool seen(const Eigen::Vector2d& p, Layer layer) const;
    /// Area of the layer [m2].
    [[nodiscard]] double area_m2(Layer layer) const;
    /// Share of points of a rectangle (centre line from a to b, between the offsets low and high to its left) where the
    /// layer was seen.
    [[nodiscard]] double share(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double low, double high,
                               Layer layer) const;
    /// Share of the rectangle that shows free space, by the layer that a wall interrupts best: the ceiling where one
    /// was seen at all, else the floor.
    [[nodiscard]] double freeShare(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double low, double high) const;
    /// Height of the highest surface overhead near p (within a quarter of a metre), or a negative number where none was
    /// seen: the local ceiling, level or sloped.
    [[nodiscard]] double overhead_m(const Eigen::Vector2d& p) const;
    [[nodiscard]] Layer mainLayer() const noexcept { return m_main; }

private:
    double m_pixel = 0.05;
    Eigen::Vector2d m_low = Eigen::Vector2d::Zero();
    Eigen::Vector2i m_size = Eigen::Vector2i::Zero();
    Layer m_main = Ceiling;
    std::vector<std::uint8_t> m_layers;
    Eigen::Vector2i m_coarseSize = Eigen::Vector2i::Zero();
    std::vector<float> m_overhead;  ///< of coarse pixels, above the floor; negative for none
};

}  // namespace s2b

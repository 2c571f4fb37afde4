// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/surface_cells.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace s2b
{

/// The cells between two heights by square tiles of the plan, to look at what lies near a wall without visiting all.
class CellIndex
{
public:
    CellIndex(const SurfaceCells& cells, double zMin, double zMax);

    /// Calls visit(cell) for every cell of the tiles that the segment from a to b, widened by `reach`, touches: all
    /// that lie within, and some around. In a fixed order.
    template <typename Visit>
    void near(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double reach, Visit&& visit) const
    {
        const Eigen::Vector2i low = tileOf(a.cwiseMin(b) - Eigen::Vector2d::Constant(reach));
        const Eigen::Vector2i high = tileOf(a.cwiseMax(b) + Eigen::Vector2d::Constant(reach));
        const Eigen::Vector2d d = b - a;
        const double length = d.norm();
        const Eigen::Vector2d t = length > 0 ? Eigen::Vector2d(d / length) : Eigen::Vector2d::UnitX();
        const Eigen::Vector2d n(-t.y(), t.x());
        for (int y = std::max(0, low.y()); y <= std::min(m_size.y() - 1, high.y()); ++y)
            for (int x = std::max(0, low.x()); x <= std::min(m_size.x() - 1, high.x()); ++x)
            {
                const Eigen::Vector2d centre = m_low + kTile_m * Eigen::Vector2d(x + 0.5, y + 0.5) - a;
                if (std::abs(n.dot(centre)) > reach + 0.71 * kTile_m)
                    continue;
                const std::size_t tile =
                    static_cast<std::size_t>(x) + static_cast<std::size_t>(m_size.x()) * static_cast<std::size_t>(y);
                for (std::uint32_t i = m_start[tile]; i < m_start[tile + 1]; ++i)
                    visit(m_cells->cells[m_order[i]]);
            }
    }

private:
    static constexpr double kTile_m = 0.5;
    [[nodiscard]] Eigen::Vector2i tileOf(const Eigen::Vector2d& p) const;

    const SurfaceCells* m_cells;
    Eigen::Vector2d m_low = Eigen::Vector2d::Zero();
    Eigen::Vector2i m_size = Eigen::Vector2i::Zero();
    std::vector<std::uint32_t> m_start, m_order;
};

}  // namespace s2b

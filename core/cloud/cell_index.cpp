// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/cell_index.h"

#include "core/base/floor_to_int.h"

#include <limits>

namespace s2b
{

CellIndex::CellIndex(const SurfaceCells& cells, double zMin, double zMax) : m_cells(&cells)
{
    std::vector<std::uint32_t> inside;
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const SurfaceCell& c : cells.between(zMin, zMax))
    {
        const Eigen::Vector3f& p = c.position;
        if (static_cast<double>(p.z()) < zMin || static_cast<double>(p.z()) > zMax)
            continue;
        inside.push_back(static_cast<std::uint32_t>(&c - cells.cells.data()));
        low = low.cwiseMin(p.head<2>().cast<double>());
        high = high.cwiseMax(p.head<2>().cast<double>());
    }
    if (inside.empty())
        return;
    m_low = low;
    m_size = ((high - low) / kTile_m).array().floor().cast<int>() + 1;
    m_start.assign(static_cast<std::size_t>(m_size.x()) * static_cast<std::size_t>(m_size.y()) + 1, 0);
    const auto tile = [&](std::uint32_t i)
    {
        const Eigen::Vector2i t = tileOf(cells.cells[i].position.head<2>().cast<double>());
        return static_cast<std::size_t>(t.x()) + static_cast<std::size_t>(m_size.x()) * static_cast<std::size_t>(t.y());
    };
    for (const std::uint32_t i : inside)
        ++m_start[tile(i) + 1];
    for (std::size_t k = 1; k < m_start.size(); ++k)
        m_start[k] += m_start[k - 1];
    m_order.resize(inside.size());
    std::vector<std::uint32_t> cursor(m_start.begin(), m_start.end() - 1);
    for (const std::uint32_t i : inside)
        m_order[cursor[tile(i)]++] = i;
}

Eigen::Vector2i CellIndex::tileOf(const Eigen::Vector2d& p) const
{
    return {floorToInt((p.x() - m_low.x()) / kTile_m), floorToInt((p.y() - m_low.y()) / kTile_m)};
}

}  // namespace s2b

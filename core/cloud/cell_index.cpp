// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/cell_index.h"

#include "core/base/floor_to_int.h"

#include <limits>

namespace s2b
{

CellIndex::CellIndex(const SurfaceCells& cells, double zMin, double zMax) : m_cells(&cells)
{
    struct Inside
    {
        std::uint32_t cell, tile;
    };
    std::vector<Inside> inside;
    Eigen::Vector2f low = Eigen::Vector2f::Constant(std::numeric_limits<float>::infinity()), high = -low;
    for (const SurfaceCell& c : cells.between(zMin, zMax))
    {
        const Eigen::Vector3f& p = c.position;
        if (static_cast<double>(p.z()) < zMin || static_cast<double>(p.z()) > zMax)
            continue;
        inside.push_back({static_cast<std::uint32_t>(&c - cells.cells.data()), 0});
        low = low.cwiseMin(p.head<2>());
        high = high.cwiseMax(p.head<2>());
    }
    if (inside.empty())
        return;
    m_low = low.cast<double>();
    m_size = ((high.cast<double>() - m_low) / kTile_m).array().floor().cast<int>() + 1;
    m_start.assign(static_cast<std::size_t>(m_size.x()) * static_cast<std::size_t>(m_size.y()) + 1, 0);
    for (Inside& i : inside)
    {
        const Eigen::Vector2i t = tileOf(cells.cells[i.cell].position.head<2>().cast<double>());
        i.tile = static_cast<std::uint32_t>(t.x() + m_size.x() * t.y());
        ++m_start[i.tile + 1];
    }
    for (std::size_t k = 1; k < m_start.size(); ++k)
        m_start[k] += m_start[k - 1];
    m_order.resize(inside.size());
    std::vector<std::uint32_t> cursor(m_start.begin(), m_start.end() - 1);
    for (const Inside& i : inside)
        m_order[cursor[i.tile]++] = i.cell;
}

Eigen::Vector2i CellIndex::tileOf(const Eigen::Vector2d& p) const
{
    return {floorToInt((p.x() - m_low.x()) / kTile_m), floorToInt((p.y() - m_low.y()) / kTile_m)};
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/cell_normals.h"

#include "core/geometry/flattest_direction.h"

#include <algorithm>
#include <cmath>

namespace s2b
{
namespace
{

constexpr int kHalo = 2;  // cells around a block that its normals look at

}  // namespace

NormalFinder::NormalFinder(int cellsPerBlock, int minimumNeighbours)
    : m_cellsPerBlock(cellsPerBlock),
      m_minimum(minimumNeighbours),
      m_edge(cellsPerBlock + 2 * kHalo),
      m_grid(static_cast<std::size_t>(m_edge) * static_cast<std::size_t>(m_edge) * static_cast<std::size_t>(m_edge), 0)
{
    for (int dz = -kHalo; dz <= kHalo; ++dz)
        for (int dy = -kHalo; dy <= kHalo; ++dy)
            for (int dx = -kHalo; dx <= kHalo; ++dx)
                (std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) <= 1 ? m_near : m_ring)
                    .push_back(dx + m_edge * (dy + m_edge * dz));
}

std::int32_t NormalFinder::at(int x, int y, int z) const
{
    return x + kHalo + m_edge * (y + kHalo + m_edge * (z + kHalo));
}

void NormalFinder::add(const Moments& m, int x, int y, int z)
{
    // About the block's middle: numbers as small as they can be.
    const double middle = 0.5 * (m_cellsPerBlock - 1), n = m.count;
    const double cx = x - middle, cy = y - middle, cz = z - middle;
    const double sx = m.sum[0], sy = m.sum[1], sz = m.sum[2];
    m_set.push_back(at(x, y, z));
    m_grid[static_cast<std::size_t>(m_set.back())] = static_cast<std::uint32_t>(m_sums.size());
    m_sums.push_back({n, sx + n * cx, sy + n * cy, sz + n * cz,       //
                      m.square[0] + cx * (2 * sx + n * cx),           //
                      m.square[1] + cx * sy + cy * sx + n * cx * cy,  //
                      m.square[2] + cx * sz + cz * sx + n * cx * cz,  //
                      m.square[3] + cy * (2 * sy + n * cy),           //
                      m.square[4] + cy * sz + cz * sy + n * cy * cz,  //
                      m.square[5] + cz * (2 * sz + n * cz)});
}

void NormalFinder::lookAt(const Around& blocks)
{
    // Cleared by undoing what was set: most of the grid is empty.
    for (const std::int32_t place : m_set)
        m_grid[static_cast<std::size_t>(place)] = 0;
    m_set.clear();
    m_sums.assign(1, {});
    const auto holds = [&](int v) { return v >= -kHalo && v < m_edge - kHalo; };
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
            {
                const std::vector<Moments>* cells =
                    blocks[static_cast<std::size_t>(dx + 1 + 3 * (dy + 1) + 9 * (dz + 1))];
                if (!cells)
                    continue;
                const auto layer = [&](int z)
                {
                    return std::partition_point(cells->begin(), cells->end(),
                                                [&](const Moments& m) { return m.local[2] < z; });
                };
                // Sorted by z: of the blocks below and above only the layers that the halo reaches.
                const auto first = dz < 0 ? layer(m_cellsPerBlock - kHalo) : cells->begin();
                const auto last = dz > 0 ? layer(kHalo) : cells->end();
                for (auto m = first; m != last; ++m)
                {
                    const int x = m->local[0] + dx * m_cellsPerBlock, y = m->local[1] + dy * m_cellsPerBlock,
                              z = m->local[2] + dz * m_cellsPerBlock;
                    if (!holds(x) || !holds(y) || !holds(z))
                        continue;
                    add(*m, x, y, z);
                }
            }
}

void NormalFinder::gather(std::int32_t place, const std::vector<std::int32_t>& offsets, Sums& sums) const
{
    // Which ones first, without branches: which neighbours are empty can't be foretold.
    std::array<std::uint32_t, 128> found;
    std::size_t count = 0;
    for (const std::int32_t offset : offsets)
    {
        found[count] = m_grid[static_cast<std::size_t>(place + offset)];
        count += found[count] != 0;
    }
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] += m_sums[found[k]][i];
}

CellNormal NormalFinder::normalOf(const Sums& sums) const
{
    CellNormal result;
    if (sums[0] < m_minimum)
        return result;
    const Eigen::Vector3d mean = Eigen::Vector3d(sums[1], sums[2], sums[3]) / sums[0];
    Eigen::Matrix3d c;
    c << sums[4], sums[5], sums[6], sums[5], sums[7], sums[8], sums[6], sums[8], sums[9];
    c = c / sums[0] - mean * mean.transpose();
    const FlattestDirection flattest = flattestDirection(c);
    result.ratio = flattest.middle > 1e-9 ? flattest.least / flattest.middle : 1.0;
    result.direction = flattest.direction.cast<float>();
    result.flatness = static_cast<float>(std::sqrt(flattest.least));
    result.valid = !flattest.direction.isZero();
    return result;
}

CellNormal NormalFinder::of(const Moments& cell) const
{
    const std::int32_t place = at(cell.local[0], cell.local[1], cell.local[2]);
    Sums sums{};
    gather(place, m_near, sums);
    const CellNormal near = normalOf(sums);
    if (near.valid && near.ratio <= 0.08)
        return near;
    gather(place, m_ring, sums);
    const CellNormal wider = normalOf(sums);
    return wider.valid && (!near.valid || wider.ratio < near.ratio) ? wider : near;
}

}  // namespace s2b

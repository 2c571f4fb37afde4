// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/cell_normals.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace s2b
{
namespace
{

constexpr int kHalo = 2;  // cells around a block that its normals look at

/// Sum of moments about a common centre.
struct Accumulated
{
    double n = 0;
    Eigen::Vector3d s = Eigen::Vector3d::Zero();
    Eigen::Matrix3d q = Eigen::Matrix3d::Zero();  // lower triangle

    void add(const Moments& m, int dx, int dy, int dz)
    {
        const double c = m.count;
        const double sx = m.sum[0], sy = m.sum[1], sz = m.sum[2];
        n += c;
        s += Eigen::Vector3d(sx + c * dx, sy + c * dy, sz + c * dz);
        q(0, 0) += m.square[0] + 2 * dx * sx + c * dx * dx;
        q(1, 0) += m.square[1] + dx * sy + dy * sx + c * dx * dy;
        q(2, 0) += m.square[2] + dx * sz + dz * sx + c * dx * dz;
        q(1, 1) += m.square[3] + 2 * dy * sy + c * dy * dy;
        q(2, 1) += m.square[4] + dy * sz + dz * sy + c * dy * dz;
        q(2, 2) += m.square[5] + 2 * dz * sz + c * dz * dz;
    }
};

CellNormal normalOf(const Accumulated& a, int minimum)
{
    CellNormal result;
    if (a.n < minimum)
        return result;
    Eigen::Matrix3d c = a.q / a.n;
    const Eigen::Vector3d mean = a.s / a.n;
    c -= mean * mean.transpose();
    c(0, 1) = c(1, 0);
    c(0, 2) = c(2, 0);
    c(1, 2) = c(2, 1);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(c);
    const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0.0);
    result.ratio = values[1] > 1e-9 ? values[0] / values[1] : 1.0;
    result.direction = solver.eigenvectors().col(0).normalized().cast<float>();
    result.flatness = static_cast<float>(std::sqrt(values[0]));
    result.valid = result.direction.allFinite();
    return result;
}

}  // namespace

NormalFinder::NormalFinder(int cellsPerBlock, int minimumNeighbours)
    : m_cellsPerBlock(cellsPerBlock),
      m_minimum(minimumNeighbours),
      m_edge(cellsPerBlock + 2 * kHalo),
      m_grid(static_cast<std::size_t>(m_edge) * static_cast<std::size_t>(m_edge) * static_cast<std::size_t>(m_edge),
             nullptr)
{
}

std::size_t NormalFinder::at(int x, int y, int z) const
{
    return static_cast<std::size_t>(x + kHalo) +
           static_cast<std::size_t>(m_edge) * (static_cast<std::size_t>(y + kHalo) +
                                               static_cast<std::size_t>(m_edge) * static_cast<std::size_t>(z + kHalo));
}

void NormalFinder::lookAt(const Around& blocks)
{
    // Cleared by undoing what was set: most of the grid is empty.
    for (const std::size_t i : m_set)
        m_grid[i] = nullptr;
    m_set.clear();
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
                    m_set.push_back(at(x, y, z));
                    m_grid[m_set.back()] = &*m;
                }
            }
}

CellNormal NormalFinder::within(const Moments& cell, int radius) const
{
    Accumulated a;
    for (int dz = -radius; dz <= radius; ++dz)
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx)
                if (const Moments* o = m_grid[at(cell.local[0] + dx, cell.local[1] + dy, cell.local[2] + dz)])
                    a.add(*o, dx, dy, dz);
    return normalOf(a, m_minimum);
}

CellNormal NormalFinder::of(const Moments& cell) const
{
    const CellNormal near = within(cell, 1);
    if (near.valid && near.ratio <= 0.08)
        return near;
    const CellNormal wider = within(cell, 2);
    return wider.valid && (!near.valid || wider.ratio < near.ratio) ? wider : near;
}

}  // namespace s2b

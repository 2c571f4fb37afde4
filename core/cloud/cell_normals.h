// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/cell_moments.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace s2b
{

/// Direction of the surface about a cell.
struct CellNormal
{
    Eigen::Vector3f direction = Eigen::Vector3f::Zero();  ///< unit, of either sign
    float flatness = 0;                                   ///< RMS distance of the neighbourhood's points, in cells
    double ratio = 1.0;                                   ///< smallest to middle variance
    bool valid = false;
};

/// Finds normals from the moments of a cell's neighbourhood, block by block. One for each thread: it keeps its memory
/// from block to block, a dense grid of a block's cells with a halo.
class NormalFinder
{
public:
    /// Cells of the 27 blocks about one, by (dx + 1) + 3 * (dy + 1) + 9 * (dz + 1), sorted by (z, y, x); null where
    /// nothing is.
    using Around = std::array<const std::vector<Moments>*, 27>;

    NormalFinder(int cellsPerBlock, int minimumNeighbours);

    /// Looks at another block.
    void lookAt(const Around& blocks);
    /// Of a cell of the block that is looked at: least eigenvector of the moments of its 27 neighbours; where these
    /// hold too few points, or noise as wide as they are, of 125, if that is flatter.
    [[nodiscard]] CellNormal of(const Moments& cell) const;

private:
    /// n, sx, sy, sz, xx, xy, xz, yy, yz, zz: moments about one point of the block, so that a sum needs no shifting.
    using Sums = std::array<double, 10>;

    [[nodiscard]] std::int32_t at(int x, int y, int z) const;
    void add(const Moments& m, int x, int y, int z);
    /// Adds what the cells at the offsets hold.
    void gather(std::int32_t place, const std::vector<std::int32_t>& offsets, Sums& sums) const;
    [[nodiscard]] CellNormal normalOf(const Sums& sums) const;

    int m_cellsPerBlock, m_minimum, m_edge;
    std::vector<std::int32_t> m_near, m_ring;  ///< offsets within the grid of the 27, and of the 98 about them
    std::vector<std::uint32_t> m_grid;         ///< by place: which of the sums, 0 where nothing is
    std::vector<Sums> m_sums;
    std::vector<std::int32_t> m_set;  ///< places that are not empty, in the order of the sums
};

}  // namespace s2b

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
    [[nodiscard]] std::size_t at(int x, int y, int z) const;
    [[nodiscard]] CellNormal within(const Moments& cell, int radius) const;

    int m_cellsPerBlock, m_minimum, m_edge;
    std::vector<const Moments*> m_grid;
    std::vector<std::size_t> m_set;
};

}  // namespace s2b

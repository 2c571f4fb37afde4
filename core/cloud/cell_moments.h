// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/blocks.h"
#include "core/labels/label.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace s2b
{

/// Of 255, 40 %: a class that a model is less sure of says nothing, and the shape decides.
inline constexpr std::uint8_t kLeastGuess = 102;

/// The points of one cell of a block: how many, their sums, and what most of them are.
struct Moments
{
    std::array<std::uint8_t, 3> local{};  ///< cell within the block, 0..cells per block - 1
    Label label = Label::Unassigned;
    std::uint8_t labelShare = 0;
    std::array<std::int8_t, 3>
        view{};  ///< mean direction to the stations that the points were measured from, 127 = 1; 0 when none is known
    std::uint32_t count = 0;
    std::array<float, 3> sum{};     ///< of positions relative to the cell's centre, in cells
    std::array<float, 6> square{};  ///< xx xy xz yy yz zz
};

/// Gathers blocks' points into cells. One for each thread: it keeps its memory from block to block.
class CellGatherer
{
public:
    CellGatherer(const CloudView& cloud, const Blocks& blocks, int cellsPerBlock);

    /// Cells of one block, sorted by (z, y, x). Independent of the order of the points.
    /// @param cellOfPoint  where given: by point of the cloud, which of the block's cells it lies in
    [[nodiscard]] std::vector<Moments> gather(std::uint32_t block, const Eigen::Vector3i& firstCell,
                                              std::uint32_t* cellOfPoint = nullptr);
    /// How many cells of a block hold points.
    [[nodiscard]] std::size_t count(std::uint32_t block, const Eigen::Vector3i& firstCell);

private:
    /// Whole numbers: a sum of them is the same in any order.
    struct Sums
    {
        std::uint32_t key = 0;
        std::uint32_t count = 0;
        std::array<std::int64_t, 3> sum{};
        std::array<std::int64_t, 6> square{};
        std::array<std::uint32_t, kLabelCount> votes{};
        std::array<std::int64_t, 3> view{};  ///< of unit vectors to the stations, in kViewUnits
        std::uint32_t viewed = 0;            ///< points whose station is known
    };
    void addPoints(std::uint32_t block, const Eigen::Vector3i& firstCell, std::uint32_t* slotOfPoint);
    void addView(PointIndex point, Sums& sums) const;
    [[nodiscard]] Moments momentsOf(const Sums& sums) const;

    const CloudView& m_cloud;
    const Blocks& m_blocks;
    int m_cellsPerBlock;
    double m_size_m;
    std::vector<std::int32_t> m_slot;  ///< by cell of the block: index in m_sums, or -1
    std::vector<Sums> m_sums;
    std::vector<std::uint64_t> m_sorted;      ///< key and slot
    std::vector<std::uint32_t> m_rankOfSlot;  ///< place among the sorted
};

}  // namespace s2b

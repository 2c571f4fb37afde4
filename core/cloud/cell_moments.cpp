// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/cell_moments.h"

#include <algorithm>
#include <cmath>

namespace s2b
{
namespace
{

constexpr int kUnits = 4096;      // positions within a cell, as whole numbers
constexpr int kViewUnits = 1024;  // unit vectors, as whole numbers

/// To the nearest whole number, halves away from zero.
std::int32_t nearest(double v)
{
    return static_cast<std::int32_t>(v + (v < 0.0 ? -0.5 : 0.5));
}

}  // namespace

CellGatherer::CellGatherer(const CloudView& cloud, const Blocks& blocks, int cellsPerBlock)
    : m_cloud(cloud),
      m_blocks(blocks),
      m_cellsPerBlock(cellsPerBlock),
      m_size_m(kBlock_m / cellsPerBlock),
      m_slot(static_cast<std::size_t>(cellsPerBlock) * static_cast<std::size_t>(cellsPerBlock) *
                 static_cast<std::size_t>(cellsPerBlock),
             -1)
{
}

void CellGatherer::addView(PointIndex point, Sums& sums) const
{
    const std::uint16_t station = m_cloud.stations.of(point);
    if (station == StationView::kUnknown)
        return;
    const Eigen::Vector3d to = m_cloud.stations.positions[station] - pointAt(m_cloud, point).cast<double>();
    const double distance = to.norm();
    if (!(distance > 1e-6))
        return;
    ++sums.viewed;
    for (std::size_t axis = 0; axis < 3; ++axis)
        sums.view[axis] += nearest(to[static_cast<Eigen::Index>(axis)] / distance * kViewUnits);
}

void CellGatherer::addPoints(std::uint32_t block, const Eigen::Vector3i& firstCell, std::uint32_t* slotOfPoint)
{
    for (std::uint32_t j = m_blocks.start[block]; j < m_blocks.start[block + 1]; ++j)
    {
        const PointIndex i = m_blocks.order[j];
        std::array<std::int32_t, 3> local{};
        std::array<std::int32_t, 3> within{};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            const double q = static_cast<double>(m_cloud.xyz[3 * std::size_t{i} + axis]) / m_size_m;
            const int first = firstCell[static_cast<Eigen::Index>(axis)];
            // A point on the block's own border: the division may round it into the cell before.
            local[axis] = std::clamp(floorToInt(q) - first, 0, m_cellsPerBlock - 1);
            within[axis] = nearest((q - static_cast<double>(first + local[axis]) - 0.5) * kUnits);
        }
        const auto key =
            static_cast<std::uint32_t>(local[0] + m_cellsPerBlock * (local[1] + m_cellsPerBlock * local[2]));
        std::int32_t& slot = m_slot[key];
        if (slot < 0)
        {
            slot = static_cast<std::int32_t>(m_sums.size());
            m_sums.emplace_back().key = key;
        }
        if (slotOfPoint)
            slotOfPoint[i] = static_cast<std::uint32_t>(slot);
        Sums& sums = m_sums[static_cast<std::size_t>(slot)];
        const std::int64_t x = within[0], y = within[1], z = within[2];
        ++sums.count;
        sums.sum[0] += x;
        sums.sum[1] += y;
        sums.sum[2] += z;
        sums.square[0] += x * x;
        sums.square[1] += x * y;
        sums.square[2] += x * z;
        sums.square[3] += y * y;
        sums.square[4] += y * z;
        sums.square[5] += z * z;
        if (m_cloud.labels)
            sums.votes[std::min<std::size_t>(m_cloud.labels[i], kLabelCount - 1)] +=
                m_cloud.confidence ? m_cloud.confidence[i] : 1u;
        if (!m_cloud.stations.empty())
            addView(i, sums);
    }
}

Moments CellGatherer::momentsOf(const Sums& sums) const
{
    Moments m;
    const int key = static_cast<int>(sums.key);
    m.local = {static_cast<std::uint8_t>(key % m_cellsPerBlock),
               static_cast<std::uint8_t>(key / m_cellsPerBlock % m_cellsPerBlock),
               static_cast<std::uint8_t>(key / m_cellsPerBlock / m_cellsPerBlock)};
    m.count = sums.count;
    for (std::size_t a = 0; a < 3; ++a)
        m.sum[a] = static_cast<float>(static_cast<double>(sums.sum[a]) / kUnits);
    for (std::size_t a = 0; a < 6; ++a)
        m.square[a] = static_cast<float>(static_cast<double>(sums.square[a]) / (static_cast<double>(kUnits) * kUnits));
    if (m_cloud.labels)
    {
        const auto best = std::max_element(sums.votes.begin(), sums.votes.end());
        m.label = static_cast<Label>(best - sums.votes.begin());
        m.labelShare = static_cast<std::uint8_t>((m_cloud.confidence ? 1.0 : 255.0) * *best / sums.count);
        // A guess that is not sure says nothing: geometry alone decides.
        if (m_cloud.confidence && m.labelShare < kLeastGuess)
            m.label = Label::Unassigned;
    }
    for (std::size_t a = 0; a < 3 && sums.viewed > 0; ++a)
        m.view[a] = static_cast<std::int8_t>(
            nearest(127.0 * static_cast<double>(sums.view[a]) / (static_cast<double>(kViewUnits) * sums.viewed)));
    return m;
}

std::vector<Moments> CellGatherer::gather(std::uint32_t block, const Eigen::Vector3i& firstCell,
                                          std::uint32_t* cellOfPoint)
{
    addPoints(block, firstCell, cellOfPoint);
    for (std::size_t slot = 0; slot < m_sums.size(); ++slot)
    {
        m_sorted.push_back(static_cast<std::uint64_t>(m_sums[slot].key) << 32 | slot);
        m_slot[m_sums[slot].key] = -1;
    }
    std::sort(m_sorted.begin(), m_sorted.end());
    std::vector<Moments> cells;
    cells.reserve(m_sorted.size());
    for (const std::uint64_t s : m_sorted)
        cells.push_back(momentsOf(m_sums[static_cast<std::uint32_t>(s)]));
    if (cellOfPoint)
    {
        m_rankOfSlot.resize(m_sorted.size());
        for (std::uint32_t rank = 0; rank < m_sorted.size(); ++rank)
            m_rankOfSlot[static_cast<std::uint32_t>(m_sorted[rank])] = rank;
        for (std::uint32_t j = m_blocks.start[block]; j < m_blocks.start[block + 1]; ++j)
            cellOfPoint[m_blocks.order[j]] = m_rankOfSlot[cellOfPoint[m_blocks.order[j]]];
    }
    m_sums.clear();
    m_sorted.clear();
    return cells;
}

std::size_t CellGatherer::count(std::uint32_t block, const Eigen::Vector3i& firstCell)
{
    addPoints(block, firstCell, nullptr);
    const std::size_t cells = m_sums.size();
    for (const Sums& sums : m_sums)
        m_slot[sums.key] = -1;
    m_sums.clear();
    return cells;
}

}  // namespace s2b

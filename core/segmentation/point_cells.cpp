// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/point_cells.h"

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/cloud/blocks.h"

#include <bit>
#include <cmath>
#include <limits>

namespace s2b
{
namespace
{

constexpr std::size_t kChunk = 1u << 16;

using Key = Eigen::Vector3i;

/// Cells by their place in the grid: an open hash that is at most half full.
class CellTable
{
public:
    explicit CellTable(const SurfaceCells& cells)
        : m_cells(cells),
          m_perMetre(1.0 / cells.size_m),
          m_mask(std::bit_ceil(2 * cells.cells.size() + 1) - 1),
          m_slots(m_mask + 1, PointCells::kNone)
    {
        for (std::size_t i = 0; i < cells.cells.size(); ++i)
        {
            // Two centroids may round to one place; the first one has it.
            const Key key = keyOf(cells.cells[i].position);
            std::size_t slot = hashOf(key);
            while (m_slots[slot] != PointCells::kNone && keyOf(cells.cells[m_slots[slot]].position) != key)
                slot = (slot + 1) & m_mask;
            if (m_slots[slot] == PointCells::kNone)
                m_slots[slot] = static_cast<std::uint32_t>(i);
        }
    }
    /// The cell that holds the point, or the nearest of the 26 around it.
    [[nodiscard]] std::uint32_t find(const Eigen::Vector3f& p) const
    {
        const Key key = keyOf(p);
        if (const std::uint32_t own = at(key); own != PointCells::kNone)
            return own;
        std::uint32_t best = PointCells::kNone;
        float distance = std::numeric_limits<float>::infinity();
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                {
                    const std::uint32_t cell = at(key + Key(dx, dy, dz));
                    if (cell == PointCells::kNone)
                        continue;
                    const float d = (m_cells.cells[cell].position - p).squaredNorm();
                    if (d < distance)
                        distance = d, best = cell;
                }
        return best;
    }

private:
    [[nodiscard]] Key keyOf(const Eigen::Vector3f& p) const
    {
        const auto along = [&](float v) { return floorToInt(static_cast<double>(v) * m_perMetre); };
        return {along(p.x()), along(p.y()), along(p.z())};
    }
    [[nodiscard]] std::size_t hashOf(const Key& key) const
    {
        // Eight neighbours along x stay neighbours in memory; these groups are spread evenly, or runs would grow
        // together.
        const std::uint64_t group =
            randomBits(static_cast<std::uint32_t>(key.x() >> 3), static_cast<std::uint32_t>(key.y()),
                       static_cast<std::uint32_t>(key.z()));
        return (group << 3 | static_cast<std::uint64_t>(key.x() & 7)) & m_mask;
    }
    [[nodiscard]] std::uint32_t at(const Key& key) const
    {
        std::size_t slot = hashOf(key);
        while (m_slots[slot] != PointCells::kNone)
        {
            if (keyOf(m_cells.cells[m_slots[slot]].position) == key)
                return m_slots[slot];
            slot = (slot + 1) & m_mask;
        }
        return PointCells::kNone;
    }

    const SurfaceCells& m_cells;
    double m_perMetre;
    std::size_t m_mask;
    std::vector<std::uint32_t> m_slots;
};

}  // namespace

PointCells findPointCells(const CloudView& cloud, const SurfaceCells& cells, const Context& context)
{
    const CellTable table(cells);
    PointCells result;
    result.cellOfPoint.resize(cloud.count);
    parallelChunks(cloud.count, kChunk, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t i = begin; i < end; ++i)
                           result.cellOfPoint[i] = table.find(pointAt(cloud, i));
                   });
    context.checkCancelled();
    return result;
}

std::vector<std::array<std::uint8_t, 3>> cellColours(const CloudView& cloud, const PointCells& points,
                                                     std::size_t cellCount, const Context& context)
{
    struct Sum
    {
        std::array<std::uint32_t, 3> rgb{};  // of up to 16 million points
        std::uint32_t count = 0;
    };
    std::vector<Sum> sums(cellCount);
    for (std::size_t i = 0; i < cloud.count; ++i)
    {
        if (i % kChunk == 0)
            context.checkCancelled();
        if (points.cellOfPoint[i] == PointCells::kNone || sums[points.cellOfPoint[i]].count == (1u << 24))
            continue;
        Sum& sum = sums[points.cellOfPoint[i]];
        ++sum.count;
        for (std::size_t k = 0; k < 3; ++k)
            sum.rgb[k] += cloud.rgb[cloud.rgbStride * i + k];
    }
    std::vector<std::array<std::uint8_t, 3>> colours(cellCount);
    for (std::size_t c = 0; c < cellCount; ++c)
        for (std::size_t k = 0; k < 3 && sums[c].count > 0; ++k)
            colours[c][k] = static_cast<std::uint8_t>((sums[c].rgb[k] + sums[c].count / 2) / sums[c].count);
    return colours;
}

}  // namespace s2b

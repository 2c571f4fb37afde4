// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/surface_cells.h"

#include "core/base/parallel.h"
#include "core/cloud/blocks.h"
#include "core/cloud/cell_moments.h"
#include "core/cloud/cell_normals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace s2b
{
namespace
{

// Mean cosine between normal and view: 8 degrees off the surface; less is noise in the normal, or was seen from both
// sides.
constexpr float kLeastFacing = 0.14f;
constexpr double kLeastFlat = 0.35;        // smallest to middle variance of what still has a direction
constexpr std::size_t kBlockChunk = 16;    // blocks that one thread takes at a time
constexpr std::size_t kSampledBlock = 16;  // every so many blocks are counted first

/// A whole number of cells per block keeps cells and blocks aligned.
int cellsPerBlockOf(double spacing_m, const CellParams& params)
{
    const double wanted = std::clamp(spacing_m * params.spacingsPerCell, params.size_m, 0.25 * kBlock_m);
    return std::max(4, static_cast<int>(std::floor(kBlock_m / wanted + 1e-9)));
}

/// Gathers cells and finds their normals layer by layer of blocks, from below: only three layers of moments are kept at
/// a time, which take more memory than the cells themselves.
class CellBuilder
{
public:
    CellBuilder(const CloudView& cloud, const Blocks& blocks, int cellsPerBlock, const CellParams& params,
                const Context& context, std::uint32_t* cellOfPoint)
        : m_cloud(cloud),
          m_blocks(blocks),
          m_cellsPerBlock(cellsPerBlock),
          m_params(params),
          m_context(context),
          m_cellOfPoint(cellOfPoint),
          m_moments(blocks.occupied.size()),
          m_slotOfBlock(blocks.start.size() - 1, -1)
    {
        for (std::size_t k = 0; k < blocks.occupied.size(); ++k)
            m_slotOfBlock[blocks.occupied[k]] = static_cast<std::int32_t>(k);
        const auto perLayer = static_cast<std::uint32_t>(blocks.size.x() * blocks.size.y());
        for (int z = 0; z <= blocks.size.z(); ++z)
            m_firstOfLayer.push_back(
                static_cast<std::size_t>(std::lower_bound(blocks.occupied.begin(), blocks.occupied.end(),
                                                          perLayer * static_cast<std::uint32_t>(z)) -
                                         blocks.occupied.begin()));
    }

    /// @param firstOfLayer  as SurfaceCells::firstOfLayer
    [[nodiscard]] std::vector<SurfaceCell> build(std::vector<std::size_t>& firstOfLayer)
    {
        std::vector<SurfaceCell> cells;
        cells.reserve(expectedCells());
        firstOfLayer.assign(1, 0);
        const std::size_t layers = m_firstOfLayer.size() - 1;
        gather(0);
        for (std::size_t z = 0; z < layers; ++z)
        {
            if (z + 1 < layers)
                gather(z + 1);
            append(z, cells);
            firstOfLayer.push_back(cells.size());
            if (z > 0)
                for (std::size_t k = m_firstOfLayer[z - 1]; k < m_firstOfLayer[z]; ++k)
                    m_moments[k] = {};
        }
        return cells;
    }

private:
    [[nodiscard]] Eigen::Vector3i coordinates(std::size_t slot) const
    {
        const int nx = m_blocks.size.x(), ny = m_blocks.size.y(), v = static_cast<int>(m_blocks.occupied[slot]);
        return {v % nx, v / nx % ny, v / nx / ny};
    }
    [[nodiscard]] Eigen::Vector3i firstCell(std::size_t slot) const
    {
        return (coordinates(slot) + m_blocks.low.matrix()) * m_cellsPerBlock;
    }

    /// About how many cells there will be, so that their memory need not grow, and be copied, on the way.
    [[nodiscard]] std::size_t expectedCells() const
    {
        const std::size_t samples = (m_blocks.occupied.size() + kSampledBlock - 1) / kSampledBlock;
        std::vector<std::size_t> counts(samples, 0);
        parallelChunks(samples, kBlockChunk, m_context,
                       [&](std::size_t begin, std::size_t end)
                       {
                           CellGatherer gatherer(m_cloud, m_blocks, m_cellsPerBlock);
                           for (std::size_t i = begin; i < end; ++i)
                               counts[i] =
                                   gatherer.count(m_blocks.occupied[i * kSampledBlock], firstCell(i * kSampledBlock));
                       });
        std::size_t sum = 0;
        for (const std::size_t c : counts)
            sum += c;
        return static_cast<std::size_t>(1.1 * static_cast<double>(sum) * static_cast<double>(m_blocks.occupied.size()) /
                                        static_cast<double>(samples));
    }

    void gather(std::size_t layer)
    {
        const std::size_t first = m_firstOfLayer[layer];
        parallelChunks(m_firstOfLayer[layer + 1] - first, kBlockChunk, m_context,
                       [&](std::size_t begin, std::size_t end)
                       {
                           CellGatherer gatherer(m_cloud, m_blocks, m_cellsPerBlock);
                           for (std::size_t k = first + begin; k < first + end; ++k)
                               m_moments[k] = gatherer.gather(m_blocks.occupied[k], firstCell(k), m_cellOfPoint);
                       });
        m_context.checkCancelled();
    }

    void append(std::size_t layer, std::vector<SurfaceCell>& cells) const
    {
        const std::size_t first = m_firstOfLayer[layer], count = m_firstOfLayer[layer + 1] - first;
        std::vector<std::size_t> firstOut(count + 1, cells.size());
        for (std::size_t k = 0; k < count; ++k)
            firstOut[k + 1] = firstOut[k] + m_moments[first + k].size();
        if (firstOut[count] > cells.capacity())
            cells.reserve(firstOut[count] + firstOut[count] / 4);
        cells.resize(firstOut[count]);
        parallelChunks(count, kBlockChunk, m_context,
                       [&](std::size_t begin, std::size_t end)
                       {
                           NormalFinder normals(m_cellsPerBlock, m_params.minimumNeighbours);
                           for (std::size_t k = begin; k < end; ++k)
                           {
                               normals.lookAt(around(first + k));
                               const Eigen::Vector3d low = firstCell(first + k).cast<double>();
                               std::size_t out = firstOut[k];
                               for (const Moments& m : m_moments[first + k])
                                   cells[out++] = cellOf(m, low, normals.of(m));
                               if (m_cellOfPoint)
                                   numberPoints(m_blocks.occupied[first + k], firstOut[k]);
                           }
                       });
        m_context.checkCancelled();
    }

    /// From cells of the block to cells of the cloud.
    void numberPoints(std::uint32_t block, std::size_t firstOfBlock) const
    {
        for (std::uint32_t j = m_blocks.start[block]; j < m_blocks.start[block + 1]; ++j)
            m_cellOfPoint[m_blocks.order[j]] += static_cast<std::uint32_t>(firstOfBlock);
    }

    [[nodiscard]] NormalFinder::Around around(std::size_t slot) const
    {
        NormalFinder::Around blocks{};
        const Eigen::Vector3i here = coordinates(slot);
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                {
                    const Eigen::Array3i other = here.array() + Eigen::Array3i(dx, dy, dz);
                    if ((other < 0).any() || (other >= m_blocks.size).any())
                        continue;
                    const std::int32_t at = m_slotOfBlock[static_cast<std::size_t>(other.x()) +
                                                          static_cast<std::size_t>(m_blocks.size.x()) *
                                                              (static_cast<std::size_t>(other.y()) +
                                                               static_cast<std::size_t>(m_blocks.size.y()) *
                                                                   static_cast<std::size_t>(other.z()))];
                    if (at >= 0)
                        blocks[static_cast<std::size_t>(dx + 1 + 3 * (dy + 1) + 9 * (dz + 1))] =
                            &m_moments[static_cast<std::size_t>(at)];
                }
        return blocks;
    }

    [[nodiscard]] SurfaceCell cellOf(const Moments& m, const Eigen::Vector3d& low, const CellNormal& normal) const
    {
        const double size = kBlock_m / m_cellsPerBlock;
        SurfaceCell cell;
        const Eigen::Vector3d mean(m.sum[0], m.sum[1], m.sum[2]);
        cell.position =
            ((low + Eigen::Vector3d(m.local[0] + 0.5, m.local[1] + 0.5, m.local[2] + 0.5) + mean / m.count) * size)
                .cast<float>();
        cell.count = m.count;
        cell.label = m.label;
        cell.labelShare = m.labelShare;
        cell.flatness = normal.flatness * static_cast<float>(size);
        if (normal.valid && normal.ratio < kLeastFlat)
        {
            cell.normal = normal.direction;
            const float facing = normal.direction.dot(Eigen::Vector3f(m.view[0], m.view[1], m.view[2])) / 127.0f;
            cell.facesScanner = std::abs(facing) > kLeastFacing;
            if (cell.facesScanner && facing < 0)
                cell.normal = -cell.normal;
        }
        return cell;
    }

    const CloudView& m_cloud;
    const Blocks& m_blocks;
    int m_cellsPerBlock;
    const CellParams& m_params;
    const Context& m_context;
    std::uint32_t* m_cellOfPoint;                 ///< by point; none where nobody asks for it
    std::vector<std::vector<Moments>> m_moments;  ///< by occupied block; of three layers at a time
    std::vector<std::int32_t> m_slotOfBlock;      ///< by block of the grid: index among the occupied, or -1
    std::vector<std::size_t> m_firstOfLayer;      ///< among the occupied, and one more
};

}  // namespace

SurfaceCells SurfaceCells::empty() const
{
    SurfaceCells none;
    none.size_m = size_m, none.spacing_m = spacing_m;
    none.hasLabels = hasLabels, none.hasGuesses = hasGuesses, none.hasStations = hasStations;
    return none;
}

std::span<const SurfaceCell> SurfaceCells::between(double zMin, double zMax) const
{
    if (firstOfLayer.size() < 2)
        return cells;
    constexpr double rounding_m = 0.01;
    const auto layerAt = [&](double z, double layers)
    { return static_cast<std::size_t>(std::clamp(std::floor((z - lowestLayer_m) / kBlock_m), 0.0, layers)); };
    const auto layers = static_cast<double>(firstOfLayer.size() - 1);
    const std::size_t first = firstOfLayer[layerAt(zMin - rounding_m, layers)],
                      last = firstOfLayer[layerAt(zMax + rounding_m + kBlock_m, layers)];
    return std::span(cells).subspan(first, std::max(first, last) - first);
}

SurfaceCells buildSurfaceCells(const CloudView& cloud, const KeptRegion& region, const CellParams& params,
                               const Context& context, std::vector<std::uint32_t>* cellOfPoint)
{
    if (cloud.count == 0)
        throw Error(ErrorCode::EmptyCloud, "the cloud has no points");
    if (cloud.count > std::numeric_limits<PointIndex>::max())
        throw Error(ErrorCode::BadFile, "the cloud has more than 4294967295 points; subsample it first");
    const Blocks blocks = sortIntoBlocks(cloud, region, context);

    SurfaceCells result;
    result.hasLabels = cloud.labels != nullptr;
    result.hasStations = !cloud.stations.empty();
    result.hasGuesses = result.hasLabels && cloud.confidence != nullptr;
    result.spacing_m = estimateSpacing(cloud, blocks);
    const int cellsPerBlock = cellsPerBlockOf(result.spacing_m, params);
    result.size_m = kBlock_m / cellsPerBlock;
    result.lowestLayer_m = kBlock_m * blocks.low.z();
    if (cellOfPoint)
        cellOfPoint->assign(cloud.count, kNoCell);
    result.cells =
        CellBuilder(cloud, blocks, cellsPerBlock, params, context, cellOfPoint ? cellOfPoint->data() : nullptr)
            .build(result.firstOfLayer);
    return result;
}

}  // namespace s2b

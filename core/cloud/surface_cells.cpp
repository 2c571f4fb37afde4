// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/surface_cells.h"

#include "core/base/parallel.h"
#include "core/cloud/blocks.h"
#include "core/cloud/cell_moments.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

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

struct Normal
{
    Eigen::Vector3f direction = Eigen::Vector3f::Zero();
    float flatness = 0;  // in cells
    double ratio = 1.0;  // smallest to middle variance
    bool valid = false;
};

Normal normalOf(const Accumulated& a, int minimum)
{
    Normal result;
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

/// Looks cells up around one block: a dense index grid with a halo, cleared by undoing what was set.
class Neighbourhood
{
public:
    explicit Neighbourhood(int cellsPerBlock)
        : m_edge(cellsPerBlock + 2 * kHalo),
          m_index(
              static_cast<std::size_t>(m_edge) * static_cast<std::size_t>(m_edge) * static_cast<std::size_t>(m_edge),
              nullptr)
    {
    }
    void set(int x, int y, int z, const Moments* m)
    {
        const std::size_t i = at(x, y, z);
        m_index[i] = m;
        m_set.push_back(i);
    }
    [[nodiscard]] const Moments* get(int x, int y, int z) const { return m_index[at(x, y, z)]; }
    [[nodiscard]] bool holds(int v) const { return v >= -kHalo && v < m_edge - kHalo; }
    void clear()
    {
        for (const std::size_t i : m_set)
            m_index[i] = nullptr;
        m_set.clear();
    }

private:
    [[nodiscard]] std::size_t at(int x, int y, int z) const
    {
        return static_cast<std::size_t>(x + kHalo) +
               static_cast<std::size_t>(m_edge) *
                   (static_cast<std::size_t>(y + kHalo) +
                    static_cast<std::size_t>(m_edge) * static_cast<std::size_t>(z + kHalo));
    }
    int m_edge;
    std::vector<const Moments*> m_index;
    std::vector<std::size_t> m_set;
};

}  // namespace

SurfaceCells buildSurfaceCells(const CloudView& cloud, const KeptRegion& region, const CellParams& params,
                               const Context& context)
{
    if (cloud.count == 0)
        throw Error(ErrorCode::EmptyCloud, "the cloud has no points");
    if (cloud.count > std::numeric_limits<PointIndex>::max())
        throw Error(ErrorCode::BadFile, "the cloud has more than 4294967295 points; subsample it first");
    Blocks blocks = sortIntoBlocks(cloud, region, context);

    SurfaceCells result;
    result.hasLabels = cloud.labels != nullptr;
    result.spacing_m = estimateSpacing(cloud, blocks);
    // A whole number of cells per block keeps cells and blocks aligned.
    const double wanted = std::clamp(result.spacing_m * params.spacingsPerCell, params.size_m, 0.25 * kBlock_m);
    const int cellsPerBlock = std::max(4, static_cast<int>(std::floor(kBlock_m / wanted + 1e-9)));
    const double size = kBlock_m / cellsPerBlock;
    result.size_m = size;

    const std::size_t blockCount = blocks.occupied.size();
    std::vector<std::vector<Moments>> moments(blockCount);
    std::vector<std::int32_t> slotOfBlock(blocks.start.size() - 1, -1);
    for (std::size_t k = 0; k < blockCount; ++k)
        slotOfBlock[blocks.occupied[k]] = static_cast<std::int32_t>(k);
    const auto coordinates = [&](std::uint32_t b) -> Eigen::Vector3i
    {
        const int nx = blocks.size.x(), ny = blocks.size.y(), v = static_cast<int>(b);
        return {v % nx, v / nx % ny, v / nx / ny};
    };
    const auto firstCell = [&](std::uint32_t b) -> Eigen::Vector3i
    { return (coordinates(b) + blocks.low.matrix()) * cellsPerBlock; };

    parallelChunks(blockCount, 16, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       CellGatherer gatherer(cloud, blocks, cellsPerBlock);
                       for (std::size_t k = begin; k < end; ++k)
                           moments[k] = gatherer.gather(blocks.occupied[k], firstCell(blocks.occupied[k]));
                   });
    context.checkCancelled();
    blocks.order = {};

    std::vector<std::size_t> firstOut(blockCount + 1, 0);
    for (std::size_t k = 0; k < blockCount; ++k)
        firstOut[k + 1] = firstOut[k] + moments[k].size();
    result.cells.resize(firstOut[blockCount]);

    const auto normalsOfBlock = [&](std::size_t k, Neighbourhood& around)
    {
        const Eigen::Vector3i here = coordinates(blocks.occupied[k]);
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                {
                    const Eigen::Vector3i other = here + Eigen::Vector3i(dx, dy, dz);
                    if ((other.array() < 0).any() || (other.array() >= blocks.size).any())
                        continue;
                    const std::int32_t slot = slotOfBlock[static_cast<std::size_t>(other.x()) +
                                                          static_cast<std::size_t>(blocks.size.x()) *
                                                              (static_cast<std::size_t>(other.y()) +
                                                               static_cast<std::size_t>(blocks.size.y()) *
                                                                   static_cast<std::size_t>(other.z()))];
                    if (slot < 0)
                        continue;
                    const std::vector<Moments>& cells = moments[static_cast<std::size_t>(slot)];
                    const auto layer = [&](int z)
                    {
                        return std::partition_point(cells.begin(), cells.end(),
                                                    [&](const Moments& m) { return m.local[2] < z; });
                    };
                    // Sorted by z: of the blocks below and above only the layers that the halo reaches.
                    const auto first = dz < 0 ? layer(cellsPerBlock - kHalo) : cells.begin();
                    const auto last = dz > 0 ? layer(kHalo) : cells.end();
                    for (auto m = first; m != last; ++m)
                    {
                        const int x = m->local[0] + dx * cellsPerBlock, y = m->local[1] + dy * cellsPerBlock,
                                  z = m->local[2] + dz * cellsPerBlock;
                        if (around.holds(x) && around.holds(y) && around.holds(z))
                            around.set(x, y, z, &*m);
                    }
                }
        const Eigen::Vector3d low = firstCell(blocks.occupied[k]).cast<double>();
        std::size_t out = firstOut[k];
        for (const Moments& m : moments[k])
        {
            const int x = m.local[0], y = m.local[1], z = m.local[2];
            const auto gather = [&](int radius)
            {
                Accumulated a;
                for (int dz = -radius; dz <= radius; ++dz)
                    for (int dy = -radius; dy <= radius; ++dy)
                        for (int dx = -radius; dx <= radius; ++dx)
                            if (const Moments* o = around.get(x + dx, y + dy, z + dz))
                                a.add(*o, dx, dy, dz);
                return normalOf(a, params.minimumNeighbours);
            };
            Normal normal = gather(1);
            // Too few points, or noise as wide as the neighbourhood: look further, and keep the flatter one.
            if (!normal.valid || normal.ratio > 0.08)
            {
                const Normal wider = gather(2);
                if (wider.valid && (!normal.valid || wider.ratio < normal.ratio))
                    normal = wider;
            }
            SurfaceCell& cell = result.cells[out++];
            const Eigen::Vector3d mean(m.sum[0], m.sum[1], m.sum[2]);
            cell.position = ((low + Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5) + mean / m.count) * size).cast<float>();
            cell.count = m.count;
            cell.label = m.label;
            cell.labelShare = m.labelShare;
            cell.flatness = normal.flatness * static_cast<float>(size);
            if (normal.valid && normal.ratio < 0.35)
                cell.normal = normal.direction;
        }
        around.clear();
    };
    parallelChunks(blockCount, 16, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       Neighbourhood around(cellsPerBlock);
                       for (std::size_t k = begin; k < end; ++k)
                           normalsOfBlock(k, around);
                   });
    context.checkCancelled();
    return result;
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/surface_cells.h"

#include "core/base/parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>

namespace s2b
{
namespace
{

constexpr double kBlock_m = 1.0;  // a block's cells fit into the cache
constexpr std::size_t kPointChunk = 1u << 18;
constexpr std::int32_t kUnits = 4096;  // positions within a cell, as whole numbers: sums don't depend on the order
constexpr int kHalo = 2;               // cells around a block that its normals look at

struct Bounds
{
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
};

Eigen::Vector3f pointAt(const CloudView& cloud, std::size_t i)
{
    return {cloud.xyz[3 * i], cloud.xyz[3 * i + 1], cloud.xyz[3 * i + 2]};
}

Bounds findBounds(const CloudView& cloud, const KeptRegion& region, const Context& context)
{
    Bounds all;
    std::mutex mutex;
    std::atomic<std::size_t> firstBad{std::numeric_limits<std::size_t>::max()};
    parallelChunks(cloud.count, kPointChunk, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       Bounds b;
                       for (std::size_t i = begin; i < end; ++i)
                       {
                           const Eigen::Vector3f p = pointAt(cloud, i);
                           if (!p.allFinite())
                           {
                               std::size_t seen = firstBad.load();
                               while (i < seen && !firstBad.compare_exchange_weak(seen, i))
                               {
                               }
                               return;
                           }
                           if (!region.contains(p))
                               continue;
                           b.low = b.low.cwiseMin(p.cast<double>());
                           b.high = b.high.cwiseMax(p.cast<double>());
                       }
                       const std::lock_guard lock(mutex);
                       all.low = all.low.cwiseMin(b.low);
                       all.high = all.high.cwiseMax(b.high);
                   });
    context.checkCancelled();
    if (firstBad != std::numeric_limits<std::size_t>::max())
        throw Error(ErrorCode::BadCoordinates,
                    "point " + std::to_string(firstBad) +
                        " has coordinates that are not finite numbers; remove such points first");
    if (!(all.low.x() <= all.high.x()))
        throw Error(ErrorCode::EmptyCloud, "the cloud has no points to work on");
    return all;
}

/// Points sorted by block: the only per-point memory.
struct Blocks
{
    Eigen::Array3i low = Eigen::Array3i::Zero();  ///< block coordinate of the grid's first block
    Eigen::Array3i size = Eigen::Array3i::Zero();
    std::vector<std::uint32_t> start;     ///< per block of the grid, and one more
    std::vector<PointIndex> order;        ///< point indices, block after block
    std::vector<std::uint32_t> occupied;  ///< grid indices of blocks with points, ascending
};

Blocks sortIntoBlocks(const CloudView& cloud, const KeptRegion& region, const Bounds& bounds, const Context& context)
{
    Blocks blocks;
    double edge = kBlock_m;
    blocks.low = (bounds.low / edge).array().floor().cast<int>();
    const Eigen::Array3i high = (bounds.high / edge).array().floor().cast<int>();
    blocks.size = high - blocks.low + 1;
    const double gridSize = blocks.size.cast<double>().prod();
    if (gridSize > 4e8)
        throw Error(ErrorCode::BadCoordinates,
                    "the cloud spans " + std::to_string((bounds.high - bounds.low).maxCoeff()) +
                        " m; remove the points far outside the building, or turn the clutter filter on");
    const auto blockOf = [&](const Eigen::Vector3f& p) -> std::size_t
    {
        const Eigen::Array3i b = (p.cast<double>() / edge).array().floor().cast<int>() - blocks.low;
        return static_cast<std::size_t>(b.x()) +
               static_cast<std::size_t>(blocks.size.x()) *
                   (static_cast<std::size_t>(b.y()) +
                    static_cast<std::size_t>(blocks.size.y()) * static_cast<std::size_t>(b.z()));
    };
    const std::size_t count = static_cast<std::size_t>(gridSize);
    std::vector<std::atomic<std::uint32_t>> cursor(count + 1);
    const auto overPoints = [&](const auto& visit)
    {
        parallelChunks(cloud.count, kPointChunk, context,
                       [&](std::size_t begin, std::size_t end)
                       {
                           for (std::size_t i = begin; i < end; ++i)
                           {
                               const Eigen::Vector3f p = pointAt(cloud, i);
                               if (region.contains(p))
                                   visit(i, blockOf(p));
                           }
                       });
        context.checkCancelled();
    };
    overPoints([&](std::size_t, std::size_t b) { cursor[b].fetch_add(1, std::memory_order_relaxed); });
    blocks.start.resize(count + 1);
    std::uint32_t sum = 0;
    for (std::size_t b = 0; b < count; ++b)
    {
        blocks.start[b] = sum;
        const std::uint32_t n = cursor[b].load(std::memory_order_relaxed);
        if (n > 0)
            blocks.occupied.push_back(static_cast<std::uint32_t>(b));
        cursor[b].store(sum, std::memory_order_relaxed);
        sum += n;
    }
    blocks.start[count] = sum;
    blocks.order.resize(sum);
    overPoints([&](std::size_t i, std::size_t b)
               { blocks.order[cursor[b].fetch_add(1, std::memory_order_relaxed)] = static_cast<PointIndex>(i); });
    return blocks;
}

/// Typical distance between neighbouring points on a surface: from the points per occupied 8 cm cell of dense blocks.
double estimateSpacing(const CloudView& cloud, const Blocks& blocks)
{
    constexpr double edge = 0.08;
    std::vector<std::pair<double, std::uint32_t>> perBlock;  // points per occupied cell, points
    const std::size_t step = std::max<std::size_t>(1, blocks.occupied.size() / 400);
    for (std::size_t k = 0; k < blocks.occupied.size(); k += step)
    {
        const std::uint32_t b = blocks.occupied[k];
        const std::uint32_t n = blocks.start[b + 1] - blocks.start[b];
        std::vector<std::uint64_t> keys(n);
        for (std::uint32_t j = 0; j < n; ++j)
        {
            const Eigen::Array3d c =
                (pointAt(cloud, blocks.order[blocks.start[b] + j]).cast<double>() / edge).array().floor();
            const auto part = [](double v)
            { return static_cast<std::uint64_t>(static_cast<std::int64_t>(v) + (1 << 20)); };
            keys[j] = part(c.x()) | part(c.y()) << 21 | part(c.z()) << 42;
        }
        std::sort(keys.begin(), keys.end());
        const auto distinct = std::unique(keys.begin(), keys.end()) - keys.begin();
        perBlock.emplace_back(static_cast<double>(n) / static_cast<double>(distinct), n);
    }
    std::sort(perBlock.begin(), perBlock.end());
    std::uint64_t total = 0;
    for (const auto& [density, n] : perBlock)
        total += n;
    std::uint64_t sum = 0;
    for (const auto& [density, n] : perBlock)
    {
        sum += n;
        if (2 * sum >= total)
            return std::clamp(edge / std::sqrt(density), 0.001, 0.5);
    }
    return 0.02;
}

struct Moments
{
    std::array<std::int16_t, 3> local{};  ///< cell within the block, 0..cells per block - 1
    Label label = Label::Unassigned;
    std::uint8_t labelShare = 0;
    std::uint32_t count = 0;
    std::array<float, 3> sum{};     ///< of positions relative to the cell's centre, in cells
    std::array<float, 6> square{};  ///< xx xy xz yy yz zz
};

/// Cells of one block, sorted by (z, y, x).
std::vector<Moments> momentsOfBlock(const CloudView& cloud, const Blocks& blocks, std::uint32_t block, double size,
                                    const Eigen::Vector3i& firstCell)
{
    const std::uint32_t begin = blocks.start[block];
    const std::uint32_t n = blocks.start[block + 1] - begin;
    // Key and position in one word: sorting words is what the processor does best.
    std::vector<std::uint64_t> keyed(n);
    std::vector<std::array<std::int32_t, 3>> position(n);
    const Eigen::Array3d first = firstCell.cast<double>().array(), last = first + (std::round(kBlock_m / size) - 1);
    for (std::uint32_t j = 0; j < n; ++j)
    {
        const PointIndex i = blocks.order[begin + j];
        const Eigen::Array3d q = pointAt(cloud, i).cast<double>().array() / size;
        // A point on the block's own border: the division may round it into the cell before.
        const Eigen::Array3d cell = q.floor().max(first).min(last);
        const Eigen::Array3i local = cell.cast<int>() - firstCell.array();
        keyed[j] = (static_cast<std::uint64_t>(local.x()) | static_cast<std::uint64_t>(local.y()) << 10 |
                    static_cast<std::uint64_t>(local.z()) << 20)
                       << 32 |
                   j;
        const Eigen::Array3d inCell = ((q - cell - 0.5) * kUnits).round();
        position[j] = {static_cast<std::int32_t>(inCell.x()), static_cast<std::int32_t>(inCell.y()),
                       static_cast<std::int32_t>(inCell.z())};
    }
    std::sort(keyed.begin(), keyed.end());
    std::vector<Moments> cells;
    for (std::size_t j = 0; j < keyed.size();)
    {
        Moments m;
        const auto key = static_cast<std::uint32_t>(keyed[j] >> 32);
        m.local = {static_cast<std::int16_t>(key & 1023), static_cast<std::int16_t>(key >> 10 & 1023),
                   static_cast<std::int16_t>(key >> 20)};
        std::array<std::int64_t, 3> s{};
        std::array<std::int64_t, 6> q{};
        std::array<std::uint32_t, kLabelCount> votes{};
        for (; j < keyed.size() && static_cast<std::uint32_t>(keyed[j] >> 32) == key; ++j)
        {
            const auto at = static_cast<std::uint32_t>(keyed[j]);
            const auto& p = position[at];
            ++m.count;
            for (int a = 0; a < 3; ++a)
                s[static_cast<std::size_t>(a)] += p[static_cast<std::size_t>(a)];
            q[0] += static_cast<std::int64_t>(p[0]) * p[0];
            q[1] += static_cast<std::int64_t>(p[0]) * p[1];
            q[2] += static_cast<std::int64_t>(p[0]) * p[2];
            q[3] += static_cast<std::int64_t>(p[1]) * p[1];
            q[4] += static_cast<std::int64_t>(p[1]) * p[2];
            q[5] += static_cast<std::int64_t>(p[2]) * p[2];
            if (cloud.labels)
                ++votes[std::min<std::size_t>(cloud.labels[blocks.order[begin + at]], kLabelCount - 1)];
        }
        for (std::size_t a = 0; a < 3; ++a)
            m.sum[a] = static_cast<float>(static_cast<double>(s[a]) / kUnits);
        for (std::size_t a = 0; a < 6; ++a)
            m.square[a] = static_cast<float>(static_cast<double>(q[a]) / (static_cast<double>(kUnits) * kUnits));
        if (cloud.labels)
        {
            const auto best = std::max_element(votes.begin(), votes.end());
            m.label = static_cast<Label>(best - votes.begin());
            m.labelShare = static_cast<std::uint8_t>(255.0 * *best / m.count);
        }
        cells.push_back(m);
    }
    return cells;
}

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
    const Bounds bounds = findBounds(cloud, region, context);
    Blocks blocks = sortIntoBlocks(cloud, region, bounds, context);

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

    parallelChunks(blockCount, 8, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t k = begin; k < end; ++k)
                           moments[k] =
                               momentsOfBlock(cloud, blocks, blocks.occupied[k], size, firstCell(blocks.occupied[k]));
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
                    for (const Moments& m : moments[static_cast<std::size_t>(slot)])
                    {
                        const int x = m.local[0] + dx * cellsPerBlock, y = m.local[1] + dy * cellsPerBlock,
                                  z = m.local[2] + dz * cellsPerBlock;
                        if (around.holds(x) && around.holds(y) && around.holds(z))
                            around.set(x, y, z, &m);
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/dbscan.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>

namespace s2b
{

namespace
{

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Disjoint sets with path halving; the root of a set is its lowest member.
class UnionFind
{
public:
    explicit UnionFind(std::size_t count) : m_parent(count) { std::iota(m_parent.begin(), m_parent.end(), 0u); }
    [[nodiscard]] std::uint32_t find(std::uint32_t x)
    {
        while (m_parent[x] != x)
            x = m_parent[x] = m_parent[m_parent[x]];
        return x;
    }
    void join(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        m_parent[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> m_parent;
};

/// The points in cells whose diagonal is just below eps: points of one cell are neighbours of each other, and those of
/// any other cell only when it is at most kReach cells away along each axis.
template <int kDim>
class CellGrid
{
public:
    using Point = Eigen::Matrix<double, kDim, 1>;
    using Key = std::array<std::int32_t, kDim>;
    /// ceil of sqrt(2) and of sqrt(3), the cells in eps.
    static constexpr std::int32_t kReach = 2;

    template <class InputPoint>
    CellGrid(std::span<const InputPoint> points, double eps)
    {
        Point low = Point::Constant(std::numeric_limits<double>::infinity());
        Point high = -low;
        for (const InputPoint& p : points)
        {
            if (!p.allFinite())
                throw Error(ErrorCode::BadCoordinates, "a point to be clustered has coordinates that are not finite");
            low = low.cwiseMin(p.template cast<double>());
            high = high.cwiseMax(p.template cast<double>());
        }
        // A little less than eps / sqrt(dim): rounding must not put points farther apart than eps into one cell.
        const double side = eps / std::sqrt(double(kDim)) * (1.0 - 1e-9);
        if (!((high - low).maxCoeff() / side < 2147483640.0))
            throw Error(ErrorCode::BadParameter, "a cluster radius of " + std::to_string(eps) +
                                                     " m is too small for the extent of the points, use a larger one");

        struct Entry
        {
            Key key;
            std::uint32_t index;
        };
        std::vector<Entry> entries(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            for (int d = 0; d < kDim; ++d)
                entries[i].key[std::size_t(d)] = std::int32_t(std::floor((double(points[i][d]) - low[d]) / side));
            entries[i].index = std::uint32_t(i);
        }
        std::sort(entries.begin(), entries.end(),
                  [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.index < b.index; });

        m_points.reserve(points.size());
        m_index.reserve(points.size());
        for (const Entry& entry : entries)
        {
            if (m_keys.empty() || m_keys.back() != entry.key)
            {
                m_keys.push_back(entry.key);
                m_begin.push_back(std::uint32_t(m_points.size()));
            }
            m_points.push_back(points[entry.index].template cast<double>());
            m_index.push_back(entry.index);
        }
        m_begin.push_back(std::uint32_t(m_points.size()));
    }

    [[nodiscard]] std::uint32_t cellCount() const { return std::uint32_t(m_keys.size()); }
    [[nodiscard]] std::uint32_t begin(std::uint32_t cell) const { return m_begin[cell]; }
    [[nodiscard]] std::uint32_t end(std::uint32_t cell) const { return m_begin[cell + 1]; }
    [[nodiscard]] std::uint32_t size(std::uint32_t cell) const { return end(cell) - begin(cell); }
    [[nodiscard]] const Point& point(std::uint32_t slot) const { return m_points[slot]; }
    /// Index of the point in the input.
    [[nodiscard]] std::uint32_t index(std::uint32_t slot) const { return m_index[slot]; }
    [[nodiscard]] std::uint32_t pointCount() const { return std::uint32_t(m_points.size()); }

    /// Calls visit(cell, first, last) for every cell and each range [first, last) of cells in its reach, itself
    /// included.
    ///
    /// Cells that differ in the last axis alone are neighbours in the sorted order, so the reach is one range for each
    /// row of the other axes, and each moves on monotonically with the cell: no hash table, no search. Near rows come
    /// first: most questions end there.
    template <class Visit>
    void forEachNeighbourRange(Visit visit) const
    {
        const std::vector<Key> rows = rowsByDistance();
        std::vector<std::uint32_t> first(rows.size(), 0);
        std::vector<std::uint32_t> last(rows.size(), 0);
        for (std::uint32_t cell = 0; cell < cellCount(); ++cell)
        {
            for (std::size_t row = 0; row < rows.size(); ++row)
            {
                Key low = m_keys[cell];
                for (std::size_t d = 0; d < low.size(); ++d)
                    low[d] += rows[row][d];
                Key high = low;
                low.back() -= kReach;
                high.back() += kReach;
                while (first[row] < cellCount() && m_keys[first[row]] < low)
                    ++first[row];
                last[row] = std::max(last[row], first[row]);
                while (last[row] < cellCount() && !(high < m_keys[last[row]]))
                    ++last[row];
                if (first[row] < last[row])
                    visit(cell, first[row], last[row]);
            }
        }
    }

private:
    /// The offsets of the reach along all axes but the last.
    static std::vector<Key> rowsByDistance()
    {
        std::vector<Key> rows;
        for (std::int32_t x = -kReach; x <= kReach; ++x)
        {
            if constexpr (kDim == 2)
                rows.push_back({x, 0});
            else
            {
                for (std::int32_t y = -kReach; y <= kReach; ++y)
                    rows.push_back({x, y, 0});
            }
        }
        const auto distance2 = [](const Key& row)
        { return std::inner_product(row.begin(), row.end(), row.begin(), std::int32_t{0}); };
        std::ranges::stable_sort(rows, {}, distance2);
        return rows;
    }

    std::vector<Key> m_keys;
    std::vector<std::uint32_t> m_begin;  ///< of each cell in m_points, and the end
    std::vector<Point> m_points;         ///< sorted by cell, then by index
    std::vector<std::uint32_t> m_index;
};

template <int kDim>
class Dbscan
{
public:
    template <class InputPoint>
    Dbscan(std::span<const InputPoint> points, double eps, int minPoints)
        : m_grid(points, eps), m_eps2(eps * eps), m_minPoints(std::uint32_t(std::max(minPoints, 1)))
    {
    }

    std::vector<int> run()
    {
        findCorePoints();
        boundCorePoints();
        UnionFind sets = joinCells();
        const std::vector<std::uint32_t> nearest = findNearestCores();
        return numberClusters(sets, nearest);
    }

private:
    using Point = typename CellGrid<kDim>::Point;

    [[nodiscard]] bool near(std::uint32_t a, std::uint32_t b) const
    {
        return (m_grid.point(a) - m_grid.point(b)).squaredNorm() <= m_eps2;
    }

    [[nodiscard]] std::uint32_t countNear(std::uint32_t p, std::uint32_t cell) const
    {
        std::uint32_t count = 0;
        for (std::uint32_t q = m_grid.begin(cell); q < m_grid.end(cell); ++q)
            count += near(p, q) ? 1 : 0;
        return count;
    }

    void findCorePoints()
    {
        std::vector<std::uint32_t> neighbours(m_grid.pointCount());
        m_grid.forEachNeighbourRange(
            [&](std::uint32_t cell, std::uint32_t first, std::uint32_t last)
            {
                if (m_grid.size(cell) >= m_minPoints)
                    return;  // all of them are core points
                for (std::uint32_t other = first; other < last; ++other)
                {
                    for (std::uint32_t p = m_grid.begin(cell); p < m_grid.end(cell); ++p)
                    {
                        if (other == cell)
                            neighbours[p] += m_grid.size(cell);
                        else if (neighbours[p] < m_minPoints)
                            neighbours[p] += countNear(p, other);
                    }
                }
            });
        m_isCore.resize(m_grid.pointCount());
        for (std::uint32_t cell = 0; cell < m_grid.cellCount(); ++cell)
        {
            for (std::uint32_t p = m_grid.begin(cell); p < m_grid.end(cell); ++p)
                m_isCore[p] = m_grid.size(cell) >= m_minPoints || neighbours[p] >= m_minPoints;
        }
    }

    void boundCorePoints()
    {
        const Point infinite = Point::Constant(std::numeric_limits<double>::infinity());
        m_low.assign(m_grid.cellCount(), infinite);
        m_high.assign(m_grid.cellCount(), -infinite);
        m_core.assign(m_grid.cellCount(), kNone);
        for (std::uint32_t cell = 0; cell < m_grid.cellCount(); ++cell)
        {
            for (std::uint32_t p = m_grid.begin(cell); p < m_grid.end(cell); ++p)
            {
                if (!m_isCore[p])
                    continue;
                m_low[cell] = m_low[cell].cwiseMin(m_grid.point(p));
                m_high[cell] = m_high[cell].cwiseMax(m_grid.point(p));
                if (m_core[cell] == kNone)
                    m_core[cell] = p;
            }
        }
    }

    /// Squared distance of a point to the box of a cell's core points. The margin keeps rounding from excluding a pair
    /// that near() accepts.
    [[nodiscard]] bool nearBox(const Point& p, std::uint32_t cell) const
    {
        const Point outside = (m_low[cell] - p).cwiseMax(p - m_high[cell]).cwiseMax(0.0);
        return outside.squaredNorm() <= m_eps2 * (1.0 + 1e-9);
    }

    [[nodiscard]] bool haveNearCores(std::uint32_t a, std::uint32_t b) const
    {
        if (near(m_core[a], m_core[b]))
            return true;
        const Point gap = (m_low[a] - m_high[b]).cwiseMax(m_low[b] - m_high[a]).cwiseMax(0.0);
        if (gap.squaredNorm() > m_eps2 * (1.0 + 1e-9))
            return false;
        for (std::uint32_t p = m_grid.begin(a); p < m_grid.end(a); ++p)
        {
            if (!m_isCore[p] || !nearBox(m_grid.point(p), b))
                continue;
            for (std::uint32_t q = m_grid.begin(b); q < m_grid.end(b); ++q)
            {
                if (m_isCore[q] && near(p, q))
                    return true;
            }
        }
        return false;
    }

    UnionFind joinCells()
    {
        UnionFind sets(m_grid.cellCount());
        m_grid.forEachNeighbourRange(
            [&](std::uint32_t cell, std::uint32_t first, std::uint32_t last)
            {
                if (m_core[cell] == kNone)
                    return;
                for (std::uint32_t other = first; other < std::min(last, cell); ++other)
                {
                    if (m_core[other] != kNone && sets.find(cell) != sets.find(other) && haveNearCores(cell, other))
                        sets.join(cell, other);
                }
            });
        return sets;
    }

    /// The cell of the nearest core point of every point that is none itself; kNone for noise.
    std::vector<std::uint32_t> findNearestCores() const
    {
        std::vector<std::uint32_t> nearest(m_grid.pointCount(), kNone);
        std::vector<std::uint32_t> nearestIndex(m_grid.pointCount(), kNone);
        std::vector<double> nearest2(m_grid.pointCount(), m_eps2);
        m_grid.forEachNeighbourRange(
            [&](std::uint32_t cell, std::uint32_t first, std::uint32_t last)
            {
                for (std::uint32_t p = m_grid.begin(cell); p < m_grid.end(cell); ++p)
                {
                    if (m_isCore[p])
                        continue;
                    for (std::uint32_t other = first; other < last; ++other)
                    {
                        for (std::uint32_t q = m_grid.begin(other); q < m_grid.end(other); ++q)
                        {
                            const double distance2 = (m_grid.point(p) - m_grid.point(q)).squaredNorm();
                            if (!m_isCore[q] || distance2 > nearest2[p] ||
                                (distance2 == nearest2[p] && nearestIndex[p] <= m_grid.index(q)))
                                continue;
                            nearest[p] = other;
                            nearestIndex[p] = m_grid.index(q);
                            nearest2[p] = distance2;
                        }
                    }
                }
            });
        return nearest;
    }

    std::vector<int> numberClusters(UnionFind& sets, const std::vector<std::uint32_t>& nearest) const
    {
        std::vector<std::uint32_t> rootOfPoint(m_grid.pointCount(), kNone);
        for (std::uint32_t cell = 0; cell < m_grid.cellCount(); ++cell)
        {
            for (std::uint32_t p = m_grid.begin(cell); p < m_grid.end(cell); ++p)
            {
                const std::uint32_t owner = m_isCore[p] ? cell : nearest[p];
                if (owner != kNone)
                    rootOfPoint[m_grid.index(p)] = sets.find(owner);
            }
        }
        std::vector<int> numberOfRoot(m_grid.cellCount(), -1);
        std::vector<int> labels(m_grid.pointCount(), -1);
        int count = 0;
        for (std::size_t i = 0; i < labels.size(); ++i)
        {
            if (rootOfPoint[i] == kNone)
                continue;
            int& number = numberOfRoot[rootOfPoint[i]];
            if (number < 0)
                number = count++;
            labels[i] = number;
        }
        return labels;
    }

    CellGrid<kDim> m_grid;
    double m_eps2;
    std::uint32_t m_minPoints;
    std::vector<char> m_isCore;         ///< by slot
    std::vector<std::uint32_t> m_core;  ///< first core point (slot) of a cell, kNone when it has none
    std::vector<Point> m_low, m_high;   ///< box of a cell's core points
};

template <int kDim, class Point>
std::vector<int> runDbscan(std::span<const Point> points, double eps, int minPoints)
{
    if (!(eps > 0.0) || !std::isfinite(eps))
        throw Error(ErrorCode::BadParameter, "a cluster radius has to be positive and finite");
    if (points.empty())
        return {};
    if (points.size() >= kNone)
        throw Error(ErrorCode::BadParameter, "more than 4294967294 points can't be clustered at once");
    return Dbscan<kDim>(points, eps, minPoints).run();
}

}  // namespace

std::vector<int> dbscan(std::span<const Eigen::Vector2f> points, double eps, int minPoints)
{
    return runDbscan<2>(points, eps, minPoints);
}

std::vector<int> dbscan(std::span<const Eigen::Vector2d> points, double eps, int minPoints)
{
    return runDbscan<2>(points, eps, minPoints);
}

std::vector<int> dbscan(std::span<const Eigen::Vector3f> points, double eps, int minPoints)
{
    return runDbscan<3>(points, eps, minPoints);
}

std::vector<int> dbscan(std::span<const Eigen::Vector3d> points, double eps, int minPoints)
{
    return runDbscan<3>(points, eps, minPoints);
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/face_cells.h"

#include "core/base/parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace s2b::validation
{

namespace
{

constexpr float kCell_m = 0.10F;
constexpr int kSamples = 4;  ///< per cell and direction, for its area
constexpr std::size_t kGridChunk = 64;
constexpr float kMostCells = 1e5F;      ///< of one grid: larger faces have larger cells
constexpr float kSameNormal = 0.01F;    ///< faces whose normals differ less ...
constexpr float kSamePlane_m = 0.005F;  ///< ... and that lie so near to each other are one plane

using PlaneKey = std::array<int, 5>;

PlaneKey keyOf(const SurfaceTriangle& t)
{
    const auto whole = [](float x) { return static_cast<int>(std::lround(x)); };
    return {t.element, whole(t.normal.x() / kSameNormal), whole(t.normal.y() / kSameNormal),
            whole(t.normal.z() / kSameNormal), whole(t.normal.dot(t.a) / kSamePlane_m)};
}

float cross(const Eigen::Vector2f& a, const Eigen::Vector2f& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

std::size_t FaceCells::Grid::cellAt(const Eigen::Vector2f& at) const
{
    const Eigen::Vector2f q = (at - low).cwiseQuotient(step);
    const int column = std::clamp(static_cast<int>(std::floor(q.x())), 0, columns - 1);
    const int row = std::clamp(static_cast<int>(std::floor(q.y())), 0, rows - 1);
    return cell(column, row);
}

FaceCells::FaceCells(const std::vector<SurfaceTriangle>& triangles, const Context& context)
{
    std::map<PlaneKey, std::uint32_t> known;
    std::vector<Eigen::Vector2f> high;
    for (const SurfaceTriangle& t : triangles)
    {
        const auto [at, isNew] = known.try_emplace(keyOf(t), static_cast<std::uint32_t>(m_grids.size()));
        if (isNew)
        {
            Grid grid;
            grid.element = t.element;
            grid.normal = t.normal;
            const bool isLevel = std::abs(t.normal.z()) > 0.9F;
            grid.u = isLevel ? Eigen::Vector3f((t.b - t.a).normalized())
                             : Eigen::Vector3f(Eigen::Vector3f::UnitZ().cross(t.normal).normalized());
            grid.v = t.normal.cross(grid.u);
            grid.low.setConstant(std::numeric_limits<float>::infinity());
            m_grids.push_back(grid);
            high.emplace_back(Eigen::Vector2f::Constant(-std::numeric_limits<float>::infinity()));
        }
        m_gridOf.push_back(at->second);
        Grid& grid = m_grids[at->second];
        for (const Eigen::Vector3f& p : {t.a, t.b, t.c})
        {
            grid.low = grid.low.cwiseMin(grid.local(p));
            high[at->second] = high[at->second].cwiseMax(grid.local(p));
        }
    }
    std::size_t count = 0;
    int columns = 0;
    for (std::size_t g = 0; g < m_grids.size(); ++g)
    {
        Grid& grid = m_grids[g];
        const Eigen::Vector2f size = (high[g] - grid.low).cwiseMax(1e-4F);
        const float cell = std::max(kCell_m, std::sqrt(size.prod() / kMostCells));
        grid.columns = std::max(1, static_cast<int>(std::lround(size.x() / cell)));
        grid.rows = std::max(1, static_cast<int>(std::lround(size.y() / cell)));
        grid.step = {size.x() / static_cast<float>(grid.columns), size.y() / static_cast<float>(grid.rows)};
        grid.first = count;
        count += static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
        Cell cell0;
        cell0.element = grid.element;
        cell0.normal = grid.normal;
        m_cells.resize(count, cell0);
        for (std::size_t c = grid.first; c < count; ++c)
            m_cells[c].column = columns + static_cast<int>((c - grid.first) % static_cast<std::size_t>(grid.columns));
        columns += grid.columns;
    }
    std::vector<std::vector<std::uint32_t>> trianglesOf(m_grids.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        trianglesOf[m_gridOf[t]].push_back(t);
    parallelChunks(m_grids.size(), kGridChunk, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t g = begin; g < end; ++g)
                           for (const std::uint32_t t : trianglesOf[g])
                               addArea(triangles[t], m_grids[g]);
                   });
    for (Cell& cell : m_cells)
        if (cell.area_m2 > 0.0F)
            cell.center /= cell.area_m2;
}

std::size_t FaceCells::cellAt(std::uint32_t triangle, const Eigen::Vector3f& point) const
{
    const Grid& grid = m_grids[m_gridOf[triangle]];
    return grid.cellAt(grid.local(point));
}

/// Divides the triangle's area among the cells by samples on a lattice that all triangles of the plane share.
void FaceCells::addArea(const SurfaceTriangle& triangle, const Grid& grid)
{
    const std::array<Eigen::Vector2f, 3> corners = {grid.local(triangle.a), grid.local(triangle.b),
                                                    grid.local(triangle.c)};
    const float twice = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const float depth = triangle.normal.dot(triangle.a);
    const Eigen::Vector2f step = grid.step / static_cast<float>(kSamples);
    const auto index = [](float x) { return static_cast<int>(std::floor(x)); };

    // Of each row of samples, the first and the last one within.
    struct Run
    {
        int row, first, last;
    };
    std::vector<Run> runs;
    int samples = 0;
    const float bottom = std::min({corners[0].y(), corners[1].y(), corners[2].y()});
    const float top = std::max({corners[0].y(), corners[1].y(), corners[2].y()});
    const int lowest = std::max(0, index((bottom - grid.low.y()) / step.y()));
    const int highest = std::min(grid.rows * kSamples - 1, index((top - grid.low.y()) / step.y()));
    for (int row = lowest; row <= highest; ++row)
    {
        const float y = grid.low.y() + step.y() * (static_cast<float>(row) + 0.5F);
        if (y < bottom || y > top)
            continue;
        float low = grid.low.x();
        float high = grid.low.x() + static_cast<float>(grid.columns) * grid.step.x();
        for (std::size_t k = 0; k < 3; ++k)
        {
            const Eigen::Vector2f& from = corners[k];
            const Eigen::Vector2f edge = corners[(k + 1) % 3] - from;
            const bool isRising = (edge.y() > 0.0F) == (twice > 0.0F);  // the triangle is on its left
            if (edge.y() == 0.0F)
                continue;  // parallel to the row, which is between bottom and top
            const float x = from.x() + edge.x() * (y - from.y()) / edge.y();
            (isRising ? high : low) = isRising ? std::min(high, x) : std::max(low, x);
        }
        const int first = std::max(0, index((low - grid.low.x()) / step.x() + 0.5F));
        const int last = std::min(grid.columns * kSamples - 1, index((high - grid.low.x()) / step.x() - 0.5F));
        if (first > last)
            continue;
        runs.push_back({row, first, last});
        samples += last - first + 1;
    }
    const auto add = [&](std::size_t cell, float area, float x, float y)
    {
        m_cells[cell].area_m2 += area;
        m_cells[cell].center += area * (x * grid.u + y * grid.v + depth * grid.normal);
    };
    const float area = 0.5F * std::abs(twice);
    if (samples == 0)
    {
        const Eigen::Vector2f middle = (corners[0] + corners[1] + corners[2]) / 3.0F;
        add(grid.cellAt(middle), area, middle.x(), middle.y());
        return;
    }
    const float share = area / static_cast<float>(samples);
    for (const Run& run : runs)
        for (int from = run.first; from <= run.last;)
        {
            const int column = from / kSamples;
            const int to = std::min(run.last, (column + 1) * kSamples - 1);
            const float middle = 0.5F * static_cast<float>(from + to) + 0.5F;
            add(grid.cell(column, run.row / kSamples), share * static_cast<float>(to - from + 1),
                grid.low.x() + step.x() * middle, grid.low.y() + step.y() * (static_cast<float>(run.row) + 0.5F));
            from = to + 1;
        }
}

}  // namespace s2b::validation

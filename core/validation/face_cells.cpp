// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/face_cells.h"

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
constexpr int kSamples = 4;             ///< per cell and direction, for its area
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
    return first + static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
}

FaceCells::FaceCells(const std::vector<SurfaceTriangle>& triangles)
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
    for (std::size_t t = 0; t < triangles.size(); ++t)
        addArea(triangles[t], m_grids[m_gridOf[t]]);
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
    const Eigen::Vector2f a = grid.local(triangle.a);
    const Eigen::Vector2f b = grid.local(triangle.b);
    const Eigen::Vector2f c = grid.local(triangle.c);
    const float depth = triangle.normal.dot(triangle.a);
    const float twice = cross(b - a, c - a);
    const float side = twice < 0.0F ? -1.0F : 1.0F;
    const Eigen::Vector2f step = grid.step / static_cast<float>(kSamples);
    const auto index = [&](float x, float low, float width) { return static_cast<int>(std::floor((x - low) / width)); };
    const Eigen::Vector2f low = a.cwiseMin(b).cwiseMin(c);
    const Eigen::Vector2f high = a.cwiseMax(b).cwiseMax(c);
    std::vector<Eigen::Vector2f> samples;
    for (int i = index(low.x(), grid.low.x(), step.x()); i <= index(high.x(), grid.low.x(), step.x()); ++i)
        for (int j = index(low.y(), grid.low.y(), step.y()); j <= index(high.y(), grid.low.y(), step.y()); ++j)
        {
            const Eigen::Vector2f p = grid.low + step.cwiseProduct(Eigen::Vector2f(static_cast<float>(i) + 0.5F,
                                                                                   static_cast<float>(j) + 0.5F));
            if (side * cross(b - a, p - a) >= 0.0F && side * cross(c - b, p - b) >= 0.0F &&
                side * cross(a - c, p - c) >= 0.0F)
                samples.push_back(p);
        }
    if (samples.empty())
        samples.emplace_back((a + b + c) / 3.0F);
    const float share = 0.5F * std::abs(twice) / static_cast<float>(samples.size());
    for (const Eigen::Vector2f& p : samples)
    {
        Cell& cell = m_cells[grid.cellAt(p)];
        cell.area_m2 += share;
        cell.center += share * (p.x() * grid.u + p.y() * grid.v + depth * grid.normal);
    }
}

}  // namespace s2b::validation

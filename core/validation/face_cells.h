// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/validation/surface_search.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace s2b::validation
{

/// The surfaces of elements in cells of 10 cm, to say how much of them has points.
///
/// Triangles of an element in one plane share a grid, so that the way a mesh is divided does not matter. Grids are
/// fitted to their faces: a rectangle has whole cells only.
class FaceCells
{
public:
    /// The cells do not depend on the number of threads.
    FaceCells(const std::vector<SurfaceTriangle>& triangles, const Context& context);

    struct Cell
    {
        int element = -1;
        int column = 0;  ///< cells above one another in an upright face have the same one
        float area_m2 = 0.0F;
        Eigen::Vector3f center = Eigen::Vector3f::Zero();  ///< of the surface within
        Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    };
    [[nodiscard]] const std::vector<Cell>& cells() const { return m_cells; }
    /// The cell at a point of a triangle.
    [[nodiscard]] std::size_t cellAt(std::uint32_t triangle, const Eigen::Vector3f& point) const;

private:
    struct Grid
    {
        int element = -1;
        Eigen::Vector3f normal = Eigen::Vector3f::Zero();
        Eigen::Vector3f u = Eigen::Vector3f::Zero();
        Eigen::Vector3f v = Eigen::Vector3f::Zero();
        Eigen::Vector2f low = Eigen::Vector2f::Zero();
        Eigen::Vector2f step = Eigen::Vector2f::Ones();
        int columns = 1;
        int rows = 1;
        std::size_t first = 0;  ///< cell

        [[nodiscard]] Eigen::Vector2f local(const Eigen::Vector3f& p) const { return {u.dot(p), v.dot(p)}; }
        [[nodiscard]] std::size_t cell(int column, int row) const
        {
            return first + static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                   static_cast<std::size_t>(column);
        }
        [[nodiscard]] std::size_t cellAt(const Eigen::Vector2f& local) const;
    };
    void addArea(const SurfaceTriangle& triangle, const Grid& grid);

    std::vector<Grid> m_grids;
    std::vector<std::uint32_t> m_gridOf;  ///< by triangle
    std::vector<Cell> m_cells;
};

}  // namespace s2b::validation

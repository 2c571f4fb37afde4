// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"
#include "core/model/building.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace s2b
{

/// Square pixels over the plan of the whole building, the same for all of its storeys.
struct PlanGrid
{
    Eigen::Vector2d low = Eigen::Vector2d::Zero();  ///< lower-left corner of the first pixel
    double pixel_m = 0.05;
    int width = 0, height = 0;

    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
    [[nodiscard]] std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    /// Index of the pixel that p lies in; size() when it is outside.
    [[nodiscard]] std::size_t find(const Eigen::Vector2d& p) const;
    [[nodiscard]] int reach(double metres) const;  ///< in pixels, at least 1
};

/// Covers all cells with a rim of 1 m. Pixels are 5 cm, larger for a sparse cloud or a large site.
[[nodiscard]] PlanGrid planGridOf(const SurfaceCells& cells);

/// One byte a pixel of a PlanGrid; not 0: set.
using PlanBits = std::vector<std::uint8_t>;

/// What of a storey was seen in each pixel, as a sum of these.
enum PlanLayer : std::uint8_t
{
    kFloorLayer = 1,    ///< the storey's floor
    kCeilingLayer = 2,  ///< something over people's heads, up to the storey's ceiling
    kCoverLayer = 4,    ///< something over people's heads at any height: indoors, also in a stairwell
    kBetweenLayer = 8   ///< something level between floor and head: steps, furniture
};

/// @param cells  building frame
[[nodiscard]] PlanBits rasterOf(const SurfaceCells& cells, const Level& level, const PlanGrid& grid);

/// Visits the pixels whose centres are inside, row by row: visit(index). Cost: O(rows * edges + pixels).
void forEachPixel(const Polygon& polygon, const PlanGrid& grid, const std::function<void(std::size_t)>& visit);

/// Pixels within `reach` pixels (a square) of a set one; and those farther than that from every unset one.
[[nodiscard]] PlanBits dilated(const PlanBits& bits, const PlanGrid& grid, int reach);
[[nodiscard]] PlanBits eroded(const PlanBits& bits, const PlanGrid& grid, int reach);

}  // namespace s2b

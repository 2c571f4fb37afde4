// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"
#include "core/model/building.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace s2b
{

/// Square pixels over the plan of the whole building, the same for all of its storeys.
struct PlanGrid
{
    Eigen::Vector2d low = Eigen::Vector2d::Zero();  ///< lower-left corner of the first pixel
    double pixel_m = 0.05;
    int width = 0, height = 0;

    [[nodiscard]] std::size_t size() const
    {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    [[nodiscard]] std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    /// Index of the pixel that p lies in; size() when it is outside.
    [[nodiscard]] std::size_t find(const Eigen::Vector2d& p) const;
    [[nodiscard]] int reach(double metres) const;  ///< in pixels, at least 1
};

/// A cell that does not stand upright, as far as floors and ceilings are concerned.
struct PlanCell
{
    std::uint32_t pixel = 0;
    float z = 0;
    std::uint32_t count = 0;  ///< points
    float upward = 0;         ///< |normal.z|
    Label label = Label::Unassigned;
    bool isSmooth = false;  ///< part of a plane, not of a heap
};

/// The cells of a building that do not stand upright, by pixel.
struct PlanCells
{
    PlanGrid grid;
    double size_m = 0.0;  ///< of a cell
    bool hasLabels = false;
    std::vector<PlanCell> cells;
};

/// The grid covers all cells with a rim of 1 m. Pixels are 5 cm, larger for a sparse cloud or a large site.
/// @param cells  building frame
[[nodiscard]] PlanCells planCellsOf(const SurfaceCells& cells);

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

[[nodiscard]] PlanBits rasterOf(const PlanCells& cells, const Level& level);

/// Lowest height of what slopes overhead in each pixel, NaN where there is nothing; empty when the storey's ceiling is
/// level.
[[nodiscard]] std::vector<float> slopesOf(const PlanCells& cells, const Level& level);

/// Pixels side by side, from index begin up to end.
struct PixelSpan
{
    std::size_t begin = 0, end = 0;
};

/// The pixels whose centres are inside, row by row. Cost: O(rows * edges).
[[nodiscard]] std::vector<PixelSpan> pixelsOf(const Polygon& polygon, const PlanGrid& grid);

/// Calls visit(index) for each of them.
template <typename Visit>
void forEachPixel(const Polygon& polygon, const PlanGrid& grid, Visit&& visit)
{
    for (const PixelSpan& span : pixelsOf(polygon, grid))
        for (std::size_t i = span.begin; i < span.end; ++i)
            visit(i);
}

/// Pixels within `reach` pixels (a square) of a set one; and those farther than that from every unset one.
[[nodiscard]] PlanBits dilated(const PlanBits& bits, const PlanGrid& grid, int reach);
[[nodiscard]] PlanBits eroded(const PlanBits& bits, const PlanGrid& grid, int reach);

}  // namespace s2b

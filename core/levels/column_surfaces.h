// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/surface_cells.h"

#include <cstdint>
#include <vector>

namespace s2b
{

inline constexpr double kMergeZ_m = 0.06;  ///< surfaces closer than this in one column are one

/// A horizontal (or, looking up, sloped) surface in one plan column.
struct ColumnSurface
{
    std::int32_t x = 0, y = 0;
    double z = 0;
    bool isLevel = false;     ///< horizontal
    bool maybeFloor = false;  ///< its label does not say otherwise
    bool maybeCeiling = false;
};

[[nodiscard]] inline bool sameColumn(const ColumnSurface& a, const ColumnSurface& b)
{
    return a.x == b.x && a.y == b.y;
}

/// Edge of the plan columns in which floors meet their ceilings: wide enough for a few cells of each surface, in sparse
/// clouds too.
[[nodiscard]] double columnEdge(const SurfaceCells& cells);

/// What lies above each other in each plan column, from below; sorted by x, y and z. Stray cells are no surface.
/// Cost: one sort of the level and sloped cells.
[[nodiscard]] std::vector<ColumnSurface> surfacesByColumn(const SurfaceCells& cells, const Context& context);

}  // namespace s2b

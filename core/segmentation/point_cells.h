// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/point_cloud.h"
#include "core/cloud/surface_cells.h"

#include <array>
#include <cstdint>
#include <vector>

namespace s2b
{

/// Which cell each point lies in, to carry classes from cells to points and colours the other way.
struct PointCells
{
    static constexpr std::uint32_t kNone = 0xffffffff;
    std::vector<std::uint32_t> cellOfPoint;  ///< by point; kNone where there is no cell in it or beside it
};

/// A point without a cell of its own takes the nearest of those around it.
/// @param cells  made of this cloud and not turned since.
/// Cost: a look-up a point; 4 bytes a point and 24 a cell.
[[nodiscard]] PointCells findPointCells(const CloudView& cloud, const SurfaceCells& cells, const Context& context);

/// Mean red, green, blue by cell. @pre cloud.rgb.
[[nodiscard]] std::vector<std::array<std::uint8_t, 3>> cellColours(const CloudView& cloud, const PointCells& points,
                                                                   std::size_t cellCount, const Context& context);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"
#include "core/segmentation/segment.h"

#include <cstdint>
#include <vector>

namespace s2b
{

/// What a model sees at once.
struct SegmentPass
{
    double floor_m = 0.0, ceiling_m = 0.0;  ///< of the storey
    std::vector<std::uint32_t> cells;       ///< the pass's own, then those around it
    std::size_t inside = 0;                 ///< how many are its own
};

/// Cuts the cells into storeys, and these into tiles where they are large. Every cell is inside exactly one pass.
///
/// A cell belongs to the storey whose floor it is above, up to the middle of the next slab; what is below all belongs
/// to the lowest. Without any of the levels (from the lowest to the highest) all cells are one storey between their own
/// lowest and highest surfaces.
[[nodiscard]] std::vector<SegmentPass> planPasses(const SurfaceCells& cells, std::vector<Level> levels,
                                                  const SegmentParams& params, const Context& context);

}  // namespace s2b

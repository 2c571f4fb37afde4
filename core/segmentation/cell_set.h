// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/surface_cells.h"

#include <array>
#include <cstdint>
#include <vector>

namespace s2b
{

/// The cells that a model sees at once: a storey, or a tile of a large one with some metres around it.
///
/// Building frame: x and y along the dominant directions, z up.
struct CellSet
{
    double size_m = 0.0;     ///< edge of a cell: the model's, or larger in a sparser cloud
    double spacing_m = 0.0;  ///< typical point spacing of the cloud
    double floor_m = 0.0;    ///< height of the storey's floor
    double ceiling_m = 0.0;  ///< of its ceiling (highest level one), or of the walls' tops
    std::vector<SurfaceCell> cells;
    std::vector<std::array<std::uint8_t, 3>> colours;  ///< red, green, blue by cell; empty without colours
};

}  // namespace s2b

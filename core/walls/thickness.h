// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/cell_index.h"
#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"
#include "core/walls/parallel_planes.h"

#include <vector>

namespace s2b
{

/// Gives bodies with one face seen their thickness: from a collinear wall that shares the face, from the reveals of
/// their openings (what was seen behind the face: jambs, sills, frames), from the building's other walls of the kind,
/// and only last from the default (D3.6, 1.2). The unseen side stays marked as not seen.
void settleThickness(std::vector<WallBody>& bodies, const SurfaceCells& cells, const CellIndex& index,
                     const Level& level, const PlanMask& mask, const WallParams& params);

}  // namespace s2b

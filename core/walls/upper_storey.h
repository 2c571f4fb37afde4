// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/cell_index.h"
#include "core/levels/levels.h"
#include "core/model/building.h"

#include <optional>
#include <vector>

namespace s2b
{

/// Height of a storey that shows in its walls alone: walls that begin more than a room's height above the level's
/// floor, over open space (a gallery, a tower over a hall). Nothing when there are none of together at least 2 m.
/// Where lower walls beside them end at about that height, their tops give it.
[[nodiscard]] std::optional<double> upperStoreyBase(const std::vector<Wall>& walls, const Level& level,
                                                    const CellIndex& index, double minimumRoomHeight_m);

/// Divides the walls at that height (D3.6, 3.6: elements are separated by levels): what is above goes to `upper`.
/// Walls that hardly reach above it stay whole. New walls are appended; junctions are repeated for pairs that both go
/// on.
void divideWalls(std::vector<Wall>& walls, std::vector<Junction>& junctions, double base_m, ElementId upper,
                 std::uint32_t& nextId);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/slabs/slabs.h"

#include <vector>

namespace s2b
{

/// What the slab under a storey carries: its rooms and the walls around them, without holes but for courtyards.
/// @return valid polygons of at least `minimumArea_m2`, sorted.
[[nodiscard]] std::vector<Polygon> slabOutlines(const RoomPlan& plan, const SlabParams& params);

/// Holes in the slab between two storeys (see findSlabs()), within `outlines`.
/// @param undersides  pixels where the ceiling of the storey below was seen
[[nodiscard]] std::vector<Polygon> slabHoles(const RoomPlan& above, const RoomPlan& below, const PlanBits& undersides,
                                             const SlabParams& params);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/levels/levels.h"
#include "core/walls/parallel_planes.h"

#include <vector>

namespace s2b
{

/// Gives each body the heights that its faces really reach, and splits it where they change (a lower roof beside a
/// higher one). A top near the storey's ceiling is the ceiling; a bottom well above the floor counts only where the
/// floor was seen to run through below (furniture hides the lower part of many walls).
[[nodiscard]] std::vector<WallBody> settleHeights(std::vector<WallBody> bodies, const std::vector<Face>& faces,
                                                  const Level& level, const PlanMask& mask, const WallParams& params);

}  // namespace s2b

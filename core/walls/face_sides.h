// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/walls/face.h"
#include "core/walls/plan_mask.h"

#include <vector>

namespace s2b
{

/// Sides of all faces (Face::side, isBesideRoom).
///
/// A face was seen from the side that its scanner stood on, where that is known. Else floor or ceiling right beside it
/// say where the room is; where neither does, free space further away on one side only is seen across the wall's own
/// body. A face without any of that (a stair, a shaft) follows a collinear one, at most `sameOffset_m` off it.
void findSides(std::vector<Face>& faces, const PlanMask& mask, double sameOffset_m);

}  // namespace s2b

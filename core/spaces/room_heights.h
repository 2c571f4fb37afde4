// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spaces/room_plan.h"

namespace s2b
{

/// Measures the rooms' own floors and ceilings (they differ from room to room). A room whose ceiling is not level, or
/// was not seen, keeps the storey's.
void measureHeights(const PlanCells& cells, RoomPlan& plan);

}  // namespace s2b

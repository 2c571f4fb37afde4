// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"

namespace s2b
{

/// Height of a wall's upper edge above the building frame's zero.
/// @param s_m  along the axis from its start; beyond the ends of a sloped edge its end's height counts
[[nodiscard]] double topAt(const Wall& wall, double s_m);

}  // namespace s2b

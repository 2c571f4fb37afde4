// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/levels/levels.h"

namespace s2b
{

/// The levels of given storeys (corrected by hand, or of an earlier run): floor and ceiling are the storey's, the rest
/// is what the cloud says about them.
/// @param storeys  ascending
/// @param found    by findLevels()
[[nodiscard]] std::vector<Level> levelsOf(const std::vector<Storey>& storeys, const std::vector<Level>& found);

}  // namespace s2b

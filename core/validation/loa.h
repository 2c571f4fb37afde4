// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/validation/validation.h"

namespace s2b::validation
{

/// The best band whose limit the deviation keeps.
/// @param deviation_m  that 95 % of the points keep.
[[nodiscard]] LoaBand bandOf(double deviation_m, const ValidationParams& params);

/// Whether it keeps the band that is asked for (ValidationParams::tolerance).
[[nodiscard]] bool keepsTolerance(double deviation_m, const ValidationParams& params);

}  // namespace s2b::validation

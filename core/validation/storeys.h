// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/validation/validation.h"

#include <vector>

namespace s2b::validation
{

/// The nearest of the result's storeys for each surveyed one of the truth, in its order. One that has none within half
/// a storey (1.2 m) is missed; its error is the distance all the same, infinite without any storey.
[[nodiscard]] std::vector<StoreyError> compareStoreys(const Bim& truth, const Bim& result);

/// Storeys of the result beyond as many as the truth's surveyed ones.
[[nodiscard]] int extraStoreys(const Bim& truth, const Bim& result);

}  // namespace s2b::validation

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/validation/validation.h"

namespace s2b::validation
{

/// Refuses models that can't be compared: two on different places, or one in another unit than the other.
/// @param cloud  may be null.
/// @throws Error{BadFile} that names the files and the distance between them, or the ratio of their sizes.
void checkOverlap(const Bim& truth, const Bim& result, const CloudView* cloud);

}  // namespace s2b::validation

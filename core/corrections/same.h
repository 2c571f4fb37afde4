// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether two states of an element are the same in every value.
#pragma once

#include "core/model/building.h"

namespace s2b
{

[[nodiscard]] bool isSame(const Storey& a, const Storey& b);
[[nodiscard]] bool isSame(const Wall& a, const Wall& b);
[[nodiscard]] bool isSame(const Opening& a, const Opening& b);
[[nodiscard]] bool isSame(const Column& a, const Column& b);
[[nodiscard]] bool isSame(const Slab& a, const Slab& b);
[[nodiscard]] bool isSame(const Space& a, const Space& b);
[[nodiscard]] bool isSame(const Junction& a, const Junction& b);
[[nodiscard]] bool isSame(const Diagnostic& a, const Diagnostic& b);

}  // namespace s2b

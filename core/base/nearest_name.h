// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace s2b
{

/// The candidate with the smallest edit distance to `name` (insert, remove, replace one character; case ignored), for
/// error messages that name what was probably meant. The first one of equally near ones; empty without candidates.
/// Cost: O(candidates * lengths^2).
[[nodiscard]] std::string_view nearestName(std::string_view name, std::span<const std::string_view> candidates);

/// "a, b, c".
[[nodiscard]] std::string joinNames(std::span<const std::string_view> names);

}  // namespace s2b

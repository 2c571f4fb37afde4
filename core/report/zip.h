// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace s2b::report
{

/// A ZIP archive of these files (path, content) in this order. Every entry bears the same date, 1980-01-01 (the
/// format's earliest): the same content gives the same bytes.
/// @throws Error{Internal}
[[nodiscard]] std::string makeZip(const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace s2b::report

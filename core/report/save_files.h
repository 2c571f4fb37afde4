// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace s2b::report
{

/// Puts all these files (name, content) into a folder, which is made if need be: first each one beside its place, then,
/// once all of them are on the disk, each is renamed. A failure before that leaves the folder as it was, and none where
/// there was none.
/// @throws Error{CannotWrite} that names the file and what the system said.
void saveFiles(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace s2b::report

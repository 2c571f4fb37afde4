// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace s2b
{

/// Puts `content` at `path`: all of it, or nothing. It is written to a file beside, flushed to the disk and renamed, so
/// an existing file stays as it was on any error; a symbolic link's target is replaced, not the link. A device is
/// written to as it is.
/// @throws Error{CannotWrite} that names the path and what the system said; nothing is left then.
void saveFile(const std::string& path, std::string_view content);

/// Puts all these files (name, content) into a folder, which is made if need be: first each one beside its place, then,
/// once all of them are on the disk, each is renamed. A failure before that leaves the folder as it was, and none where
/// there was none.
/// @throws Error{CannotWrite} as saveFile, of the file that it was.
void saveFiles(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace s2b::ifc
{

/// Puts `content` at `path`: all of it, or nothing. It is written to a file beside, flushed to the disk and renamed, so
/// an existing file stays as it was on any error; a symbolic link's target is replaced, not the link. A device is
/// written to as it is.
/// @throws Error{CannotWrite} that names the path and what the system said; nothing is left then.
void saveFile(const std::string& path, std::string_view content);

}  // namespace s2b::ifc

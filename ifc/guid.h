// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace s2b::ifc
{

/// The IFC GlobalId (22 characters) of a name: a version 5 UUID (RFC 9562) of `name` within `nameSpace`, compressed as
/// buildingSMART defines it. Equal names give equal ids on every machine.
[[nodiscard]] std::string globalId(std::string_view nameSpace, std::string_view name);

}  // namespace s2b::ifc

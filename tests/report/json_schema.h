// SPDX-License-Identifier: GPL-3.0-or-later
/// The part of JSON Schema (draft 2020-12) that our schema is written in.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace s2b::report::testing
{

/// What a value does wrong, each with its place; empty when it fits. A keyword that is not known here is a fault too,
/// so that no rule of the schema goes unchecked.
[[nodiscard]] std::vector<std::string> faults(const nlohmann::json& value, const nlohmann::json& schema);

}  // namespace s2b::report::testing

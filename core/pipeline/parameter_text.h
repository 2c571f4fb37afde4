// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pipeline/parameters.h"

#include <string>

namespace s2b
{

/// The shortest decimal text that reads back to the same value, whatever the locale.
[[nodiscard]] std::string numberText(double value);

/// "0.05 to 3", "true or false".
[[nodiscard]] std::string rangeText(const ParameterInfo& info);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
/// The parameters of a validation, in a table as those of the reconstruction (core/pipeline/parameters.h): they are no
/// part of a reconstruction, its dialog or its record in the IFC.
#pragma once

#include "core/validation/validation.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace s2b::validation
{

struct ParameterRow
{
    std::string name;  ///< "validation.tolerance"
    std::string unit;  ///< "m", "1"
    double minimum = 0.0;
    double maximum = 0.0;
    std::string help;    ///< one sentence
    std::string source;  ///< where the default comes from
    std::variant<double* (*)(ValidationParams&), int* (*)(ValidationParams&)> member;
};

[[nodiscard]] const std::vector<ParameterRow>& parameterRows();

/// "validation.tolerance=20", upper and lower case alike.
/// @throws Error{BadParameter} for an unknown name (naming the nearest), text that is no number, a value out of range.
void setParameter(ValidationParams& params, std::string_view assignment);

/// @throws Error{BadParameter} for a value out of its range, a tolerance that is no LOA, or limits that do not fall
/// from LOA10 to LOA50.
void checkParams(const ValidationParams& params);

/// The table as the Markdown in docs/validation.md.
[[nodiscard]] std::string parameterTableText();

}  // namespace s2b::validation

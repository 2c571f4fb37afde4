// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/validation/bim.h"

#include <string>

namespace s2b::validation
{

/// Reads the truth that a simulated survey writes beside its scan (gt.json): elements with boxes, axes and outlines,
/// and what the survey saw of each (BimElement::visibility).
///
/// An element counts when at least a tenth of its surface and 200 points of it were seen; a wall, when 30 % of one of
/// its sides and 200 points were; a column, when 15 % of its surface was; a door or window, when 200 points of its wall
/// lie around it. Elements of storeys without a station don't count, nor do walls and columns of which less than 0.3 m
/// stand between the storey's floor and ceiling.
/// @throws Error{BadFile} for a file that is not such a truth.
[[nodiscard]] Bim readSurveyTruth(const std::string& path);

/// Whether a JSON file has the parts of such a truth. @throws Error{BadFile} for a file that is not JSON.
[[nodiscard]] bool isSurveyTruth(const std::string& path);

}  // namespace s2b::validation

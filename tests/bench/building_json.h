// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"

#include <string>

namespace s2b
{

/// The building as JSON in world coordinates, for plots: plan outlines, heights, provenance.
[[nodiscard]] std::string buildingJson(const Building& building);

}  // namespace s2b

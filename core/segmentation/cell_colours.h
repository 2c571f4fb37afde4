// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/point_cloud.h"

#include <array>
#include <cstdint>
#include <vector>

namespace s2b
{

/// Mean red, green, blue by cell; black where no point lies in it. @pre cloud.rgb.
/// @param cellOfPoint  by point, kNoCell where there is none (buildSurfaceCells)
[[nodiscard]] std::vector<std::array<std::uint8_t, 3>> cellColours(const CloudView& cloud,
                                                                   const std::vector<std::uint32_t>& cellOfPoint,
                                                                   std::size_t cellCount, const Context& context);

}  // namespace s2b

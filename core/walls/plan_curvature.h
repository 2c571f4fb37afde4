// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/walls/axis_sort.h"

#include <cstdint>
#include <vector>

namespace s2b
{

/// A storey's vertical surface (labelled wall, where there are labels) of all directions, seen from the top: pixels as
/// large as a cell, with at least 0.2 m of surface above each other. Sorted by place.
[[nodiscard]] std::vector<PlanPixel> verticalPixels(const SurfaceCells& cells, const Level& level,
                                                    const Context& context);

/// The pixels about which the surface is curved as a wall may be (WallParams::minimumArcRadius_m to
/// maximumArcRadius_m), by a parabola through what lies on both sides of them. Some lie about blunt corners.
/// Cost: about 100 neighbours a pixel.
[[nodiscard]] std::vector<std::uint32_t> curvedPixels(const std::vector<PlanPixel>& pixels, double cell_m,
                                                      const WallParams& params, const Context& context);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/segmentation/cell_set.h"

#include <array>
#include <cstdint>
#include <vector>

namespace s2b
{

/// How an upright cell lies to the planes about it. Leaves and frames of doors and windows stand back or proud of the
/// wall's face by some centimetres and end at a height; furniture ends below the ceiling.
struct WallPlane
{
    float offset = 0.0f;         ///< |distance| from the strongest parallel plane within 0.3 m, in 0.1 m
    float strength = 0.0f;       ///< that plane's area relative to the window it is looked for in (0 to about 1)
    float own = 0.0f;            ///< the same of the plane that the cell itself lies in
    float upperOffset = 0.0f;    ///< offset, of the planes higher than 2.15 m above the floor alone
    float upperStrength = 0.0f;  ///< strength, of the same
    float runUp = 0.0f;          ///< how far the surface goes on without a gap above the cell, in metres
    float runDown = 0.0f;        ///< the same below
    float top = 0.0f;            ///< the surface's highest point about the cell: below the ceiling, in metres
    float bottom = 0.0f;         ///< its lowest one: above the floor, in metres
};

/// One for each cell; zeros for cells that are not upright. Planes are those square to the building's frame: surfaces
/// at an angle to it find weaker ones.
///
/// The planes' strength is the area of upright cells that face the same axis, in strips of 2 cm by 1.4 m in plan.
/// Cost: O(cells + plan); memory: 24 bytes per 2 cm x 20 cm of the plan. Deterministic for any number of threads.
[[nodiscard]] std::vector<WallPlane> findWallPlanes(const CellSet& set, const Context& context);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/surface_cells.h"
#include "core/model/building.h"

namespace s2b
{

struct FrameParams
{
    double verticalTolerance = 0.15;  ///< largest |n_z| of a vertical surface
    bool operator==(const FrameParams&) const = default;
};

/// Yaw of the building's dominant directions in (-pi/4, pi/4] [rad] (D3.6, 1.2 asks for it by hand or by PCA).
///
/// From the normals of vertical surfaces folded to a quarter turn, then refined on the largest planes' own points.
/// @return 0 when there is no vertical surface.
[[nodiscard]] double findDominantYaw(const SurfaceCells& cells, const FrameParams& params, const Context& context = {});

/// Turns cells by -yaw about the vertical through the origin.
void rotateCells(SurfaceCells& cells, double yaw_rad);

}  // namespace s2b

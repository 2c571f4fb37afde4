// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/rasters.h"

namespace s2b::report
{

/// A picture of one element that is out of tolerance: its place in plan with truth, result and points, and the
/// deviations of both faces when it is a wall.
/// @param wall  its faces, may be null
[[nodiscard]] Image drawSnapshot(const Scene& scene, const Row& row, const StoreyRasters& rasters,
                                 const WallFaces* wall);

}  // namespace s2b::report

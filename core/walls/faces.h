// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/walls/axis_sort.h"
#include "core/walls/face.h"
#include "core/walls/plan_mask.h"

#include <vector>

namespace s2b
{

/// Fits the planes of each instance (D3.6, 3.4.2 and 3.4.3) and gathers what was seen of them.
///
/// Instances are DBSCAN clusters of an axis set's plan pixels. Within one, planes are found by consensus constrained to
/// vertical planes near the set's direction (D3.6: HYSAC): the offset with the most support first, then its own
/// direction by least squares, growing along the line until nothing changes. The offset is a robust mean of all its
/// points, so noise widens the spread and not the wall.
///
/// @return faces in the order of sets, clusters and support; `side` says where free space is.
[[nodiscard]] std::vector<Face> findFaces(const SurfaceCells& cells, const Level& level, const PlanMask& mask,
                                          const WallParams& params, const Context& context);

}  // namespace s2b

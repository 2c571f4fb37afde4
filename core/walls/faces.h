// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/walls/face.h"
#include "core/walls/plan_mask.h"
#include "core/walls/walls.h"

#include <vector>

namespace s2b
{

/// Finds the faces of a storey's walls: the planes of its vertical surfaces (face_lines.h), what was seen of each,
/// which of them are walls' (labels and shape weigh each other), and which side is free (face_sides.h).
///
/// The offset is a robust mean of all points on the plane, so noise widens the spread and not the wall.
/// @return faces in the order of sets, clusters and support; `side` says where free space is.
[[nodiscard]] std::vector<Face> findFaces(const SurfaceCells& cells, const Level& level, const PlanMask& mask,
                                          const WallParams& params, const Context& context);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"
#include "core/walls/face.h"
#include "core/walls/parallel_planes.h"

#include <vector>

namespace s2b
{

/// What the faces' points say of a wall. The left face (seen from start to end) is the body's high one.
/// @param cell_m  edge of the surface cells
[[nodiscard]] Evidence evidenceOf(const WallBody& body, const std::vector<Face>& faces, double cell_m);

/// [0, 1] Share of the body's better seen side that is a surface. A place that few of the cells that it has room for
/// cover counts in part: stray points (mixed pixels behind an edge, reflections) lie thinly on planes of their own.
[[nodiscard]] double seenShare(const WallBody& body, const std::vector<Face>& faces, double cell_m);

}  // namespace s2b

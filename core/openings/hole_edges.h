// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/openings/wall_view.h"

#include <optional>

namespace s2b
{

/// Plane of the jamb near s: surface inside the body that looks along the wall, between two heights.
[[nodiscard]] std::optional<double> jambNear(const WallView& view, double s, double bottom, double top, double reach);

/// Height of a level surface inside the body near z (a head's soffit, a sill), between two places along the wall.
[[nodiscard]] std::optional<double> headNear(const WallView& view, double begin, double end, double z);

/// Height of a sill between two places along the wall: a level surface inside the body, above the floor and within
/// `reach` of it, over most of the width. A doorway has none.
[[nodiscard]] std::optional<double> sillAbove(const WallView& view, double begin, double end, double reach);

/// Where the faces end towards the hole: the outermost of their points near s; s itself when there are too few.
[[nodiscard]] double faceEdge(const WallView& view, double s, bool holeIsRight, double bottom, double top);

/// The hole grown to where the wall's faces end about it: a frame or jamb that a model takes for wall is part of the
/// hole. Only outwards, a quarter of a metre at most, and not where something stands in front of the face.
[[nodiscard]] Hole grownToFaces(const WallView& view, const Hole& hole);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/walls/arcs.h"
#include "core/walls/plan_mask.h"
#include "core/walls/walls.h"

#include <vector>

namespace s2b
{

/// Removes straight bodies that lie for the most part within a curved wall: frames and panes of its openings.
void dropWithinArcs(std::vector<WallBody>& bodies, const ArcScenes& arcs);

/// Takes a straight wall out of the unrolled plan that it was found in: an arc, its ends on the same circle.
void bend(Wall& wall, const Unrolling& unrolling);

/// Joins the curved walls with the others (those with a bulge are the curved ones), by the rules of straight walls:
/// axes are drawn to one common point, bodies are cut so that they touch (docs/conventions.md). Beyond those:
/// - A straight wall that goes on along an arc's tangent meets it at the foot of the arc's centre on its axis, and both
///   bodies end there.
/// - Two arcs whose ends lie together (halves of a ring, an S) meet between these ends.
/// - A straight wall that runs through an arc is split there.
/// An arc keeps the middle of its axis; its ends lie exactly on the common points.
void connectArcs(std::vector<Wall>& walls, std::vector<Junction>& junctions, const PlanMask& mask,
                 std::uint32_t& nextId, const WallParams& params);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"

#include <set>

namespace s2b
{

inline constexpr double kJoinReach_m = 0.6;  ///< an end this near to another wall is drawn to it

/// Moves a wall's start along its axis by `delta_m` (> 0: shorter), so that what lies on it stays where it is.
void moveStart(Building& building, Wall& wall, double delta_m);
/// Moves its end along its axis by `delta_m` (> 0: longer).
void moveEnd(Wall& wall, double delta_m);

/// Draws the walls that meet one of `moved` together again: axes to their common point, bodies to the faces
/// (docs/conventions.md). A junction whose walls no longer meet is removed, with a Diagnostic "JunctionOpened".
void settleJunctions(Building& building, const std::set<ElementId>& moved);

/// Settles the junctions of a wall that went back to its reconstructed state; neighbours that are then where they were
/// found are as they were found again, to the last digit.
void restoreNeighbours(Building& building, const Building& found, ElementId id);

/// Joins the free ends of a wall to the walls of its storey within kJoinReach_m, and theirs to it.
void joinEnds(Building& building, ElementId id);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spaces/room_plan.h"

#include <cstdint>
#include <vector>

namespace s2b
{

struct SpaceResult
{
    std::vector<Space> spaces;
    std::vector<Diagnostic> diagnostics;
};

/// The spaces of one storey: its rooms, named "<storey>.<number>" by their outlines' order.
///
/// Conventions:
/// - The outline lies on the faces of the walls, as they are in the model; doors, windows and openings do not interrupt
///   it. Columns stand within a space and are not cut out of it; a wall that stands free in a room is.
/// - Rooms are what was seen: a share of `minimumSeen` of the floor or the ceiling at least, and something overhead
/// where
///   the survey has ceilings at all. What walls enclose unseen (shafts) is no space, nor is a courtyard.
/// - A room that walls leave open is closed by the outline of its ceiling where walls make up `minimumWallShare` of the
///   outline, and a diagnostic says so; else there is only the diagnostic.
/// - The height is measured floor to ceiling in the room itself; of a sloped or unseen ceiling it is the storey's,
/// assumed.
/// @param storeyNumber  0 for the lowest
/// @param nextId        the next free ElementId value; advanced
[[nodiscard]] SpaceResult findSpaces(const RoomPlan& plan, ElementId storey, std::size_t storeyNumber,
                                     std::uint32_t& nextId, const SpaceParams& params);

}  // namespace s2b

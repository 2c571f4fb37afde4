// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/spaces/outline.h"
#include "core/spaces/plan_raster.h"

#include <vector>

namespace s2b
{

/// Rooms from the wall plan (spaces, and the outlines of slabs).
struct SpaceParams
{
    double closeGap_m = 0.20;          ///< gaps between walls up to this wide are closed
    double minimumWallHeight_m = 1.8;  ///< lower walls do not divide rooms
    double minimumArea_m2 = 0.5;
    double minimumSeen = 0.3;       ///< share of a room whose floor or ceiling was seen
    double minimumWallShare = 0.5;  ///< of a room's outline, or roof that comes down, where walls leave it open
    bool operator==(const SpaceParams&) const = default;
};

enum class RoomKind
{
    Room,       ///< enclosed by walls, or nearly so
    Open,       ///< seen, but with too few walls around to say where it ends
    Uncovered,  ///< enclosed, with nothing overhead: a courtyard
    Unseen      ///< enclosed, and not seen: a shaft, or a room that was not scanned
};

/// A piece of the plan between wall faces.
struct Room
{
    Polygon outline;  ///< along the walls' faces
    Polygon core;     ///< the outline, wideningHalf_m narrower where walls bound it
    RoomKind kind = RoomKind::Room;
    double wallShare = 1.0;  ///< of the outline
    double roofShare = 0.0;  ///< of the outline, where a roof comes down instead of a wall
    double floor_m = 0.0;
    double ceiling_m = 0.0;
    bool ceilingSeen = false;  ///< level, over a third of the room at least
    double ceilingRms_m = 0.0;
};

/// One storey's plan.
struct RoomPlan
{
    Level level;
    std::vector<Wall> walls;       ///< of the storey
    std::vector<bool> isDividing;  ///< of these, those that divide rooms
    PlanGrid grid;
    PlanBits seen;                ///< rasterOf()
    std::vector<float> slopes;    ///< slopesOf()
    std::vector<Room> rooms;      ///< sorted by outline
    bool hasCeiling = false;      ///< ceilings were scanned at all
    double wideningHalf_m = 0.0;  ///< by which Room::core is narrower than the outline, on the side of walls
};

/// A wall's outline, wider and longer by `by_m` on all sides.
[[nodiscard]] Polygon widened(const Wall& wall, double by_m);

/// Directions of the walls and of the building's axes in [0, pi), without repetition.
[[nodiscard]] std::vector<double> directionsOf(const std::vector<Wall>& walls);

/// Finds what the walls enclose.
///
/// The free plan is what remains of it when the bodies of the walls are taken away, doors and openings counted as
/// solid; its bounded faces are the rooms. Gaps between walls up to `closeGap_m` are closed: the walls are widened by
/// half of it, and the faces widened back, so that the outlines lie exactly on the walls' faces. Where walls leave a
/// room open (a curtain wall, a wall that was not found), the outline of the ceiling that was seen closes it, with
/// straight sides along the walls' directions. Walls lower than `minimumWallHeight_m` divide rooms where a pitched roof
/// meets them.
///
/// @param walls  of this storey, with their ids
/// Cost: O(cells + pixels), and exact arithmetic for the walls' edges and their crossings.
[[nodiscard]] RoomPlan planRooms(const PlanCells& cells, const Level& level, std::vector<Wall> walls,
                                 const SpaceParams& params, const Context& context);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/simulator/scene.h"

#include <vector>

namespace s2b::sim
{

/// Faces, reveals and ends of a wall with its openings cut out, in the building frame. At a joint that is not square
/// the mesh reaches into the other wall, so that no light comes through.
void addWallMesh(Scene& scene, const Building& building, const Wall& wall, const std::vector<const Opening*>& openings,
                 std::uint32_t element);

/// Frame, architraves and leaves. An open leaf stands at `angle_deg` to the wall; a removed one leaves the frame.
void addDoorMesh(Scene& scene, const Wall& wall, const Opening& opening, std::uint32_t element, double angle_deg);

/// Frame, mullion, sill board and one pane in the middle of the wall.
void addWindowMesh(Scene& scene, const Wall& wall, const Opening& opening, std::uint32_t element);

}  // namespace s2b::sim

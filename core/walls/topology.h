// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/walls/parallel_planes.h"

#include <vector>

namespace s2b
{

/// Where the end of a wall meets another.
struct BodyJunction
{
    std::uint32_t wall = 0;  ///< whose end it is
    bool atEnd = false;      ///< its end, or its begin
    std::uint32_t other = 0;
    int otherEnd = 0;                                 ///< -1: the other's begin, +1: its end, 0: along its path
    Eigen::Vector2d point = Eigen::Vector2d::Zero();  ///< where the axes meet
};

/// A wall of the finished plan: its axis is [axisBegin, axisEnd] at body.middle(), its body [body.begin, body.end].
struct PlanWall
{
    WallBody body;
    double axisBegin = 0.0, axisEnd = 0.0;
};

struct Plan
{
    std::vector<PlanWall> walls;
    std::vector<BodyJunction> junctions;
};

/// Merges collinear bodies that are one wall: same faces, and no room seen in the gap between them (D3.6, 3.4.4).
[[nodiscard]] std::vector<WallBody> mergeBodies(std::vector<WallBody> bodies, const PlanMask& mask,
                                                const WallParams& params);

/// Closes the corners (D3.6, 3.4.4): axes of walls that meet are drawn to their exact common point; bodies are cut so
/// that they touch without overlap. At a corner the longer wall runs through, at a T the one that ends there is cut at
/// the other's face (docs/conventions.md). Size limits (D3.6, 6.2) drop what is no wall.
[[nodiscard]] Plan connectWalls(std::vector<WallBody> bodies, const PlanMask& mask, const WallParams& params);

/// Removes walls shorter than the limit that meet no other: those are columns, or furniture.
void dropFreePieces(Plan& plan, double minimumFreeLength_m);

}  // namespace s2b

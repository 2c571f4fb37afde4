// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/simulator/plan.h"

namespace s2b::sim
{

/// Draws that all storeys share.
struct Shell
{
    double length_m = 0.0;        ///< between the axes of the end facades, along x
    double width_m = 0.0;         ///< between the axes of the long facades, along y
    double corridorFrom_m = 0.0;  ///< y of the corridor's walls; both 0 without a corridor
    double corridorTo_m = 0.0;
    double exterior_m = 0.0;  ///< thickness
    double clearHeight_m = 0.0;
    double slab_m = 0.0;
};

[[nodiscard]] Shell makeShell(const BuildingSpec& spec);

/// Walls, rooms, openings and columns of one storey. @return the outline of the storey's outer faces.
std::vector<Eigen::Vector2d> layOut(const BuildingSpec& spec, const Shell& shell, StoreyPlan& plan);

/// Doors, windows, plain openings and columns of the rooms of one storey.
void fitOut(const BuildingSpec& spec, StoreyPlan& plan);

/// Furniture of one storey, clear of walls, columns, doors and each other.
[[nodiscard]] std::vector<Prop> furnish(const BuildingSpec& spec, const StoreyPlan& plan);

/// Flight of stairs in the storey's stair room. `hole`: what the slab above leaves open.
[[nodiscard]] Prop makeStairs(const Shell& shell, const StoreyPlan& plan);
[[nodiscard]] std::vector<Eigen::Vector2d> stairHole(const Shell& shell);

/// Ground round the building and some trees.
[[nodiscard]] std::vector<Prop> makeSurroundings(std::uint64_t seed, const Eigen::Vector2d& low,
                                                 const Eigen::Vector2d& high, double groundLevel_m);

}  // namespace s2b::sim

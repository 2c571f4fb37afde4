// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"
#include "core/walls/walls.h"

#include <Eigen/Core>

#include <vector>

namespace s2b
{

/// All vertical surface above one small square of the plan: the cells of a storey, seen from the top.
struct PlanPixel
{
    Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< mean of its cells' points
    Eigen::Vector2d normal = Eigen::Vector2d::UnitX();   ///< mean direction, unit, of undecided sign
    double weight = 0.0;                                 ///< cells above each other, wall evidence counted
};

/// Plan pixels whose normal belongs to one direction.
struct AxisSet
{
    double angle_rad = 0.0;  ///< of the normal, in [0, pi)
    std::vector<PlanPixel> pixels;
};

/// How much a cell speaks for a wall, in [0, 1]: its label where it has one.
[[nodiscard]] double wallWeight(const SurfaceCells& cells, const SurfaceCell& cell);

/// Sorts a storey's vertical surface by the direction of its normals (D3.6, 3.4.1), so that walls that meet at a corner
/// fall into different sets and parallel walls of one set stay apart.
///
/// Differs: any number of directions, found as peaks of the normals' histogram, instead of X and Y; cells above each
/// other count as one plan pixel, so that the cost of what follows depends on the walls' length alone.
[[nodiscard]] std::vector<AxisSet> sortByAxis(const SurfaceCells& cells, const Level& level, const WallParams& params,
                                              const Context& context);

}  // namespace s2b

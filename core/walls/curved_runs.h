// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"
#include "core/walls/walls.h"

#include <Eigen/Core>

#include <vector>

namespace s2b
{

/// A piece of a circle in plan that vertical surface follows: a face of a curved wall, or something else that is round.
struct CurvedRun
{
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double radius_m = 0.0;
    double begin_rad = 0.0, end_rad = 0.0;  ///< counter-clockwise, end in (begin, begin + 2 pi]
    double rms_m = 0.0;                     ///< of places 5 cm apart
    std::vector<Eigen::Vector2d> places;    ///< these places, in their order along it

    [[nodiscard]] double sweep_rad() const { return end_rad - begin_rad; }
    [[nodiscard]] double length_m() const { return radius_m * sweep_rad(); }
};

/// Finds the curved runs of a storey's vertical surface (labelled wall, where there are labels). Building frame.
///
/// Curvature is evidence of its own: pieces of a polygon are straight between its corners, however well a circle fits
/// to all of them together. So places whose surroundings are curved give the circles (RANSAC and least squares), these
/// grow along all surface that is on them, and only those count whose every piece is curved as the whole (at least
/// 70 % of its length by a quadratic fit), that turn by at least 30 degrees, or by 10 with a sagitta of 0.15 m, and
/// whose places lie within 6 mm RMS of it.
///
/// @return in the order of their length, the longest first; nothing when WallParams::curved is off.
/// Cost: O(N) for N plan pixels of the storey, about 100 neighbours each.
[[nodiscard]] std::vector<CurvedRun> findCurvedRuns(const SurfaceCells& cells, const Level& level,
                                                    const WallParams& params, const Context& context);

/// Moves the runs onto one common centre by least squares over their places, each keeping a radius of its own.
/// @return RMS of the places afterwards; the runs stay as they are when it is more than `limit_m`.
double alignRuns(std::vector<CurvedRun*>& runs, double limit_m);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/polygon.h"
#include "core/spaces/plan_raster.h"

#include <Eigen/Core>

#include <functional>
#include <span>
#include <vector>

namespace s2b
{

struct Segment
{
    Eigen::Vector2d a = Eigen::Vector2d::Zero();
    Eigen::Vector2d b = Eigen::Vector2d::Zero();
};

/// All edges of all rings, each with the polygon's inside to its left.
[[nodiscard]] std::vector<Segment> edgesOf(std::span<const Polygon> polygons);

/// Moves each edge outwards by distance(edge) (inwards when negative), corners staying sharp: the inverse of widening
/// walls. Edges that vanish on the way are dropped with what they enclosed.
/// @return valid polygons, without those below 1e-4 m2.
[[nodiscard]] std::vector<Polygon> offsetEdges(const Polygon& polygon,
                                               const std::function<double(const Segment&)>& distance);

/// How a jagged raster outline becomes one of few straight sides.
struct StraightenOptions
{
    std::vector<double> directions;  ///< of sides [rad], in [0, pi): the walls'
    std::vector<Segment> faces;      ///< sides near one of these lie on it
    double snap_m = 0.15;            ///< how near
    double detail_m = 0.20;          ///< steps and corners smaller than this are smoothed away
};

/// Outlines of the set pixels with straight sides along the given directions, where the outline allows it.
/// @return valid polygons.
[[nodiscard]] std::vector<Polygon> straightOutlines(const PlanBits& bits, const PlanGrid& grid,
                                                    const StraightenOptions& options);

/// Removes steps of less than `step_m` between parallel sides: the shorter side moves onto the longer one's line.
[[nodiscard]] std::vector<Polygon> withoutSteps(const Polygon& polygon, double step_m);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace s2b::sim
{

/// A rectangle in plan: centre, half sizes along and across its yaw.
struct PlanBox
{
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    Eigen::Vector2d half = Eigen::Vector2d::Zero();
    double yaw_rad = 0.0;
};

/// The rectangle of a given direction round the points.
[[nodiscard]] PlanBox boxAlong(const std::vector<Eigen::Vector2d>& points, double yaw_rad);
/// The smallest rectangle round the points, its longer side along its yaw in [0, pi).
[[nodiscard]] PlanBox smallestBox(std::vector<Eigen::Vector2d> points);

}  // namespace s2b::sim

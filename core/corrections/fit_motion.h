// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace s2b
{

/// The motion that takes one list of points to another: none, a shift, a turn with or without a scale, or any affine
/// one, the simplest that fits.
/// @param tolerance_m  the largest distance that is rounding
/// @return nothing when there is none: the points were changed one by one
[[nodiscard]] std::optional<Eigen::Affine3d> fitMotion(const std::vector<Eigen::Vector3d>& from,
                                                       const std::vector<Eigen::Vector3d>& to, double tolerance_m);

}  // namespace s2b

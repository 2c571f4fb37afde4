// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/section.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace s2b
{

struct ProfileFitOptions
{
    double tolerance_m = 0.012;  ///< RMS of the points about the outline that makes it the section
    double minimumSize_m = 0.08;
    double maximumSize_m = 1.60;
};

struct ProfileFit
{
    ProfileSection section;
    Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< of the section's box
    double yaw_rad = 0.0;                              ///< of the section's x axis
    double rms_m = 0.0;                                ///< of the inliers about the outline
    double inlierShare = 0.0;                          ///< [0, 1] of the points on the outline
};

/// An I, L, U or T section through a column's points in plan: least squares of the distances to the outline, each point
/// to its nearest edge (iterated as ICP is), with Tukey's biweight, from several starts of each shape and position.
///
/// A shape is only said where the points show it: its edges in the notches, its tips and its outer faces must have
/// points along at least a third of them (a web or flange that was seen from one side has no thickness); plates must be
/// thicker than the noise; 85 % of the points must lie on the outline, much nearer than to any rectangle's, and no
/// other shape's may do as well.
///
/// @param points  finite, of one column, all heights; at least some hundred.
/// @param axis    not zero: the direction to prefer where several fit as well (that of the building).
/// @return Nothing when no shape fits, or more than one does.
/// Deterministic. Cost: some 50 ms, 10 ms for a plain rectangle.
[[nodiscard]] std::optional<ProfileFit> fitProfile(std::span<const Eigen::Vector2d> points, const Eigen::Vector2d& axis,
                                                   const ProfileFitOptions& options);

}  // namespace s2b

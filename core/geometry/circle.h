// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace s2b
{

struct CircleOptions
{
    double tolerance_m = 0.02;  ///< > 0; largest distance of an inlier to the circle
    double minimumRadius_m = 0.0;
    double maximumRadius_m = std::numeric_limits<double>::infinity();
    int trials = 200;  ///< >= 1; RANSAC draws
    std::uint64_t seed = 1;
    std::optional<double>
        knownRadius_m;  ///< > 0: only the centre is sought, from two points a draw; the limits are not used
};

struct CircleFit
{
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double radius_m = 0.0;
    double rms_m = 0.0;        ///< weighted RMS distance of the inliers to the circle
    double inlierShare = 0.0;  ///< [0, 1] of all weight
    double arcCoverage = 0.0;  ///< [0, 1] of 72 sectors of 5 degrees that have an inlier
};

/// Circle through points in plan (D3.6, 3.6: a vertical cylinder seen from above): RANSAC over circles through three
/// drawn points, then geometric least squares (Gauss-Newton on the distances) on the inliers.
///
/// Differs from D3.6: points are drawn by their weight; draws are scored by truncated squares of the distances (MSAC,
/// Torr and Zisserman 2000), so that of circles with as many inliers the closer one wins; and the best is refined on
/// all of its inliers.
/// @param points   finite.
/// @param weights  empty (all 1), or one a point, >= 0.
/// @return Nothing when no draw gives a circle within the limits: fewer than three different points (two when the
/// radius
///         is known), or collinear ones. A result is not a proof of a circle: look at inlierShare, rms_m and
///         arcCoverage.
/// Deterministic for a seed; draws depend on the points' order. Cost: O(trials * N).
[[nodiscard]] std::optional<CircleFit> fitCircle(std::span<const Eigen::Vector2d> points,
                                                 std::span<const double> weights, const CircleOptions& options);

}  // namespace s2b

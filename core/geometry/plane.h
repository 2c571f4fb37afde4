// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace s2b
{

struct PlaneOptions
{
    double tolerance_m = 0.02;  ///< > 0; largest distance of an inlier to the plane
    int trials = 500;           ///< >= 1; at most so many RANSAC draws
    std::uint64_t seed = 1;
};

/// The plane normal . p = offset.
struct PlaneFit
{
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit; its largest component is positive
    double offset_m = 0.0;
    double rms_m = 0.0;                ///< RMS distance of the inliers
    double inlierShare = 0.0;          ///< [0, 1] of all points
    std::vector<std::size_t> inliers;  ///< ascending indices

    [[nodiscard]] double distance(const Eigen::Vector3d& p) const { return normal.dot(p) - offset_m; }
};

/// The plane with most points near it (RANSAC, D3.6, 3.4.3; PCL), then total least squares on its inliers in double.
///
/// @param points  finite [m]. Within some hundred metres of each other: PCL works in float.
/// @return Nothing for fewer than three points, or only collinear ones.
/// Deterministic for a seed. Draws end early when a better plane is unlikely (1 in 10 000). Cost: O(trials * N).
[[nodiscard]] std::optional<PlaneFit> fitPlane(std::span<const Eigen::Vector3f> points, const PlaneOptions& options);

}  // namespace s2b

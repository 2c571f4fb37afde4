// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/point_cloud.h"

#include <cmath>

namespace s2b
{

/// Density based clutter removal (D3.6, 3.2).
struct ClutterParams
{
    bool enabled = true;
    double voxelSize_m = 0.65;  ///< D3.6, 3.2
    double minimumDensity =
        0.02;               ///< share of the cloud's own typical points per voxel (D3.6: 2500 points of one cloud)
    double margin_m = 0.5;  ///< around the box of the dense voxels
    bool operator==(const ClutterParams&) const = default;
};

/// The region that is kept: an oriented box in plan (D3.6's minimum oriented box of the inliers) and a height range.
struct KeptRegion
{
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    Eigen::Vector2d axis = Eigen::Vector2d::UnitX();  ///< unit direction of its first side
    Eigen::Vector2d half = Eigen::Vector2d::Zero();   ///< half side lengths
    double zMin = 0.0;
    double zMax = 0.0;
    bool everything = true;  ///< no limit at all

    /// Asked for every point, some times.
    [[nodiscard]] bool contains(const Eigen::Vector3f& p) const
    {
        if (everything)
            return true;
        const double z = static_cast<double>(p.z());
        const double x = static_cast<double>(p.x()) - center.x(), y = static_cast<double>(p.y()) - center.y();
        return z >= zMin && z <= zMax && std::abs(x * axis.x() + y * axis.y()) <= half.x() &&
               std::abs(axis.x() * y - axis.y() * x) <= half.y();
    }
};

/// Finds the region that the building occupies: sparse voxels are clutter, and what lies outside the minimum oriented
/// box of the dense ones is removed; sparse details inside it are kept (D3.6, 3.2).
///
/// Differs from D3.6: the density limit is a share of the cloud's own median density, so no tuning per survey; dense
/// voxels that stand apart from the building and are few (seen through windows) do not widen the box.
/// @param cloud  N >= 1 points.  Cost: O(N), one pass, 16 bytes per occupied voxel. Independent of the point order.
[[nodiscard]] KeptRegion findDenseRegion(const CloudView& cloud, const ClutterParams& params, const Context& context);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace s2b
{

/// Which way points spread least.
struct FlattestDirection
{
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< unit, of either sign; zero where all are alike
    double least = 0.0, middle = 0.0;                     ///< the two smaller variances, least <= middle
};

/// The smallest eigenvalue of a covariance and its eigenvector, and the middle eigenvalue: for loops over
/// millions, without the arc tangent, sine and cosine by which Eigen's direct solver finds all three.
/// Accurate to 1e-9 of the largest eigenvalue where the two smallest differ by 1 % of it; where they don't, there is no
/// flattest direction.
/// @param covariance  symmetric, positive semidefinite up to rounding
[[nodiscard]] FlattestDirection flattestDirection(const Eigen::Matrix3d& covariance);

}  // namespace s2b

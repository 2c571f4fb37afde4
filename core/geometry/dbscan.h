// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <span>
#include <vector>

namespace s2b
{

/// Density based clusters (DBSCAN, Ester et al. 1996; D3.6, 3.4.2, 3.5 and 3.6), exact.
///
/// A point with at least `minPoints` points within `eps` of it (itself and a distance of exactly eps included) is a
/// core point. Core points within eps of one another are in one cluster. Any other point belongs to the cluster of its
/// nearest core point within eps (of equally near ones the one with the lowest index), and is noise when there is none.
///
/// @param points     N >= 0 finite points [m].
/// @param eps        [m] > 0, finite.
/// @param minPoints  1 or less: no noise, clusters are what single steps of eps connect.
/// @return One label a point: -1 noise, else the number of its cluster. Clusters are numbered by their lowest point
/// index.
///         Serial and without random draws: independent of threads; the clusters do not depend on the points' order.
/// @throws Error{BadCoordinates} for a point that is not finite; Error{BadParameter} for an eps that is not positive
/// and
///         finite, or below 2^-31 of the points' extent.
/// Cost: cells of eps / sqrt(dimension) in sorted order, whose points are mutual neighbours, joined by union-find:
/// O(N log N) for the sort, then near linear; about 60 bytes a point and 120 a cell. No neighbour lists are kept.
[[nodiscard]] std::vector<int> dbscan(std::span<const Eigen::Vector2f> points, double eps, int minPoints);
[[nodiscard]] std::vector<int> dbscan(std::span<const Eigen::Vector2d> points, double eps, int minPoints);
[[nodiscard]] std::vector<int> dbscan(std::span<const Eigen::Vector3f> points, double eps, int minPoints);
[[nodiscard]] std::vector<int> dbscan(std::span<const Eigen::Vector3d> points, double eps, int minPoints);

}  // namespace s2b

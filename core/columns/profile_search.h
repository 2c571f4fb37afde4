// SPDX-License-Identifier: GPL-3.0-or-later
/// The search that fitProfile stands on: one shape in one direction, from several starts.
#pragma once

#include "core/columns/profile_edges.h"

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace s2b
{

using ProfilePoints = std::vector<Eigen::Vector2d>;

/// Farther points are none of the outline's: fillets, brackets, mixed pixels.
constexpr double kOutline_m = 0.015;

/// One shape at one place while it is being fitted: turned by its yaw about the points' origin.
struct ProfileHypothesis
{
    std::optional<ProfileShape> shape;  ///< without: a rectangle
    double yaw_rad = 0.0;
    ProfileLengths lengths = ProfileLengths::Zero();
    double cost = std::numeric_limits<double>::infinity();  ///< mean of the squared distances, each at most kOutline_m
};

/// Where an edge is, in the section's own directions.
struct PlacedEdge
{
    bool isVertical;
    double place, begin, end;
};

struct NearestEdge
{
    std::size_t edge = 0;
    double square = std::numeric_limits<double>::infinity();  ///< of the distance
};

[[nodiscard]] std::vector<PlacedEdge> placedEdges(const ProfileHypothesis& h);
[[nodiscard]] NearestEdge nearestEdge(const Eigen::Vector2d& p, const std::vector<PlacedEdge>& edges);

/// The points in the directions of a section.
[[nodiscard]] ProfilePoints turnedBack(const ProfilePoints& points, double yaw_rad);

/// Moves the edges to where the points near them lie, and turns the section if it may: least squares of the distances,
/// each point to its nearest edge, with Tukey's biweight of each reach in turn. The cost is infinite when no section is
/// left.
/// @param points  about the origin, not turned.
void refineProfile(const ProfilePoints& points, ProfileHypothesis& h, std::span<const double> reaches_m, bool mayTurn);

/// The best of several thicknesses of web and flange, refined.
[[nodiscard]] ProfileHypothesis searchProfile(const ProfilePoints& points, std::optional<ProfileShape> shape,
                                              double yaw_rad);

}  // namespace s2b

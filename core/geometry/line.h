// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <span>

namespace s2b
{

/// A straight line in plan: the trace of a vertical plane.
struct LineFit
{
    Eigen::Vector2d point = Eigen::Vector2d::Zero();  ///< weighted centroid of the points that it rests on
    Eigen::Vector2d direction =
        Eigen::Vector2d::Zero();  ///< unit, x > 0 or (x = 0 and y > 0); zero when there is no line
    double rms_m = 0.0;           ///< weighted RMS distance of the points, by their final weights
    double weight = 0.0;          ///< sum of the final weights; 0 when there is no line

    /// Unit normal to the left of the direction.
    [[nodiscard]] Eigen::Vector2d normal() const { return {-direction.y(), direction.x()}; }
    /// Signed distance, positive on the left.
    [[nodiscard]] double distance(const Eigen::Vector2d& p) const { return normal().dot(p - point); }
};

/// Total least squares line with robust reweighting (Tukey's biweight of the distance, scale from the median absolute
/// distance), which starts at the plain weighted fit: for points most of which already belong to the line (a face's).
///
/// @param points   finite. Fewer than two different ones: no line (direction zero).
/// @param weights  empty (all 1), or one a point, >= 0.
/// Deterministic; independent of the coordinates' origin but for rounding. Cost: O(N) for each of at most 20 rounds.
[[nodiscard]] LineFit fitLine(std::span<const Eigen::Vector2d> points, std::span<const double> weights);

/// The offset along a known direction that most weight agrees on.
struct OffsetConsensus
{
    double offset = 0.0;    ///< [m] robust mean of the offsets within the tolerance
    double weight = 0.0;    ///< sum of the weights within the tolerance of `offset`; 0 when there are no points
    double share = 0.0;     ///< [0, 1] of all weight
    double rms_m = 0.0;     ///< weighted RMS of those offsets about `offset`
    std::size_t count = 0;  ///< points within the tolerance of `offset`
};

/// Consensus constrained to vertical planes of one direction (HYSAC: D3.6, 3.4.3 and 6.2): with the normal known, a
/// plane is one number, and all hypotheses can be looked at instead of drawn.
///
/// The window of width 2 * tolerance with the most weight, then the biweight mean within: symmetric noise moves it by
/// its standard error only, so two faces of a wall keep their distance.
/// @param offsets    finite signed distances along the normal [m].
/// @param weights    empty (all 1), or one an offset, >= 0.
/// @param tolerance  [m] > 0.
/// Of equally heavy windows the lowest counts. Deterministic; independent of the order. Cost: O(N log N).
[[nodiscard]] OffsetConsensus findOffset(std::span<const double> offsets, std::span<const double> weights,
                                         double tolerance);

}  // namespace s2b

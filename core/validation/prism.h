// SPDX-License-Identifier: GPL-3.0-or-later
/// Elements as they are compared: a plan from one height to another, in one common frame.
#pragma once

#include "core/validation/bim.h"

#include <Eigen/Geometry>

#include <limits>
#include <vector>

namespace s2b::validation
{

struct Prism
{
    Polygon plan;
    Eigen::AlignedBox2d bounds;
    double area_m2 = 0.0;
    double low_m = 0.0;
    double high_m = 0.0;
    double bandLow_m = -std::numeric_limits<double>::infinity();  ///< heights that the survey saw of it
    double bandHigh_m = std::numeric_limits<double>::infinity();
    Eigen::Vector3d center = Eigen::Vector3d::Zero();

    [[nodiscard]] double volume_m3() const { return area_m2 * std::max(0.0, high_m - low_m); }
};

/// @param shift  added to the element's coordinates: the difference of two BIMs' origins.
[[nodiscard]] Prism prismOf(const BimElement& element, const Eigen::Vector3d& shift);

/// The polygon moved by `shift`.
[[nodiscard]] Polygon moved(const Polygon& polygon, const Eigen::Vector2d& shift);

/// Area that two plans share [m2]. Cost: some 100 us when their bounds overlap.
[[nodiscard]] double commonArea(const Prism& a, const Prism& b);

/// Two elements that overlap in plan.
struct Overlap
{
    int truth = 0;
    int result = 0;
    double area_m2 = 0.0;  ///< > 0
};

/// All pairs that share area, by truth, then result.
[[nodiscard]] std::vector<Overlap> overlapsOf(const std::vector<Prism>& truth, const std::vector<Prism>& result);

/// Volume shared over volume covered, of the whole prisms; `area_m2` is what their plans share.
[[nodiscard]] double fullIou(const Prism& truth, const Prism& result, double area_m2);

/// The same between the heights that the survey saw of the truth (its band): above and below nobody knows anything.
[[nodiscard]] double seenIou(const Prism& truth, const Prism& result, double area_m2);

/// Share of `part`'s volume inside `whole`.
[[nodiscard]] double shareInside(const Prism& part, const Prism& whole, double area_m2);

}  // namespace s2b::validation

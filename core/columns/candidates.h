// SPDX-License-Identifier: GPL-3.0-or-later
/// What may be columns: clusters of surface seen from the top, with the rectangle and the circle that fit them.
#pragma once

#include "core/columns/columns.h"
#include "core/columns/profile_fit.h"
#include "core/geometry/circle.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace s2b
{

/// Surface seen from the top: the cells above one small square of the plan.
struct ColumnSpot
{
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    Eigen::Vector2d normal = Eigen::Vector2d::Zero();
    double weight = 0;  ///< cells above each other
    std::uint64_t points = 0;
    std::uint64_t rows = 0;  ///< bit r: something was seen at that height above the floor
};

/// The points of one column candidate and what fits them.
struct ColumnCandidate
{
    std::vector<ColumnSpot> spots;
    std::vector<Eigen::Vector2d> points;
    std::vector<double> weights;
    double weight = 0;
    Eigen::Vector2d x = Eigen::Vector2d::UnitX(), center = Eigen::Vector2d::Zero();
    double width = 0, depth = 0, rectangleRms = 0;
    std::optional<CircleFit> circle;
    std::optional<ProfileFit> profile;
    bool isRound = false;
    bool isEngaged = false;  ///< stands in a wall: the part within is assumed
};

/// DBSCAN in plan of the slice of one storey (D3.6, 3.6), each cluster with what fits it.
[[nodiscard]] std::vector<ColumnCandidate> columnCandidates(const SurfaceCells& cells, const Level& level,
                                                            const std::vector<Wall>& walls, const ColumnParams& params,
                                                            const Context& context);

/// Round columns of one storey mostly have one radius: it settles those of which little was seen.
void shareRadius(std::vector<ColumnCandidate>& candidates, const ColumnParams& params, const Context& context);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"
#include "core/walls/walls.h"

#include <Eigen/Core>

#include <vector>

namespace s2b
{

/// A vertical plane seen from the top: t * s + n * offset with s in [begin, end]; n is t turned by +90 degrees.
struct FaceLine
{
    Eigen::Vector2d t = Eigen::Vector2d::UnitX();
    double offset = 0.0;
    double begin = 0.0, end = 0.0;
    double weight = 0.0;  ///< cells on it

    [[nodiscard]] Eigen::Vector2d n() const { return {-t.y(), t.x()}; }
};

/// Fits the planes of each instance (D3.6, 3.4.2 and 3.4.3).
///
/// Instances are DBSCAN clusters of an axis set's plan pixels. Within one, planes are found by consensus constrained to
/// vertical planes near the set's direction (D3.6: HYSAC): the offset with the most support first, then its own
/// direction by least squares, growing along the line until nothing changes; what is left then, by RANSAC.
/// @return in the order of sets, clusters and support; directions in [-45, 135) degrees.
[[nodiscard]] std::vector<FaceLine> findLines(const SurfaceCells& cells, const Level& level, const WallParams& params,
                                              const Context& context);

}  // namespace s2b

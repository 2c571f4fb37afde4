// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/cell_index.h"
#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"
#include "core/walls/parallel_planes.h"
#include "core/walls/plan_mask.h"
#include "core/walls/walls.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace s2b
{

/// Coordinates that a circle is straight in: x is the arc length on it, counter-clockwise from an angle, y the distance
/// inwards. Lengths are kept on the circle itself and everywhere across it; orientation is kept too.
struct Unrolling
{
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double radius_m = 1.0;
    double angle_rad = 0.0;  ///< of x = 0
    double length_m = 0.0;   ///< what lies about [0, length] counts
    double margin_m = 0.0;   ///< and this far beyond its ends

    [[nodiscard]] Eigen::Vector2d fromPlan(const Eigen::Vector2d& p) const;
    [[nodiscard]] Eigen::Vector2d toPlan(const Eigen::Vector2d& q) const;
    [[nodiscard]] bool contains(const Eigen::Vector2d& q) const;
};

/// Curved walls of one circle, unrolled: there they are straight, and all that holds for straight walls holds for them.
struct ArcScene
{
    Unrolling unrolling;
    SurfaceCells cells;  ///< what lies about the circle, unrolled
    PlanMask mask;       ///< of these
    CellIndex index;     ///< of these
    std::vector<Face> faces;
    std::vector<WallBody> bodies;  ///< along x
    bool isClosed = false;         ///< half of a ring: both ends go on in the other half

    ArcScene(const Unrolling& about, SurfaceCells unrolled, const Level& level);
    ArcScene(const ArcScene&) = delete;  // the index refers to the cells
    ArcScene& operator=(const ArcScene&) = delete;
};

using ArcScenes = std::vector<std::unique_ptr<ArcScene>>;

/// Finds the curved walls of a storey, with the faces seen of them; thickness and heights are settled by settleArcs().
/// A ring is two half circles. Nothing, in hardly any time, where nothing curved stands upright.
[[nodiscard]] ArcScenes findArcs(const SurfaceCells& cells, const Level& level, const WallParams& params,
                                 const Context& context);

/// The storey's cells without those of the curved walls: their facets are no straight walls.
[[nodiscard]] SurfaceCells withoutArcs(const SurfaceCells& cells, const Level& level, const ArcScenes& arcs);

/// Thickness where one face was seen, merging and heights, by the rules of straight walls (which are the other walls of
/// their kind).
void settleArcs(ArcScenes& arcs, const std::vector<WallBody>& straight, const Level& level, const WallParams& params);

}  // namespace s2b

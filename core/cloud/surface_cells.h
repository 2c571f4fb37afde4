// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/clutter.h"
#include "core/cloud/point_cloud.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace s2b
{

struct CellParams
{
    double size_m = 0.02;          ///< of a cell in a dense cloud; a sparser cloud gets larger cells
    double spacingsPerCell = 1.0;  ///< smallest cell in units of the cloud's point spacing
    int minimumNeighbours = 6;     ///< points needed for a normal
    bool operator==(const CellParams&) const = default;
};

/// A piece of surface: the points of one grid cell.
struct SurfaceCell
{
    Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< centroid [m], relative to the cloud's origin (or frame)
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();    ///< unit, of undecided sign; zero when it has none
    float flatness = 0.0f;            ///< RMS distance [m] of the neighbourhood's points from the plane
    std::uint32_t count = 0;          ///< points in the cell
    Label label = Label::Unassigned;  ///< the most frequent label
    std::uint8_t labelShare = 0;      ///< its share, 0..255
};

struct SurfaceCells
{
    double size_m = 0.0;     ///< edge of a cell
    double spacing_m = 0.0;  ///< typical point spacing of the cloud
    bool hasLabels = false;
    std::vector<SurfaceCell> cells;
};

/// Sorts the points into surface cells: the only pass over all points. Normals come from the moments of a cell and its
/// 26 neighbours (D3.6, 3.4.1 uses k nearest neighbours).
///
/// The cell size adapts to the cloud: at least `spacingsPerCell` point spacings, so that a neighbourhood always holds
/// enough points, and never so large that both faces of a thin wall fall into one.
/// @throws Error{BadCoordinates} at the first point that is not finite, Error{EmptyCloud} when none is in `region`.
/// Cost: O(N). Memory: 4 bytes a point and about 80 bytes a cell. Independent of the point order and of the threads.
[[nodiscard]] SurfaceCells buildSurfaceCells(const CloudView& cloud, const KeptRegion& region, const CellParams& params,
                                             const Context& context);

}  // namespace s2b

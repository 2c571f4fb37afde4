// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/clutter.h"
#include "core/cloud/point_cloud.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
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
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();    ///< unit, zero when it has none; its sign: see facesScanner
    float flatness = 0.0f;            ///< RMS distance [m] of the neighbourhood's points from the plane
    std::uint32_t count = 0;          ///< points in the cell
    Label label = Label::Unassigned;  ///< the most frequent label
    std::uint8_t labelShare = 0;      ///< its share, 0..255; of a model's labels weighed by how sure they are
    bool facesScanner = false;        ///< the normal points to where it was seen from; else its sign is undecided
};

inline constexpr std::uint32_t kNoCell = 0xffffffff;  ///< of a point

struct SurfaceCells
{
    double size_m = 0.0;     ///< edge of a cell
    double spacing_m = 0.0;  ///< typical point spacing of the cloud
    bool hasLabels = false;
    bool hasStations = false;  ///< some cells face the scanner
    bool hasGuesses = false;   ///< the labels are a model's, and shares of them say how sure it is
    std::vector<SurfaceCell> cells;

    /// Where the cells are sorted by layers of a metre: the first one's lower edge [m], each layer's first cell, and
    /// one more.
    double lowestLayer_m = 0.0;
    std::vector<std::size_t> firstOfLayer;

    /// Whether labels are taken at their word, and not as one opinion beside the geometry's.
    [[nodiscard]] bool labelsAreSure() const { return hasLabels && !hasGuesses; }
    /// Without any cells, all else the same.
    [[nodiscard]] SurfaceCells empty() const;
    /// Those between two heights and some around, as far as the layers tell; all without layers.
    [[nodiscard]] std::span<const SurfaceCell> between(double zMin, double zMax) const;
};

/// Sorts the points into surface cells: the only pass over all points. Normals come from the moments of a cell and its
/// 26 neighbours (D3.6, 3.4.1 uses k nearest neighbours).
///
/// Where the cloud carries stations, a normal points to the scanner, unless the cell's points were seen from both sides
/// or too flat to tell.
///
/// The cell size adapts to the cloud: at least `spacingsPerCell` point spacings, so that a neighbourhood always holds
/// enough points, and never so large that both faces of a thin wall fall into one.
/// @throws Error{BadCoordinates} at the first point that is not finite, Error{EmptyCloud} when none is in `region`.
/// Cost: O(N). Memory: 4 bytes a point, 36 bytes a cell, and 48 more a cell of the three layers of a metre in work.
/// Independent of the point order and of the threads.
/// @param cellOfPoint  where given: becomes the index of each point's cell, kNoCell outside the region
[[nodiscard]] SurfaceCells buildSurfaceCells(const CloudView& cloud, const KeptRegion& region, const CellParams& params,
                                             const Context& context, std::vector<std::uint32_t>* cellOfPoint = nullptr);

}  // namespace s2b

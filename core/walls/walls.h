// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/cell_index.h"
#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"
#include "core/model/building.h"

#include <vector>

namespace s2b
{

/// Wall reconstruction (D3.6, 3.4).
struct WallParams
{
    double normalTolerance = 0.1;      ///< |1 - |n . axis||; D3.6, 3.4.1
    double clusterRadius_m = 0.10;     ///< DBSCAN radius; D3.6, 3.4.2
    int clusterMinimumCells = 10;      ///< DBSCAN minimum neighbours, in cells
    double planeDistance_m = 0.02;     ///< largest distance of a cell from its plane
    double minimumFaceArea_m2 = 0.15;  ///< smallest face that counts
    double minimumThickness_m = 0.05;
    double maximumThickness_m = 0.60;  ///< largest distance of parallel planes of one wall; D3.6, 3.4.3
    double defaultThickness_m = 0.20;  ///< of a wall with one face seen and nothing that says more; D3.6, 1.2
    double defaultExternalThickness_m = 0.30;
    double minimumLength_m = 0.30;      ///< D3.6, 6.2: size limits
    double minimumFreeLength_m = 0.60;  ///< of a wall that meets no other
    double minimumCoverage = 0.20;      ///< share of the better seen side with points
    double minimumHeight_m = 0.50;      ///< D3.6, 6.2: size limits
    double mergeGap_m = 0.45;           ///< largest gap between collinear pieces of one wall; D3.6, 3.4.4
    double mergeUnseen_m = 4.0;         ///< largest hidden gap between collinear pieces, each longer than it
    double mergeOffset_m = 0.03;        ///< largest offset between collinear pieces of one wall
    double closeGap_m = 0.60;           ///< largest gap that is closed at a corner; D3.6, 3.4.4
    double minimumTopStep_m = 0.5;      ///< of a wall's top, to be two walls; D3.6, 6.2: height correction
    double widestOpening_m = 2.2;       ///< that a wall goes on above; above a wider one hangs a beam
    double deepestBeam_m = 0.9;         ///< a beam is no higher
    double minimumAgreement = 0.85;     ///< share of a face's cells that were scanned from one side, to be that side's

    bool curved = true;                ///< whether curved walls are looked for
    double minimumArcRadius_m = 0.8;   ///< of a curved wall's face
    double maximumArcRadius_m = 30.0;  ///< of a curved wall's face

    bool operator==(const WallParams&) const = default;
};

struct WallResult
{
    std::vector<Wall> walls;
    std::vector<Junction> junctions;
    std::vector<Diagnostic> diagnostics;
};

/// Reconstructs the walls of one storey (D3.6, 3.4): axis sorting, instances, planes, parallel planes, boxes, topology.
///
/// @param cells   building frame
/// @param index   of the storey's cells
/// @param storey  of the level, for the walls to refer to
/// @param nextId  the next free ElementId value; advanced
[[nodiscard]] WallResult findWalls(const SurfaceCells& cells, const CellIndex& index, const Level& level,
                                   ElementId storey, std::uint32_t& nextId, const WallParams& params,
                                   const Context& context);

}  // namespace s2b

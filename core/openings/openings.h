// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/cell_index.h"
#include "core/cloud/sightlines.h"
#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"
#include "core/model/building.h"

#include <set>
#include <vector>

namespace s2b
{

/// Doors, windows and plain openings (D3.6, 3.5).
struct OpeningParams
{
    double clusterRadius_m = 0.10;  ///< D3.6, 3.5: DBSCAN radius
    double minimumDoorWidth_m = 0.50;
    double maximumDoorWidth_m = 4.0;
    double minimumDoorHeight_m = 1.6;
    double minimumWindowWidth_m = 0.30;
    double maximumWindowWidth_m = 6.0;  ///< of one that is seen by its recess alone
    double minimumWindowHeight_m = 0.30;
    double minimumEmptyDoorWidth_m = 0.55;   ///< of a hole without leaf, frame or label that counts as a door
    double maximumEmptyDoorWidth_m = 1.35;   ///< of the same; a wider one is a plain opening
    double minimumEmptyDoorHeight_m = 1.85;  ///< of the same
    double maximumEmptyDoorHeight_m = 2.45;  ///< of the same
    double leafReach_m = 1.3;                ///< how far beside a wall an open leaf is looked for
    double minimumSeenThrough = 0.5;         ///< share of a hole that rays of known stations passed, to be open by that
    bool operator==(const OpeningParams&) const = default;
};

struct OpeningResult
{
    std::vector<Opening> openings;
    std::vector<Diagnostic> diagnostics;
};

/// Finds the doors, windows and plain openings of one storey in its walls (D3.6, 3.5).
///
/// Two ways, the first wins where both see a hole:
/// - From labels, in D3.6's two steps: points inside a wall's body say that it hosts a door or window, and give its
/// outline
///   (leaves stand open outside it, linings lie on the faces: neither is the hole); only then the points around the
///   wall are looked at, for the leaf.
/// - From the void in the wall's faces, where the floor runs through or jambs were seen: an open or removed leaf leaves
///   nothing else (D3.6, 3.5, leaves these out). Nothing seen is not open.
/// @param index  of the storey's cells
/// @param walls  of this storey
/// @param kinds  what is asked for
/// @param sightlines  of the cloud's stations: what rays passed through is open; empty when none are known
[[nodiscard]] OpeningResult findOpenings(const SurfaceCells& cells, const CellIndex& index, const Level& level,
                                         const std::vector<Wall>& walls, const std::set<OpeningKind>& kinds,
                                         std::uint32_t& nextId, const OpeningParams& params, const Context& context,
                                         const Sightlines& sightlines = {});

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"
#include "core/model/building.h"

#include <vector>

namespace s2b
{

/// Doors, windows and plain openings (D3.6, 3.5).
struct OpeningParams
{
    double searchMargin_m = 0.10;      ///< D3.6, 3.5: first step, inside the wall's box
    double clusterRadius_m = 0.10;     ///< D3.6, 3.5: DBSCAN radius
    double minimumDoorWidth_m = 0.50;
    double maximumDoorWidth_m = 4.0;
    double minimumDoorHeight_m = 1.6;
    double minimumWindowWidth_m = 0.30;
    double minimumWindowHeight_m = 0.30;
    bool operator==(const OpeningParams&) const = default;
};

struct OpeningResult
{
    std::vector<Opening> openings;
    std::vector<Diagnostic> diagnostics;
};

/// Finds the doors or windows of one storey in its walls from their labelled points (D3.6, 3.5).
///
/// Two steps as in D3.6: points inside a wall's body say that it hosts one and give its outline (leaves stand open outside
/// it, linings lie on the faces: neither is the hole); only then the points around the wall are looked at, for the leaf.
/// @param walls  of this storey
/// @param kind   Door or Window
[[nodiscard]] OpeningResult findOpenings(const SurfaceCells& cells, const Level& level, const std::vector<Wall>& walls,
                                         OpeningKind kind, std::uint32_t& nextId, const OpeningParams& params,
                                         const Context& context);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/surface_cells.h"
#include "core/model/building.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace s2b
{

struct LevelParams
{
    double binSize_m = 0.02;           ///< of the height histogram
    double minimumRoomHeight_m = 1.9;  ///< D3.6, 3.3: floor and ceiling are told apart by it
    double maximumRoomHeight_m = 6.0;  ///< D3.6, 3.3
    double minimumArea_m2 = 4.0;       ///< of a level's surface
    double minimumAreaShare = 0.12;    ///< of a level's surface, relative to the largest level's
    bool operator==(const LevelParams&) const = default;
};

/// One storey's heights, building frame.
struct Level
{
    double floor_m = 0.0;
    double ceiling_m = 0.0;
    bool ceilingSeen = false;  ///< false: no level ceiling was found (sloped, or not scanned); ceiling_m is then the
                               ///< top of the vertical surfaces or the next floor
    double floorArea_m2 = 0.0;
    double ceilingArea_m2 = 0.0;
    double floorRms_m = 0.0;
    /// All level ceilings over a good part of the floor (suspended ones, stepped ones), ascending; empty when none was
    /// seen.
    std::vector<double> ceilings;
    /// Highest z at which a surface is still this storey's ceiling: below the next floor's surface.
    double ceilingLimit_m = std::numeric_limits<double>::infinity();

    /// The highest ceiling; ceiling_m where none was seen.
    [[nodiscard]] double highestCeiling_m() const { return ceilings.empty() ? ceiling_m : ceilings.back(); }
    /// Is it the height of one of the ceilings, to the given distance?
    [[nodiscard]] bool isCeiling(double z, double distance) const
    {
        return z < ceilingLimit_m &&
               std::any_of(ceilings.begin(), ceilings.end(), [&](double c) { return std::abs(z - c) < distance; });
    }
};

/// The cells that a storey's stages look at: from below its floor to above its ceilings, and some around.
[[nodiscard]] inline std::span<const SurfaceCell> cellsOf(const SurfaceCells& cells, const Level& level)
{
    return cells.between(level.floor_m - 0.5, level.highestCeiling_m() + 1.0);
}

struct LevelResult
{
    std::vector<Level> levels;  ///< ascending, a floor always below its ceiling
    std::vector<Diagnostic> diagnostics;
};

/// Finds the storeys from peaks of the height histogram of horizontal surfaces (D3.6, 3.3).
///
/// Differs: only horizontal surfaces count, by area and not by points (a near floor does not outweigh a far one); which
/// peak is a floor follows from what lies above it in the same place, and from the labels where there are any.
[[nodiscard]] LevelResult findLevels(const SurfaceCells& cells, const LevelParams& params, const Context& context);

}  // namespace s2b

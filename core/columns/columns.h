// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/point_cloud.h"
#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"
#include "core/model/building.h"

#include <vector>

namespace s2b
{

/// Columns (D3.6, 3.6).
struct ColumnParams
{
    double clusterRadius_m = 0.10;  ///< DBSCAN radius; D3.6, 3.6
    int clusterMinimumCells = 20;   ///< smaller clusters are artefacts; D3.6, 3.6 (100 to 5000 points)
    double sliceMargin_m = 0.25;    ///< cut off above the floor and below the ceiling; D3.6, 3.6
    double minimumSize_m = 0.08;
    double maximumSize_m = 1.60;
    double circleTolerance_m = 0.012;   ///< RMS of a circle fit that makes a column round
    int circleTrials = 200;             ///< RANSAC trials; D3.6, 3.6
    bool profiles = true;               ///< look for I, L, U and T sections
    double profileTolerance_m = 0.012;  ///< RMS of the points about the outline that makes a column such a section
    bool operator==(const ColumnParams&) const = default;
};

/// The points themselves, for what cells are too coarse for.
struct ColumnSource
{
    const CloudView* cloud = nullptr;  ///< null: no section is finer than a rectangle or a circle
    Frame frame;                       ///< of the building, which the cells are in
};

struct ColumnResult
{
    std::vector<Column> columns;
    std::vector<Diagnostic> diagnostics;
};

/// Finds the columns of one storey (D3.6, 3.6): DBSCAN in plan of a slice between floor and ceiling, then a rectangle
/// or a circle, whichever the points fit; beyond D3.6, where neither does, an I, L, U or T section, if the points show
/// one (profile_fit.h), or else the box around them with a diagnostic.
///
/// From their labelled points; without labels from what stands free of the walls, is no larger than a column and
/// reaches from the floor to the ceiling. A circle seen from one side takes the radius of the storey's other round
/// columns.
/// @param source  read only where a candidate is not round
/// @param walls   of this storey
[[nodiscard]] ColumnResult findColumns(const SurfaceCells& cells, const ColumnSource& source, const Level& level,
                                       const std::vector<Wall>& walls, ElementId storey, std::uint32_t& nextId,
                                       const ColumnParams& params, const Context& context);

}  // namespace s2b

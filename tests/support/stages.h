// SPDX-License-Identifier: GPL-3.0-or-later
/// The stages one after another on a hand-made cloud whose walls lie along the axes already.
#pragma once

#include "core/cloud/cell_index.h"
#include "core/cloud/station_assignment.h"
#include "core/cloud/surface_cells.h"
#include "core/columns/columns.h"
#include "core/levels/levels.h"
#include "core/openings/openings.h"
#include "core/walls/walls.h"
#include "tests/support/hand_made_cloud.h"

#include <string_view>

namespace s2b::test
{

inline SurfaceCells cellsOf(const HandMadeCloud& cloud, bool withLabels = true)
{
    CloudView view = cloud.view(withLabels);
    std::vector<std::uint16_t> stationOfPoint;
    if (view.stations.positions.size() > 1 && !view.stations.ofPoint)
    {
        stationOfPoint = nearestVisibleStations(view, Context{});
        view.stations.ofPoint = stationOfPoint.data();
    }
    return buildSurfaceCells(view, KeptRegion{}, CellParams{}, Context{});
}

inline LevelResult levelsOf(const HandMadeCloud& cloud, bool withLabels = true)
{
    return findLevels(cellsOf(cloud, withLabels), LevelParams{}, Context{});
}

/// What was found on one storey.
struct StoreyResult
{
    Level level;
    WallResult walls;
    OpeningResult openings;
    ColumnResult columns;
};

/// @param level  the storey's true heights, so that a test of walls fails for walls only.
inline StoreyResult storeyOf(const HandMadeCloud& cloud, bool withLabels = true, const WallParams& params = {},
                             double floor = 0.0, double ceiling = 2.6)
{
    const SurfaceCells cells = cellsOf(cloud, withLabels);
    StoreyResult result;
    result.level.floor_m = floor;
    result.level.ceiling_m = ceiling;
    result.level.ceilingSeen = true;
    result.level.ceilings = {ceiling};
    const Context context;
    const ElementId storey{1};
    std::uint32_t nextId = 2;
    const CellIndex index(cells, floor - 0.2, ceiling + 0.4);
    result.walls = findWalls(cells, index, result.level, storey, nextId, params, context);
    const CloudView view = cloud.view(withLabels);
    const Sightlines sightlines(view, 0.0, Eigen::Vector3d::Zero(), context);
    result.openings = findOpenings(cells, index, result.level, result.walls.walls,
                                   {OpeningKind::Door, OpeningKind::Window, OpeningKind::Plain}, nextId,
                                   OpeningParams{}, context, sightlines);
    result.columns =
        findColumns(cells, {&view, {}}, result.level, result.walls.walls, storey, nextId, ColumnParams{}, context);
    return result;
}

inline std::size_t countCode(const std::vector<Diagnostic>& diagnostics, std::string_view code)
{
    return static_cast<std::size_t>(
        std::count_if(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& d) { return d.code == code; }));
}

}  // namespace s2b::test

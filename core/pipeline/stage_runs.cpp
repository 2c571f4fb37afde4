// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/stage_runs.h"

#include "core/cloud/cell_index.h"
#include "core/cloud/clutter.h"
#include "core/columns/columns.h"
#include "core/openings/openings.h"
#include "core/slabs/slabs.h"
#include "core/spaces/spaces.h"
#include "core/walls/upper_storey.h"
#include "core/walls/walls.h"

#include <algorithm>
#include <format>

namespace s2b
{
namespace
{

std::set<OpeningKind> openingKinds(const std::set<Stage>& stages)
{
    std::set<OpeningKind> kinds;
    for (const auto& [stage, kind] :
         {std::pair(Stage::Doors, OpeningKind::Door), std::pair(Stage::Windows, OpeningKind::Window),
          std::pair(Stage::Openings, OpeningKind::Plain)})
        if (stages.contains(stage))
            kinds.insert(kind);
    return kinds;
}

}  // namespace

SurfaceCells surfaceCellsOf(const CloudView& cloud, const PipelineOptions& options, const Context& context)
{
    const Parameters& p = options.parameters;
    checkParameters(p);
    CloudView input = cloud;
    if (options.geometryOnly)
        input.labels = nullptr;
    if (input.count == 0)
        throw Error(ErrorCode::EmptyCloud, "the cloud has no points");
    context.report("Clutter", 0.0);
    const KeptRegion region = findDenseRegion(input, p.clutter, context);
    context.report("Surface cells", 0.1);
    return buildSurfaceCells(input, region, p.cells, context);
}

Storey storeyOf(const Level& level)
{
    Storey storey;
    storey.elevation_m = level.floor_m;
    storey.height = {level.ceiling_m - level.floor_m, level.ceilingSeen ? Provenance::Measured : Provenance::Assumed,
                     0.0};
    return storey;
}

StoreyRun runStorey(const SurfaceCells& cells, const StoreyTask& task, const PipelineOptions& options,
                    std::uint32_t& nextId, const Context& context)
{
    const Parameters& p = options.parameters;
    const Level& level = task.level;
    const auto fraction = [&](double within)
    { return task.fromFraction + (task.toFraction - task.fromFraction) * within; };
    const CellIndex index(cells, level.floor_m - 0.2, level.highestCeiling_m() + 0.4);
    StoreyRun run;
    std::vector<Diagnostic> wallDiagnostics;
    if (options.stages.contains(Stage::Walls))
    {
        context.report(std::format("Walls of {}", task.name), fraction(0.0));
        WallResult walls = findWalls(cells, index, level, task.storey, nextId, p.walls, context);
        if (const auto base = upperStoreyBase(walls.walls, level, index, p.levels.minimumRoomHeight_m))
        {
            Storey upper;
            upper.id = ElementId{nextId++};
            upper.elevation_m = *base;
            upper.height = {level.ceiling_m - *base, Provenance::Assumed, 0.0};
            divideWalls(walls.walls, walls.junctions, *base, upper.id, nextId);
            run.upper = upper;
            run.diagnostics.push_back({Severity::Warning, "levels", "StoreyFromWalls",
                                       "No floor of this storey was seen; walls that begin at its height show it.",
                                       upper.id, Eigen::Vector3d(0, 0, *base)});
        }
        run.walls = std::move(walls.walls);
        run.junctions = std::move(walls.junctions);
        wallDiagnostics = std::move(walls.diagnostics);
    }
    const std::vector<Wall>& walls = task.walls ? *task.walls : run.walls;
    if (const std::set<OpeningKind> kinds = openingKinds(options.stages); !kinds.empty())
    {
        context.report(std::format("Openings of {}", task.name), fraction(0.6));
        OpeningResult openings = findOpenings(cells, index, level, walls, kinds, nextId, p.openings, context);
        run.openings = std::move(openings.openings);
        append(run.diagnostics, std::move(openings.diagnostics));
    }
    append(run.diagnostics, std::move(wallDiagnostics));
    if (options.stages.contains(Stage::Columns))
    {
        context.report(std::format("Columns of {}", task.name), fraction(0.8));
        ColumnResult columns = findColumns(cells, task.columns, level, walls, task.storey, nextId, p.columns, context);
        run.columns = std::move(columns.columns);
        append(run.diagnostics, std::move(columns.diagnostics));
    }
    return run;
}

RoomsRun runRooms(const SurfaceCells& cells, const std::vector<Level>& levels, const std::vector<ElementId>& storeys,
                  const std::vector<Wall>& walls, const PipelineOptions& options, std::uint32_t& nextId,
                  const Context& context)
{
    RoomsRun run;
    if (!options.stages.contains(Stage::Slabs) && !options.stages.contains(Stage::Spaces))
        return run;
    context.report("Rooms", 0.92);
    const PlanCells plan = planCellsOf(cells);
    std::vector<RoomPlan> plans;
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
        std::vector<Wall> own;
        std::copy_if(walls.begin(), walls.end(), std::back_inserter(own),
                     [&](const Wall& w) { return w.storey == storeys[i]; });
        plans.push_back(planRooms(plan, levels[i], std::move(own), options.parameters.spaces, context));
    }
    if (options.stages.contains(Stage::Slabs))
    {
        context.report("Slabs", 0.95);
        SlabResult slabs = findSlabs(plan, plans, storeys, nextId, options.parameters.slabs, context);
        run.slabs = std::move(slabs.slabs);
        append(run.diagnostics, std::move(slabs.diagnostics));
    }
    if (options.stages.contains(Stage::Spaces))
    {
        context.report("Spaces", 0.98);
        for (std::size_t i = 0; i < plans.size(); ++i)
        {
            SpaceResult spaces = findSpaces(plans[i], storeys[i], i, nextId, options.parameters.spaces);
            append(run.spaces, std::move(spaces.spaces));
            append(run.diagnostics, std::move(spaces.diagnostics));
        }
    }
    return run;
}

}  // namespace s2b

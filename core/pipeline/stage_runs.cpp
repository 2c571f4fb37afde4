// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/stage_runs.h"

#include "core/base/parallel.h"
#include "core/cloud/cell_index.h"
#include "core/cloud/clutter.h"
#include "core/cloud/station_assignment.h"
#include "core/columns/columns.h"
#include "core/levels/given_levels.h"
#include "core/openings/openings.h"
#include "core/slabs/slabs.h"
#include "core/spaces/spaces.h"
#include "core/walls/upper_storey.h"
#include "core/walls/walls.h"

#include <algorithm>
#include <format>
#include <limits>

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

constexpr double kMostHidden = 0.5;  // of the points, from their stations

/// Moves the ids that a storey gave, those from `firstId` on, up.
void moveIds(StoreyRun& run, std::uint32_t firstId, std::uint32_t by)
{
    const auto move = [&](ElementId& id)
    {
        if (id.value >= firstId)
            id.value += by;
    };
    if (run.upper)
        move(run.upper->id);
    for (Wall& w : run.walls)
        move(w.id), move(w.storey);
    for (Junction& j : run.junctions)
        move(j.wallA), move(j.wallB);
    for (Opening& o : run.openings)
        move(o.id), move(o.host);
    for (Column& c : run.columns)
        move(c.id), move(c.storey);
    for (Diagnostic& d : run.diagnostics)
        move(d.element);
}

}  // namespace

LevelResult givenLevels(const std::vector<StoreyHeights>& given, double originZ_m, const LevelResult& found)
{
    std::vector<Storey> storeys;
    double last = -std::numeric_limits<double>::infinity();
    for (const StoreyHeights& heights : given)
    {
        if (!(heights.floor_m >= last) || !(heights.ceiling_m > heights.floor_m))
            throw Error(
                ErrorCode::BadParameter,
                std::format("the level from {} to {} m is not above the one before it, or its ceiling not above "
                            "its floor: give levels from the lowest to the highest",
                            heights.floor_m, heights.ceiling_m));
        last = heights.ceiling_m;
        Storey storey;
        storey.elevation_m = heights.floor_m - originZ_m;
        storey.height = {heights.ceiling_m - heights.floor_m,
                         heights.ceilingSeen ? Provenance::Corrected : Provenance::Assumed, 0.0};
        storeys.push_back(storey);
    }
    return {levelsOf(storeys, found.levels), {}};
}

StationInput stationsOf(const CloudView& cloud, const Context& context)
{
    StationInput result;
    result.view = cloud.stations;
    if (cloud.stations.positions.size() > 1 && !cloud.stations.ofPoint)
    {
        result.ofPoint = nearestVisibleStations(cloud, context);
        result.view.ofPoint = result.ofPoint.data();
    }
    else if (!cloud.stations.empty() && hiddenShare(cloud, context) > kMostHidden)
    {
        result.view = {};
        result.diagnostics.push_back({Severity::Warning,
                                      "stations",
                                      "StationsContradict",
                                      "Most points could not be seen from the stations that they name (other points "
                                      "are in between); the stations were not used.",
                                      {},
                                      {}});
    }
    return result;
}

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

CellIndex indexOf(const SurfaceCells& cells, const Level& level)
{
    return {cells, level.floor_m - 0.2, level.highestCeiling_m() + 0.4};
}

StoreyRun runStorey(const SurfaceCells& cells, const StoreyTask& task, const PipelineOptions& options,
                    std::uint32_t& nextId, const Context& context)
{
    const Parameters& p = options.parameters;
    const Level& level = task.level;
    const auto fraction = [&](double within)
    { return task.fromFraction + (task.toFraction - task.fromFraction) * within; };
    std::optional<CellIndex> own;
    const CellIndex& index = task.index ? *task.index : own.emplace(indexOf(cells, level));
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
        const Sightlines none;
        OpeningResult openings = findOpenings(cells, index, level, walls, kinds, nextId, p.openings, context,
                                              task.sightlines ? *task.sightlines : none);
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

std::vector<StoreyRun> runStoreys(const SurfaceCells& cells, const std::vector<StoreyTask>& tasks,
                                  const PipelineOptions& options, std::uint32_t& nextId, const Context& context)
{
    std::vector<StoreyRun> runs;
    if (tasks.size() < 2 || context.threads == 1)
    {
        for (const StoreyTask& task : tasks)
            runs.push_back(runStorey(cells, task, options, nextId, context));
        return runs;
    }
    context.report("Walls, openings, columns", tasks.front().fromFraction);
    Context silent = context;  // progress and messages are for the thread that runs the pipeline
    silent.progress = nullptr;
    silent.log = nullptr;
    const std::uint32_t firstId = nextId;
    std::vector<std::uint32_t> lastId(tasks.size(), firstId);
    runs.resize(tasks.size());
    parallelChunks(tasks.size(), 1, context, [&](std::size_t i, std::size_t)
                   { runs[i] = runStorey(cells, tasks[i], options, lastId[i], silent); });
    context.checkCancelled();
    for (std::size_t i = 0; i < runs.size(); ++i)
    {
        moveIds(runs[i], firstId, nextId - firstId);
        nextId += lastId[i] - firstId;
    }
    return runs;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/pipeline.h"

#include "core/cloud/frame.h"
#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"
#include "core/pipeline/stage_runs.h"

#include <algorithm>
#include <format>

namespace s2b
{
namespace
{

/// Moves cells and levels so that the lowest floor is at z = 0; returns by how much it was above.
double liftToLowestFloor(SurfaceCells& cells, LevelResult& levels)
{
    const double lowest = levels.levels.front().floor_m;
    cells.lowestLayer_m -= lowest;
    for (SurfaceCell& c : cells.cells)
        c.position.z() = static_cast<float>(static_cast<double>(c.position.z()) - lowest);
    for (Level& l : levels.levels)
    {
        l.floor_m -= lowest, l.ceiling_m -= lowest, l.ceilingLimit_m -= lowest;
        for (double& c : l.ceilings)
            c -= lowest;
    }
    for (Diagnostic& d : levels.diagnostics)
        d.location.z() -= lowest;
    return lowest;
}

}  // namespace

Building reconstruct(const CloudView& cloud, const PipelineOptions& options, const Context& context)
{
    const Parameters& p = options.parameters;
    StationInput stations = stationsOf(cloud, context);
    CloudView input = cloud;
    input.stations = stations.view;
    SurfaceCells cells = surfaceCellsOf(input, options, context);
    context.report("Building frame", 0.5);
    const double yaw = findDominantYaw(cells, p.frame, context);
    rotateCells(cells, yaw);

    Building building;
    building.frame.yaw_rad = yaw;
    building.frame.origin = cloud.origin;
    append(building.diagnostics, std::move(stations.diagnostics));
    std::uint32_t nextId = 1;

    context.report("Levels", 0.55);
    LevelResult levels = findLevels(cells, p.levels, context);
    if (!options.levels.empty())
        levels = givenLevels(options.levels, cloud.origin.z(), levels);
    if (!levels.levels.empty())
        building.frame.origin.z() += liftToLowestFloor(cells, levels);
    append(building.diagnostics, std::move(levels.diagnostics));
    std::vector<ElementId> storeys;
    for (std::size_t i = 0; i < levels.levels.size(); ++i)
    {
        Storey storey = storeyOf(levels.levels[i]);
        storey.id = ElementId{nextId++};
        storey.name = std::format("Level {}", i);
        storeys.push_back(storey.id);
        if (!options.levels.empty() && levels.levels[i].ceilingSeen)
            storey.height.provenance = Provenance::Corrected;
        building.storeys.push_back(storey);
    }

    std::vector<Storey> wallStoreys;  // that show in walls alone
    const double share = 0.32 / static_cast<double>(std::max<std::size_t>(1, levels.levels.size()));
    const Sightlines sightlines(input, yaw, Eigen::Vector3d(0, 0, cloud.origin.z() - building.frame.origin.z()),
                                context);
    std::vector<StoreyTask> tasks;
    for (std::size_t i = 0; i < levels.levels.size(); ++i)
    {
        const double from = 0.6 + share * static_cast<double>(i);
        tasks.push_back({levels.levels[i],
                         storeys[i],
                         building.storeys[i].name,
                         nullptr,
                         from,
                         from + share,
                         {&cloud, building.frame},
                         &sightlines});
    }
    std::vector<StoreyRun> runs = runStoreys(cells, tasks, options, nextId, context);
    for (StoreyRun& run : runs)
    {
        if (run.upper)
            wallStoreys.push_back(*run.upper);
        append(building.walls, std::move(run.walls));
        append(building.junctions, std::move(run.junctions));
        append(building.openings, std::move(run.openings));
        append(building.columns, std::move(run.columns));
        append(building.diagnostics, std::move(run.diagnostics));
    }
    RoomsRun rooms = runRooms(cells, levels.levels, storeys, building.walls, options, nextId, context);
    append(building.slabs, std::move(rooms.slabs));
    append(building.spaces, std::move(rooms.spaces));
    append(building.diagnostics, std::move(rooms.diagnostics));
    building.storeys.insert(building.storeys.end(), wallStoreys.begin(), wallStoreys.end());
    std::stable_sort(building.storeys.begin(), building.storeys.end(),
                     [](const Storey& a, const Storey& b) { return a.elevation_m < b.elevation_m; });
    for (std::size_t i = 0; i < building.storeys.size(); ++i)
        building.storeys[i].name = std::format("Level {}", i);
    context.checkCancelled();  // also of a request made in the last step
    return building;
}

}  // namespace s2b

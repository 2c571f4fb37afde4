// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/pipeline.h"

#include "core/cloud/cell_index.h"
#include "core/cloud/clutter.h"
#include "core/cloud/frame.h"
#include "core/cloud/surface_cells.h"
#include "core/columns/columns.h"
#include "core/levels/levels.h"
#include "core/openings/openings.h"
#include "core/slabs/slabs.h"
#include "core/spaces/spaces.h"
#include "core/walls/upper_storey.h"
#include "core/walls/walls.h"

#include <algorithm>
#include <format>
#include <iterator>

namespace s2b
{
namespace
{

template <typename T>
void append(std::vector<T>& to, std::vector<T>&& from)
{
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// Slabs and spaces of all storeys, from their walls.
void addRooms(const SurfaceCells& cells, const std::vector<Level>& levels, const PipelineOptions& options,
              std::uint32_t& nextId, Building& building, const Context& context)
{
    if (!options.stages.contains(Stage::Slabs) && !options.stages.contains(Stage::Spaces))
        return;
    context.report("Rooms", 0.92);
    const PlanCells plan = planCellsOf(cells);
    std::vector<RoomPlan> plans;
    std::vector<ElementId> storeys;
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
        storeys.push_back(building.storeys[i].id);
        std::vector<Wall> walls;
        std::copy_if(building.walls.begin(), building.walls.end(), std::back_inserter(walls),
                     [&](const Wall& w) { return w.storey == storeys.back(); });
        plans.push_back(planRooms(plan, levels[i], std::move(walls), options.parameters.spaces, context));
    }
    if (options.stages.contains(Stage::Slabs))
    {
        context.report("Slabs", 0.95);
        SlabResult slabs = findSlabs(plan, plans, storeys, nextId, options.parameters.slabs, context);
        append(building.slabs, std::move(slabs.slabs));
        append(building.diagnostics, std::move(slabs.diagnostics));
    }
    if (options.stages.contains(Stage::Spaces))
    {
        context.report("Spaces", 0.98);
        for (std::size_t i = 0; i < plans.size(); ++i)
        {
            SpaceResult spaces = findSpaces(plans[i], storeys[i], i, nextId, options.parameters.spaces);
            append(building.spaces, std::move(spaces.spaces));
            append(building.diagnostics, std::move(spaces.diagnostics));
        }
    }
}

/// Moves cells and levels so that the lowest floor is at z = 0; returns by how much it was above.
double liftToLowestFloor(SurfaceCells& cells, LevelResult& levels)
{
    const double lowest = levels.levels.front().floor_m;
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
    checkParameters(p);
    CloudView input = cloud;
    if (options.geometryOnly)
        input.labels = nullptr;
    if (input.count == 0)
        throw Error(ErrorCode::EmptyCloud, "the cloud has no points");

    context.report("Clutter", 0.0);
    const KeptRegion region = findDenseRegion(input, p.clutter, context);
    context.report("Surface cells", 0.1);
    SurfaceCells cells = buildSurfaceCells(input, region, p.cells, context);
    context.report("Building frame", 0.5);
    const double yaw = findDominantYaw(cells, p.frame);
    rotateCells(cells, yaw);

    Building building;
    building.frame.yaw_rad = yaw;
    building.frame.origin = input.origin;
    std::uint32_t nextId = 1;

    context.report("Levels", 0.55);
    LevelResult levels = findLevels(cells, p.levels, context);
    if (!levels.levels.empty())
        building.frame.origin.z() += liftToLowestFloor(cells, levels);
    append(building.diagnostics, std::move(levels.diagnostics));
    for (std::size_t i = 0; i < levels.levels.size(); ++i)
    {
        const Level& level = levels.levels[i];
        Storey storey;
        storey.id = ElementId{nextId++};
        storey.name = std::format("Level {}", i);
        storey.elevation_m = level.floor_m;
        storey.height = {level.ceiling_m - level.floor_m,
                         level.ceilingSeen ? Provenance::Measured : Provenance::Assumed, 0.0};
        building.storeys.push_back(storey);
    }

    std::vector<Storey> wallStoreys;  // that show in walls alone
    for (std::size_t i = 0; i < levels.levels.size(); ++i)
    {
        const Level& level = levels.levels[i];
        const ElementId storey = building.storeys[i].id;
        const auto stageFraction = [&](double within)
        { return 0.6 + 0.32 * (static_cast<double>(i) + within) / static_cast<double>(levels.levels.size()); };
        std::vector<Wall> storeyWalls;
        if (options.stages.contains(Stage::Walls))
        {
            context.report(std::format("Walls of {}", building.storeys[i].name), stageFraction(0.0));
            const CellIndex index(cells, level.floor_m - 0.2, level.highestCeiling_m() + 0.4);
            WallResult walls = findWalls(cells, index, level, storey, nextId, p.walls, context);
            if (const auto base = upperStoreyBase(walls.walls, level, index, p.levels.minimumRoomHeight_m))
            {
                Storey upper;
                upper.id = ElementId{nextId++};
                upper.elevation_m = *base;
                upper.height = {level.ceiling_m - *base, Provenance::Assumed, 0.0};
                divideWalls(walls.walls, walls.junctions, *base, upper.id, nextId);
                wallStoreys.push_back(upper);
                building.diagnostics.push_back(
                    {Severity::Warning, "levels", "StoreyFromWalls",
                     "No floor of this storey was seen; walls that begin at its height show it.", upper.id,
                     Eigen::Vector3d(0, 0, *base)});
            }
            std::set<OpeningKind> kinds;
            for (const auto& [stage, kind] :
                 {std::pair(Stage::Doors, OpeningKind::Door), std::pair(Stage::Windows, OpeningKind::Window),
                  std::pair(Stage::Openings, OpeningKind::Plain)})
                if (options.stages.contains(stage))
                    kinds.insert(kind);
            if (!kinds.empty())
            {
                context.report(std::format("Openings of {}", building.storeys[i].name), stageFraction(0.6));
                OpeningResult openings =
                    findOpenings(cells, index, level, walls.walls, kinds, nextId, p.openings, context);
                append(building.openings, std::move(openings.openings));
                append(building.diagnostics, std::move(openings.diagnostics));
            }
            storeyWalls = walls.walls;
            append(building.walls, std::move(walls.walls));
            append(building.junctions, std::move(walls.junctions));
            append(building.diagnostics, std::move(walls.diagnostics));
        }
        if (options.stages.contains(Stage::Columns))
        {
            context.report(std::format("Columns of {}", building.storeys[i].name), stageFraction(0.8));
            ColumnResult columns = findColumns(cells, level, storeyWalls, storey, nextId, p.columns, context);
            append(building.columns, std::move(columns.columns));
            append(building.diagnostics, std::move(columns.diagnostics));
        }
    }
    addRooms(cells, levels.levels, options, nextId, building, context);
    building.storeys.insert(building.storeys.end(), wallStoreys.begin(), wallStoreys.end());
    std::stable_sort(building.storeys.begin(), building.storeys.end(),
                     [](const Storey& a, const Storey& b) { return a.elevation_m < b.elevation_m; });
    for (std::size_t i = 0; i < building.storeys.size(); ++i)
        building.storeys[i].name = std::format("Level {}", i);
    context.checkCancelled();  // also of a request made in the last step
    return building;
}

}  // namespace s2b

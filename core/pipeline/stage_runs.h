// SPDX-License-Identifier: GPL-3.0-or-later
/// The stages of one storey, and of all rooms: what a whole reconstruction and a run of single stages share.
#pragma once

#include "core/cloud/cell_index.h"
#include "core/cloud/sightlines.h"
#include "core/cloud/surface_cells.h"
#include "core/columns/columns.h"
#include "core/levels/levels.h"
#include "core/pipeline/pipeline.h"

#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace s2b
{

template <typename T>
void append(std::vector<T>& to, std::vector<T>&& from)
{
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// What is known of a cloud's stations, as the stages use it.
struct StationInput
{
    StationView view;  ///< of `ofPoint`, or the cloud's own; empty when they contradict the points
    std::vector<std::uint16_t> ofPoint;
    std::vector<Diagnostic> diagnostics;
};

/// Gives the points their stations where the cloud does not say them, and looks whether it can be true what it says.
[[nodiscard]] StationInput stationsOf(const CloudView& cloud, const Context& context);

/// The storey of a level, without an id or a name.
[[nodiscard]] Storey storeyOf(const Level& level);

/// The levels that a person gave, with what was found at the same heights.
/// @param originZ_m  world z of the cells' zero
/// @throws Error{BadParameter} when they are not ascending, or one has its ceiling below its floor
[[nodiscard]] LevelResult givenLevels(const std::vector<StoreyHeights>& given, double originZ_m,
                                      const LevelResult& found);

/// The cells of a cloud without clutter, about the cloud's origin.
[[nodiscard]] SurfaceCells surfaceCellsOf(const CloudView& cloud, const PipelineOptions& options,
                                          const Context& context);

/// The cells that a storey's stages look up by place, and what settles classes after them.
[[nodiscard]] CellIndex indexOf(const SurfaceCells& cells, const Level& level);

struct StoreyTask
{
    const Level& level;
    ElementId storey;
    std::string name;                             ///< for the progress
    const std::vector<Wall>* walls = nullptr;     ///< given ones; null: found by the stage Walls, or none
    double fromFraction = 0.0, toFraction = 1.0;  ///< of the progress
    ColumnSource columns{};                       ///< the points themselves, for the sections of columns
    const Sightlines* sightlines = nullptr;       ///< null: none are known
    const CellIndex* index = nullptr;             ///< indexOf the level; null: made by the run
};

struct StoreyRun
{
    std::vector<Wall> walls;  ///< found ones only
    std::vector<Junction> junctions;
    std::vector<Opening> openings;
    std::vector<Column> columns;
    std::vector<Diagnostic> diagnostics;
    std::optional<Storey> upper;  ///< that shows in the walls alone
};

/// Runs the stages Walls, Doors, Windows, Openings and Columns, as far as they are asked for, on one storey.
/// @param nextId  the next free ElementId value; advanced
[[nodiscard]] StoreyRun runStorey(const SurfaceCells& cells, const StoreyTask& task, const PipelineOptions& options,
                                  std::uint32_t& nextId, const Context& context);

/// Runs them on several storeys side by side, each on its own: the same result, ids included, as one after another.
/// @param tasks  of which none has given walls
[[nodiscard]] std::vector<StoreyRun> runStoreys(const SurfaceCells& cells, const std::vector<StoreyTask>& tasks,
                                                const PipelineOptions& options, std::uint32_t& nextId,
                                                const Context& context);

struct RoomsRun
{
    std::vector<Slab> slabs;
    std::vector<Space> spaces;
    std::vector<Diagnostic> diagnostics;
};

/// Runs the stages Slabs and Spaces, as far as they are asked for, on all storeys.
/// @param storeys  of the levels, in the same order
/// @param walls    of all storeys
[[nodiscard]] RoomsRun runRooms(const SurfaceCells& cells, const std::vector<Level>& levels,
                                const std::vector<ElementId>& storeys, const std::vector<Wall>& walls,
                                const PipelineOptions& options, std::uint32_t& nextId, const Context& context);

}  // namespace s2b

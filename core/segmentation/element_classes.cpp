// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/element_classes.h"

#include "core/base/parallel.h"
#include "core/cloud/cell_index.h"
#include "core/cloud/cell_moments.h"
#include "core/geometry/polygon.h"
#include "core/model/wall_axis.h"
#include "core/pipeline/stage_runs.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace s2b
{
namespace
{

constexpr std::uint8_t kByElement = 170;        // confidence of a class that the model did not see
constexpr double kOnFace_m = 0.03;              // from a wall's face or a column's outline
constexpr double kBesideFaces_m = 0.06;         // that a frame or a leaf stands out of the wall
constexpr double kReveal_m = 0.04;              // from the edge of an opening
constexpr double kCasing_m = 0.10;              // around an opening, where a frame may cover the wall
constexpr double kAlong = 0.7, kAcross = 0.85;  // of a unit normal

struct Hole
{
    double from_m = 0.0, to_m = 0.0, low_m = 0.0, high_m = 0.0;  ///< along the axis, and z
    Label label = Label::Unassigned;
};

void give(CellClass& c, Label label)
{
    if (c.label == label)
        c.confidence = std::max(c.confidence, kByElement);
    else
        c = {label, kByElement};
}

bool isPartOfShell(Label label)
{
    return label == Label::Floor || label == Label::Ceiling || label == Label::Roof || label == Label::Stair ||
           label == Label::Beam;
}

void settleWall(const Wall& wall, const std::vector<Hole>& holes, const SurfaceCells& cells, const CellIndex& index,
                std::vector<CellClass>& classes)
{
    const WallAxis axis(wall);
    const double half = wall.thickness.value_m / 2, reach = half + kBesideFaces_m;
    const double beside = wall.bulge == 0.0 ? 0.0 : std::abs(axis.project((wall.start + wall.end) / 2).y());
    const double top = wall.base_m + wall.height.value_m;
    index.near(wall.start, wall.end, reach + beside,
               [&](const SurfaceCell& cell)
               {
                   CellClass& c = classes[static_cast<std::size_t>(&cell - cells.cells.data())];
                   const Eigen::Vector2d p = axis.project(cell.position.head<2>().cast<double>());
                   const double s = p.x(), d = std::abs(p.y()), z = static_cast<double>(cell.position.z());
                   if (d > reach || s < wall.bodyStart_m || s > wall.bodyEnd_m || z < wall.base_m || z > top)
                       return;
                   const Eigen::Vector2d m = cell.normal.head<2>().cast<double>();
                   const double along = std::abs(axis.direction(s).dot(m)), across = std::abs(axis.normal(s).dot(m));
                   const double up = std::abs(static_cast<double>(cell.normal.z()));
                   for (const Hole& h : holes)
                   {
                       if (s < h.from_m || s > h.to_m || z < h.low_m || z > h.high_m)
                           continue;
                       const bool isJamb = along > kAlong && std::min(s - h.from_m, h.to_m - s) < kReveal_m;
                       const bool isSillOrHead = up > kAlong && std::min(z - h.low_m, h.high_m - z) < kReveal_m;
                       if (h.label != Label::Unassigned && !isJamb && !isSillOrHead && !isPartOfShell(c.label))
                           give(c, h.label);
                       return;
                   }
                   const bool isCasing = std::ranges::any_of(
                       holes,
                       [&](const Hole& h)
                       {
                           return c.label == h.label && s > h.from_m - kCasing_m && s < h.to_m + kCasing_m &&
                                  z > h.low_m - kCasing_m && z < h.high_m + kCasing_m;
                       });
                   if (across > kAcross && std::abs(d - half) < kOnFace_m && !isPartOfShell(c.label) && !isCasing)
                       give(c, Label::Wall);
               });
}

void settleColumn(const Column& column, const SurfaceCells& cells, const CellIndex& index,
                  std::vector<CellClass>& classes)
{
    const std::vector<Eigen::Vector2d> outline = column.outline();
    double radius = 0.0;
    for (const Eigen::Vector2d& p : outline)
        radius = std::max(radius, (p - column.center).norm());
    const auto isOnOutline = [&](const Eigen::Vector2d& p)
    {
        for (std::size_t i = 0; i < outline.size(); ++i)
        {
            const Eigen::Vector2d &a = outline[i], b = outline[(i + 1) % outline.size()];
            const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
            if ((a + t * (b - a) - p).norm() < kOnFace_m)
                return true;
        }
        return false;
    };
    index.near(column.center, column.center, radius + kOnFace_m,
               [&](const SurfaceCell& cell)
               {
                   CellClass& c = classes[static_cast<std::size_t>(&cell - cells.cells.data())];
                   const double z = static_cast<double>(cell.position.z());
                   if (z > column.base_m && z < column.base_m + column.height.value_m && !isPartOfShell(c.label) &&
                       isOnOutline(cell.position.head<2>().cast<double>()))
                       give(c, Label::Column);
               });
}

std::vector<Hole> holesOf(const Wall& wall, const std::vector<Opening>& openings)
{
    std::vector<Hole> holes;
    for (const Opening& o : openings)
        if (o.host == wall.id)
        {
            const double low = wall.base_m + o.sill.value_m;
            holes.push_back({o.offset_m, o.offset_m + o.width.value_m, low, low + o.height.value_m,
                             o.kind == OpeningKind::Door     ? Label::Door
                             : o.kind == OpeningKind::Window ? Label::Window
                                                             : Label::Unassigned});
        }
    return holes;
}

}  // namespace

void settleByElements(SurfaceCells cells, const std::vector<Level>& levels, std::vector<CellClass>& classes,
                      const Context& context)
{
    cells.hasLabels = cells.hasGuesses = true;
    for (std::size_t i = 0; i < classes.size(); ++i)
    {
        cells.cells[i].labelShare = classes[i].confidence;
        cells.cells[i].label = classes[i].confidence < kLeastGuess ? Label::Unassigned : classes[i].label;
    }
    PipelineOptions options;
    options.stages = {Stage::Levels, Stage::Walls, Stage::Doors, Stage::Windows, Stage::Openings, Stage::Columns};
    std::vector<StoreyTask> tasks;
    std::uint32_t nextId = 1;
    std::vector<std::optional<CellIndex>> indices(levels.size());
    parallelChunks(levels.size(), 1, context,
                   [&](std::size_t i, std::size_t) { indices[i].emplace(indexOf(cells, levels[i])); });
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
        tasks.push_back({levels[i], ElementId{nextId++}, "the storey"});
        tasks.back().index = &*indices[i];
    }
    Context silent = context;  // of progress: the segmentation tells its own
    silent.progress = nullptr;
    const std::vector<StoreyRun> runs = runStoreys(cells, tasks, options, nextId, silent);
    for (std::size_t i = 0; i < runs.size(); ++i)
    {
        for (const Wall& wall : runs[i].walls)
            settleWall(wall, holesOf(wall, runs[i].openings), cells, *indices[i], classes);
        for (const Column& column : runs[i].columns)
            settleColumn(column, cells, *indices[i], classes);
    }
}

}  // namespace s2b

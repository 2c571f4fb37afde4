// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/report.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/save_file.h"
#include "core/report/bcf.h"
#include "core/report/csv.h"
#include "core/report/html.h"
#include "core/report/json.h"
#include "core/report/plan_view.h"
#include "core/report/rasters.h"
#include "core/report/scene.h"
#include "core/report/snapshot.h"

#include <algorithm>
#include <iterator>

namespace s2b::report
{
using namespace validation;
namespace
{

constexpr std::size_t kWorstWalls = 12;  ///< whose faces the page shows

/// The walls whose faces are spread out: the worst of all, and those that an issue is made of.
std::vector<bool> chooseWalls(const Scene& scene)
{
    std::vector<bool> isChosen(scene.rows.size(), false);
    std::size_t count = 0;
    for (std::size_t i = 0; i < scene.rows.size(); ++i)
    {
        const Row& row = scene.rows[i];
        if (row.pair.elementClass != ElementClass::Wall || !row.result || !row.toResult || row.toResult->points == 0)
            continue;
        isChosen[i] = count < kWorstWalls || row.verdict == Verdict::OutOfTolerance;
        count += isChosen[i] ? 1 : 0;
    }
    return isChosen;
}

struct Pictures
{
    Drawings drawings;
    std::vector<std::pair<std::size_t, Drawing>> walls;  ///< by row
    std::map<std::size_t, std::string> snapshots;        ///< by row
};

void drawLevel(const ReportInput& input, const Scene& scene, const Level& level, const std::vector<bool>& isChosen,
               Pictures& pictures, const Context& context)
{
    const bool isSeen = std::any_of(level.rows.begin(), level.rows.end(),
                                    [&](std::size_t i) { return scene.rows[i].style != Style::NotSeen; });
    if (!isSeen)
    {
        if (!level.rows.empty())
            pictures.drawings.unseen.push_back(level.name);
        return;
    }
    std::vector<WallFaces> walls;
    for (const std::size_t i : level.rows)
    {
        if (!isChosen[i])
            continue;
        if (WallFaces faces = wallFaces(scene, i); faces.row >= 0)
            walls.push_back(std::move(faces));
    }
    const StoreyRasters rasters = rasterize(input, scene, level, walls, context);
    pictures.drawings.plans.push_back(drawPlan(scene, level, rasters));
    for (const bool isFloor : {false, true})
        pictures.drawings.deviations.push_back(drawDeviations(scene, level, rasters, isFloor));
    for (const WallFaces& wall : walls)
        pictures.walls.emplace_back(static_cast<std::size_t>(wall.row), drawWall(scene, wall));
    std::vector<std::size_t> issues;
    std::copy_if(level.rows.begin(), level.rows.end(), std::back_inserter(issues),
                 [&](std::size_t i) { return scene.rows[i].verdict == Verdict::OutOfTolerance; });
    std::vector<std::string> snapshots(issues.size());
    parallelChunks(issues.size(), 1, context,
                   [&](std::size_t begin, std::size_t)
                   {
                       const std::size_t row = issues[begin];
                       const auto wall = std::find_if(walls.begin(), walls.end(), [&](const WallFaces& w)
                                                      { return w.row == static_cast<int>(row); });
                       snapshots[begin] = encodePng(
                           drawSnapshot(scene, scene.rows[row], rasters, wall == walls.end() ? nullptr : &*wall));
                   });
    for (std::size_t i = 0; i < issues.size(); ++i)
        pictures.snapshots[issues[i]] = std::move(snapshots[i]);
}

}  // namespace

void writeReport(const ReportInput& input, const std::string& folder, const Context& context)
{
    if (!input.result || !input.validation || !input.params)
        throw Error(ErrorCode::Internal, "a report needs a result, its validation and the parameters of it");
    context.report("Drawing the report", 0.0);
    const Scene scene = makeScene(input);
    const std::vector<bool> isChosen = chooseWalls(scene);
    Pictures pictures;
    for (std::size_t i = 0; i < scene.levels.size(); ++i)
    {
        context.report("Drawing the report", 0.9 * static_cast<double>(i) / static_cast<double>(scene.levels.size()));
        drawLevel(input, scene, scene.levels[i], isChosen, pictures, context);
    }
    std::sort(pictures.walls.begin(), pictures.walls.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < std::min(kWorstWalls, pictures.walls.size()); ++i)
        pictures.drawings.walls.push_back(std::move(pictures.walls[i].second));

    const std::vector<std::pair<std::string, std::string>> files{
        {"report.html", makeHtml(input, scene, pictures.drawings)},
        {"report.json", makeJson(input, scene)},
        {"elements.csv", makeCsv(scene)},
        {"issues.bcf", makeBcf(input, scene, pictures.snapshots)},
    };
    context.report("Writing the report", 0.95);
    saveFiles(folder, files);
}

}  // namespace s2b::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/level_survey.h"

#include "core/cloud/frame.h"
#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"
#include "core/pipeline/stage_runs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace s2b
{

namespace
{

constexpr float kHorizontal = 0.95f;  // |z| of the unit normal, as the levels ask for

HeightProfile profileOf(const SurfaceCells& cells, double bin_m, double originZ)
{
    float low = std::numeric_limits<float>::infinity(), high = -low;
    for (const SurfaceCell& c : cells.cells)
        low = std::min(low, c.position.z()), high = std::max(high, c.position.z());
    HeightProfile profile;
    profile.bin_m = bin_m;
    if (cells.cells.empty())
        return profile;
    // Bins begin at whole multiples of their height: the profile does not jump with a stray lowest point.
    profile.low_m = bin_m * std::floor((static_cast<double>(low) + originZ) / bin_m);
    const double span = static_cast<double>(high) + originZ - profile.low_m;
    profile.area_m2.assign(static_cast<std::size_t>(span / bin_m) + 1, 0.0);
    const double area = cells.size_m * cells.size_m;
    for (const SurfaceCell& c : cells.cells)
    {
        if (std::abs(c.normal.z()) < kHorizontal)
            continue;
        const double at = (static_cast<double>(c.position.z()) + originZ - profile.low_m) / bin_m;
        profile.area_m2[std::min(profile.area_m2.size() - 1, static_cast<std::size_t>(std::max(0.0, at)))] += area;
    }
    return profile;
}

}  // namespace

LevelSurvey surveyLevels(const CloudView& cloud, const PipelineOptions& options, const Context& context)
{
    const Parameters& p = options.parameters;
    SurfaceCells cells = surfaceCellsOf(cloud, options, context);
    context.report("Levels", 0.9);
    rotateCells(cells, findDominantYaw(cells, p.frame, context));  // the plan columns of the levels follow the walls

    LevelSurvey survey;
    survey.profile = profileOf(cells, p.levels.binSize_m, cloud.origin.z());
    for (const Level& level : findLevels(cells, p.levels, context).levels)
        survey.storeys.push_back(
            {level.floor_m + cloud.origin.z(), level.ceiling_m + cloud.origin.z(), level.ceilingSeen});
    context.checkCancelled();
    return survey;
}

}  // namespace s2b

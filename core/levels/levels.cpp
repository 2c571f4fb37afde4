// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/levels/levels.h"

#include "core/levels/column_surfaces.h"
#include "core/levels/height_histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace s2b
{
namespace
{

constexpr double kSlab_m = 0.8;         // thickest slab with its finishes
constexpr double kSameFloor_m = 0.5;    // floors closer than this are steps of one
constexpr double kCeilingShare = 0.08;  // of the floor, that a further (suspended, stepped) ceiling covers at least

/// Floor and ceiling above each other in one column.
struct Pair
{
    double floor = 0, ceiling = 0;
    bool ceilingLevel = false;
};

/// What the columns say of floors.
struct FloorSurvey
{
    FloorSurvey(double lowest, double highest, double column_m2, const LevelParams& params)
        : low(lowest),
          high(highest),
          columnArea_m2(column_m2),
          covered(low, high, params.binSize_m),
          open(low, high, params.binSize_m)
    {
    }

    double low, high;  ///< of all surfaces
    double columnArea_m2;
    HeightHistogram covered, open;  ///< area of floors with and without a ceiling above
    std::vector<Pair> pairs;
    std::vector<double> heights;  ///< of all these floors
};

/// In each column: which surface is a floor with room above it, and what is above.
FloorSurvey surveyFloors(const std::vector<ColumnSurface>& surfaces, double columnArea_m2, const LevelParams& params)
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const ColumnSurface& s : surfaces)
        low = std::min(low, s.z), high = std::max(high, s.z);
    FloorSurvey survey(low, high, columnArea_m2, params);
    for (std::size_t i = 0; i < surfaces.size(); ++i)
    {
        const ColumnSurface& s = surfaces[i];
        if (!s.isLevel || !s.maybeFloor)
            continue;
        // A slab's underside: right above it is a surface with room above that.
        if (i + 2 < surfaces.size() && sameColumn(surfaces[i + 1], s) && surfaces[i + 1].isLevel &&
            surfaces[i + 1].z - s.z < kSlab_m && sameColumn(surfaces[i + 2], s) &&
            surfaces[i + 2].z - surfaces[i + 1].z >= params.minimumRoomHeight_m)
            continue;
        // The next surface that may be a ceiling (furniture above the floor is not one).
        std::size_t j = i + 1;
        while (j < surfaces.size() && sameColumn(surfaces[j], s) &&
               (surfaces[j].z - s.z < params.minimumRoomHeight_m || !surfaces[j].maybeCeiling))
            ++j;
        const bool covered =
            j < surfaces.size() && sameColumn(surfaces[j], s) && surfaces[j].z - s.z <= params.maximumRoomHeight_m;
        if (covered)
        {
            survey.covered.add(s.z, columnArea_m2);
            survey.pairs.push_back({s.z, surfaces[j].z, surfaces[j].isLevel});
        }
        else
            survey.open.add(s.z, columnArea_m2);
        survey.heights.push_back(s.z);
    }
    return survey;
}

/// Height below which 98 % of the vertical surfaces above `floor` and below `limit` lie.
double topOfVerticalSurfaces(const SurfaceCells& cells, double floor, double limit)
{
    std::vector<float> z;
    for (const SurfaceCell& c : cells.cells)
        if (!c.normal.isZero() && std::abs(c.normal.z()) < 0.3f && c.position.z() > floor && c.position.z() < limit &&
            (!cells.labelsAreSure() || c.label == Label::Wall))
            z.push_back(c.position.z());
    if (z.empty())
        return std::min(limit, floor + 2.5);
    const auto at = z.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(z.size() - 1) * 0.98);
    std::nth_element(z.begin(), at, z.end());
    return static_cast<double>(*at);
}

/// Area of upright surfaces between two heights [m2].
double verticalArea(const SurfaceCells& cells, double low, double high)
{
    std::size_t count = 0;
    for (const SurfaceCell& c : cells.cells)
        count += !c.normal.isZero() && std::abs(c.normal.z()) < 0.3f && c.position.z() > low && c.position.z() < high;
    return static_cast<double>(count) * cells.size_m * cells.size_m;
}

/// Is there another floor within a slab's thickness above? Then the surface below it is a ceiling.
bool hasFloorAbove(const std::vector<HeightPeak>& floors, const HeightPeak& p)
{
    return std::any_of(floors.begin(), floors.end(), [&](const HeightPeak& q)
                       { return q.z > p.z + kMergeZ_m && q.z < p.z + kSlab_m && q.area > 0.3 * p.area; });
}

/// Where no ceiling was seen, the ground around a house is the largest surface; its floor lies a step above.
void raiseAboveTerrain(std::vector<HeightPeak>& peaks, const HeightHistogram& openFloors)
{
    constexpr double lowest_m = 0.10, highest_m = 0.45, leastShare = 0.05;
    const std::vector<HeightPeak> all = peaksOf(openFloors, 0.09);
    for (HeightPeak& p : peaks)
    {
        const double terrain = p.z, area = p.area;
        for (const HeightPeak& q : all)
            if (const double step = q.z - terrain; step > lowest_m && step < highest_m && q.area > leastShare * area &&
                                                   (p.z == terrain || q.area > p.area))
                p = q;
    }
}

/// Floors under a ceiling, the largest first: for the most part a floor lies so, terrain under trees and eaves only.
std::vector<HeightPeak> coveredFloors(const SurfaceCells& cells, const FloorSurvey& survey)
{
    std::vector<HeightPeak> peaks = peaksOf(survey.covered, 0.12);
    if (!cells.labelsAreSure())
        std::erase_if(peaks,
                      [&](const HeightPeak& p) { return p.area < 0.3 * (p.area + survey.open.areaNear(p.z, 0.05)); });
    return peaks;
}

/// The floors of storeys, from below.
std::vector<HeightPeak> storeyFloors(const SurfaceCells& cells, const FloorSurvey& survey,
                                     const std::vector<HeightPeak>& covered, const LevelParams& params)
{
    // Of two floors close to each other the covered one counts.
    std::vector<HeightPeak> peaks;
    for (const HeightPeak& p : covered)
        if (std::none_of(peaks.begin(), peaks.end(),
                         [&](const HeightPeak& q) { return std::abs(p.z - q.z) < kSameFloor_m; }))
            peaks.push_back(p);
    // Without any ceiling (not scanned) the floors themselves have to do; with labels an open floor counts as one too,
    // and so does one that walls stand on where it is all that the floor below has above it.
    std::vector<HeightPeak> openPeaks = peaksOf(survey.open, kSameFloor_m);
    if (!cells.labelsAreSure())
        raiseAboveTerrain(openPeaks, survey.open);
    const double largestPaired = peaks.empty() ? 0.0 : peaks.front().area;
    const auto isUpperFloor = [&](const HeightPeak& p)
    {
        double below = 0;
        for (const Pair& q : survey.pairs)
            below += std::abs(q.ceiling - p.z) < kMergeZ_m ? survey.columnArea_m2 : 0.0;
        return below > 0.3 * p.area && verticalArea(cells, p.z + 0.8, p.z + 1.8) > 2 * std::sqrt(p.area);
    };
    for (const HeightPeak& p : openPeaks)
    {
        if (p.area < params.minimumArea_m2 ||
            (!cells.labelsAreSure() && largestPaired >= params.minimumArea_m2 && !isUpperFloor(p)))
            continue;
        const auto same = std::find_if(peaks.begin(), peaks.end(),
                                       [&](const HeightPeak& q) { return std::abs(p.z - q.z) < kSameFloor_m; });
        if (same == peaks.end())
            peaks.push_back(p);
        else if (same->area <= 0.3 * p.area)  // the larger part of one floor
            *same = p;
    }
    if (peaks.empty())
        return peaks;
    const double largest = std::max_element(peaks.begin(), peaks.end(),
                                            [](const HeightPeak& a, const HeightPeak& b) { return a.area < b.area; })
                               ->area;
    std::erase_if(peaks, [&](const HeightPeak& p)
                  { return p.area < params.minimumArea_m2 || p.area < params.minimumAreaShare * largest; });
    std::sort(peaks.begin(), peaks.end(), [](const HeightPeak& a, const HeightPeak& b) { return a.z < b.z; });
    return peaks;
}

/// A floor and the ceiling most of it lies under.
Level levelOf(const HeightPeak& p, const FloorSurvey& survey, const LevelParams& params)
{
    Level level;
    level.floor_m = medianNear(survey.heights, p.z, 0.05);
    level.floorArea_m2 = p.area;
    HeightHistogram ceilings(survey.low, survey.high, params.binSize_m);
    std::vector<double> ceilingHeights;
    double slopedTop = -std::numeric_limits<double>::infinity();
    for (const Pair& q : survey.pairs)
        if (std::abs(q.floor - level.floor_m) < 0.06)
        {
            if (q.ceilingLevel)
                ceilings.add(q.ceiling, survey.columnArea_m2), ceilingHeights.push_back(q.ceiling);
            else
                slopedTop = std::max(slopedTop, q.ceiling);
        }
    const std::vector<HeightPeak> above = peaksOf(ceilings, 0.2);
    if (!above.empty() && above.front().area > 0.25 * p.area)
    {
        level.ceiling_m = medianNear(ceilingHeights, above.front().z, 0.05);
        level.ceilingArea_m2 = above.front().area;
        level.ceilingSeen = true;
        for (const HeightPeak& q : above)
            if (q.area > kCeilingShare * p.area)
                level.ceilings.push_back(medianNear(ceilingHeights, q.z, 0.05));
        std::sort(level.ceilings.begin(), level.ceilings.end());
    }
    else
        level.ceiling_m = slopedTop;  // settled when the next floor is known
    return level;
}

/// What of a storey's ceiling the next floor says, and the height of those that were not seen.
void settleCeilings(LevelResult& result, const SurfaceCells& cells, const LevelParams& params)
{
    for (std::size_t i = 0; i < result.levels.size(); ++i)
    {
        Level& level = result.levels[i];
        if (level.ceilingSeen)
        {
            if (i + 1 < result.levels.size())
            {
                const double next = result.levels[i + 1].floor_m;
                std::erase_if(level.ceilings, [&](double c) { return c > level.ceiling_m && c > next - 0.03; });
                if (next > level.ceiling_m)
                    level.ceilingLimit_m = (level.highestCeiling_m() + next) / 2;
            }
            continue;
        }
        const double limit =
            i + 1 < result.levels.size() ? result.levels[i + 1].floor_m : level.floor_m + params.maximumRoomHeight_m;
        if (!std::isfinite(level.ceiling_m) || level.ceiling_m > limit)
            level.ceiling_m = topOfVerticalSurfaces(cells, level.floor_m, limit);
        result.diagnostics.push_back(
            {Severity::Warning,
             "levels",
             "CeilingNotLevel",
             "No level ceiling was found above this floor; the walls' own tops give its height.",
             {},
             Eigen::Vector3d(0, 0, level.floor_m)});
    }
}

}  // namespace

LevelResult findLevels(const SurfaceCells& cells, const LevelParams& params, const Context& context)
{
    LevelResult result;
    const std::vector<ColumnSurface> surfaces = surfacesByColumn(cells, context);
    context.checkCancelled();
    if (surfaces.empty())
    {
        result.diagnostics.push_back(
            {Severity::Error,
             "levels",
             "NoHorizontalSurface",
             "No horizontal surface was found, so there are no storeys: is the cloud's Z axis up?",
             {},
             {}});
        return result;
    }
    const double column_m = columnEdge(cells);
    const FloorSurvey survey = surveyFloors(surfaces, column_m * column_m, params);
    const std::vector<HeightPeak> covered = coveredFloors(cells, survey);
    const std::vector<HeightPeak> peaks = storeyFloors(cells, survey, covered, params);
    if (peaks.empty())
    {
        result.diagnostics.push_back({Severity::Error,
                                      "levels",
                                      "NoFloor",
                                      "No floor was found under a ceiling, so there are no storeys.",
                                      {},
                                      {}});
        return result;
    }
    for (const HeightPeak& p : peaks)
    {
        Level level = levelOf(p, survey, params);
        // What the level below has as its ceiling is no floor; nor is what stands in its room, unless it is a large
        // part of the plan (a mezzanine, a half-level) and not furniture.
        if (!result.levels.empty())
        {
            Level& below = result.levels.back();
            const bool coincide = below.ceilingSeen && std::abs(level.floor_m - below.ceiling_m) < kMergeZ_m;
            const bool isItsCeiling = coincide && (cells.labelsAreSure() || hasFloorAbove(covered, p));
            if (coincide && !isItsCeiling)  // a ceiling that was not scanned: what is above the floor is the next floor
                below.ceilingSeen = false, below.ceilings.clear(), below.ceilingArea_m2 = 0;
            const bool standsInIt =
                level.floor_m < below.ceiling_m - 0.1 && level.floor_m - below.floor_m < params.minimumRoomHeight_m;
            if (isItsCeiling || (standsInIt && level.floorArea_m2 < 0.4 * below.floorArea_m2))
                continue;
        }
        result.levels.push_back(level);
    }
    settleCeilings(result, cells, params);
    return result;
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/levels/levels.h"

#include "core/base/floor_to_int.h"
#include "core/base/parallel_sort.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace s2b
{
namespace
{

constexpr double kColumn_m = 0.10;    // edge of the plan columns in which floors meet their ceilings, at least
constexpr double kSlab_m = 0.8;       // thickest slab with its finishes
constexpr double kSameFloor_m = 0.5;  // floors closer than this are steps of one
constexpr double kMergeZ_m = 0.06;    // surfaces closer than this in one column are one

/// A horizontal (or, looking up, sloped) surface in one plan column.
struct Surface
{
    std::int32_t x = 0, y = 0;
    double z = 0;
    bool isLevel = false;     ///< horizontal
    bool maybeFloor = false;  ///< its label does not say otherwise
    bool maybeCeiling = false;
};

/// Floor and ceiling above each other in one column.
struct Pair
{
    double floor = 0, ceiling = 0;
    bool ceilingLevel = false;
};

bool sameColumn(const Surface& a, const Surface& b)
{
    return a.x == b.x && a.y == b.y;
}

/// Wide enough for a few cells of each surface, in sparse clouds too.
double columnEdge(const SurfaceCells& cells)
{
    return std::max(kColumn_m, 2.5 * cells.size_m);
}

std::vector<Surface> surfacesByColumn(const SurfaceCells& cells, const Context& context)
{
    const double column = columnEdge(cells);
    // Stray cells (mixed pixels, what was seen through windows) are no surface.
    const int minimumCells = std::max(2, static_cast<int>(0.2 * (column / cells.size_m) * (column / cells.size_m)));
    // Small: sorting these is most of the work.
    struct Hit
    {
        std::int32_t x, y;
        float z;
        bool isLevel, maybeFloor, maybeCeiling;
    };
    std::vector<Hit> raw;
    for (const SurfaceCell& c : cells.cells)
    {
        const double nz = std::abs(static_cast<double>(c.normal.z()));
        // A sloped ceiling is still a surface; foliage is not.
        if (nz < 0.35 || (nz < 0.95 && static_cast<double>(c.flatness) > 0.45 * cells.size_m))
            continue;
        // A model tells floors from ground and furniture no better than what lies above them does.
        if (cells.labelsAreSure() &&
            (c.label == Label::Furniture || c.label == Label::Stair || c.label == Label::Door ||
             c.label == Label::Window || c.label == Label::Wall || c.label == Label::Column))
            continue;
        Hit s{};
        s.x = floorToInt(static_cast<double>(c.position.x()) / column);
        s.y = floorToInt(static_cast<double>(c.position.y()) / column);
        s.z = c.position.z();
        s.isLevel = nz > 0.95;
        s.maybeFloor = s.maybeCeiling = true;
        if (cells.labelsAreSure())
        {
            s.maybeFloor = c.label == Label::Floor;
            s.maybeCeiling = c.label == Label::Ceiling || c.label == Label::Roof || c.label == Label::Beam;
        }
        // A floor is seen from above, a ceiling from below.
        if (c.facesScanner)
            (c.normal.z() > 0 ? s.maybeCeiling : s.maybeFloor) = false;
        raw.push_back(s);
    }
    parallelSort(raw, context,
                 [](const Hit& a, const Hit& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
    std::vector<Surface> merged;
    for (std::size_t i = 0; i < raw.size();)
    {
        const Hit first = raw[i];
        const auto lowest = static_cast<double>(first.z);
        double sum = 0;
        int n = 0, level = 0, floorVotes = 0, ceilingVotes = 0;
        for (; i < raw.size() && raw[i].x == first.x && raw[i].y == first.y &&
               static_cast<double>(raw[i].z) - lowest < kMergeZ_m;
             ++i)
        {
            sum += static_cast<double>(raw[i].z), ++n;
            level += raw[i].isLevel;
            floorVotes += raw[i].maybeFloor;
            ceilingVotes += raw[i].maybeCeiling;
        }
        if (n >= minimumCells)
            merged.push_back({first.x, first.y, sum / n, 2 * level > n, 2 * floorVotes > n, 2 * ceilingVotes > n});
    }
    return merged;
}

/// Area over height, one bin a `bin`; peaks are read off a smoothed copy.
class HeightHistogram
{
public:
    HeightHistogram(double low, double high, double bin)
        : m_low(low),
          m_bin(bin),
          m_area(static_cast<std::size_t>(std::max(1.0, std::ceil((high - low) / bin) + 3)), 0.0)
    {
    }
    void add(double z, double area)
    {
        const double i = (z - m_low) / m_bin + 1;
        if (i >= 0 && i < static_cast<double>(m_area.size()))
            m_area[static_cast<std::size_t>(i)] += area;
    }
    [[nodiscard]] double z(std::size_t i) const { return m_low + (static_cast<double>(i) - 0.5) * m_bin; }
    [[nodiscard]] double areaNear(double height, double reach) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < m_area.size(); ++i)
            if (std::abs(z(i) - height) <= reach)
                sum += m_area[i];
        return sum;
    }
    /// Area within `reach` of each bin.
    [[nodiscard]] std::vector<double> smoothed(double reach) const
    {
        const auto r = static_cast<std::ptrdiff_t>(std::lround(reach / m_bin));
        std::vector<double> s(m_area.size(), 0.0);
        for (std::size_t i = 0; i < s.size(); ++i)
            for (std::ptrdiff_t k = -r; k <= r; ++k)
            {
                const std::ptrdiff_t j = static_cast<std::ptrdiff_t>(i) + k;
                if (j >= 0 && j < static_cast<std::ptrdiff_t>(m_area.size()))
                    s[i] += m_area[static_cast<std::size_t>(j)];
            }
        return s;
    }

private:
    double m_low, m_bin;
    std::vector<double> m_area;
};

/// Median of the values within `reach` of `centre`.
double medianNear(std::vector<double> values, double centre, double reach)
{
    std::erase_if(values, [&](double v) { return std::abs(v - centre) > reach; });
    if (values.empty())
        return centre;
    const auto mid = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), mid, values.end());
    return *mid;
}

constexpr double kCeilingShare = 0.08;  // of the floor, that a further (suspended, stepped) ceiling covers at least

struct Peak
{
    double z = 0, area = 0;
};

/// Local maxima, the largest first; a smaller one within `apart` of a larger one is part of it.
std::vector<Peak> peaksOf(const HeightHistogram& histogram, double apart)
{
    const std::vector<double> s = histogram.smoothed(0.04);
    std::vector<Peak> all;
    for (std::size_t i = 0; i < s.size(); ++i)
        if (s[i] > 0)
            all.push_back({histogram.z(i), s[i]});
    std::sort(all.begin(), all.end(),
              [](const Peak& a, const Peak& b) { return std::tie(b.area, a.z) < std::tie(a.area, b.z); });
    std::vector<Peak> peaks;
    for (const Peak& p : all)
        if (std::none_of(peaks.begin(), peaks.end(), [&](const Peak& q) { return std::abs(p.z - q.z) < apart; }))
            peaks.push_back(p);
    return peaks;
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
bool hasFloorAbove(const std::vector<Peak>& floors, const Peak& p)
{
    return std::any_of(floors.begin(), floors.end(), [&](const Peak& q)
                       { return q.z > p.z + kMergeZ_m && q.z < p.z + kSlab_m && q.area > 0.3 * p.area; });
}

/// Where no ceiling was seen, the ground around a house is the largest surface; its floor lies a step above.
void raiseAboveTerrain(std::vector<Peak>& peaks, const HeightHistogram& openFloors)
{
    constexpr double lowest_m = 0.10, highest_m = 0.45, leastShare = 0.05;
    const std::vector<Peak> all = peaksOf(openFloors, 0.09);
    for (Peak& p : peaks)
    {
        const double terrain = p.z, area = p.area;
        for (const Peak& q : all)
            if (const double step = q.z - terrain; step > lowest_m && step < highest_m && q.area > leastShare * area &&
                                                   (p.z == terrain || q.area > p.area))
                p = q;
    }
}

}  // namespace

LevelResult findLevels(const SurfaceCells& cells, const LevelParams& params, const Context& context)
{
    LevelResult result;
    const std::vector<Surface> surfaces = surfacesByColumn(cells, context);
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
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Surface& s : surfaces)
        low = std::min(low, s.z), high = std::max(high, s.z);

    // In each column: which surface is a floor with room above it, and what is above.
    const double columnArea = columnEdge(cells) * columnEdge(cells);
    HeightHistogram floors(low, high, params.binSize_m), openFloors(low, high, params.binSize_m);
    std::vector<Pair> pairs;
    std::vector<double> floorHeights;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
    {
        const Surface& s = surfaces[i];
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
            floors.add(s.z, columnArea);
            pairs.push_back({s.z, surfaces[j].z, surfaces[j].isLevel});
        }
        else
            openFloors.add(s.z, columnArea);
        floorHeights.push_back(s.z);
    }

    // A floor lies under a ceiling for the most part; terrain does so only under trees and eaves. Of two floors close
    // to each other the covered one counts.
    std::vector<Peak> peaks = peaksOf(floors, 0.12);
    if (!cells.labelsAreSure())
        std::erase_if(peaks, [&](const Peak& p) { return p.area < 0.3 * (p.area + openFloors.areaNear(p.z, 0.05)); });
    const std::vector<Peak> allFloors = peaks;
    std::vector<Peak> apart;
    for (const Peak& p : peaks)
        if (std::none_of(apart.begin(), apart.end(), [&](const Peak& q) { return std::abs(p.z - q.z) < kSameFloor_m; }))
            apart.push_back(p);
    peaks = std::move(apart);
    // Without any ceiling (not scanned) the floors themselves have to do; with labels an open floor counts as one too,
    // and so does one that walls stand on where it is all that the floor below has above it.
    std::vector<Peak> openPeaks = peaksOf(openFloors, kSameFloor_m);
    if (!cells.labelsAreSure())
        raiseAboveTerrain(openPeaks, openFloors);
    const double largestPaired = peaks.empty() ? 0.0 : peaks.front().area;
    const auto isUpperFloor = [&](const Peak& p)
    {
        double below = 0;
        for (const Pair& q : pairs)
            below += std::abs(q.ceiling - p.z) < kMergeZ_m ? columnArea : 0.0;
        return below > 0.3 * p.area && verticalArea(cells, p.z + 0.8, p.z + 1.8) > 2 * std::sqrt(p.area);
    };
    for (const Peak& p : openPeaks)
    {
        if (p.area < params.minimumArea_m2 ||
            (!cells.labelsAreSure() && largestPaired >= params.minimumArea_m2 && !isUpperFloor(p)))
            continue;
        const auto same =
            std::find_if(peaks.begin(), peaks.end(), [&](const Peak& q) { return std::abs(p.z - q.z) < kSameFloor_m; });
        if (same == peaks.end())
            peaks.push_back(p);
        else if (same->area <= 0.3 * p.area)  // the larger part of one floor
            *same = p;
    }
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
    const double largest =
        std::max_element(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) { return a.area < b.area; })
            ->area;
    std::erase_if(peaks, [&](const Peak& p)
                  { return p.area < params.minimumArea_m2 || p.area < params.minimumAreaShare * largest; });
    std::sort(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) { return a.z < b.z; });

    for (const Peak& p : peaks)
    {
        Level level;
        level.floor_m = medianNear(floorHeights, p.z, 0.05);
        level.floorArea_m2 = p.area;
        // The ceiling most of this floor lies under.
        HeightHistogram ceilings(low, high, params.binSize_m);
        std::vector<double> ceilingHeights;
        double slopedTop = -std::numeric_limits<double>::infinity();
        for (const Pair& q : pairs)
            if (std::abs(q.floor - level.floor_m) < 0.06)
            {
                if (q.ceilingLevel)
                    ceilings.add(q.ceiling, columnArea), ceilingHeights.push_back(q.ceiling);
                else
                    slopedTop = std::max(slopedTop, q.ceiling);
            }
        const std::vector<Peak> above = peaksOf(ceilings, 0.2);
        if (!above.empty() && above.front().area > 0.25 * p.area)
        {
            level.ceiling_m = medianNear(ceilingHeights, above.front().z, 0.05);
            level.ceilingArea_m2 = above.front().area;
            level.ceilingSeen = true;
            for (const Peak& q : above)
                if (q.area > kCeilingShare * p.area)
                    level.ceilings.push_back(medianNear(ceilingHeights, q.z, 0.05));
            std::sort(level.ceilings.begin(), level.ceilings.end());
        }
        else
            level.ceiling_m = slopedTop;  // settled below, when the next floor is known
        // What the level below has as its ceiling is no floor; nor is what stands in its room, unless it is a large
        // part of the plan (a mezzanine, a half-level) and not furniture.
        if (!result.levels.empty())
        {
            Level& below = result.levels.back();
            const bool coincide = below.ceilingSeen && std::abs(level.floor_m - below.ceiling_m) < kMergeZ_m;
            const bool isItsCeiling = coincide && (cells.labelsAreSure() || hasFloorAbove(allFloors, p));
            if (coincide && !isItsCeiling)  // a ceiling that was not scanned: what is above the floor is the next floor
                below.ceilingSeen = false, below.ceilings.clear(), below.ceilingArea_m2 = 0;
            const bool standsInIt =
                level.floor_m < below.ceiling_m - 0.1 && level.floor_m - below.floor_m < params.minimumRoomHeight_m;
            if (isItsCeiling || (standsInIt && level.floorArea_m2 < 0.4 * below.floorArea_m2))
                continue;
        }
        result.levels.push_back(level);
    }
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
    return result;
}

}  // namespace s2b

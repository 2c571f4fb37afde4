// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/levels/column_surfaces.h"

#include "core/base/floor_to_int.h"
#include "core/base/parallel_sort.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace s2b
{
namespace
{

constexpr double kColumn_m = 0.10;  // of a dense cloud

}  // namespace

double columnEdge(const SurfaceCells& cells)
{
    return std::max(kColumn_m, 2.5 * cells.size_m);
}

std::vector<ColumnSurface> surfacesByColumn(const SurfaceCells& cells, const Context& context)
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
    std::vector<ColumnSurface> merged;
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

}  // namespace s2b

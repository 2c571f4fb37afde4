// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/upper_storey.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace s2b
{
namespace
{

/// Floor that a wall over open space stands on: the assumed slab above the underside where that was seen, else the
/// lowest of its faces.
double floorOf(const Wall& wall, const CellIndex& index, double slabThickness_m)
{
    constexpr std::size_t enough = 20;
    std::vector<double> underside, face;
    const Eigen::Vector2d t = wall.direction(), n = wall.normal();
    const double half = wall.thickness.value_m / 2;
    index.near(wall.start, wall.end, wall.thickness.value_m,
               [&](const SurfaceCell& c)
               {
                   const Eigen::Vector2d p = c.position.head<2>().cast<double>() - wall.start;
                   const double s = t.dot(p), d = std::abs(n.dot(p)), z = static_cast<double>(c.position.z());
                   if (s < wall.bodyStart_m + 0.05 || s > wall.bodyEnd_m - 0.05 || std::abs(z - wall.base_m) > 0.3)
                       return;
                   if (d < half - 0.03 && std::abs(c.normal.z()) > 0.8f)
                       underside.push_back(z);
                   else if (std::abs(d - half) < 0.02 && std::abs(n.dot(c.normal.head<2>().cast<double>())) > 0.8)
                       face.push_back(z);
               });
    if (underside.size() >= enough)
    {
        const auto middle = underside.begin() + static_cast<std::ptrdiff_t>(underside.size() / 2);
        std::nth_element(underside.begin(), middle, underside.end());
        return *middle + slabThickness_m;
    }
    if (face.size() < enough)
        return wall.base_m;
    const auto low = face.begin() + static_cast<std::ptrdiff_t>(face.size() / 50);
    std::nth_element(face.begin(), low, face.end());
    return *low;
}

}  // namespace

std::optional<double> upperStoreyBase(const std::vector<Wall>& walls, const Level& level, const CellIndex& index,
                                      double minimumRoomHeight_m, double slabThickness_m)
{
    constexpr double minimumLength_m = 2.0, minimumHeight_m = 1.0;
    double length = 0, sum = 0;
    for (const Wall& w : walls)
        if (w.base_m - level.floor_m >= minimumRoomHeight_m && w.height.value_m >= minimumHeight_m &&
            w.evidence.facesSeen == 2)
        {
            length += w.axisLength_m();
            sum += w.axisLength_m() * floorOf(w, index, slabThickness_m);
        }
    if (length < minimumLength_m)
        return std::nullopt;
    return sum / length;
}

void divideWalls(std::vector<Wall>& walls, std::vector<Junction>& junctions, double base_m, ElementId upper,
                 std::uint32_t& nextId)
{
    constexpr double atLeast_m = 1.0;
    std::map<ElementId, ElementId> above;
    const std::size_t count = walls.size();
    for (std::size_t i = 0; i < count; ++i)
    {
        const double top = walls[i].base_m + walls[i].height.value_m;
        if (top < base_m + atLeast_m)
            continue;
        if (walls[i].base_m > base_m - atLeast_m)
        {
            walls[i].storey = upper;
            walls[i].base_m = base_m;
            walls[i].height.value_m = top - base_m;
            above[walls[i].id] = walls[i].id;
            continue;
        }
        Wall part = walls[i];
        part.id = ElementId{nextId++};
        part.storey = upper;
        part.base_m = base_m;
        part.height.value_m = top - base_m;
        walls[i].height = {base_m - walls[i].base_m, Provenance::Corrected, walls[i].height.rms_m};
        above[walls[i].id] = part.id;
        walls.push_back(part);
    }
    const std::size_t known = junctions.size();
    for (std::size_t i = 0; i < known; ++i)
    {
        const auto a = above.find(junctions[i].wallA), b = above.find(junctions[i].wallB);
        if (a == above.end() || b == above.end())
            continue;
        if (a->first == a->second || b->first == b->second)
            junctions[i].wallA = a->second, junctions[i].wallB = b->second;
        else
            junctions.push_back({a->second, b->second, junctions[i].endA, junctions[i].endB});
    }
}

}  // namespace s2b

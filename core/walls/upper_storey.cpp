// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/upper_storey.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace s2b
{
namespace
{

/// Heights of the cells on a wall's faces within 0.3 m of z, ascending.
std::vector<double> faceHeights(const Wall& wall, const CellIndex& index, double z)
{
    std::vector<double> heights;
    const Eigen::Vector2d t = wall.direction(), n = wall.normal();
    index.near(wall.start, wall.end, wall.thickness.value_m,
               [&](const SurfaceCell& c)
               {
                   const Eigen::Vector2d p = c.position.head<2>().cast<double>() - wall.start;
                   const double s = t.dot(p), height = static_cast<double>(c.position.z());
                   if (s > wall.bodyStart_m + 0.05 && s < wall.bodyEnd_m - 0.05 && std::abs(height - z) < 0.3 &&
                       std::abs(std::abs(n.dot(p)) - wall.thickness.value_m / 2) < 0.02 &&
                       std::abs(n.dot(c.normal.head<2>().cast<double>())) > 0.8)
                       heights.push_back(height);
               });
    std::sort(heights.begin(), heights.end());
    return heights;
}

/// Length-weighted mean of what the walls say.
class Mean
{
public:
    void add(const Wall& wall, double value)
    {
        m_length += wall.axisLength_m();
        m_sum += wall.axisLength_m() * value;
    }
    [[nodiscard]] double length_m() const { return m_length; }
    [[nodiscard]] double value() const { return m_sum / m_length; }

private:
    double m_length = 0, m_sum = 0;
};

}  // namespace

std::optional<double> upperStoreyBase(const std::vector<Wall>& walls, const Level& level, const CellIndex& index,
                                      double minimumRoomHeight_m)
{
    constexpr double minimumLength_m = 2.0, minimumHeight_m = 1.0, reach_m = 0.5;
    Mean bases;
    for (const Wall& w : walls)
        if (w.base_m - level.floor_m >= minimumRoomHeight_m && w.height.value_m >= minimumHeight_m &&
            w.evidence.facesSeen == 2)
        {
            const std::vector<double> z = faceHeights(w, index, w.base_m);
            bases.add(w, z.size() < 20 ? w.base_m : z[z.size() / 50]);
        }
    if (bases.length_m() < minimumLength_m)
        return std::nullopt;
    // A roof often hides the foot of such a wall; the lower walls beside it end at the same storey.
    Mean tops;
    for (const Wall& w : walls)
    {
        const double top = w.base_m + w.height.value_m;
        if (w.base_m < level.floor_m + 0.5 && std::abs(top - bases.value()) < reach_m && w.evidence.facesSeen == 2)
            if (const std::vector<double> z = faceHeights(w, index, top); z.size() >= 20)
                tops.add(w, z[z.size() - 1 - z.size() / 50]);
    }
    return tops.length_m() >= minimumLength_m ? tops.value() : bases.value();
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
        // A slope that comes down below the floor above leaves one wall.
        const auto isBelow = [&](const Eigen::Vector2d& p) { return p.y() < base_m; };
        if (top < base_m + atLeast_m || std::ranges::any_of(walls[i].topProfile, isBelow))
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
        walls[i].topProfile.clear();
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

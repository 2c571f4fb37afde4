// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/corrections/junctions.h"

#include "core/corrections/elements.h"
#include "core/model/wall_axis.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace s2b
{
namespace
{

constexpr double kMeet_m = 0.002;    // axes this near to each other meet
constexpr double kLargest_m = 1.5;   // an end is not drawn further
constexpr double kShortest_m = 0.1;  // nor a wall made shorter
const double kLeastSine = std::sin(10 * std::numbers::pi / 180);

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Where the axes' lines cross, as arc lengths on both; nothing for arcs and nearly parallel walls.
std::optional<std::pair<double, double>> crossing(const Wall& a, const Wall& b)
{
    const double sine = cross(a.direction(), b.direction());
    if (a.bulge != 0 || b.bulge != 0 || std::abs(sine) < kLeastSine)
        return std::nullopt;
    const Eigen::Vector2d between = b.start - a.start;
    return std::pair(cross(between, b.direction()) / sine, cross(between, a.direction()) / sine);
}

double placeOf(const Wall& wall, JunctionEnd end)
{
    return end == JunctionEnd::End ? wall.axisLength_m() : 0.0;
}

/// How far the axis' end has to go to reach s (> 0: outwards).
double drawnBy(const Wall& wall, JunctionEnd end, double s)
{
    return end == JunctionEnd::Start ? -s : s - wall.axisLength_m();
}

bool canReach(const Wall& wall, JunctionEnd end, double s)
{
    const double length = wall.axisLength_m();
    if (end == JunctionEnd::Path)
        return s > -kJoinReach_m && s < length + kJoinReach_m;
    const double by = drawnBy(wall, end, s);
    return by < kLargest_m && length + by > kShortest_m;
}

void drawTo(Building& building, Wall& wall, JunctionEnd end, double s)
{
    if (end == JunctionEnd::Path || std::abs(drawnBy(wall, end, s)) < 1e-9)
        return;
    if (end == JunctionEnd::Start)
        moveStart(building, wall, s);
    else
        moveEnd(wall, s - wall.axisLength_m());
}

double overhang(const Wall& wall, JunctionEnd end)
{
    return end == JunctionEnd::Start ? -wall.bodyStart_m : wall.bodyEnd_m - wall.axisLength_m();
}

void setOverhang(Wall& wall, JunctionEnd end, double value_m)
{
    if (end == JunctionEnd::Start)
        wall.bodyStart_m = -value_m;
    else if (end == JunctionEnd::End)
        wall.bodyEnd_m = wall.axisLength_m() + value_m;
}

/// The body of `a` ends at the near face of `b`, or, running through a corner, at its far one.
void cutBody(Wall& a, JunctionEnd endA, const Wall& b, bool isThrough)
{
    const double sine = std::abs(cross(a.direction(), b.direction()));
    const double half =
        isThrough
            ? b.thickness.value_m / 2 / sine
            : -(b.thickness.value_m + std::abs(a.direction().dot(b.direction())) * a.thickness.value_m) / 2 / sine;
    setOverhang(a, endA, half);
}

void cutBodies(Wall& a, JunctionEnd endA, Wall& b, JunctionEnd endB)
{
    const bool isCorner = endA != JunctionEnd::Path && endB != JunctionEnd::Path;
    bool aThrough = false;
    if (isCorner)  // as it was; of a new corner the longer wall
        aThrough = overhang(a, endA) > 1e-6   ? true
                   : overhang(b, endB) > 1e-6 ? false
                                              : std::pair(a.axisLength_m(), b.id) >= std::pair(b.axisLength_m(), a.id);
    if (endA != JunctionEnd::Path)
        cutBody(a, endA, b, isCorner && aThrough);
    if (endB != JunctionEnd::Path)
        cutBody(b, endB, a, isCorner && !aThrough);
}

/// Whether the junction's ends still lie on each other.
bool stillMeets(const Wall& a, JunctionEnd endA, const Wall& b, JunctionEnd endB)
{
    const WallAxis axisA(a), axisB(b);
    if (endA == JunctionEnd::Path && endB == JunctionEnd::Path)
        return true;
    if (endA == JunctionEnd::Path)
        return stillMeets(b, endB, a, endA);
    const Eigen::Vector2d p = axisA.at(placeOf(a, endA));
    if (endB != JunctionEnd::Path)
        return (p - axisB.at(placeOf(b, endB))).norm() < kMeet_m;
    const Eigen::Vector2d on = axisB.project(p);
    return std::abs(on.y()) < kMeet_m && on.x() > -kMeet_m && on.x() < axisB.length_m() + kMeet_m;
}

bool settle(Building& building, const Junction& j)
{
    Wall& a = *findElement(building.walls, j.wallA);
    Wall& b = *findElement(building.walls, j.wallB);
    const auto at = crossing(a, b);
    if (!at)
        return stillMeets(a, j.endA, b, j.endB);
    if (!canReach(a, j.endA, at->first) || !canReach(b, j.endB, at->second))
        return false;
    // Which of a corner runs through has to be read before the ends move: the overhang moves with them.
    drawTo(building, a, j.endA, at->first);
    drawTo(building, b, j.endB, at->second);
    cutBodies(a, j.endA, b, j.endB);
    return true;
}

void sayOpened(Building& building, const Junction& j)
{
    const Wall& a = *building.wall(j.wallA);
    const Eigen::Vector2d p = WallAxis(a).at(j.endA == JunctionEnd::Path ? a.axisLength_m() / 2 : placeOf(a, j.endA));
    building.diagnostics.push_back(
        {Severity::Warning, "corrections", "JunctionOpened",
         std::format("{} and {} no longer meet.", nameOf(building, j.wallA), nameOf(building, j.wallB)), j.wallA,
         Eigen::Vector3d(p.x(), p.y(), a.base_m)});
}

constexpr double kNear_m = 1e-6;

bool isNear(const Dimension& a, const Dimension& b)
{
    return std::abs(a.value_m - b.value_m) < kNear_m && a.provenance == b.provenance;
}

bool isNear(const Wall& a, const Wall& b)
{
    return (a.start - b.start).norm() < kNear_m && (a.end - b.end).norm() < kNear_m && a.bulge == b.bulge &&
           std::abs(a.bodyStart_m - b.bodyStart_m) < kNear_m && std::abs(a.bodyEnd_m - b.bodyEnd_m) < kNear_m &&
           std::abs(a.base_m - b.base_m) < kNear_m && isNear(a.height, b.height) && isNear(a.thickness, b.thickness) &&
           a.topProfile.size() == b.topProfile.size();
}

bool isNear(const Opening& a, const Opening& b)
{
    return std::abs(a.offset_m - b.offset_m) < kNear_m && isNear(a.width, b.width) && isNear(a.height, b.height) &&
           isNear(a.sill, b.sill) && a.kind == b.kind && a.host == b.host;
}

bool isIn(const std::vector<Junction>& junctions, const Junction& j)
{
    return std::ranges::any_of(junctions, [&](const Junction& k) { return isSame(j, k); });
}

bool isJoined(const Building& building, ElementId id, JunctionEnd end)
{
    return std::ranges::any_of(building.junctions, [&](const Junction& j)
                               { return (j.wallA == id && j.endA == end) || (j.wallB == id && j.endB == end); });
}

}  // namespace

void moveStart(Building& building, Wall& wall, double delta_m)
{
    if (wall.bulge != 0)
        return;  // an arc's radius is not a person's to guess: it stays
    wall.start += delta_m * wall.direction();
    wall.bodyEnd_m -= delta_m;
    for (Eigen::Vector2d& v : wall.topProfile)
        v.x() -= delta_m;
    for (Opening& o : building.openings)
        if (o.host == wall.id)
            o.offset_m -= delta_m;
}

void moveEnd(Wall& wall, double delta_m)
{
    if (wall.bulge != 0)
        return;
    wall.end += delta_m * wall.direction();
    wall.bodyEnd_m += delta_m;
}

void settleJunctions(Building& building, const std::set<ElementId>& moved)
{
    std::vector<Junction> opened;
    std::set<ElementId> touched = moved;
    for (const Junction& j : building.junctions)
        if (moved.contains(j.wallA) || moved.contains(j.wallB))
        {
            touched.insert({j.wallA, j.wallB});
            if (!settle(building, j))
                opened.push_back(j);
        }
    // An end that several walls share can follow only one of them.
    for (const Junction& j : building.junctions)
        if ((touched.contains(j.wallA) || touched.contains(j.wallB)) && !isIn(opened, j) &&
            !stillMeets(*building.wall(j.wallA), j.endA, *building.wall(j.wallB), j.endB))
            opened.push_back(j);
    std::erase_if(building.junctions, [&](const Junction& j) { return isIn(opened, j); });
    for (const Junction& j : opened)
        sayOpened(building, j);
}

void restoreNeighbours(Building& building, const Building& found, ElementId id)
{
    std::set<ElementId> around = {id};
    for (const Junction& j : building.junctions)
        if (j.wallA == id || j.wallB == id)
            around.insert({j.wallA, j.wallB});
    settleJunctions(building, {id});
    for (const ElementId wall : around)
    {
        Wall& now = *findElement(building.walls, wall);
        const Wall* was = found.wall(wall);
        if (!was || !isNear(now, *was))
            continue;
        now = *was;
        for (Opening& o : building.openings)
            if (const Opening* before = findElement(found.openings, o.id);
                before && o.host == wall && isNear(o, *before))
                o = *before;
    }
}

void joinEnds(Building& building, ElementId id)
{
    const Wall& wall = *building.wall(id);
    for (const JunctionEnd end : {JunctionEnd::Start, JunctionEnd::End})
    {
        if (isJoined(building, id, end))
            continue;
        std::optional<Junction> best;
        double least = kJoinReach_m;
        for (const Wall& other : building.walls)
        {
            if (other.id == id || other.storey != wall.storey)
                continue;
            const auto at = crossing(wall, other);
            if (!at)
                continue;
            const double away = std::abs(drawnBy(wall, end, at->first)) - other.thickness.value_m / 2;
            const double length = other.axisLength_m(), s = at->second;
            const double reach = wall.thickness.value_m / 2 + kJoinReach_m;
            if (away >= least || s < -reach || s > length + reach)
                continue;
            least = away;
            const double nearEnd = std::max(0.15, 0.75 * wall.thickness.value_m);
            JunctionEnd otherEnd = JunctionEnd::Path;
            if (s < nearEnd && !isJoined(building, other.id, JunctionEnd::Start))
                otherEnd = JunctionEnd::Start;
            else if (s > length - nearEnd && !isJoined(building, other.id, JunctionEnd::End))
                otherEnd = JunctionEnd::End;
            best = Junction{id, other.id, end, otherEnd};
        }
        if (best && settle(building, *best))
            building.junctions.push_back(*best);
    }
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/slabs/slab_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace s2b
{
namespace
{

constexpr double kTouch_m = 0.02;   // a wall this near to a room bounds it
constexpr double kCorner_m = 0.60;  // how far a wall may reach past the room: the thickest wall that it meets there
constexpr double kOnWall_m = 1e-6;
constexpr double kCoverShare = 0.5;  // of a hole, where something overhead was seen
constexpr double kBelowShare = 0.3;  // of a hole, where floor or steps below were seen
constexpr double kFloorShare = 0.3;  // of an open area, for it to have a floor

bool isCarried(const Room& room, const RoomPlan& plan)
{
    if (room.kind != RoomKind::Open)
        return room.kind == RoomKind::Room;
    std::size_t all = 0, floor = 0;
    forEachPixel(room.outline, plan.grid,
                 [&](std::size_t i)
                 {
                     ++all;
                     floor += (plan.seen[i] & kFloorLayer) != 0;
                 });
    return static_cast<double>(floor) > kFloorShare * static_cast<double>(all);
}

/// The part of a straight wall along the rooms, with the corners at its ends. Thickness 0: it is along none.
/// @param gap  between wall and room
Wall partAlong(const Wall& wall, const std::vector<Segment>& sides, double gap)
{
    if (wall.bulge != 0.0)
        return wall;
    const Eigen::Vector2d t = wall.direction(), n = wall.normal();
    const double half = wall.thickness.value_m / 2;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Segment& s : sides)
    {
        const double da = n.dot(s.a - wall.start), db = n.dot(s.b - wall.start);
        // On either face, or across an end.
        if (std::max(std::abs(da), std::abs(db)) > half + gap + kTouch_m)
            continue;
        const double u = t.dot(s.a - wall.start), v = t.dot(s.b - wall.start);
        if (std::max(u, v) < wall.bodyStart_m - gap - kTouch_m || std::min(u, v) > wall.bodyEnd_m + gap + kTouch_m)
            continue;
        low = std::min({low, u, v});
        high = std::max({high, u, v});
    }
    Wall part = wall;
    if (low > high)
    {
        part.thickness.value_m = 0;
        return part;
    }
    part.bodyStart_m = std::max(wall.bodyStart_m, low - gap - kCorner_m);
    part.bodyEnd_m = std::min(wall.bodyEnd_m, high + gap + kCorner_m);
    return part;
}

bool isNear(const std::vector<Segment>& edges, const Eigen::Vector2d& p, double distance)
{
    return std::any_of(edges.begin(), edges.end(),
                       [&](const Segment& s)
                       {
                           const Eigen::Vector2d d = s.b - s.a;
                           const double length2 = d.squaredNorm();
                           const double u = length2 > 0 ? std::clamp((p - s.a).dot(d) / length2, 0.0, 1.0) : 0.0;
                           return (s.a + d * u - p).norm() < distance;
                       });
}

}  // namespace

std::vector<Polygon> slabOutlines(const RoomPlan& plan, const SlabParams& params)
{
    const double half = plan.wideningHalf_m;
    std::vector<Polygon> carried, courtyards, walls;
    for (const Room& room : plan.rooms)
        if (room.kind == RoomKind::Uncovered)
            courtyards.push_back(room.outline);
        else if (isCarried(room, plan))
            carried.push_back(room.core);
    if (carried.empty())
        return {};
    // What rooms and walls enclose together is carried as well, seen or not.
    for (std::size_t w = 0; w < plan.walls.size(); ++w)
        if (plan.isDividing[w])
            walls.push_back(widened(plan.walls[w], half));
    std::vector<Polygon> all = carried;
    all.insert(all.end(), walls.begin(), walls.end());
    all = unite(all);
    for (const Polygon& p : all)
        for (const Ring& hole : p.holes)
            carried.push_back({hole, {}});

    const std::vector<Segment> sides = edgesOf(carried);
    std::vector<Polygon> bodies;
    for (std::size_t w = 0; w < plan.walls.size(); ++w)
        if (plan.isDividing[w])
            if (const Wall part = partAlong(plan.walls[w], sides, half); part.thickness.value_m > 0)
                bodies.push_back(widened(part, half));
    const std::vector<Segment> wallEdges = edgesOf(unite(bodies));
    std::vector<Polygon> parts = std::move(carried);
    parts.insert(parts.end(), bodies.begin(), bodies.end());
    std::vector<Polygon> wide;
    const double notch = params.minimumHoleWidth_m / 2;
    for (const Polygon& whole : unite(parts))
        for (const Polygon& outline :
             offsetEdges({whole.outer, {}},
                         [&](const Segment& e) { return isNear(wallEdges, (e.a + e.b) / 2, kOnWall_m) ? -half : 0.0; }))
            for (Polygon& p : offsetEdges(outline, [&](const Segment&) { return notch; }))
                wide.push_back(std::move(p));
    // Narrow notches are closed on the way there and back.
    std::vector<Polygon> result;
    for (const Polygon& p : unite(wide))
        for (const Polygon& outline : offsetEdges({p.outer, {}}, [&](const Segment&) { return -notch; }))
            for (Polygon& straight : withoutSteps(outline, params.outlineStep_m))
                result.push_back(std::move(straight));
    result = subtract(result, courtyards);
    std::erase_if(result, [&](const Polygon& p) { return area(p) < params.minimumArea_m2; });
    return result;
}

std::vector<Polygon> slabHoles(const RoomPlan& above, const RoomPlan& below, const PlanBits& undersides,
                               const SlabParams& params)
{
    const PlanGrid& grid = above.grid;
    if (!below.hasCeiling)
        return {};
    PlanBits domain(grid.size(), 0), slab(grid.size(), 0);
    for (const RoomPlan* plan : {&above, &below})
        for (const Room& room : plan->rooms)
            if (room.kind == RoomKind::Room || room.kind == RoomKind::Open)
                forEachPixel(room.outline, grid, [&](std::size_t i) { domain[i] = 1; });
    for (const Wall& w : above.walls)
        forEachPixel({w.outline(), {}}, grid, [&](std::size_t i) { domain[i] = 0; });
    for (std::size_t i = 0; i < slab.size(); ++i)
        slab[i] = (above.seen[i] & kFloorLayer) || undersides[i];
    // Gaps between scan lines are no holes, nor are seams along walls.
    const int gap = grid.reach(0.10);
    slab = eroded(dilated(slab, grid, gap), grid, gap);
    PlanBits missing(grid.size());
    for (std::size_t i = 0; i < slab.size(); ++i)
        missing[i] = domain[i] && !slab[i];
    const int narrow = grid.reach(params.minimumHoleWidth_m / 2);
    missing = dilated(eroded(missing, grid, narrow), grid, narrow);
    missing = eroded(dilated(missing, grid, narrow), grid, narrow);  // what hangs in the opening is not slab
    for (std::size_t i = 0; i < slab.size(); ++i)
        missing[i] = missing[i] && domain[i];
    if (std::none_of(missing.begin(), missing.end(), [](std::uint8_t v) { return v != 0; }))
        return {};

    StraightenOptions options;
    options.directions = directionsOf(above.walls);
    std::vector<Polygon> bodies;
    for (const RoomPlan* plan : {&above, &below})
        for (const Wall& w : plan->walls)
            bodies.push_back({w.outline(), {}});
    options.faces = edgesOf(bodies);
    options.detail_m = std::max(0.25, 4 * grid.pixel_m);
    std::vector<Polygon> holes;
    for (Polygon& hole : straightOutlines(missing, grid, options))
    {
        hole.holes.clear();  // an island would float
        std::size_t all = 0, covered = 0, floor = 0;
        forEachPixel(hole, grid,
                     [&](std::size_t i)
                     {
                         ++all;
                         covered += (above.seen[i] & kCoverLayer) != 0;
                         floor += (below.seen[i] & (kFloorLayer | kBetweenLayer)) != 0;
                     });
        const double n = static_cast<double>(all);
        if (area(hole) >= params.minimumHoleArea_m2 && static_cast<double>(covered) > kCoverShare * n &&
            static_cast<double>(floor) > kBelowShare * n)
            holes.push_back(std::move(hole));
    }
    return holes;
}

}  // namespace s2b

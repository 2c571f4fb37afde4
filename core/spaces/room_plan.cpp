// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spaces/room_plan.h"

#include "core/spaces/room_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace s2b
{
namespace
{

constexpr double kOnWall_m = 1e-6;    // an edge this near to the walls' outline came from it
constexpr double kOpenWidth_m = 0.6;  // narrower open areas are soffits and door recesses
constexpr double kOpenArea_m2 = 2.0;
constexpr double kFewWalls = 0.1;   // share of an outline
constexpr double kEaves_m = 1.5;    // a roof that is lower ends the room
constexpr double kFaint_m2 = 0.02;  // faces below it are slits between walls

/// Lowest slope overhead near a place; infinite without any.
double slopeNear(const RoomPlan& plan, const Eigen::Vector2d& p)
{
    double lowest = std::numeric_limits<double>::infinity();
    if (plan.slopes.empty())
        return lowest;
    for (const double dx : {-1.0, 0.0, 1.0})
        for (const double dy : {-1.0, 0.0, 1.0})
            if (const std::size_t i = plan.grid.find(p + plan.grid.pixel_m * Eigen::Vector2d(dx, dy));
                i < plan.slopes.size())
                lowest = std::fmin(lowest, static_cast<double>(plan.slopes[i]));
    return lowest;
}

/// Share of places along a segment that a test holds for.
template <typename Test>
double shareAlong(const Eigen::Vector2d& a, const Eigen::Vector2d& b, Test&& test)
{
    const int n = std::max(1, static_cast<int>(std::lround((b - a).norm() / 0.2)));
    int hits = 0;
    for (int i = 0; i < n; ++i)
        hits += test(Eigen::Vector2d(a + (b - a) * ((i + 0.5) / n)));
    return static_cast<double>(hits) / n;
}

bool dividesRooms(const Wall& wall, const RoomPlan& plan, const SpaceParams& params)
{
    const double top = wall.base_m + wall.height.value_m, floor = plan.level.floor_m;
    if (wall.base_m - floor >= 0.5)
        return false;
    if (top - floor >= std::min(params.minimumWallHeight_m, 0.8 * (plan.level.ceiling_m - floor)))
        return true;
    // A low wall under the eaves.
    const Eigen::Vector2d beside = wall.normal() * (wall.thickness.value_m / 2 + 0.15);
    return shareAlong(wall.start, wall.end, [&](const Eigen::Vector2d& p)
                      { return std::min(slopeNear(plan, p + beside), slopeNear(plan, p - beside)) < top + 0.5; }) > 0.5;
}

double distanceTo(const Segment& s, const Eigen::Vector2d& p)
{
    const Eigen::Vector2d d = s.b - s.a;
    const double length2 = d.squaredNorm();
    const double u = length2 > 0 ? std::clamp((p - s.a).dot(d) / length2, 0.0, 1.0) : 0.0;
    return (s.a + d * u - p).norm();
}

/// The free face with its walls given back their true thickness.
void addFace(const Polygon& face, const std::vector<Segment>& wallEdges, RoomKind kind, RoomPlan& plan)
{
    const double half = plan.wideningHalf_m;
    const auto isOnWall = [&](const Segment& e)
    {
        const Eigen::Vector2d middle = (e.a + e.b) / 2;
        return std::any_of(wallEdges.begin(), wallEdges.end(),
                           [&](const Segment& w) { return distanceTo(w, middle) < kOnWall_m; });
    };
    double all = 0, onWall = 0, underRoof = 0;
    for (const Segment& e : edgesOf(std::span(&face, 1)))
    {
        const double length = (e.b - e.a).norm();
        all += length;
        if (isOnWall(e))
        {
            onWall += length;
            continue;
        }
        const Eigen::Vector2d inward = Eigen::Vector2d(e.a.y() - e.b.y(), e.b.x() - e.a.x()) / length * 0.2;
        underRoof += length * shareAlong(e.a + inward, e.b + inward, [&](const Eigen::Vector2d& p)
                                         { return slopeNear(plan, p) < plan.level.floor_m + kEaves_m; });
    }
    for (Polygon& outline : offsetEdges(face, [&](const Segment& e) { return isOnWall(e) ? half : 0.0; }))
    {
        Room room;
        room.outline = std::move(outline);
        room.core = face;
        room.kind = kind;
        room.wallShare = all > 0 ? onWall / all : 0;
        room.roofShare = all > 0 ? underRoof / all : 0;
        plan.rooms.push_back(std::move(room));
    }
}

std::vector<Polygon> holesOf(const std::vector<Polygon>& polygons)
{
    std::vector<Polygon> holes;
    for (const Polygon& p : polygons)
        for (const Ring& hole : p.holes)
            holes.push_back({hole, {}});
    return holes;
}

void setPixels(PlanBits& bits, const PlanGrid& grid, const std::vector<Polygon>& polygons)
{
    for (const Polygon& p : polygons)
        forEachPixel(p, grid, [&](std::size_t i) { bits[i] = 1; });
}

/// Areas that were seen as room outside of what the walls enclose.
std::vector<Polygon> openAreas(const RoomPlan& plan, const std::vector<Polygon>& solid,
                               const std::vector<Polygon>& enclosed)
{
    const PlanGrid& grid = plan.grid;
    PlanBits wall(grid.size(), 0), taken(grid.size(), 0), open(grid.size(), 0);
    setPixels(wall, grid, solid);
    setPixels(taken, grid, enclosed);
    const std::uint8_t layer = plan.hasCeiling ? kCeilingLayer : kFloorLayer;
    for (std::size_t i = 0; i < open.size(); ++i)
        open[i] = plan.seen[i] & layer;
    const int gap = grid.reach(0.15);
    open = eroded(dilated(open, grid, gap), grid, gap);
    for (std::size_t i = 0; i < open.size(); ++i)
        open[i] = open[i] && !taken[i] && !wall[i];
    const int narrow = grid.reach(kOpenWidth_m / 2);
    const PlanBits wide = dilated(eroded(open, grid, narrow), grid, narrow);
    if (std::none_of(wide.begin(), wide.end(), [](std::uint8_t v) { return v != 0; }))
        return {};
    // Up to the walls beside it, and into them: the walls' own faces then bound it exactly.
    PlanBits all(grid.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = (open[i] && wide[i]) || wall[i];
    const PlanBits joined = eroded(dilated(all, grid, gap), grid, gap);
    PlanBits grown = dilated(wide, grid, gap + 1);
    for (std::size_t i = 0; i < all.size(); ++i)
        grown[i] = grown[i] && joined[i] && !taken[i] && (wide[i] || wall[i] || !open[i]);
    StraightenOptions options;
    options.directions = directionsOf(plan.walls);
    options.detail_m = std::max(0.3, 4 * grid.pixel_m);
    std::vector<Polygon> walls = solid;
    walls.insert(walls.end(), enclosed.begin(), enclosed.end());
    std::vector<Polygon> areas = subtract(straightOutlines(grown, grid, options), walls);
    std::erase_if(areas, [](const Polygon& p)
                  { return area(p) < kOpenArea_m2 || 2 * area(p) < 0.5 * kOpenWidth_m * perimeter(p); });
    return areas;
}

struct Shares
{
    double seen = 0, covered = 0;
};

Shares sharesOf(const Polygon& outline, const RoomPlan& plan)
{
    std::size_t all = 0, seen = 0, covered = 0;
    forEachPixel(outline, plan.grid,
                 [&](std::size_t i)
                 {
                     ++all;
                     seen += (plan.seen[i] & (kFloorLayer | kCeilingLayer | kBetweenLayer)) != 0;
                     covered += (plan.seen[i] & kCoverLayer) != 0;
                 });
    const double n = static_cast<double>(std::max<std::size_t>(1, all));
    return {static_cast<double>(seen) / n, static_cast<double>(covered) / n};
}

}  // namespace

Polygon widened(const Wall& wall, double by_m)
{
    Wall wide = wall;
    wide.thickness.value_m += 2 * by_m;
    wide.bodyStart_m -= by_m;
    wide.bodyEnd_m += by_m;
    return {wide.outline(), {}};
}

std::vector<double> directionsOf(const std::vector<Wall>& walls)
{
    std::vector<double> directions{0.0, std::numbers::pi / 2};
    for (const Wall& w : walls)
    {
        if (w.bulge != 0.0 || w.axisLength_m() < 1.0)
            continue;
        const Eigen::Vector2d t = w.direction();
        double angle = std::fmod(std::atan2(t.y(), t.x()) + std::numbers::pi, std::numbers::pi);
        const auto isNear = [&](double d) { return std::abs(std::remainder(angle - d, std::numbers::pi)) < 0.05; };
        if (std::none_of(directions.begin(), directions.end(), isNear))
            directions.push_back(angle);
    }
    return directions;
}

RoomPlan planRooms(const PlanCells& cells, const Level& level, std::vector<Wall> walls, const SpaceParams& params,
                   const Context& context)
{
    RoomPlan plan;
    plan.level = level;
    plan.walls = std::move(walls);
    plan.grid = cells.grid;
    plan.seen = rasterOf(cells, level);
    plan.slopes = slopesOf(cells, level);
    context.checkCancelled();
    const auto count = [&](std::uint8_t layer)
    { return std::count_if(plan.seen.begin(), plan.seen.end(), [&](std::uint8_t v) { return v & layer; }); };
    plan.hasCeiling = level.ceilingSeen || 5 * count(kCeilingLayer) > count(kFloorLayer);

    const double half = plan.wideningHalf_m = std::max(0.001, params.closeGap_m / 2);
    std::vector<Polygon> bodies;
    for (const Wall& w : plan.walls)
    {
        plan.isDividing.push_back(dividesRooms(w, plan, params));
        if (plan.isDividing.back())
            bodies.push_back(widened(w, half));
    }
    const std::vector<Polygon> solid = unite(bodies);
    const std::vector<Segment> edges = edgesOf(solid);
    const std::vector<Polygon> holes = holesOf(solid);
    for (const Polygon& face : subtract(holes, solid))
        addFace(face, edges, RoomKind::Room, plan);
    std::erase_if(plan.rooms, [](const Room& r) { return area(r.outline) < kFaint_m2; });
    for (Room& room : plan.rooms)
    {
        const Shares shares = sharesOf(room.outline, plan);
        if (shares.seen < params.minimumSeen)
            room.kind = RoomKind::Unseen;
        else if (plan.hasCeiling && shares.covered < params.minimumSeen)
            room.kind = RoomKind::Uncovered;
    }
    context.checkCancelled();
    // Without ceilings, ground outside looks like a floor inside: only walls can tell them apart.
    if (plan.hasCeiling || plan.rooms.empty())
        for (const Polygon& face : openAreas(plan, solid, holes))
            addFace(face, edges, RoomKind::Open, plan);
    for (Room& room : plan.rooms)
        if (room.kind == RoomKind::Open && room.wallShare + room.roofShare >= params.minimumWallShare)
            room.kind = RoomKind::Room;
    // Beside better ones, what no wall bounds is a soffit, a tree, a car's roof.
    const bool hasBounded =
        std::any_of(plan.rooms.begin(), plan.rooms.end(), [](const Room& r) { return r.wallShare >= kFewWalls; });
    std::erase_if(plan.rooms, [&](const Room& r) { return hasBounded && r.wallShare < kFewWalls; });
    std::stable_sort(plan.rooms.begin(), plan.rooms.end(),
                     [](const Room& a, const Room& b)
                     {
                         const Eigen::Vector2d& p = a.outline.outer.front();
                         const Eigen::Vector2d& q = b.outline.outer.front();
                         return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
                     });
    measureHeights(cells, plan);
    return plan;
}

}  // namespace s2b

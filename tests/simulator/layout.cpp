// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/layout.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace s2b::sim
{

namespace
{

constexpr double kCubicleDepth_m = 1.45;
constexpr double kCubicleWidth_m = 1.0;  ///< at least, between axes
constexpr double kObliqueExtra_m = 2.4;  ///< a room next to the 30 degree wall is wider by this

double radians(double degrees)
{
    return degrees * std::numbers::pi / 180.0;
}

/// The four facades: 0 south, 1 east, 2 north, 3 west. South and north run through at the corners.
struct Facades
{
    std::vector<std::size_t> walls;
    std::vector<Eigen::Vector2d> joints;
};

Facades addFacades(const BuildingSpec& spec, const Shell& shell, StoreyPlan& plan)
{
    const double lean = shell.width_m * std::tan(radians(spec.facadeAngle_deg));
    const Eigen::Vector2d a(0.0, 0.0);
    const Eigen::Vector2d b(shell.length_m, 0.0);
    const Eigen::Vector2d c(shell.length_m + lean, shell.width_m);
    const Eigen::Vector2d d(0.0, shell.width_m);
    const double bulge = spec.curvedFacade ? std::tan(radians(60.0) / 4.0) : 0.0;
    Facades f;
    f.walls = {plan.addWall(a, b, 0.0, shell.exterior_m, true), plan.addWall(b, c, bulge, shell.exterior_m, true),
               plan.addWall(c, d, 0.0, shell.exterior_m, true), plan.addWall(d, a, 0.0, shell.exterior_m, true)};
    f.joints = {b, c, d, a};
    plan.corner(f.walls[0], JunctionEnd::End, f.walls[1], JunctionEnd::Start);
    plan.corner(f.walls[2], JunctionEnd::Start, f.walls[1], JunctionEnd::End);
    plan.corner(f.walls[2], JunctionEnd::End, f.walls[3], JunctionEnd::Start);
    plan.corner(f.walls[0], JunctionEnd::Start, f.walls[3], JunctionEnd::End);
    return f;
}

std::size_t addPartition(StoreyPlan& plan, const Eigen::Vector2d& from, std::size_t fromWall, const Eigen::Vector2d& to,
                         std::size_t toWall, double bulge, double thickness_m)
{
    const std::size_t wall = plan.addWall(from, to, bulge, thickness_m, false);
    plan.butt(wall, JunctionEnd::Start, fromWall);
    plan.butt(wall, JunctionEnd::End, toWall);
    return wall;
}

std::string roomName(const StoreyPlan& plan, const char* what, std::size_t number)
{
    return std::string(what) + " " + std::to_string(plan.storeyIndex()) + "." + (number < 10 ? "0" : "") +
           std::to_string(number);
}

/// A row of cubicles along the facade of a room, and what is left of the room.
struct Band
{
    std::size_t facade;
    std::size_t left, right;  ///< partitions, seen from the corridor towards the facade with x to the right
    std::size_t corridor;
    bool isSouth;
};

void addWetRoom(const BuildingSpec& spec, const Shell& shell, StoreyPlan& plan, const Band& band,
                const std::vector<Eigen::Vector2d>& ring, double height_m)
{
    const double facadeY = band.isSouth ? 0.0 : shell.width_m;
    const double frontY = facadeY + (band.isSouth ? 1.0 : -1.0) *
                                        (shell.exterior_m / 2.0 + kCubicleDepth_m + spec.cubicleThickness_m / 2.0);
    const auto at = [&](std::size_t side, double y)
    {
        const Wall& w = plan.wall(side);
        const AxisCurve row({0.0, y}, {1.0, y}, 0.0);
        return AxisCurve(w).meet(0.0, row, 0.0, 0.5 * (w.start + w.end));
    };
    const Eigen::Vector2d frontLeft = at(band.left, frontY);
    const Eigen::Vector2d frontRight = at(band.right, frontY);
    const std::size_t front =
        addPartition(plan, frontLeft, band.left, frontRight, band.right, 0.0, spec.cubicleThickness_m);
    const double from = std::max(frontLeft.x(), at(band.left, facadeY).x());
    const double to = std::min(frontRight.x(), at(band.right, facadeY).x());
    const int count = std::max(1, static_cast<int>((to - from) / kCubicleWidth_m));

    std::vector<std::size_t> dividers{band.left};
    for (int i = 1; i < count; ++i)
    {
        const double x = from + (to - from) * i / count;
        dividers.push_back(
            addPartition(plan, {x, frontY}, front, {x, facadeY}, band.facade, 0.0, spec.cubicleThickness_m));
    }
    dividers.push_back(band.right);
    const std::size_t first = plan.rooms.size();
    for (std::size_t i = 0; i + 1 < dividers.size(); ++i)
    {
        const std::size_t l = dividers[i];
        const std::size_t r = dividers[i + 1];
        std::vector<std::size_t> walls{band.facade, r, front, l};
        std::vector<Eigen::Vector2d> joints{at(r, facadeY), at(r, frontY), at(l, frontY), at(l, facadeY)};
        if (!band.isSouth)
        {
            walls = {front, r, band.facade, l};
            joints = {at(r, frontY), at(r, facadeY), at(l, facadeY), at(l, frontY)};
        }
        plan.addRoom(RoomKind::Cubicle, roomName(plan, "WC", plan.rooms.size() - first + 1), walls, joints, height_m);
    }
    // ring: facade-right, corridor-right, corridor-left, facade-left (south) or mirrored (north).
    if (band.isSouth)
        plan.addRoom(RoomKind::Wet, roomName(plan, "Washroom", 1), {front, band.right, band.corridor, band.left},
                     {frontRight, ring[1], ring[2], frontLeft}, height_m);
    else
        plan.addRoom(RoomKind::Wet, roomName(plan, "Washroom", 1), {band.corridor, band.right, front, band.left},
                     {ring[0], frontRight, frontLeft, ring[3]}, height_m);
}

/// Rooms on one side of the corridor.
void addSide(const BuildingSpec& spec, const Shell& shell, StoreyPlan& plan, const Facades& facades,
             std::size_t corridor, bool isSouth, Random& random)
{
    const int n = spec.roomsPerSide;
    const double corridorY = isSouth ? shell.corridorFrom_m : shell.corridorTo_m;
    const double facadeY = isSouth ? 0.0 : shell.width_m;
    const double depth = std::abs(facadeY - corridorY);
    std::vector<double> widths;
    for (int i = 0; i < n; ++i)
        widths.push_back(random.uniform(spec.roomWidth_m.min_m, spec.roomWidth_m.max_m));
    if (spec.obliqueWalls && isSouth)
        widths[1] += kObliqueExtra_m;
    const double scale = shell.length_m / std::accumulate(widths.begin(), widths.end(), 0.0);

    const std::size_t facade = facades.walls[isSouth ? 0 : 2];
    std::vector<std::size_t> sides{facades.walls[3]};
    std::vector<Eigen::Vector2d> onCorridor{plan.crossing(facades.walls[3], corridor, {0.0, corridorY})};
    std::vector<Eigen::Vector2d> onFacade{{0.0, facadeY}};
    double x = 0.0;
    for (int i = 1; i < n; ++i)
    {
        x += widths[static_cast<std::size_t>(i) - 1] * scale;
        double shift = 0.0;
        double bulge = 0.0;
        if (spec.obliqueWalls && i == 1)
            shift = depth * std::tan(radians(isSouth ? 30.0 : 4.0));
        else if (spec.curvedWalls && !isSouth && i == n - 1)
            bulge = std::tan(radians(random.uniform(50.0, 65.0)) / 4.0);
        onCorridor.emplace_back(x, corridorY);
        onFacade.emplace_back(x + shift, facadeY);
        sides.push_back(addPartition(plan, onCorridor.back(), corridor, onFacade.back(), facade, bulge,
                                     random.pick(spec.partitionThickness_m)));
    }
    sides.push_back(facades.walls[1]);
    onCorridor.push_back(plan.crossing(facades.walls[1], corridor, {shell.length_m, corridorY}));
    onFacade.push_back(facades.joints[isSouth ? 0 : 1]);

    const int wet = spec.cubicles && isSouth ? (n <= 3 ? n - 1 : 2) : -1;
    for (int i = 0; i < n; ++i)
    {
        const auto k = static_cast<std::size_t>(i);
        std::vector<std::size_t> walls{facade, sides[k + 1], corridor, sides[k]};
        std::vector<Eigen::Vector2d> joints{onFacade[k + 1], onCorridor[k + 1], onCorridor[k], onFacade[k]};
        if (!isSouth)
        {
            walls = {corridor, sides[k + 1], facade, sides[k]};
            joints = {onCorridor[k + 1], onFacade[k + 1], onFacade[k], onCorridor[k]};
        }
        const double drop = random.uniform(0.25, 0.4);
        const double height =
            spec.suspendedCeilings && i % 2 == 0 ? std::max(2.4, shell.clearHeight_m - drop) : shell.clearHeight_m;
        if (i == wet)
            addWetRoom(spec, shell, plan, {facade, sides[k], sides[k + 1], corridor, isSouth}, joints, height);
        else
            plan.addRoom(spec.stairs && !isSouth && i == 0 ? RoomKind::Stair : RoomKind::Office,
                         roomName(plan, "Room", k + (isSouth ? 1 : 51)), walls, joints,
                         spec.stairs && !isSouth && i == 0 ? shell.clearHeight_m : height);
    }
}

void addCorridor(const BuildingSpec& spec, const Shell& shell, StoreyPlan& plan, const Facades& facades, Random& random)
{
    const std::size_t west = facades.walls[3];
    const std::size_t east = facades.walls[1];
    const auto at = [&](std::size_t wall, double y)
    {
        return AxisCurve(plan.wall(wall))
            .meet(0.0, AxisCurve({0.0, y}, {1.0, y}, 0.0), 0.0,
                  {shell.length_m * 0.5 + (wall == east ? 1e3 : -1e3), y});
    };
    const double y0 = shell.corridorFrom_m;
    const double y1 = shell.corridorTo_m;
    const std::size_t south =
        addPartition(plan, at(west, y0), west, at(east, y0), east, 0.0, random.pick(spec.partitionThickness_m));
    const std::size_t north =
        addPartition(plan, at(west, y1), west, at(east, y1), east, 0.0, random.pick(spec.partitionThickness_m));
    const double drop = random.uniform(0.25, 0.4);
    plan.addRoom(RoomKind::Corridor, roomName(plan, "Corridor", 0), {south, east, north, west},
                 {at(east, y0), at(east, y1), at(west, y1), at(west, y0)},
                 spec.suspendedCeilings ? std::max(2.4, shell.clearHeight_m - drop) : shell.clearHeight_m);
    addSide(spec, shell, plan, facades, south, true, random);
    addSide(spec, shell, plan, facades, north, false, random);
}

}  // namespace

Shell makeShell(const BuildingSpec& spec)
{
    Random random{spec.seed, 0x5e11};
    Shell shell;
    shell.exterior_m = random.pick(spec.exteriorThickness_m);
    shell.clearHeight_m = random.uniform(spec.clearHeight_m.min_m, spec.clearHeight_m.max_m);
    shell.slab_m = random.uniform(spec.slabThickness_m.min_m, spec.slabThickness_m.max_m);
    const auto width = [&] { return random.uniform(spec.roomWidth_m.min_m, spec.roomWidth_m.max_m); };
    const auto depth = [&] { return random.uniform(spec.roomDepth_m.min_m, spec.roomDepth_m.max_m); };
    if (spec.layout != Layout::Corridor)
    {
        shell.length_m = width() + (spec.layout == Layout::TwoRooms ? width() : 0.0);
        shell.width_m = depth();
        return shell;
    }
    for (int i = 0; i < spec.roomsPerSide; ++i)
        shell.length_m += width();
    if (spec.obliqueWalls)
        shell.length_m += kObliqueExtra_m;
    shell.corridorFrom_m = depth();
    shell.corridorTo_m = shell.corridorFrom_m + random.uniform(spec.corridorWidth_m.min_m, spec.corridorWidth_m.max_m);
    shell.width_m = shell.corridorTo_m + depth();
    return shell;
}

std::vector<Eigen::Vector2d> layOut(const BuildingSpec& spec, const Shell& shell, StoreyPlan& plan)
{
    Random random{spec.seed, 0x1a7, plan.storeyIndex()};
    const Facades f = addFacades(spec, shell, plan);
    if (spec.layout == Layout::Corridor)
    {
        addCorridor(spec, shell, plan, f, random);
    }
    else if (spec.layout == Layout::OneRoom)
    {
        plan.addRoom(RoomKind::Office, roomName(plan, "Room", 1), f.walls, f.joints, shell.clearHeight_m);
    }
    else
    {
        const double x = shell.length_m * random.uniform(0.42, 0.58);
        const double bulge = spec.curvedWalls ? std::tan(radians(60.0) / 4.0) : 0.0;
        const double shift = spec.obliqueWalls && !spec.curvedWalls ? shell.width_m * std::tan(radians(4.0)) : 0.0;
        const Eigen::Vector2d south(x - shift / 2.0, 0.0);
        const Eigen::Vector2d north(x + shift / 2.0, shell.width_m);
        const std::size_t wall =
            addPartition(plan, south, f.walls[0], north, f.walls[2], bulge, random.pick(spec.partitionThickness_m));
        plan.addRoom(RoomKind::Office, roomName(plan, "Room", 1), {f.walls[0], wall, f.walls[2], f.walls[3]},
                     {south, north, f.joints[2], f.joints[3]}, shell.clearHeight_m);
        plan.addRoom(RoomKind::Office, roomName(plan, "Room", 2), {f.walls[0], f.walls[1], f.walls[2], wall},
                     {f.joints[0], f.joints[1], north, south}, shell.clearHeight_m);
    }
    return plan.faceRing(f.walls, f.joints, false);
}

}  // namespace s2b::sim

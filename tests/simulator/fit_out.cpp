// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/layout.h"
#include "tests/simulator/variety.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace s2b::sim
{

namespace
{

void setLeaf(const BuildingSpec& spec, const StoreyPlan& plan, Opening& door, std::size_t wall, const Room& opensInto,
             int leaves, Random& random)
{
    door.leaves = leaves;
    const double draw = random.uniform();
    door.leafState = draw < spec.removedDoors                    ? LeafState::Removed
                     : draw < spec.removedDoors + spec.openDoors ? LeafState::Open
                                                                 : LeafState::Closed;
    door.hingeAtStart = random.chance(0.5);
    door.opensToLeft = plan.sideOf(wall, opensInto) > 0.0;
}

void addDoors(const BuildingSpec& spec, StoreyPlan& plan)
{
    if (spec.layout != Layout::Corridor)
    {
        // One door: in the partition of two rooms (their second wall), in the south wall of a single room.
        Random random{spec.seed, 0xd00e, plan.storeyIndex()};
        const Room& room = plan.rooms.front();
        const std::size_t wall = room.walls[spec.layout == Layout::TwoRooms ? 1 : 0];
        if (Opening* door = plan.addOpening(wall, room, OpeningKind::Door, 0.885, 2.01, 0.0, random, 0.5))
            setLeaf(spec, plan, *door, wall, room, 1, random);
        return;
    }
    const Room& corridor = plan.rooms.front();
    std::size_t index = 0;
    for (const Room& room : plan.rooms)
    {
        Random random{spec.seed, 0xd00f, plan.storeyIndex(), index++};
        const std::vector<double> widths{0.76, 0.885, 0.885, 1.01};
        const double height = random.chance(0.7) ? 2.01 : 2.135;
        if (room.kind == RoomKind::Corridor)
        {
            // The entrance, from the west; above it the stretch is left to a window.
            if (plan.storeyIndex() != 0)
                continue;
            const double width = spec.doubleDoors ? 1.5 : 1.01;
            if (Opening* door = plan.addOpening(room.walls[3], room, OpeningKind::Door, width, 2.135, 0.0, random, 0.5))
                setLeaf(spec, plan, *door, room.walls[3], room, spec.doubleDoors ? 2 : 1, random);
            continue;
        }
        if (room.kind == RoomKind::Cubicle)
        {
            // Cubicles open outwards, into the room in front of them.
            const auto front = std::find_if(room.walls.begin(), room.walls.end(),
                                            [&](std::size_t w)
                                            {
                                                const auto& wet = plan.rooms;
                                                return std::any_of(wet.begin(), wet.end(),
                                                                   [&](const Room& r)
                                                                   {
                                                                       return r.kind == RoomKind::Wet &&
                                                                              (r.walls[0] == w || r.walls[2] == w) &&
                                                                              !plan.wall(w).isExternal;
                                                                   });
                                            });
            const auto wet = std::find_if(plan.rooms.begin(), plan.rooms.end(),
                                          [](const Room& r) { return r.kind == RoomKind::Wet; });
            if (front == room.walls.end() || wet == plan.rooms.end())
                continue;
            if (Opening* door = plan.addOpening(*front, room, OpeningKind::Door, 0.6, 2.01, 0.0, random, 0.5))
                setLeaf(spec, plan, *door, *front, *wet, 1, random);
            continue;
        }
        const auto shared = std::find_if(room.walls.begin(), room.walls.end(), [&](std::size_t w)
                                         { return w == corridor.walls[0] || w == corridor.walls[2]; });
        const bool isDouble = spec.doubleDoors && room.kind == RoomKind::Office && index % 4 == 3;
        const double width = isDouble ? random.uniform(1.4, 1.8) : random.pick(widths);
        if (Opening* door = plan.addOpening(*shared, room, OpeningKind::Door, width, height, 0.0, random))
            setLeaf(spec, plan, *door, *shared, room, isDouble ? 2 : 1, random);
    }
}

void addWindows(const BuildingSpec& spec, StoreyPlan& plan)
{
    std::size_t index = 0;
    for (const Room& room : plan.rooms)
    {
        Random random{spec.seed, 0x3193, plan.storeyIndex(), index++};
        const bool isSmall = room.kind == RoomKind::Cubicle;
        const bool isTall = room.kind == RoomKind::Office && random.chance(0.2);
        const double width = isSmall ? 0.5 : random.uniform(0.9, 1.6);
        const double sill = isSmall ? 1.6 : isTall ? 0.1 : random.uniform(0.75, 1.0);
        const double height = isSmall ? 0.6 : isTall ? 2.15 : random.uniform(1.2, 1.3);
        for (const std::size_t wall : room.walls)
        {
            if (!plan.wall(wall).isExternal || plan.wall(wall).bulge != 0.0)
                continue;
            const AxisCurve curve(plan.wall(wall));
            double from = 1e9;
            double to = -1e9;
            for (const Eigen::Vector2d& joint : room.joints)
            {
                const Eigen::Vector2d q = curve.project(joint);
                if (std::abs(q.y()) > 0.01)
                    continue;
                from = std::min(from, q.x());
                to = std::max(to, q.x());
            }
            const int count = isSmall ? 1 : static_cast<int>((to - from) / (width + 0.8));
            for (int i = 0; i < count; ++i)
                plan.addOpening(wall, room, OpeningKind::Window, width, height, sill, random,
                                count == 1 ? 0.5 : (i + 0.25) / (count - 0.5));
        }
    }
}

/// Passages between neighbouring offices.
void addPlainOpenings(const BuildingSpec& spec, StoreyPlan& plan)
{
    std::size_t index = 0;
    for (std::size_t i = 0; i + 1 < plan.rooms.size(); ++i)
    {
        const Room& a = plan.rooms[i];
        const Room& b = plan.rooms[i + 1];
        if (a.kind != RoomKind::Office || b.kind != RoomKind::Office)
            continue;
        Random random{spec.seed, 0x0be4, plan.storeyIndex(), i};
        for (const std::size_t wall : a.walls)
        {
            const bool isBetween = std::find(b.walls.begin(), b.walls.end(), wall) != b.walls.end();
            if (!isBetween || plan.wall(wall).isExternal || plan.wall(wall).bulge != 0.0 ||
                wall == plan.rooms[0].walls[0] || wall == plan.rooms[0].walls[2])
                continue;
            if (index++ % 2 == 0)
                plan.addOpening(wall, a, OpeningKind::Plain, random.uniform(0.9, 1.8), random.uniform(2.05, 2.3), 0.0,
                                random);
        }
    }
}

/// Rolled steel (HE, IPE, angles, channels, tees) and cast concrete sections in turn.
ProfileSection profileOf(std::size_t turn, Random& random)
{
    const std::vector<ProfileSection> known{
        {ProfileShape::I, 0.30, 0.30, 0.011, 0.019},   {ProfileShape::L, 0.20, 0.20, 0.020, 0.020},
        {ProfileShape::I, 0.19, 0.45, 0.0094, 0.0146}, {ProfileShape::L, 0.60, 0.45, 0.20, 0.20},
        {ProfileShape::U, 0.10, 0.30, 0.010, 0.016},   {ProfileShape::T, 0.30, 0.15, 0.011, 0.019}};
    ProfileSection section = known[turn % known.size()];
    const double scale = random.uniform(0.95, 1.05);  // no two alike
    for (double* size : {&section.width_m, &section.depth_m})
        *size *= scale;
    return section;
}

void addColumns(const BuildingSpec& spec, StoreyPlan& plan)
{
    std::size_t index = 0;
    for (const Room& room : plan.rooms)
    {
        if (room.kind != RoomKind::Office)
            continue;
        Random random{spec.seed, 0xc01, plan.storeyIndex(), index};
        const std::size_t turn = index++ % 3;
        const Eigen::Vector2d middle = room.middle();
        if (turn == 2 && spec.engagedColumns)
        {
            const auto facade = std::find_if(room.walls.begin(), room.walls.end(), [&](std::size_t w)
                                             { return plan.wall(w).isExternal && plan.wall(w).bulge == 0.0; });
            if (facade == room.walls.end())
                continue;
            const double width = random.pick(std::vector<double>{0.3, 0.35, 0.4});
            const double depth = 0.4;
            const double out = random.uniform(0.15, 0.3);  // of the wall
            const double s = plan.freeStretch(*facade, room, width, 0.3, random);
            if (s < 0.0)
                continue;
            const AxisCurve curve(plan.wall(*facade));
            const double offset =
                plan.sideOf(*facade, room) * (plan.wall(*facade).thickness.value_m / 2.0 + out - depth / 2.0);
            const Eigen::Vector2d along = curve.direction(s);
            plan.addColumn(curve.at(s + width / 2.0, offset), std::atan2(along.y(), along.x()),
                           RectangleSection{width, depth});
            plan.take(*facade, s, s + width);
        }
        else if ((turn == 0 && spec.rectangularColumns) || (turn == 1 && spec.roundColumns))
        {
            const Eigen::Vector2d center(middle.x() + random.uniform(-0.6, 0.6),
                                         middle.y() + random.uniform(-0.6, 0.6));
            if (room.clearance(center) < 0.9)
                continue;
            if (turn == 1)
                plan.addColumn(center, 0.0, CircleSection{random.pick(std::vector<double>{0.15, 0.2, 0.25})});
            else if (spec.profileColumns)
                plan.addColumn(center, random.pick(std::vector<double>{0.0, 0.5, 1.0, 1.5}) * std::numbers::pi,
                               profileOf((index - 1) / 3 + 2 * plan.storeyIndex(), random));
            else
                plan.addColumn(center, random.chance(0.3) ? std::numbers::pi / 4.0 : 0.0,
                               RectangleSection{random.pick(std::vector<double>{0.3, 0.4, 0.5}),
                                                random.pick(std::vector<double>{0.3, 0.4})});
        }
    }
}

}  // namespace

void fitOut(const BuildingSpec& spec, StoreyPlan& plan)
{
    if (spec.varied)
    {
        addVariedOpenings(spec, plan);
        addColumns(spec, plan);
        return;
    }
    if (spec.doors)
        addDoors(spec, plan);
    if (spec.plainOpenings)
        addPlainOpenings(spec, plan);
    addColumns(spec, plan);
    if (spec.windows)
        addWindows(spec, plan);
}

}  // namespace s2b::sim

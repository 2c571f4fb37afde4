// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/layout.h"
#include "tests/simulator/piece.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace s2b::sim
{

namespace
{

Prop table(Piece piece, double width, double depth)
{
    piece.box(0, 0, 0.725, width / 2, depth / 2, 0.015);
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            piece.box(x * (width / 2 - 0.06), y * (depth / 2 - 0.06), 0.355, 0.022, 0.022, 0.355);
    return piece.take();
}

Prop chair(Piece piece)
{
    piece.box(0, 0, 0.45, 0.22, 0.22, 0.025);
    piece.box(0, -0.2, 0.70, 0.21, 0.02, 0.22);
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            piece.box(x * 0.19, y * 0.19, 0.2125, 0.015, 0.015, 0.2125);
    return piece.take();
}

Prop shelf(Piece piece, double width, double depth, double height)
{
    const int boards = std::max(3, static_cast<int>(height / 0.35) + 1);
    for (int i = 0; i < boards; ++i)
        piece.box(0, 0, 0.05 + (height - 0.07) * i / (boards - 1), width / 2 - 0.02, depth / 2 - 0.01, 0.012);
    for (const double x : {-1.0, 1.0})
        piece.box(x * (width / 2 - 0.01), 0, height / 2, 0.01, depth / 2 - 0.01, height / 2);
    piece.box(0, -depth / 2 + 0.005, height / 2, width / 2, 0.005, height / 2);
    return piece.take();
}

struct Disc
{
    Eigen::Vector2d center;
    double radius;
};

}  // namespace

std::vector<Prop> furnish(const BuildingSpec& spec, const StoreyPlan& plan)
{
    std::vector<Prop> props;
    const Building& building = plan.building();
    const auto storey = static_cast<int>(plan.storeyIndex());
    const double floor = building.storeys[plan.storeyIndex()].elevation_m;
    const ElementId storeyId = building.storeys[plan.storeyIndex()].id;

    std::vector<Disc> taken;
    for (const Opening& opening : building.openings)
    {
        const Wall* host = building.wall(opening.host);
        if (host->storey == storeyId && opening.kind != OpeningKind::Window)
            taken.push_back({AxisCurve(*host).at(opening.offset_m + opening.width.value_m / 2.0),
                             opening.width.value_m / (opening.leaves == 2 ? 1.6 : 1.0) + 0.3});
    }
    for (const Column& column : building.columns)
        if (column.storey == storeyId)
            taken.push_back({column.center, 0.35});

    std::size_t index = 0;
    for (const Room& room : plan.rooms)
    {
        Random random{spec.seed, 0xf0a, plan.storeyIndex(), index++};
        if (room.kind == RoomKind::Cubicle || room.kind == RoomKind::Stair)
            continue;
        const double area = building.spaces[room.space].area_m2;
        const int target = room.kind == RoomKind::Office ? 1 + static_cast<int>(area / 4.5) : 1;
        const auto isFree = [&](const Eigen::Vector2d& at, double halfX, double halfY, double yaw, double gap)
        {
            const Eigen::Vector2d u(std::cos(yaw), std::sin(yaw));
            const Eigen::Vector2d n(-u.y(), u.x());
            for (const double x : {-1.0, 0.0, 1.0})
                for (const double y : {-1.0, 1.0})
                    if (room.clearance(at + u * (x * halfX) + n * (y * halfY)) < gap)
                        return false;
            const double radius = std::hypot(halfX, halfY);
            return std::none_of(taken.begin(), taken.end(),
                                [&](const Disc& d) { return (d.center - at).norm() < d.radius + 0.85 * radius; });
        };
        int placed = 0;
        for (int attempt = 0; attempt < target * 12 && placed < target; ++attempt)
        {
            const Colour colour = random.pick(pieceColours());
            const double draw = random.uniform();
            if (draw < 0.6 || room.kind != RoomKind::Office)
            {
                // Along a wall: cupboards to the floor and shelves.
                const std::size_t wall = random.pick(room.walls);
                const AxisCurve curve(plan.wall(wall));
                if (curve.isArc())
                    continue;
                const bool isShelf = random.chance(0.4);
                const double width = random.uniform(0.6, 1.6);
                const double depth = room.kind == RoomKind::Office ? random.uniform(0.3, 0.6) : 0.3;
                const std::vector<double> heights{0.75, 0.9, 1.2, 1.6, 1.9, 2.1};
                const double height = random.pick(heights) * random.uniform(0.97, 1.03);
                const double gap = random.pick(std::vector<double>{0.002, 0.005, 0.02, 0.05});
                const double side = plan.sideOf(wall, room);
                const Eigen::Vector2d at =
                    curve.at(random.uniform(0.0, curve.length()),
                             side * (plan.wall(wall).thickness.value_m / 2.0 + gap + depth / 2.0));
                const Eigen::Vector2d out = curve.normal(0.0) * side;
                const double yaw = std::atan2(out.y(), out.x()) - std::numbers::pi / 2.0;
                if (!isFree(at, width / 2.0, depth / 2.0, yaw, 0.9 * gap))
                    continue;
                Piece piece(isShelf ? "shelf" : "cupboard", at, floor, yaw, storey, colour);
                if (isShelf)
                    props.push_back(shelf(std::move(piece), width, depth, height));
                else
                {
                    piece.box(0, 0, height / 2, width / 2, depth / 2, height / 2);
                    props.push_back(piece.take());
                }
                taken.push_back({at, std::hypot(width, depth) / 2.0});
                ++placed;
                continue;
            }
            const Eigen::Vector2d middle = room.middle();
            const Eigen::Vector2d at(middle.x() + random.uniform(-1.8, 1.8), middle.y() + random.uniform(-1.8, 1.8));
            if (draw < 0.85)
            {
                const double width = random.uniform(1.2, 1.8);
                const double depth = random.uniform(0.7, 0.9);
                const double yaw = (random.chance(0.5) ? std::numbers::pi / 2.0 : 0.0) + 0.1 * random.gaussian();
                if (!isFree(at, width / 2.0, depth / 2.0 + 0.5, yaw, 0.1))
                    continue;
                props.push_back(table(Piece("table", at, floor, yaw, storey, colour), width, depth));
                for (const double side : {-1.0, 1.0})
                {
                    const Eigen::Vector2d n(-std::sin(yaw), std::cos(yaw));
                    if (random.chance(0.8))
                        props.push_back(
                            chair(Piece("chair", at + n * (side * (depth / 2.0 + 0.15)), floor,
                                        yaw + (side < 0.0 ? 0.0 : std::numbers::pi) + 0.3 * random.gaussian(), storey,
                                        random.pick(pieceColours()))));
                }
                taken.push_back({at, std::hypot(width, depth) / 2.0 + 0.3});
                ++placed;
            }
            else
            {
                const double w = random.uniform(0.25, 0.6);
                const double d = random.uniform(0.25, 0.5);
                const double h = random.uniform(0.25, 0.9);
                const double yaw = random.uniform(0.0, std::numbers::pi);
                if (!isFree(at, w / 2.0, d / 2.0, yaw, 0.05))
                    continue;
                Piece piece("box", at, floor, yaw, storey, colour);
                piece.box(0, 0, h / 2, w / 2, d / 2, h / 2);
                props.push_back(piece.take());
                taken.push_back({at, std::hypot(w, d) / 2.0});
                ++placed;
            }
        }
    }
    return props;
}

}  // namespace s2b::sim

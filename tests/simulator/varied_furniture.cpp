// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/piece.h"
#include "tests/simulator/variety.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace s2b::sim
{

namespace
{

struct Disc
{
    Eigen::Vector2d center;
    double radius;
};

/// Books, folders, boxes, screens: things of many sizes side by side on a board, y from `back` to `front`.
void addThings(Piece& piece, double width, double back, double front, double z, double most, double filled,
               Random& random)
{
    for (double x = -width / 2.0 + 0.02; x < width / 2.0 - 0.05;)
    {
        const double size = std::min(random.uniform(0.04, 0.45), width / 2.0 - 0.02 - x);
        if (size > 0.03 && random.chance(filled))
        {
            const double depth = random.uniform(0.4, 1.0) * (front - back);
            const double height = random.uniform(0.25, 1.0) * most;
            const double from = random.chance(0.5) ? back : random.uniform(back, front - depth);
            piece.box(x + size / 2.0, from + depth / 2.0, z + height / 2.0, size / 2.0 - 0.003, depth / 2.0,
                      height / 2.0);
        }
        x += size + random.uniform(0.0, 0.06);
    }
}

/// A shelf full of things, with a back and sides or without.
void addFilledShelf(Piece& piece, double width, double depth, double height, Random& random)
{
    const double filled = random.uniform(0.3, 0.95);
    const double spacing = random.uniform(0.25, 0.5);
    if (random.chance(0.5))
        piece.box(0, -depth / 2.0 + 0.005, height / 2.0, width / 2.0, 0.005, height / 2.0);
    for (double x = -width / 2.0; x <= width / 2.0 + 1e-6; x += width / std::max(1.0, std::round(width / 1.0)))
        piece.box(x, 0, height / 2.0, 0.015, depth / 2.0, height / 2.0);
    for (double z = random.uniform(0.03, 0.12); z < height; z += spacing)
    {
        piece.box(0, 0, z, width / 2.0, depth / 2.0, 0.012);
        addThings(piece, width, -depth / 2.0, depth / 2.0, z + 0.012, spacing - 0.05, filled, random);
    }
}

/// A desk or bench with things on it and below it.
void addFilledDesk(Piece& piece, double width, double depth, Random& random)
{
    const double height = random.uniform(0.68, 0.95);
    piece.box(0, 0, height, width / 2.0, depth / 2.0, 0.015);
    for (const double x : {-1.0, 1.0})
    {
        if (random.chance(0.5))
            piece.box(x * (width / 2.0 - 0.2), 0, height / 2.0, 0.2, 0.45 * depth, height / 2.0);
        else
            piece.box(x * (width / 2.0 - 0.03), 0, height / 2.0, 0.02, 0.45 * depth, height / 2.0);
    }
    addThings(piece, width, -depth / 2.0, depth / 2.0, height + 0.015, random.uniform(0.15, 0.7),
              random.uniform(0.2, 0.8), random);
    if (random.chance(0.4))
        addThings(piece, 0.8 * width, -depth / 2.0, depth / 2.0, 0.0, 0.6 * height, 0.4, random);
}

class Furnisher
{
public:
    Furnisher(const BuildingSpec& spec, const StoreyPlan& plan, const std::vector<Prop>& before)
        : m_spec(spec), m_plan(plan), m_storey(static_cast<int>(plan.storeyIndex()))
    {
        const Building& building = plan.building();
        const Storey& storey = building.storeys[plan.storeyIndex()];
        m_floor = storey.elevation_m;
        for (const Opening& opening : building.openings)
        {
            const Wall* host = building.wall(opening.host);
            if (host->storey != storey.id)
                continue;
            const Eigen::Vector2d at = AxisCurve(*host).at(opening.offset_m + opening.width.value_m / 2.0);
            const double half = opening.width.value_m / 2.0;
            (opening.sill.value_m > 0.3 ? m_windows : m_doors).push_back({at, half + 0.15});
        }
        for (const Column& column : building.columns)
            if (column.storey == storey.id)
                m_taken.push_back({column.center, 0.35});
        for (const Prop& prop : before)
            for (const PropBox& box : prop.boxes)
                if (prop.storey == m_storey && box.center.z() - box.half.z() < m_floor + 2.0)
                    m_taken.push_back({box.center.head<2>(), box.half.head<2>().norm()});
    }

    std::vector<Prop> furnish()
    {
        // Some buildings are full of furniture: little is seen of the lower half of their walls.
        Random crowd{m_spec.seed, 0x7f1};
        const double density = crowd.chance(0.3) ? crowd.uniform(1.5, 4.0) : 1.0;
        std::size_t index = 0;
        for (const Room& room : m_plan.rooms)
        {
            Random random{m_spec.seed, 0x7f0, m_plan.storeyIndex(), index++};
            if (room.kind == RoomKind::Stair || room.kind == RoomKind::Cubicle)
                continue;
            const int pieces = static_cast<int>(m_plan.building().spaces[room.space].area_m2 / 6.0 * density *
                                                random.uniform(0.0, 1.5));
            for (int i = 0; i < std::min(pieces, 16); ++i)
                alongWall(room, random);
            for (int i = 0; i < std::min(pieces / 2, 4); ++i)
                inTheRoom(room, random);
            lamps(room, random);
            services(room, random);
        }
        return std::move(m_props);
    }

private:
    struct Place
    {
        Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< on the wall's face
        Eigen::Vector2d out = Eigen::Vector2d::Zero();
        double yaw = 0.0;
    };

    Piece piece(const char* kind, const Place& place, double off, Random& random) const
    {
        return {kind, place.at + place.out * off, m_floor, place.yaw, m_storey, random.pick(pieceColours())};
    }

    /// A stretch of a straight wall's face, clear of doors and furniture; of windows too unless `underWindows`.
    bool find(const Room& room, double width, double depth, bool underWindows, Random& random, Place& place) const
    {
        const std::size_t wall = random.pick(room.walls);
        const AxisCurve curve(m_plan.wall(wall));
        if (curve.isArc())
            return false;
        const double side = m_plan.sideOf(wall, room);
        const double s = random.uniform(0.0, curve.length());
        place.out = curve.normal(0.0) * side;
        place.at = curve.at(s, side * m_plan.wall(wall).thickness.value_m / 2.0);
        place.yaw = std::atan2(place.out.y(), place.out.x()) - std::numbers::pi / 2.0;
        const Eigen::Vector2d along(place.out.y(), -place.out.x());
        for (const double x : {-0.5, 0.0, 0.5})
            for (const double y : {0.01, depth})
                if (room.clearance(place.at + along * (x * width) + place.out * y) < 0.005)
                    return false;
        const auto isClear = [&](const std::vector<Disc>& discs)
        {
            return std::none_of(discs.begin(), discs.end(),
                                [&](const Disc& d)
                                {
                                    const Eigen::Vector2d q = d.center - place.at;
                                    return std::abs(q.dot(along)) < width / 2.0 + d.radius && q.dot(place.out) > -0.7 &&
                                           q.dot(place.out) < depth + d.radius + 0.3;
                                });
        };
        return isClear(m_doors) && isClear(m_taken) && (underWindows || isClear(m_windows));
    }

    void take(const Place& place, double width, double depth)
    {
        const Eigen::Vector2d along(place.out.y(), -place.out.x());
        for (double x = -width / 2.0 + depth / 2.0; x <= width / 2.0; x += depth)
            m_taken.push_back({place.at + place.out * depth / 2.0 + along * x, 0.7 * depth});
    }

    void alongWall(const Room& room, Random& random)
    {
        const double clear = m_plan.building().spaces[room.space].height.value_m;
        Place place;
        const double draw = random.uniform();
        const double gap = random.pick(std::vector<double>{0.0, 0.002, 0.01, 0.03});
        const bool isFilled = random.chance(0.3);
        const bool isShelf = random.chance(0.55);
        for (int attempt = 0; attempt < 15; ++attempt)
        {
            if (isFilled)
            {
                const double width = random.uniform(0.8, 3.0);
                const double depth = isShelf ? random.uniform(0.22, 0.5) : random.uniform(0.5, 0.9);
                const double height = std::min(clear - 0.1, random.uniform(1.2, 2.5));
                if (!find(room, width, depth + gap, !isShelf, random, place))
                    continue;
                Piece p = piece(isShelf ? "shelf" : "desk", place, gap + depth / 2.0, random);
                if (isShelf)
                    addFilledShelf(p, width, depth, height, random);
                else
                    addFilledDesk(p, width, depth, random);
                m_props.push_back(p.take());
                take(place, width, depth);
                return;
            }
            if (draw < 0.3)  // a wardrobe or a run of them, up to the ceiling or not
            {
                const double width = random.uniform(0.8, 3.0), depth = random.uniform(0.3, 0.65);
                const double height = random.chance(0.3) ? clear : std::min(clear, random.uniform(1.7, 2.4));
                if (!find(room, width, depth + gap, false, random, place))
                    continue;
                Piece p = piece("wardrobe", place, gap + depth / 2.0, random);
                p.box(0, 0, height / 2, width / 2, depth / 2, height / 2);
                for (double x = -width / 2 + 0.5; x < width / 2 - 0.2; x += 0.5)
                    p.box(x - 0.05, depth / 2 + 0.01, 1.05, 0.01, 0.01, 0.1);
                m_props.push_back(p.take());
                take(place, width, depth);
                return;
            }
            if (draw < 0.5)  // a kitchen
            {
                const double width = random.uniform(1.2, 3.6);
                const bool hasUpper = random.chance(0.7);
                if (!find(room, width, 0.6, !hasUpper, random, place))
                    continue;
                Piece p = piece("kitchen", place, 0.3, random);
                p.box(0, -0.02, 0.49, width / 2, 0.28, 0.39);
                p.box(0, 0, 0.9, width / 2, 0.3, 0.02);
                if (hasUpper)
                    p.box(0, -0.125, 1.8, width / 2, 0.175, random.uniform(0.25, 0.4));
                m_props.push_back(p.take());
                take(place, width, 0.6);
                return;
            }
            if (draw < 0.62)  // a picture, a board or a screen
            {
                const double width = random.uniform(0.4, 1.8), height = random.uniform(0.4, 1.1);
                if (!find(room, width, 0.05, false, random, place))
                    continue;
                Piece p = piece("picture", place, 0.018, random);
                p.box(0, 0, 1.5, width / 2, random.uniform(0.008, 0.018), height / 2);
                m_props.push_back(p.take());
                return;
            }
            if (draw < 0.74)  // a radiator
            {
                const double width = random.uniform(0.6, 1.8);
                if (!find(room, width, 0.15, true, random, place))
                    continue;
                Piece p = piece("radiator", place, 0.09, random);
                p.box(0, 0, 0.4, width / 2, 0.05, 0.28);
                m_props.push_back(p.take());
                return;
            }
            if (draw < 0.86)  // a sofa or a bed
            {
                const bool isBed = random.chance(0.5);
                const double width = random.uniform(0.9, 2.2), depth = isBed ? 2.0 : 0.9;
                if (!find(room, width, depth, true, random, place))
                    continue;
                Piece p = piece(isBed ? "bed" : "sofa", place, depth / 2.0 + 0.01, random);
                p.box(0, 0, 0.22, width / 2, depth / 2, 0.2);
                p.box(0, -depth / 2 + 0.1, 0.5, width / 2, 0.08, 0.4);
                m_props.push_back(p.take());
                take(place, width, depth);
                return;
            }
            // Curtains at both sides of a stretch, a handbreadth before the wall.
            const double width = random.uniform(1.2, 2.6);
            if (!find(room, width, 0.15, true, random, place))
                continue;
            Piece p = piece("curtain", place, 0.1, random);
            for (const double side : {-1.0, 1.0})
                for (int i = 0; i < 4; ++i)
                    p.box(side * (width / 2 - 0.08 * i), i % 2 == 0 ? 0.02 : -0.02, clear / 2, 0.04, 0.015,
                          clear / 2 - 0.06);
            m_props.push_back(p.take());
            return;
        }
    }

    void inTheRoom(const Room& room, Random& random)
    {
        const Eigen::Vector2d middle = room.middle();
        for (int attempt = 0; attempt < 8; ++attempt)
        {
            const Eigen::Vector2d at = middle + Eigen::Vector2d(random.uniform(-3, 3), random.uniform(-3, 3));
            const double width = random.uniform(0.5, 1.1), depth = random.uniform(0.3, 0.9);
            const double radius = std::hypot(width, depth);
            const auto isNear = [&](const Disc& d) { return (d.center - at).norm() < d.radius + radius + 0.2; };
            if (room.clearance(at) < radius + 0.1 || std::any_of(m_taken.begin(), m_taken.end(), isNear) ||
                std::any_of(m_doors.begin(), m_doors.end(), isNear))
                continue;
            Piece p("island", at, m_floor, random.chance(0.6) ? 0.0 : random.uniform(0.0, 3.1), m_storey,
                    random.pick(pieceColours()));
            const double draw = random.uniform();
            if (random.chance(0.35))
                addFilledDesk(p, 2.0 * width, 2.0 * std::min(depth, 0.5), random);
            else if (draw < 0.4)
                p.box(0, 0, 0.46, width, depth, 0.46);  // a kitchen island, a counter
            else if (draw < 0.6)
            {
                const double height = random.uniform(1.4, 2.0);  // a free-standing cupboard or rack
                p.box(0, 0, height / 2, width, 0.2, height / 2);
            }
            else if (draw < 0.8)
            {
                p.box(0, 0, 0.9, width, 0.02, 0.7);  // a partition screen
                p.box(0, 0, 0.05, 0.05, 0.25, 0.05);
            }
            else
            {
                p.box(0, 0, 0.85, 0.17, 0.1, 0.85);  // someone standing
                p.box(0, 0, 1.55, 0.09, 0.09, 0.12);
            }
            m_props.push_back(p.take());
            m_taken.push_back({at, radius});
            return;
        }
    }

    void lamps(const Room& room, Random& random)
    {
        const double ceiling = m_floor + m_plan.building().spaces[room.space].height.value_m;
        const Eigen::Vector2d middle = room.middle();
        const int count = static_cast<int>(random.below(4));
        for (int i = 0; i < count; ++i)
        {
            const Eigen::Vector2d at = middle + Eigen::Vector2d(random.uniform(-2, 2), random.uniform(-2, 2));
            if (room.clearance(at) < 0.7)
                continue;
            const double drop = random.chance(0.3) ? random.uniform(0.3, 0.9) : 0.0;
            Piece p("lamp", at, ceiling, random.chance(0.5) ? 0.0 : std::numbers::pi / 2.0, m_storey,
                    random.pick(pieceColours()));
            p.box(0, 0, -drop - 0.05, random.chance(0.5) ? 0.6 : 0.15, 0.15, 0.045);
            if (drop > 0.0)
                p.box(0, 0, -drop / 2, 0.008, 0.008, drop / 2);
            m_props.push_back(p.take());
        }
    }

    /// A pipe from floor to ceiling in a corner, a trunking or duct along a wall below the ceiling.
    void services(const Room& room, Random& random)
    {
        const double height = m_plan.building().spaces[room.space].height.value_m;
        Place place;
        if (random.chance(0.25) && find(room, 0.2, 0.2, false, random, place))
        {
            Piece p = piece("pipe", place, 0.08, random);
            p.box(0, 0, height / 2, 0.03, 0.03, height / 2);
            m_props.push_back(p.take());
        }
        const double length = random.uniform(1.5, 4.0);
        if (random.chance(0.25) && find(room, length, 0.4, true, random, place))
        {
            const double half = random.uniform(0.04, 0.2);
            Piece p = piece("duct", place, half + 0.01, random);
            p.box(0, 0, height - half - 0.02, length / 2, half, half);
            m_props.push_back(p.take());
        }
    }

    const BuildingSpec& m_spec;
    const StoreyPlan& m_plan;
    int m_storey;
    double m_floor = 0.0;
    std::vector<Disc> m_doors, m_windows, m_taken;
    std::vector<Prop> m_props;
};

}  // namespace

std::vector<Prop> furnishVaried(const BuildingSpec& spec, const StoreyPlan& plan, const std::vector<Prop>& before)
{
    return Furnisher(spec, plan, before).furnish();
}

}  // namespace s2b::sim

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

enum class Section
{
    Square,
    Round,
    Steel,  ///< H or I
    Tube
};

Prop column(const Eigen::Vector2d& at, double floor, double height, double yaw, int storey, Section section,
            double size, double ratio)
{
    Piece piece("column", at, floor, yaw, storey, {188, 188, 186});
    const double half = size / 2.0;
    if (section == Section::Square || section == Section::Tube)
        piece.box(0, 0, height / 2, half, half * ratio, height / 2);
    else if (section == Section::Steel)
    {
        constexpr double kFlange_m = 0.008;
        for (const double side : {-1.0, 1.0})
            piece.box(0, side * (half - kFlange_m), height / 2, half * ratio, kFlange_m, height / 2);
        piece.box(0, 0, height / 2, 0.006, half, height / 2);
    }
    Prop prop = piece.take();
    prop.label = Label::Column;
    if (section == Section::Round)
    {
        constexpr int kFacets = 24;
        for (int i = 0; i < kFacets; ++i)
        {
            const auto point = [&](int k, double z)
            {
                const double a = 2.0 * std::numbers::pi * k / kFacets;
                return Eigen::Vector3d(at.x() + half * std::cos(a), at.y() + half * std::sin(a), floor + z);
            };
            prop.triangles.push_back({point(i, 0), point(i + 1, 0), point(i + 1, height)});
            prop.triangles.push_back({point(i, 0), point(i + 1, height), point(i, height)});
        }
    }
    return prop;
}

class Structure
{
public:
    Structure(const BuildingSpec& spec, const StoreyPlan& plan)
        : m_spec(spec),
          m_plan(plan),
          m_storey(static_cast<int>(plan.storeyIndex())),
          m_floor(plan.building().storeys[plan.storeyIndex()].elevation_m)
    {
        const ElementId storey = plan.building().storeys[plan.storeyIndex()].id;
        for (const Opening& opening : plan.building().openings)
        {
            const Wall* host = plan.building().wall(opening.host);
            if (host->storey == storey && opening.kind != OpeningKind::Window)
                m_doors.push_back(AxisCurve(*host).at(opening.offset_m + opening.width.value_m / 2.0));
        }
    }

    std::vector<Prop> build()
    {
        Random style{m_spec.seed, 0x57c};
        m_section = static_cast<Section>(style.below(4));
        m_size = m_section == Section::Tube    ? style.uniform(0.06, 0.12)
                 : m_section == Section::Steel ? style.uniform(0.14, 0.35)
                                               : style.uniform(0.18, 0.6);
        m_ratio = style.chance(0.5) ? 1.0 : style.uniform(0.5, 1.0);
        const double grid = style.uniform(3.0, 7.0);
        const double turn = style.chance(0.1)   ? std::numbers::pi / 4.0
                            : style.chance(0.5) ? std::numbers::pi / 2.0
                                                : 0.0;
        const double columns = style.chance(0.6) ? style.uniform(0.3, 1.0) : 0.0;
        const double beams = style.chance(0.3) ? 0.7 : 0.0;
        std::size_t index = 0;
        for (const Room& room : m_plan.rooms)
        {
            Random random{m_spec.seed, 0x57d, m_plan.storeyIndex(), index++};
            if (room.kind == RoomKind::Cubicle || room.kind == RoomKind::Stair)
                continue;
            if (random.chance(columns))
                columnGrid(room, grid, turn, random);
            if (random.chance(0.12))
                freeWalls(room, random);
            if (random.chance(beams))
                beam(room, random);
            if (random.chance(0.4))
                stairs(room, random);
            if (random.chance(0.2))
                railing(room, random);
        }
        return std::move(m_props);
    }

private:
    [[nodiscard]] double heightOf(const Room& room) const
    {
        return m_plan.building().spaces[room.space].height.value_m;
    }
    [[nodiscard]] bool isByDoor(const Eigen::Vector2d& p, double distance) const
    {
        return std::any_of(m_doors.begin(), m_doors.end(),
                           [&](const Eigen::Vector2d& d) { return (d - p).norm() < distance; });
    }
    [[nodiscard]] static std::pair<Eigen::Vector2d, Eigen::Vector2d> extent(const Room& room)
    {
        Eigen::Vector2d low = room.outline.front();
        Eigen::Vector2d high = low;
        for (const Eigen::Vector2d& p : room.outline)
        {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        return {low, high};
    }

    void columnGrid(const Room& room, double grid, double turn, Random& random)
    {
        const auto [low, high] = extent(room);
        const Eigen::Vector2d from = low + Eigen::Vector2d(random.uniform(0.3, grid), random.uniform(0.3, grid)) * 0.6;
        int count = 0;
        for (double x = from.x(); x < high.x(); x += grid)
            for (double y = from.y(); y < high.y(); y += grid)
            {
                const Eigen::Vector2d p(x, y);
                const double clearance = room.clearance(p);
                // Free, or close to a wall or even in contact with it.
                if (clearance < 0.05 || (clearance > 0.5 * m_size + 0.001 && clearance < 0.5 * m_size + 0.02) ||
                    isByDoor(p, 0.9) || ++count > 24)
                    continue;
                m_props.push_back(column(p, m_floor, heightOf(room), turn, m_storey, m_section, m_size, m_ratio));
            }
    }

    void freeWalls(const Room& room, Random& random)
    {
        const auto [low, high] = extent(room);
        for (int i = 0; i < 6; ++i)
        {
            const Eigen::Vector2d p(random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()));
            const double half = random.uniform(0.4, 1.8);
            if (room.clearance(p) < half + 0.1 || isByDoor(p, half + 0.8))
                continue;
            Piece piece("free wall", p, m_floor, random.chance(0.5) ? 0.0 : std::numbers::pi / 2.0, m_storey,
                        {226, 222, 214});
            piece.box(0, 0, heightOf(room) / 2, half, random.uniform(0.05, 0.2), heightOf(room) / 2);
            m_props.push_back(piece.take());
            m_props.back().label = Label::Wall;
            return;
        }
    }

    void beam(const Room& room, Random& random)
    {
        const auto [low, high] = extent(room);
        const bool isAlongX = random.chance(0.5);
        const double length = isAlongX ? high.x() - low.x() : high.y() - low.y();
        const double depth = random.uniform(0.1, 0.45);
        const double half = random.uniform(0.06, 0.2);
        const int count = 1 + static_cast<int>(random.below(4));
        for (int i = 0; i < count; ++i)
        {
            Eigen::Vector2d p = 0.5 * (low + high);
            (isAlongX ? p.y() : p.x()) = isAlongX ? low.y() + (high.y() - low.y()) * (i + 0.5) / count
                                                  : low.x() + (high.x() - low.x()) * (i + 0.5) / count;
            Piece piece("beam", p, m_floor + heightOf(room), isAlongX ? 0.0 : std::numbers::pi / 2.0, m_storey,
                        {168, 150, 122});
            piece.box(0, 0, -depth / 2, length / 2, half, depth / 2);
            m_props.push_back(piece.take());
            m_props.back().label = Label::Beam;
        }
    }

    /// Treads from one height to another, a railing along one side or both.
    static void addFlight(Piece& piece, double x0, double y, double going, double halfWidth, double from, double to,
                          int steps, bool isOpen, int railings)
    {
        for (int i = 0; i < steps; ++i)
        {
            const double top = from + (to - from) * (i + 1) / steps;
            const double thickness = isOpen ? 0.05 : std::min(top, 0.35);
            const double x = x0 + going * (i + 0.5);
            piece.box(x, y, top - thickness / 2, std::abs(going) / 2, halfWidth, thickness / 2);
            for (int side = 0; side < railings; ++side)
            {
                const double edge = y + (side == 0 ? 1.0 : -1.0) * (halfWidth - 0.03);
                piece.box(x, edge, top + 0.45, 0.01, 0.01, 0.45);
                piece.box(x, edge, top + 0.9, std::abs(going) / 2, 0.025, 0.1);
            }
        }
    }

    /// A straight flight or one with a half-turn, in a corner or anywhere.
    void stairs(const Room& room, Random& random)
    {
        const auto [low, high] = extent(room);
        const double width = random.uniform(0.8, 1.3);
        const int steps = static_cast<int>(std::ceil(heightOf(room) / random.uniform(0.16, 0.2)));
        const double going = random.uniform(0.22, 0.3);
        const bool isOpen = random.chance(0.5), isTurning = random.chance(0.5);
        const int railings = static_cast<int>(random.below(3));
        const int firstSteps = isTurning ? steps / 2 : steps;
        const double landing = isTurning ? width : 0.0;
        const Eigen::Vector2d half((firstSteps * going + landing) / 2.0, isTurning ? width + 0.05 : width / 2.0);
        const double yaw = random.pick(std::vector<double>{0.0, 0.5, 1.0, 1.5}) * std::numbers::pi;
        const bool isAlongX = std::abs(std::cos(yaw)) > 0.5;
        const Eigen::Vector2d reach = isAlongX ? half : Eigen::Vector2d(half.y(), half.x());
        for (int attempt = 0; attempt < 6; ++attempt)
        {
            Eigen::Vector2d at(random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()));
            if (attempt < 4)  // in a corner
                at = Eigen::Vector2d(attempt % 2 == 0 ? low.x() + reach.x() + 0.02 : high.x() - reach.x() - 0.02,
                                     attempt < 2 ? low.y() + reach.y() + 0.02 : high.y() - reach.y() - 0.02);
            bool isFree = true;
            for (const double x : {-1.0, 0.0, 1.0})
                for (const double y : {-1.0, 1.0})
                {
                    const Eigen::Vector2d p = at + Eigen::Vector2d(x * reach.x(), y * reach.y());
                    isFree = isFree && room.clearance(p) >= 0.0 && !isByDoor(p, 0.8);
                }
            if (!isFree)
                continue;
            Piece piece("stair", at, m_floor, yaw, m_storey, {132, 132, 136});
            const double height = heightOf(room);
            const double middle = height * firstSteps / steps;
            const double y = isTurning ? width / 2.0 + 0.05 : 0.0;
            addFlight(piece, -half.x(), -y, going, width / 2.0, 0.0, middle, firstSteps, isOpen, railings);
            if (isTurning)
            {
                piece.box(half.x() - landing / 2.0, 0.0, middle - 0.1, landing / 2.0, half.y(), 0.1);
                addFlight(piece, half.x() - landing, y, -going, width / 2.0, middle, height, steps - firstSteps, isOpen,
                          railings);
            }
            m_props.push_back(piece.take());
            m_props.back().label = Label::Stair;
            return;
        }
    }

    void railing(const Room& room, Random& random)
    {
        const auto [low, high] = extent(room);
        const Eigen::Vector2d p(random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()));
        const double half = random.uniform(0.6, 2.0);
        if (room.clearance(p) < half + 0.1 || isByDoor(p, half + 0.8))
            return;
        Piece piece("railing", p, m_floor, random.chance(0.5) ? 0.0 : std::numbers::pi / 2.0, m_storey,
                    {132, 132, 136});
        piece.box(0, 0, 0.95, half, 0.025, 0.025);
        for (double x = -half; x <= half; x += 0.14)
            piece.box(x, 0, 0.47, 0.01, 0.01, 0.47);
        m_props.push_back(piece.take());
        m_props.back().label = Label::Stair;
    }

    const BuildingSpec& m_spec;
    const StoreyPlan& m_plan;
    int m_storey;
    double m_floor;
    std::vector<Eigen::Vector2d> m_doors;
    Section m_section = Section::Square;
    double m_size = 0.3, m_ratio = 1.0;
    std::vector<Prop> m_props;
};

}  // namespace

std::vector<Prop> addVariedStructure(const BuildingSpec& spec, const StoreyPlan& plan)
{
    return Structure(spec, plan).build();
}

}  // namespace s2b::sim

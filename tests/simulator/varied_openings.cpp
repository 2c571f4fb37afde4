// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/variety.h"

#include <algorithm>
#include <cmath>

namespace s2b::sim
{

namespace
{

/// What the doors and windows of one building have in common.
struct Style
{
    explicit Style(std::uint64_t seed)
    {
        Random random{seed, 0x57e1};
        doorHeight_m = random.pick(std::vector<double>{1.95, 2.01, 2.01, 2.05, 2.1, 2.135, 2.2, 2.4});
        doorWidth_m = random.pick(std::vector<double>{0.7, 0.76, 0.8, 0.885, 0.885, 0.9, 1.01, 1.1});
        fronts = random.chance(0.35) ? random.uniform(0.2, 0.8) : 0.0;
        sill_m = random.uniform(0.45, 1.2);
        windowHeight_m = random.uniform(0.8, 1.7);
        windowWidth_m = random.uniform(0.6, 2.4);
    }
    double doorHeight_m, doorWidth_m, fronts, sill_m, windowHeight_m, windowWidth_m;
};

class Fitter
{
public:
    Fitter(const BuildingSpec& spec, StoreyPlan& plan) : m_spec(spec), m_plan(plan), m_style(spec.seed) {}

    void interior()
    {
        std::vector<std::size_t> done;
        std::size_t index = 0;
        for (const Room& room : m_plan.rooms)
        {
            Random random{m_spec.seed, 0x7d0, m_plan.storeyIndex(), index++};
            for (const std::size_t wall : room.walls)
            {
                if (m_plan.wall(wall).isExternal || m_plan.wall(wall).bulge != 0.0 || room.kind == RoomKind::Corridor)
                    continue;
                const bool toCorridor = isOfCorridor(wall);
                // A partition between two rooms is met twice.
                if (!toCorridor && std::find(done.begin(), done.end(), wall) != done.end())
                    continue;
                done.push_back(wall);
                const double draw = random.uniform();
                if (draw < (toCorridor ? 0.85 : 0.4))
                    door(wall, room, random);
                else if (draw < (toCorridor ? 0.93 : 0.65))
                    m_plan.addOpening(wall, room, OpeningKind::Plain, random.uniform(0.8, 3.0),
                                      random.chance(0.3) ? 9.0 : random.uniform(2.0, 2.5), 0.0, random);
                else if (draw < (toCorridor ? 0.99 : 0.7))  // a glazed partition, with a door perhaps
                    m_plan.addOpening(wall, room, OpeningKind::Window, random.uniform(1.4, 4.0),
                                      random.chance(0.4) ? 9.0 : random.uniform(2.1, 2.6), 0.0, random);
                if (random.chance(0.06))
                    m_plan.addOpening(wall, room, OpeningKind::Window, random.uniform(0.8, 2.5),
                                      random.uniform(0.8, 1.3), random.uniform(0.8, 1.1), random);
            }
        }
    }

    void exterior()
    {
        std::size_t index = 0;
        for (const Room& room : m_plan.rooms)
        {
            Random random{m_spec.seed, 0x7d1, m_plan.storeyIndex(), index++};
            for (const std::size_t wall : room.walls)
                if (m_plan.wall(wall).isExternal && m_plan.wall(wall).bulge == 0.0)
                    facade(wall, room, random);
        }
    }

private:
    [[nodiscard]] bool isOfCorridor(std::size_t wall) const
    {
        const Room& first = m_plan.rooms.front();
        return first.kind == RoomKind::Corridor &&
               std::find(first.walls.begin(), first.walls.end(), wall) != first.walls.end();
    }

    void door(std::size_t wall, const Room& room, Random& random)
    {
        const bool isDouble = random.chance(0.12);
        double width = m_style.doorWidth_m + (random.chance(0.3) ? random.uniform(-0.15, 0.2) : 0.0);
        if (isDouble)
            width = random.uniform(1.2, 2.0);
        Opening* opening = m_plan.addOpening(wall, room, OpeningKind::Door, width, m_style.doorHeight_m, 0.0, random);
        if (opening == nullptr)
            return;
        opening->leaves = isDouble ? 2 : 1;
        const double draw = random.uniform();
        opening->leafState = draw < m_spec.removedDoors                      ? LeafState::Removed
                             : draw < m_spec.removedDoors + m_spec.openDoors ? LeafState::Open
                                                                             : LeafState::Closed;
        opening->hingeAtStart = random.chance(0.5);
        opening->opensToLeft = random.chance(0.5);
    }

    void window(std::size_t wall, const Room& room, double width, double height, double sill, Random& random,
                double position = -1.0)
    {
        m_plan.addOpening(wall, room, OpeningKind::Window, width, height, sill, random, position);
    }

    void facade(std::size_t wall, const Room& room, Random& random)
    {
        const AxisCurve curve(m_plan.wall(wall));
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
        const double length = to - from - 0.7;
        const double clear = m_plan.clearHeight();
        if (length < 0.6)
            return;
        if (random.chance(room.kind == RoomKind::Corridor ? 0.5 : 0.2))
            door(wall, room, random);
        if (random.chance(0.07))  // a door and the glazing beside it, in one frame
            window(wall, room, std::min(length, random.uniform(1.4, 2.8)), random.uniform(2.0, 2.6), 0.0, random);
        const double draw = random.uniform();
        if (draw < m_style.fronts)
        {
            // A glazed front from wall to wall, to the ceiling or nearly.
            const double sill = random.chance(0.6) ? 0.0 : random.uniform(0.02, 0.3);
            const double width = length * random.uniform(0.7, 1.0);
            if (Opening* front = m_plan.addOpening(wall, room, OpeningKind::Window, width, 9.0, sill, random, 0.5))
                front->height.value_m = clear - sill - (random.chance(0.5) ? 0.0 : random.uniform(0.02, 0.4));
            return;
        }
        if (random.chance(0.15))
            return;
        const double kind = random.uniform();
        if (kind < 0.15)
        {
            window(wall, room, length * random.uniform(0.6, 0.95), random.uniform(0.6, 1.6), random.uniform(0.7, 1.2),
                   random, 0.5);
            return;
        }
        const bool isTall = kind < 0.4;
        const double sill = isTall ? random.uniform(0.0, 0.15) : m_style.sill_m;
        const double height = isTall ? random.uniform(2.0, 2.4) : m_style.windowHeight_m;
        const double width = std::min(length, m_style.windowWidth_m);
        const int count = std::max(1, static_cast<int>(length / (width + random.uniform(0.4, 1.5))));
        for (int i = 0; i < count; ++i)
            window(wall, room, width, height, sill, random, count == 1 ? -1.0 : (i + 0.25) / (count - 0.5));
    }

    const BuildingSpec& m_spec;
    StoreyPlan& m_plan;
    Style m_style;
};

}  // namespace

void addVariedOpenings(const BuildingSpec& spec, StoreyPlan& plan)
{
    Fitter fitter(spec, plan);
    if (spec.doors)
        fitter.interior();
    if (spec.windows)
        fitter.exterior();
}

}  // namespace s2b::sim

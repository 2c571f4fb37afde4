// SPDX-License-Identifier: GPL-3.0-or-later
/// Buildings with curved walls, made by hand for the simulator: their truth is exact.
#pragma once

#include "core/model/wall_axis.h"
#include "tests/simulator/building_spec.h"
#include "tests/simulator/scanner.h"

#include <Eigen/Core>

#include <cmath>
#include <numbers>
#include <vector>

namespace s2b::test
{

/// A building of one storey and where it is scanned from.
struct CurvedBuilding
{
    sim::SimulatedBuilding building;
    std::vector<sim::Station> stations;
};

class CurvedBuildingMaker
{
public:
    explicit CurvedBuildingMaker(double height_m = 2.8) : m_height(height_m)
    {
        Storey storey;
        storey.id = {m_nextId++};
        storey.name = "Level 0";
        storey.height = {height_m, Provenance::Measured, 0.0};
        truth().storeys.push_back(storey);
    }
    std::size_t wall(const Eigen::Vector2d& start, const Eigen::Vector2d& end, double sweep_deg, double thickness_m)
    {
        Wall w;
        w.id = {m_nextId++};
        w.storey = truth().storeys.front().id;
        w.start = start;
        w.end = end;
        w.bulge = sweep_deg == 0.0 ? 0.0 : std::tan(sweep_deg * std::numbers::pi / 180 / 4);
        w.bodyEnd_m = WallAxis(w).length_m();
        w.height = {m_height, Provenance::Measured, 0.0};
        w.thickness = {thickness_m, Provenance::Measured, 0.0};
        truth().walls.push_back(w);
        return truth().walls.size() - 1;
    }
    Wall& at(std::size_t i) { return truth().walls[i]; }
    void longer(std::size_t i, double atStart_m, double atEnd_m)
    {
        at(i).bodyStart_m -= atStart_m;
        at(i).bodyEnd_m += atEnd_m;
    }
    void opening(std::size_t wall, OpeningKind kind, double offset_m, double width_m, double sill_m, double height_m,
                 LeafState state = LeafState::Unknown)
    {
        Opening o;
        o.id = {m_nextId++};
        o.host = at(wall).id;
        o.kind = kind;
        o.offset_m = offset_m;
        o.width = {width_m, Provenance::Measured, 0.0};
        o.height = {height_m, Provenance::Measured, 0.0};
        o.sill = {sill_m, Provenance::Measured, 0.0};
        o.leafState = state;
        o.leaves = kind == OpeningKind::Door ? 1 : 0;
        truth().openings.push_back(o);
    }
    void slabs(const std::vector<Eigen::Vector2d>& outline, double thickness_m = 0.25)
    {
        for (const bool roof : {false, true})
        {
            Slab s;
            s.id = {m_nextId++};
            s.storey = truth().storeys.front().id;
            s.kind = roof ? SlabKind::Roof : SlabKind::Floor;
            s.outline.outer = outline;
            s.top_m = roof ? m_height + thickness_m : 0.0;
            s.thickness = {thickness_m, Provenance::Measured, 0.0};
            truth().slabs.push_back(s);
        }
    }
    void station(double x, double y, double z = 1.6, int storey = 0)
    {
        m_result.stations.push_back({{x, y, z}, storey});
    }
    void column(const Eigen::Vector2d& center, double radius_m)
    {
        Column c;
        c.id = {m_nextId++};
        c.storey = truth().storeys.front().id;
        c.center = center;
        c.height = {m_height, Provenance::Measured, 0.0};
        c.section = CircleSection{radius_m};
        truth().columns.push_back(c);
    }
    Building& truth() { return m_result.building.truth; }
    [[nodiscard]] CurvedBuilding result() const { return m_result; }

private:
    CurvedBuilding m_result;
    double m_height;
    std::uint32_t m_nextId = 1;
};

/// Four straight walls, 0.3 m thick, with the slabs over them; low and high are the corners of their axes.
inline void addBox(CurvedBuildingMaker& m, const Eigen::Vector2d& low, const Eigen::Vector2d& high)
{
    constexpr double t = 0.3;
    const std::size_t south = m.wall(low, {high.x(), low.y()}, 0, t), east = m.wall({high.x(), low.y()}, high, 0, t),
                      north = m.wall(high, {low.x(), high.y()}, 0, t), west = m.wall({low.x(), high.y()}, low, 0, t);
    m.longer(south, t / 2, t / 2), m.longer(north, t / 2, t / 2);
    m.longer(east, -t / 2, -t / 2), m.longer(west, -t / 2, -t / 2);
    const Eigen::Vector2d d(t / 2, t / 2);
    m.slabs({low - d, {high.x() + t / 2, low.y() - t / 2}, high + d, {low.x() - t / 2, high.y() + t / 2}});
}

/// A round room in the middle of a square one, seen from both sides; with a door in it.
inline CurvedBuilding roundRoom(double radius_m, double thickness_m, bool door = false)
{
    CurvedBuildingMaker m;
    const double side = radius_m + 2.5;
    addBox(m, {-side, -side}, {side, side});
    const Eigen::Vector2d east(radius_m, 0), west(-radius_m, 0);
    const std::size_t upper = m.wall(east, west, 180, thickness_m);
    m.wall(west, east, 180, thickness_m);
    if (door)
        m.opening(upper, OpeningKind::Door, 0.4 * std::numbers::pi * radius_m, 0.9, 0.0, 2.1, LeafState::Open);
    m.station(0, 0);
    if (radius_m > 4)
        m.station(-0.5 * radius_m, 0.2), m.station(0.5 * radius_m, -0.2);
    const double corner = side - 1;
    for (const double x : {-corner, corner})
        for (const double y : {-corner, corner})
            m.station(x, y);
    for (const double x : {-corner - 0.2, corner + 0.2})
        m.station(x, 0), m.station(0, x);
    return m.result();
}

/// A nave that ends in a half circle, seen from inside, and from outside too when `outside`.
inline CurvedBuilding apse(double radius_m, double thickness_m, bool outside)
{
    CurvedBuildingMaker m;
    const double length = 6.0, t = thickness_m;
    const Eigen::Vector2d a(0, -radius_m), b(length, -radius_m), c(length, radius_m), d(0, radius_m);
    m.wall(a, b, 0, t);
    m.wall(b, c, 180, t);
    m.wall(c, d, 0, t);
    m.longer(m.wall(d, a, 0, t), -t / 2, -t / 2);
    m.longer(0, t / 2, 0), m.longer(2, 0, t / 2);
    std::vector<Eigen::Vector2d> outline{{-t / 2, -radius_m - t / 2}};
    for (int i = 0; i <= 60; ++i)
    {
        const double angle = std::numbers::pi * (i / 60.0 - 0.5);
        outline.emplace_back(length + (radius_m + t / 2 + 0.02) * std::cos(angle),
                             (radius_m + t / 2) * std::sin(angle));
    }
    outline.emplace_back(-t / 2, radius_m + t / 2);
    m.slabs(outline);
    m.station(1.5, 0.1), m.station(length - 0.5, 0.2), m.station(length + 0.4 * radius_m, -0.3);
    if (outside)
    {
        const double r = radius_m + 3;
        for (const double angle : {-0.45, -0.25, 0.0, 0.25, 0.45})
            m.station(length + r * std::cos(angle * std::numbers::pi), r * std::sin(angle * std::numbers::pi), 1.6, -1);
        m.station(1.5, -r, 1.6, -1), m.station(1.5, r, 1.6, -1), m.station(-3, 0, 1.6, -1);
    }
    return m.result();
}

/// A rectangular room one corner of which is a quarter of a circle, seen from both sides.
inline CurvedBuilding roundCorner(double radius_m, double thickness_m)
{
    CurvedBuildingMaker m;
    const double x = radius_m + 3, y = radius_m + 2.5, t = thickness_m;
    const std::size_t south = m.wall({0, 0}, {x, 0}, 0, t), east = m.wall({x, 0}, {x, y - radius_m}, 0, t);
    m.wall({x, y - radius_m}, {x - radius_m, y}, 90, t);
    const std::size_t north = m.wall({x - radius_m, y}, {0, y}, 0, t), west = m.wall({0, y}, {0, 0}, 0, t);
    m.longer(south, t / 2, t / 2), m.longer(north, 0, t / 2);
    m.longer(east, -t / 2, 0), m.longer(west, -t / 2, -t / 2);
    std::vector<Eigen::Vector2d> outline{{-t / 2, -t / 2}, {x + t / 2, -t / 2}};
    for (int i = 0; i <= 40; ++i)
    {
        const double angle = std::numbers::pi / 2 * i / 40.0;
        outline.emplace_back(x - radius_m + (radius_m + t / 2) * std::cos(angle),
                             y - radius_m + (radius_m + t / 2) * std::sin(angle));
    }
    outline.emplace_back(-t / 2, y + t / 2);
    m.slabs(outline);
    m.station(1.2, 1.2), m.station(x / 2, y / 2), m.station(x - 1.5, 1.5), m.station(1.5, y - 1.5);
    m.station(x - 0.3 * radius_m - 0.7, y - 0.3 * radius_m - 0.7);
    const double out = 2.5;
    for (const double u : {0.0, x / 2, x})
        m.station(u, -out, 1.6, -1), m.station(u, y + out, 1.6, -1);
    for (const double v : {0.0, y / 2, y})
        m.station(-out, v, 1.6, -1), m.station(x + out, v, 1.6, -1);
    m.station(x + 1.5, y + 1.5, 1.6, -1);
    return m.result();
}

/// An arc as a partition of a rectangular room, both ends on straight walls.
inline CurvedBuilding partition(double radius_m, double sweep_deg, double thickness_m)
{
    CurvedBuildingMaker m;
    const double half = radius_m * std::sin(sweep_deg * std::numbers::pi / 360);
    const double sagitta = radius_m * (1 - std::cos(sweep_deg * std::numbers::pi / 360));
    const double width = sagitta + 6;
    addBox(m, {-3, -half}, {width - 3, half});
    // The ends lie on the axes of the long walls; the bodies end at their faces.
    const std::size_t arc = m.wall({0, -half}, {0, half}, sweep_deg, thickness_m);
    const double slant = std::cos(sweep_deg * std::numbers::pi / 360);
    m.longer(arc, -0.15 / slant - thickness_m / 2 * std::tan(sweep_deg * std::numbers::pi / 360),
             -0.15 / slant - thickness_m / 2 * std::tan(sweep_deg * std::numbers::pi / 360));
    for (const double y : {-0.6 * half, 0.0, 0.6 * half})
        m.station(-1.7, y), m.station(sagitta + 1.5, y);
    m.station(0.5 * sagitta - 1.2, 0.3);
    return m.result();
}

/// A regular octagon of straight walls, seen from both sides.
inline CurvedBuilding octagon(double radius_m, double thickness_m, int sides = 8)
{
    CurvedBuildingMaker m;
    std::vector<Eigen::Vector2d> outline;
    const auto corner = [&](int i, double r) -> Eigen::Vector2d
    {
        const double angle = 2 * std::numbers::pi * (i + 0.37) / sides;
        return {r * std::cos(angle), r * std::sin(angle)};
    };
    const double step = std::numbers::pi / sides;
    for (int i = 0; i < sides; ++i)
    {
        const std::size_t w = m.wall(corner(i, radius_m), corner(i + 1, radius_m), 0, thickness_m);
        m.longer(w, i % 2 ? -thickness_m / 2 * std::tan(step) : thickness_m / 2 * std::tan(step),
                 i % 2 ? -thickness_m / 2 * std::tan(step) : thickness_m / 2 * std::tan(step));
        outline.push_back(corner(i, radius_m + thickness_m / 2 / std::cos(step)));
    }
    m.slabs(outline);
    m.station(0, 0), m.station(0.4 * radius_m, 0.2);
    for (int i = 0; i < sides; ++i)
    {
        const Eigen::Vector2d p = corner(i, radius_m + 3);
        m.station(p.x(), p.y(), 1.6, -1);
    }
    return m.result();
}

}  // namespace s2b::test

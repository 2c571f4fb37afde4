// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/plan.h"

#include <algorithm>
#include <cmath>

namespace s2b::sim
{

namespace
{

constexpr double kOpeningGap_m = 0.15;  ///< between openings, and between an opening and a joint

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

double area(const std::vector<Eigen::Vector2d>& ring)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        twice += cross(ring[i], ring[(i + 1) % ring.size()]);
    return 0.5 * twice;
}

Dimension measured(double value_m)
{
    return {value_m, Provenance::Measured, 0.0};
}

}  // namespace

Eigen::Vector2d Room::middle() const
{
    Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
        const Eigen::Vector2d& a = outline[i];
        const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
        weighted += (a + b) * cross(a, b) / 3.0;
        twice += cross(a, b);
    }
    return weighted / twice;
}

bool Room::contains(const Eigen::Vector2d& p) const
{
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
        const Eigen::Vector2d& a = outline[i];
        const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
        if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
    }
    return inside;
}

double Room::clearance(const Eigen::Vector2d& p) const
{
    double nearest = 1e9;
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
        const Eigen::Vector2d& a = outline[i];
        const Eigen::Vector2d d = outline[(i + 1) % outline.size()] - a;
        const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (a + t * d - p).norm());
    }
    return contains(p) ? nearest : -nearest;
}

StoreyPlan::StoreyPlan(Building& building, std::size_t storey, double clearHeight_m, std::uint32_t& nextId)
    : m_building(building), m_storey(storey), m_clearHeight_m(clearHeight_m), m_nextId(nextId)
{
}

std::size_t StoreyPlan::addWall(const Eigen::Vector2d& start, const Eigen::Vector2d& end, double bulge,
                                double thickness_m, bool isExternal)
{
    Wall wall;
    wall.id = {m_nextId++};
    wall.storey = m_building.storeys[m_storey].id;
    wall.start = start;
    wall.end = end;
    wall.bulge = bulge;
    wall.bodyEnd_m = AxisCurve(wall).length();
    wall.base_m = m_building.storeys[m_storey].elevation_m;
    wall.height = measured(m_clearHeight_m);
    wall.thickness = measured(thickness_m);
    wall.isExternal = isExternal;
    wall.isExternalKnown = true;
    m_building.walls.push_back(wall);
    return m_building.walls.size() - 1;
}

void StoreyPlan::butt(std::size_t index, JunctionEnd end, std::size_t otherIndex)
{
    Wall& wall = m_building.walls[index];
    const Wall& other = m_building.walls[otherIndex];
    const AxisCurve curve(wall);
    const AxisCurve otherCurve(other);
    const double gap =
        endGap(curve, wall.thickness.value_m, end == JunctionEnd::End, otherCurve, other.thickness.value_m).body_m;
    (end == JunctionEnd::Start ? wall.bodyStart_m : wall.bodyEnd_m) =
        end == JunctionEnd::Start ? gap : curve.length() - gap;
    m_building.junctions.push_back({wall.id, other.id, end, JunctionEnd::Path});

    // What the joint covers of the other wall's path, with the widening of an oblique joint.
    const double s = end == JunctionEnd::Start ? 0.0 : curve.length();
    const double t = end == JunctionEnd::Start ? gap : curve.length() - gap;
    double from = 1e9;
    double to = -1e9;
    for (const double at : {s, t})
        for (const double side : {-0.5, 0.5})
        {
            const double p = otherCurve.project(curve.at(at, side * wall.thickness.value_m)).x();
            from = std::min(from, p);
            to = std::max(to, p);
        }
    m_taken.push_back({otherIndex, from, to});
}

void StoreyPlan::corner(std::size_t throughIndex, JunctionEnd throughEnd, std::size_t otherIndex, JunctionEnd otherEnd)
{
    Wall& through = m_building.walls[throughIndex];
    Wall& other = m_building.walls[otherIndex];
    const AxisCurve curve(through);
    const AxisCurve otherCurve(other);
    const double at = throughEnd == JunctionEnd::Start ? 0.0 : curve.length();
    const double otherAt = otherEnd == JunctionEnd::Start ? 0.0 : otherCurve.length();
    const double sine = std::abs(cross(curve.direction(at), otherCurve.direction(otherAt)));
    const double reach = other.thickness.value_m / 2.0 / sine;
    (throughEnd == JunctionEnd::Start ? through.bodyStart_m : through.bodyEnd_m) =
        throughEnd == JunctionEnd::Start ? -reach : curve.length() + reach;
    const double gap =
        endGap(otherCurve, other.thickness.value_m, otherEnd == JunctionEnd::End, curve, through.thickness.value_m)
            .body_m;
    (otherEnd == JunctionEnd::Start ? other.bodyStart_m : other.bodyEnd_m) =
        otherEnd == JunctionEnd::Start ? gap : otherCurve.length() - gap;
    m_building.junctions.push_back({through.id, other.id, throughEnd, otherEnd});
}

Eigen::Vector2d StoreyPlan::crossing(std::size_t a, std::size_t b, const Eigen::Vector2d& near) const
{
    return AxisCurve(wall(a)).meet(0.0, AxisCurve(wall(b)), 0.0, near);
}

double StoreyPlan::sideOf(std::size_t index, const std::vector<Eigen::Vector2d>& joints) const
{
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& joint : joints)
        middle += joint / static_cast<double>(joints.size());
    return AxisCurve(wall(index)).project(middle).y() > 0.0 ? 1.0 : -1.0;
}

std::vector<Eigen::Vector2d> StoreyPlan::faceRing(const std::vector<std::size_t>& walls,
                                                  const std::vector<Eigen::Vector2d>& joints, bool inner) const
{
    const std::size_t n = walls.size();
    const auto face = [&](std::size_t i)
    { return (inner ? 0.5 : -0.5) * sideOf(walls[i], joints) * wall(walls[i]).thickness.value_m; };
    std::vector<Eigen::Vector2d> corners;  // corners[i]: of faces i and i + 1
    for (std::size_t i = 0; i < n; ++i)
    {
        const std::size_t next = (i + 1) % n;
        corners.push_back(AxisCurve(wall(walls[i])).meet(face(i), AxisCurve(wall(walls[next])), face(next), joints[i]));
    }
    std::vector<Eigen::Vector2d> ring;
    for (std::size_t i = 0; i < n; ++i)
    {
        const AxisCurve curve(wall(walls[i]));
        const std::vector<double> samples =
            curve.samples(curve.project(corners[(i + n - 1) % n]).x(), curve.project(corners[i]).x());
        for (std::size_t k = 1; k < samples.size(); ++k)
            ring.push_back(curve.at(samples[k], face(i)));
    }
    return ring;
}

Room& StoreyPlan::addRoom(RoomKind kind, std::string name, std::vector<std::size_t> walls,
                          std::vector<Eigen::Vector2d> joints, double height_m)
{
    Room room;
    room.kind = kind;
    room.name = std::move(name);
    room.walls = std::move(walls);
    room.joints = std::move(joints);
    room.outline = faceRing(room.walls, room.joints, true);

    Space space;
    space.id = {m_nextId++};
    space.storey = m_building.storeys[m_storey].id;
    space.name = room.name;
    space.outline.outer = room.outline;
    space.floor_m = m_building.storeys[m_storey].elevation_m;
    space.height = measured(height_m);
    space.area_m2 = area(room.outline);
    for (const std::size_t w : room.walls)
        space.boundedBy.push_back(wall(w).id);
    room.space = m_building.spaces.size();
    m_building.spaces.push_back(std::move(space));
    rooms.push_back(std::move(room));
    return rooms.back();
}

double StoreyPlan::freeStretch(std::size_t index, const Room& room, double width_m, double margin_m, Random& random,
                               double position) const
{
    const AxisCurve curve(wall(index));
    const double face = sideOf(index, room) * wall(index).thickness.value_m / 2.0;
    double from = 1e9;
    double to = -1e9;
    for (const Eigen::Vector2d& p : room.outline)
    {
        const Eigen::Vector2d q = curve.project(p);
        if (std::abs(q.y() - face) > 0.002)
            continue;
        from = std::min(from, q.x());
        to = std::max(to, q.x());
    }
    from += margin_m;
    to -= margin_m + width_m;
    if (to < from)
        return -1.0;
    for (int attempt = 0; attempt < 20; ++attempt)
    {
        const double s = from + (to - from) * (position >= 0.0 && attempt == 0 ? position : random.uniform());
        const bool isFree = std::none_of(
            m_taken.begin(), m_taken.end(), [&](const Taken& t)
            { return t.wall == index && s < t.to + kOpeningGap_m && s + width_m > t.from - kOpeningGap_m; });
        if (isFree)
            return s;
    }
    return -1.0;
}

Opening* StoreyPlan::addOpening(std::size_t index, const Room& room, OpeningKind kind, double width_m, double height_m,
                                double sill_m, Random& random, double position)
{
    const double s = freeStretch(index, room, width_m, 0.12, random, position);
    if (s < 0.0)
        return nullptr;
    Opening opening;
    opening.id = {m_nextId++};
    opening.host = wall(index).id;
    opening.kind = kind;
    opening.offset_m = s;
    opening.width = measured(width_m);
    opening.height = measured(std::min(height_m, m_clearHeight_m - sill_m - 0.1));
    opening.sill = measured(sill_m);
    m_taken.push_back({index, s, s + width_m});
    m_building.openings.push_back(opening);
    return &m_building.openings.back();
}

void StoreyPlan::addColumn(const Eigen::Vector2d& center, double yaw_rad, const Section& section)
{
    Column column;
    column.id = {m_nextId++};
    column.storey = m_building.storeys[m_storey].id;
    column.center = center;
    column.yaw_rad = yaw_rad;
    column.base_m = m_building.storeys[m_storey].elevation_m;
    column.height = measured(m_clearHeight_m);
    column.section = section;
    m_building.columns.push_back(column);
}

}  // namespace s2b::sim

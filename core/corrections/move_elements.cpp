// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/corrections/elements.h"
#include "core/corrections/junctions.h"
#include "core/model/wall_axis.h"

#include <array>
#include <cmath>

namespace s2b
{
namespace
{

constexpr double kSlant = 5e-4;        // rad; what a transformation of single precision may be off
constexpr double kThinnest_m = 0.001;  // of a plate
constexpr double kScale = 2e-4;        // a scale nearer to 1 is rounding
constexpr double kInWall_m = 0.05;

Eigen::Vector2d flat(const Eigen::Vector3d& v)
{
    return v.head<2>();
}

/// What a motion does to something upright: turn and stretch of the plan, stretch of the heights.
struct UprightMotion
{
    Eigen::Affine3d full;
    double heights = 1.0;

    [[nodiscard]] Eigen::Vector2d plan(const Eigen::Vector2d& p) const
    {
        return flat(full * Eigen::Vector3d(p.x(), p.y(), 0));
    }
    [[nodiscard]] Eigen::Vector2d along(const Eigen::Vector2d& v) const
    {
        return flat(full.linear() * Eigen::Vector3d(v.x(), v.y(), 0));
    }
    [[nodiscard]] double height(double z) const { return heights * z + full.translation().z(); }
    [[nodiscard]] bool mirrors() const { return full.linear().topLeftCorner<2, 2>().determinant() < 0; }
};

double unlessRounding(double scale)
{
    return std::abs(scale - 1) < kScale ? 1.0 : scale;
}

UprightMotion uprightMotion(const Building& building, ElementId id, const Eigen::Affine3d& motion)
{
    const Eigen::Matrix3d& a = motion.linear();
    if (!motion.matrix().allFinite() || std::abs(a.determinant()) < 1e-6)
        refuse(building, id, "was flattened: it can't be scaled by 0");
    const double tilt = std::max(flat(a.col(2)).norm() / a.col(2).norm(),
                                 std::max(std::abs(a(2, 0)) / a.col(0).norm(), std::abs(a(2, 1)) / a.col(1).norm()));
    if (tilt > kSlant)
        refuse(building, id,
               std::format("was tilted by {:.1f} degrees: elements stay upright, turn them about Z only",
                           std::asin(std::min(1.0, tilt)) * 180 / std::acos(-1.0)));
    if (a(2, 2) < 0)
        refuse(building, id, "was turned upside down: turn it about Z only");
    UprightMotion upright{motion, unlessRounding(a(2, 2))};
    upright.full.linear()(2, 0) = upright.full.linear()(2, 1) = 0;
    upright.full.linear()(0, 2) = upright.full.linear()(1, 2) = 0;
    return upright;
}

Dimension scaled(const Dimension& d, double by)
{
    return by == 1.0 ? d : Dimension{d.value_m * by, Provenance::Corrected, d.rms_m};
}

/// How much two directions at right angles are stretched; refused where the angle is lost.
std::array<double, 2> stretchOf(const Building& building, ElementId id, const UprightMotion& m,
                                const Eigen::Vector2d& x, const Eigen::Vector2d& y)
{
    const Eigen::Vector2d u = m.along(x), v = m.along(y);
    if (std::abs(u.dot(v)) > 4 * kSlant * u.norm() * v.norm())
        refuse(building, id, "was sheared: scale it along its own axes, or by the same factor in all directions");
    return {unlessRounding(u.norm()), unlessRounding(v.norm())};
}

bool stretchesEvenly(const UprightMotion& m)
{
    const Eigen::Vector2d u = m.along(Eigen::Vector2d::UnitX()), v = m.along(Eigen::Vector2d::UnitY());
    return std::abs(u.norm() - v.norm()) < 2 * kScale * u.norm() &&
           std::abs(u.dot(v)) < 4 * kSlant * u.norm() * v.norm();
}

void moveWall(Building& building, Wall& wall, const UprightMotion& m)
{
    if (wall.bulge != 0 && !stretchesEvenly(m))
        refuse(building, wall.id, "is curved: scale it by the same factor in all directions of the plan");
    const auto [along, across] = stretchOf(building, wall.id, m, wall.direction(), wall.normal());
    wall.start = m.plan(wall.start);
    wall.end = m.plan(wall.end);
    if (m.mirrors())
    {
        wall.bulge = -wall.bulge;
        std::swap(wall.evidence.faceCoverage[0], wall.evidence.faceCoverage[1]);
    }
    wall.bodyStart_m *= along;
    wall.bodyEnd_m *= along;
    for (Eigen::Vector2d& v : wall.topProfile)
        v = {v.x() * along, m.height(v.y())};
    wall.base_m = m.height(wall.base_m);
    wall.height = scaled(wall.height, m.heights);
    wall.thickness = scaled(wall.thickness, across);
    for (Opening& o : building.openings)
    {
        if (o.host != wall.id)
            continue;
        o.offset_m *= along;
        o.width = scaled(o.width, along);
        o.height = scaled(o.height, m.heights);
        o.sill = scaled(o.sill, m.heights);
        if (m.mirrors())
            o.opensToLeft = !o.opensToLeft;
    }
}

void moveColumn(const Building& building, Column& column, const UprightMotion& m)
{
    const Eigen::Vector2d x(std::cos(column.yaw_rad), std::sin(column.yaw_rad)), y(-x.y(), x.x());
    const auto [wide, deep] = stretchOf(building, column.id, m, x, y);
    if (std::holds_alternative<CircleSection>(column.section) && std::abs(wide - deep) > kScale)
        refuse(building, column.id, "is round: scale it by the same factor in all directions of the plan");
    setBox(column.section, boxOf(column.section).cwiseProduct(Eigen::Vector2d(wide, deep)));
    if (!faultOf(column.section, kThinnest_m).empty())
        refuse(building, column.id, "would have no room between its web and flanges");
    if (wide != 1.0 || deep != 1.0)
        column.sectionProvenance = Provenance::Corrected;
    Eigen::Vector2d turned = m.along(x);
    if (auto* profile = std::get_if<ProfileSection>(&column.section); profile && m.mirrors())
    {
        // A mirrored T still has its flange where its y was; a mirrored L has its legs the other way round.
        const Eigen::Vector2d up = m.along(y);
        if (profile->shape == ProfileShape::T)
            turned = {up.y(), -up.x()};
        else if (profile->shape == ProfileShape::L)
        {
            turned = up;
            std::swap(profile->width_m, profile->depth_m);
        }
    }
    column.yaw_rad = std::atan2(turned.y(), turned.x());
    column.center = m.plan(column.center);
    column.base_m = m.height(column.base_m);
    column.height = scaled(column.height, m.heights);
}

void moveOutline(Polygon& outline, const UprightMotion& m)
{
    const auto moveRing = [&](std::vector<Eigen::Vector2d>& ring)
    {
        for (Eigen::Vector2d& p : ring)
            p = m.plan(p);
        if (m.mirrors())
            std::reverse(ring.begin(), ring.end());
    };
    moveRing(outline.outer);
    for (auto& hole : outline.holes)
        moveRing(hole);
}

}  // namespace

Building moveElements(Building building, const std::vector<ElementMotion>& motions)
{
    std::set<ElementId> walls;
    for (const ElementMotion& motion : motions)
    {
        const ElementId id = motion.id;
        if (const Storey* s = building.storey(id))
        {
            const UprightMotion m = uprightMotion(building, id, motion.motion);
            building = moveLevel(std::move(building), id, m.height(s->elevation_m));
            continue;
        }
        if (findElement(building.openings, id))
            refuse(building, id, "is moved within its wall only");
        const UprightMotion m = uprightMotion(building, id, motion.motion);
        if (Wall* w = findElement(building.walls, id))
        {
            moveWall(building, *w, m);
            walls.insert(id);
        }
        else if (Column* c = findElement(building.columns, id))
            moveColumn(building, *c, m);
        else if (Slab* slab = findElement(building.slabs, id))
        {
            moveOutline(slab->outline, m);
            slab->top_m = m.height(slab->top_m);
            slab->thickness = scaled(slab->thickness, m.heights);
        }
        else if (Space* space = findElement(building.spaces, id))
        {
            moveOutline(space->outline, m);
            space->area_m2 *= std::abs(m.full.linear().topLeftCorner<2, 2>().determinant());
            space->floor_m = m.height(space->floor_m);
            space->height = scaled(space->height, m.heights);
        }
        else
            refuse(building, id, "is not there");
    }
    settleJunctions(building, walls);
    return building;
}

Building placeOpening(Building building, ElementId id, const std::array<Eigen::Vector3d, 4>& corners)
{
    Opening* o = findElement(building.openings, id);
    if (!o)
        refuse(building, id, "is no opening");
    const Wall& host = *building.wall(o->host);
    const WallAxis axis(host);
    double begin = 1e9, end = -1e9, low = 1e9, high = -1e9, off = 0;
    for (const Eigen::Vector3d& c : corners)
    {
        const Eigen::Vector2d p = axis.project(flat(c));
        begin = std::min(begin, p.x()), end = std::max(end, p.x());
        low = std::min(low, c.z()), high = std::max(high, c.z());
        off = std::max(off, std::abs(p.y()));
    }
    const double tolerance = kInWall_m + host.thickness.value_m / 2;
    if (off > tolerance)
        refuse(building, id,
               std::format("was moved {:.2f} m out of {}: move the wall, or keep it in the wall", off,
                           nameOf(building, host.id)));
    // What turned out of the wall's plane, or of the upright, is no rectangle of it.
    const double width = (flat(corners[1]) - flat(corners[0])).norm(), height = (corners[3] - corners[0]).norm();
    if (std::abs(width - (end - begin)) > 0.01 || std::abs(height - (high - low)) > 0.01)
        refuse(building, id, "was turned out of its wall: it can be moved and scaled within the wall only");
    const auto set = [](Dimension& d, double value)
    {
        if (std::abs(d.value_m - value) > kScale)
            d = {value, Provenance::Corrected, d.rms_m};
    };
    set(o->width, end - begin);
    set(o->height, high - low);
    double sill = low - host.base_m;
    sill = std::abs(sill) < 0.001 ? 0.0 : sill;  // a door from the floor stays one
    set(o->sill, sill);
    o->offset_m = begin;
    constexpr double slack_m = 0.01;
    if (begin < host.bodyStart_m - slack_m || end > host.bodyEnd_m + slack_m || sill < -slack_m ||
        sill + o->height.value_m > host.height.value_m + slack_m)
        refuse(building, id, std::format("was moved over the edge of {}", nameOf(building, host.id)));
    return building;
}

}  // namespace s2b

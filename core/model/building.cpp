// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/building.h"

#include <algorithm>
#include <cmath>

namespace s2b
{
namespace
{

constexpr double kSagitta_m = 0.001;  // how far a chord of a sampled arc may lie from the arc

/// The circle of an arc wall's axis.
struct Arc
{
    Eigen::Vector2d center;
    double radius_m;
    double startAngle_rad;
    double sweep_rad;  // > 0 counter-clockwise
};

Arc arcOf(const Wall& wall)
{
    const double sweep = 4.0 * std::atan(wall.bulge);
    const Eigen::Vector2d chord = wall.end - wall.start;
    const Eigen::Vector2d left(-chord.y(), chord.x());
    // The centre lies on the chord's bisector; to its left when a counter-clockwise arc is less than a half circle.
    const Eigen::Vector2d center = 0.5 * (wall.start + wall.end) + left * (0.5 / std::tan(0.5 * sweep));
    const Eigen::Vector2d arm = wall.start - center;
    return {center, arm.norm(), std::atan2(arm.y(), arm.x()), sweep};
}

}  // namespace

double Wall::axisLength_m() const
{
    if (bulge == 0.0)
        return (end - start).norm();
    const Arc arc = arcOf(*this);
    return arc.radius_m * std::abs(arc.sweep_rad);
}

Eigen::Vector2d Wall::direction() const
{
    const Eigen::Vector2d chord = (end - start).normalized();
    if (bulge == 0.0)
        return chord;
    // The tangent at the start is the chord turned back by half the sweep.
    return Eigen::Rotation2Dd(-2.0 * std::atan(bulge)) * chord;
}

Eigen::Vector2d Wall::normal() const
{
    const Eigen::Vector2d d = direction();
    return {-d.y(), d.x()};
}

std::vector<Eigen::Vector2d> Wall::outline() const
{
    const double half = 0.5 * thickness.value_m;
    if (bulge == 0.0)
    {
        const Eigen::Vector2d d = direction();
        const Eigen::Vector2d n(-d.y(), d.x());
        const Eigen::Vector2d from = start + d * bodyStart_m;
        const Eigen::Vector2d to = start + d * bodyEnd_m;
        return {from - n * half, to - n * half, to + n * half, from + n * half};
    }
    const Arc arc = arcOf(*this);
    const double turn = arc.sweep_rad > 0.0 ? 1.0 : -1.0;
    const double outerRadius = arc.radius_m + half;
    const double from = arc.startAngle_rad + turn * bodyStart_m / arc.radius_m;
    const double to = arc.startAngle_rad + turn * bodyEnd_m / arc.radius_m;
    const double step = 2.0 * std::acos(std::max(0.0, 1.0 - kSagitta_m / outerRadius));
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / step)));

    // Right side forth, left side back: counter-clockwise whichever way the arc turns.
    const double rightRadius = arc.radius_m + turn * half;
    const double leftRadius = arc.radius_m - turn * half;
    const auto at = [&](double radius, int i) -> Eigen::Vector2d
    {
        const double angle = from + (to - from) * i / pieces;
        return arc.center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    };
    std::vector<Eigen::Vector2d> ring;
    ring.reserve(2 * static_cast<std::size_t>(pieces) + 2);
    for (int i = 0; i <= pieces; ++i)
        ring.push_back(at(rightRadius, i));
    for (int i = pieces; i >= 0; --i)
        ring.push_back(at(leftRadius, i));
    return ring;
}

std::vector<Eigen::Vector2d> Column::outline() const
{
    std::vector<Eigen::Vector2d> ring = outlineOf(section);
    const Eigen::Rotation2Dd turn(yaw_rad);
    for (Eigen::Vector2d& p : ring)
        p = center + turn * p;
    return ring;
}

const Storey* Building::storey(ElementId id) const
{
    const auto it = std::find_if(storeys.begin(), storeys.end(), [&](const Storey& s) { return s.id == id; });
    return it == storeys.end() ? nullptr : &*it;
}

const Wall* Building::wall(ElementId id) const
{
    const auto it = std::find_if(walls.begin(), walls.end(), [&](const Wall& w) { return w.id == id; });
    return it == walls.end() ? nullptr : &*it;
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/axis_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace s2b::sim
{

namespace
{

constexpr double kSagitta_m = 0.001;

Eigen::Vector2d left(const Eigen::Vector2d& v)
{
    return {-v.y(), v.x()};
}

}  // namespace

AxisCurve::AxisCurve(const Eigen::Vector2d& start, const Eigen::Vector2d& end, double bulge)
    : m_start(start), m_direction((end - start).normalized()), m_length((end - start).norm())
{
    if (bulge == 0.0)
        return;
    const double sweep = 4.0 * std::atan(bulge);
    const double chord = m_length;
    m_radius = chord / (2.0 * std::sin(sweep / 2.0));
    m_center = 0.5 * (start + end) + left(m_direction) * (chord / 2.0 / std::tan(sweep / 2.0));
    m_angle = std::atan2(start.y() - m_center.y(), start.x() - m_center.x());
    m_length = sweep * m_radius;
}

Eigen::Vector2d AxisCurve::direction(double s) const
{
    if (!isArc())
        return m_direction;
    const double angle = m_angle + s / m_radius;
    return Eigen::Vector2d(-std::sin(angle), std::cos(angle)) * (m_radius > 0 ? 1.0 : -1.0);
}

Eigen::Vector2d AxisCurve::normal(double s) const
{
    return left(direction(s));
}

Eigen::Vector2d AxisCurve::at(double s, double offset) const
{
    if (!isArc())
        return m_start + m_direction * s + left(m_direction) * offset;
    const double angle = m_angle + s / m_radius;
    const double radius = std::abs(m_radius) - (m_radius > 0 ? offset : -offset);
    return m_center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

Eigen::Vector2d AxisCurve::project(const Eigen::Vector2d& point) const
{
    if (!isArc())
        return {(point - m_start).dot(m_direction), (point - m_start).dot(left(m_direction))};
    const Eigen::Vector2d d = point - m_center;
    const double middle = m_angle + m_length / 2.0 / m_radius;
    const double turn = std::remainder(std::atan2(d.y(), d.x()) - middle, 2.0 * std::numbers::pi);
    const double inward = std::abs(m_radius) - d.norm();
    return {m_length / 2.0 + turn * m_radius, m_radius > 0 ? inward : -inward};
}

std::vector<double> AxisCurve::samples(double from, double to) const
{
    int pieces = 1;
    if (isArc())
    {
        const double step = 2.0 * std::acos(1.0 - kSagitta_m / std::max(std::abs(m_radius), 2.0 * kSagitta_m));
        pieces = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / std::abs(m_radius) / step)));
    }
    std::vector<double> result;
    for (int i = 0; i <= pieces; ++i)
        result.push_back(from + (to - from) * i / pieces);
    return result;
}

Eigen::Vector2d AxisCurve::meet(double offset, const AxisCurve& other, double otherOffset,
                                const Eigen::Vector2d& near) const
{
    if (isArc() && !other.isArc())
        return other.meet(otherOffset, *this, offset, near);
    const Eigen::Vector2d p = at(0.0, offset);
    if (!other.isArc())
    {
        const Eigen::Vector2d n = left(other.m_direction);
        const double slope = m_direction.dot(n);
        return p + m_direction * ((other.at(0.0, otherOffset) - p).dot(n) / slope);
    }
    const double radius = (other.at(0.0, otherOffset) - other.m_center).norm();
    const double foot = (other.m_center - p).dot(m_direction);
    const double height = (p + m_direction * foot - other.m_center).norm();
    const double half = std::sqrt(std::max(0.0, radius * radius - height * height));
    const Eigen::Vector2d a = p + m_direction * (foot - half);
    const Eigen::Vector2d b = p + m_direction * (foot + half);
    return (a - near).squaredNorm() <= (b - near).squaredNorm() ? a : b;
}

EndGap endGap(const AxisCurve& wall, double thickness_m, bool atEnd, const AxisCurve& other, double otherThickness_m)
{
    constexpr double kStep_m = 0.002;
    // Signed towards this wall: at a joint of a thick wall with a thin one a corner may come out on the far side.
    const double facing = other.project(wall.at(wall.length() / 2.0)).y() > 0.0 ? 1.0 : -1.0;
    const auto outside = [&](double gap, double side)
    {
        const double s = atEnd ? wall.length() - gap : gap;
        return facing * other.project(wall.at(s, side * thickness_m / 2.0)).y() - otherThickness_m / 2.0;
    };
    // Both functions rise from the other's axis outwards; the first crossing is refined by bisection.
    const auto crossing = [&](const auto& f)
    {
        double gap = 0.0;
        while (f(gap + kStep_m) < 0.0 && gap < wall.length() / 2.0)
            gap += kStep_m;
        double low = gap;
        double high = gap + kStep_m;
        for (int i = 0; i < 40; ++i)
            (f(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
        return 0.5 * (low + high);
    };
    EndGap result;
    result.body_m = crossing([&](double gap) { return std::min(outside(gap, 1.0), outside(gap, -1.0)); });
    result.mesh_m = crossing([&](double gap) { return std::max(outside(gap, 1.0), outside(gap, -1.0)); });
    return result;
}

}  // namespace s2b::sim

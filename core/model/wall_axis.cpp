// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/wall_axis.h"

#include <cmath>
#include <numbers>

namespace s2b
{
namespace
{

Eigen::Vector2d leftOf(const Eigen::Vector2d& v)
{
    return {-v.y(), v.x()};
}

}  // namespace

WallAxis::WallAxis(const Wall& wall) : m_start(wall.start), m_direction(wall.direction())
{
    const double chord = (wall.end - wall.start).norm();
    m_length = chord;
    if (wall.bulge == 0.0)
        return;
    const double sweep = 4.0 * std::atan(wall.bulge);
    m_direction = (wall.end - wall.start) / chord;
    m_radius = chord / (2.0 * std::sin(sweep / 2.0));
    m_center = 0.5 * (wall.start + wall.end) + leftOf(m_direction) * (chord / 2.0 / std::tan(sweep / 2.0));
    m_angle = std::atan2(m_start.y() - m_center.y(), m_start.x() - m_center.x());
    m_length = sweep * m_radius;
}

Eigen::Vector2d WallAxis::direction(double s) const
{
    if (!isArc())
        return m_direction;
    const double angle = m_angle + s / m_radius;
    return Eigen::Vector2d(-std::sin(angle), std::cos(angle)) * (m_radius > 0 ? 1.0 : -1.0);
}

Eigen::Vector2d WallAxis::normal(double s) const
{
    return leftOf(direction(s));
}

Eigen::Vector2d WallAxis::at(double s, double d) const
{
    if (!isArc())
        return m_start + m_direction * s + leftOf(m_direction) * d;
    const double angle = m_angle + s / m_radius;
    return m_center + (radius_m() - (m_radius > 0 ? d : -d)) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

Eigen::Vector2d WallAxis::project(const Eigen::Vector2d& p) const
{
    const Eigen::Vector2d fromStart = p - m_start;
    if (!isArc())
        return {m_direction.dot(fromStart), leftOf(m_direction).dot(fromStart)};
    const Eigen::Vector2d arm = p - m_center;
    const double middle = m_angle + m_length / 2.0 / m_radius;
    const double turn = std::remainder(std::atan2(arm.y(), arm.x()) - middle, 2.0 * std::numbers::pi);
    const double inward = radius_m() - arm.norm();
    return {m_length / 2.0 + turn * m_radius, m_radius > 0 ? inward : -inward};
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"

#include <Eigen/Core>

namespace s2b
{

/// A wall's axis, straight or an arc, as a coordinate system of the plan: s along it from its start (arc length), d to
/// its left. s may lie outside of the axis: its line or circle goes on.
class WallAxis
{
public:
    explicit WallAxis(const Wall& wall);

    [[nodiscard]] bool isArc() const { return m_radius != 0.0; }
    [[nodiscard]] double length_m() const { return m_length; }
    [[nodiscard]] const Eigen::Vector2d& center() const { return m_center; }               ///< of an arc
    [[nodiscard]] double radius_m() const { return m_radius < 0 ? -m_radius : m_radius; }  ///< of an arc, else 0
    [[nodiscard]] Eigen::Vector2d direction(double s) const;                               ///< unit
    /// Unit, to the left of direction(s).
    [[nodiscard]] Eigen::Vector2d normal(double s) const;
    [[nodiscard]] Eigen::Vector2d at(double s, double d = 0.0) const;
    /// (s, d) of a point. Of an arc the s nearest to its middle; d is at most the radius on its inner side.
    [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector2d& p) const;

private:
    Eigen::Vector2d m_start, m_direction;  ///< the chord's for an arc
    Eigen::Vector2d m_center = Eigen::Vector2d::Zero();
    double m_length = 0.0;
    double m_radius = 0.0;  ///< signed: > 0 counter-clockwise; 0: straight
    double m_angle = 0.0;   ///< of the start about the centre
};

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"

#include <Eigen/Core>

#include <vector>

namespace s2b::ifc
{

/// A wall's body in the local frame of its placement (D3.6, 5.1), and its exact quantities.
///
/// The frame's origin is the body's lower-left corner in plan, x runs along the wall (along the chord of an arc), y to
/// its left, z up from the base: every coordinate of the body is >= 0.
class WallGeometry
{
public:
    explicit WallGeometry(const Wall& wall);

    [[nodiscard]] const Eigen::Vector2d& origin() const { return m_origin; }  ///< building frame
    [[nodiscard]] const Eigen::Vector2d& xAxis() const { return m_x; }        ///< building frame
    [[nodiscard]] bool isArc() const { return m_turn != 0.0; }
    [[nodiscard]] double radius_m() const { return m_radius; }  ///< of the axis; 0 when straight
    [[nodiscard]] double length_m() const { return m_length; }  ///< of the body, along the axis
    [[nodiscard]] double thickness_m() const { return m_wall.thickness.value_m; }
    [[nodiscard]] double bodySweep_rad() const { return isArc() ? m_length / m_radius : 0.0; }

    /// Local plan coordinates of the point at arc length `s` from the axis' start, `left` metres to the left of the
    /// axis.
    [[nodiscard]] Eigen::Vector2d at(double s, double left) const;
    /// Unit direction of the axis there, local.
    [[nodiscard]] Eigen::Vector2d tangent(double s) const;

    /// z of the top edge at `s`, building frame: the top profile, held level past its ends, or base + height.
    [[nodiscard]] double top_m(double s) const;
    [[nodiscard]] double lowestTop_m() const;
    [[nodiscard]] double highestTop_m() const;
    [[nodiscard]] bool hasLevelTop() const { return m_wall.topProfile.empty(); }
    /// (s, z) of the body's top edge from its start to its end; s ascends, and two points of equal s are a step.
    [[nodiscard]] std::vector<Eigen::Vector2d> topEdge() const;

    struct Quantities
    {
        double grossFootprint_m2 = 0.0;
        double netFootprint_m2 = 0.0;  ///< less the openings that reach the base
        double grossSide_m2 = 0.0;     ///< along the axis, without openings
        double netSide_m2 = 0.0;
        double grossVolume_m3 = 0.0;
        double netVolume_m3 = 0.0;
    };
    /// Exact for straight walls, whichever way openings overlap or stick out of the wall, and for arcs with apart
    /// openings.
    /// @param openings  those of this wall.
    [[nodiscard]] Quantities quantities(const std::vector<const Opening*>& openings) const;

private:
    [[nodiscard]] double openingPlanArea(const Opening& opening) const;

    const Wall& m_wall;
    Eigen::Vector2d m_origin = Eigen::Vector2d::Zero();
    Eigen::Vector2d m_x = Eigen::Vector2d::UnitX();
    double m_length = 0.0;
    double m_turn = 0.0;  // 1 for a counter-clockwise arc, -1 for a clockwise one, 0 for a straight wall
    double m_radius = 0.0;
    double m_startAngle = 0.0;  // building frame
    Eigen::Vector2d m_center = Eigen::Vector2d::Zero();
};

}  // namespace s2b::ifc

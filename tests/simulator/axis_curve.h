// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"

#include <Eigen/Core>

#include <vector>

namespace s2b::sim
{

/// A wall's axis in plan, straight or an arc, by arc length s from its start. s may lie outside [0, length]: the line
/// or circle goes on. Left is positive offset.
class AxisCurve
{
public:
    /// @param bulge  0: straight; else tan(sweep / 4), > 0 counter-clockwise.
    AxisCurve(const Eigen::Vector2d& start, const Eigen::Vector2d& end, double bulge);
    explicit AxisCurve(const Wall& wall) : AxisCurve(wall.start, wall.end, wall.bulge) {}

    [[nodiscard]] double length() const { return m_length; }
    [[nodiscard]] bool isArc() const { return m_radius != 0.0; }
    [[nodiscard]] Eigen::Vector2d direction(double s) const;
    [[nodiscard]] Eigen::Vector2d normal(double s) const;
    [[nodiscard]] Eigen::Vector2d at(double s, double offset = 0.0) const;
    /// Arc length and offset of a point (an arc's s is the nearest one to the arc's middle).
    [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector2d& point) const;
    /// Where to sample an arc between two lengths, ends included, with at most 1 mm sagitta; both ends for a line.
    [[nodiscard]] std::vector<double> samples(double from, double to) const;

    /// Where this curve at `offset` meets `other` at `otherOffset`, the solution nearest to `near`. Two arcs can't be
    /// met.
    [[nodiscard]] Eigen::Vector2d meet(double offset, const AxisCurve& other, double otherOffset,
                                       const Eigen::Vector2d& near) const;

private:
    Eigen::Vector2d m_start;
    Eigen::Vector2d m_direction;  ///< of the chord
    double m_length;
    Eigen::Vector2d m_center = Eigen::Vector2d::Zero();
    double m_radius = 0.0;  ///< signed: > 0 counter-clockwise; 0: straight
    double m_angle = 0.0;   ///< of the start about the centre
};

/// How far a wall's body stays away from the end of its axis where it runs into another wall.
struct EndGap
{
    double body_m = 0.0;  ///< both corners are outside the other wall
    double mesh_m = 0.0;  ///< both corners are still inside it, so that no gap is left at an oblique joint; <= body_m
};

/// @param atEnd  which end of the wall's axis lies on the other's axis.
[[nodiscard]] EndGap endGap(const AxisCurve& wall, double thickness_m, bool atEnd, const AxisCurve& other,
                            double otherThickness_m);

}  // namespace s2b::sim

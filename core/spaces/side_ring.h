// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/polygon.h"

#include <Eigen/Core>

#include <vector>

namespace s2b
{

/// One side of a ring, as the line it lies on.
struct Side
{
    Eigen::Vector2d t = Eigen::Vector2d::UnitX();  ///< unit, the inside to its left
    Eigen::Vector2d from = Eigen::Vector2d::Zero();
    Eigen::Vector2d to = Eigen::Vector2d::Zero();

    [[nodiscard]] double length() const { return (to - from).norm(); }
    [[nodiscard]] Eigen::Vector2d outward() const { return {t.y(), -t.x()}; }
    /// Moves the line.
    void shift(const Eigen::Vector2d& by)
    {
        from += by;
        to += by;
    }
};

/// A ring whose sides move as lines: its corners are where neighbouring lines meet.
class SideRing
{
public:
    explicit SideRing(std::vector<Side> sides) : m_sides(std::move(sides)) {}

    [[nodiscard]] std::vector<Side>& sides() { return m_sides; }
    /// Draws the sides to their common corners. Between parallel neighbours on different lines a step is inserted;
    /// sides that point backwards then are dropped, the worst first, until none is left. False when nothing remains.
    [[nodiscard]] bool close();
    /// Removes steps below `step_m`, the smallest first.
    void removeSteps(double step_m);
    [[nodiscard]] Ring corners() const;

private:
    void drop(std::size_t i) { m_sides.erase(m_sides.begin() + static_cast<std::ptrdiff_t>(i)); }

    std::vector<Side> m_sides;
};

/// The sides of a ring of points.
[[nodiscard]] SideRing sidesOf(const Ring& ring);

}  // namespace s2b

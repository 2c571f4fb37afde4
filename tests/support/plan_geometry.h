// SPDX-License-Identifier: GPL-3.0-or-later
/// What a plan of walls has to fulfil, measured independently of the code that made it.
#pragma once

#include "core/model/building.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace s2b::test
{

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Area of a ring; > 0 counter-clockwise.
inline double ringArea(const std::vector<Eigen::Vector2d>& ring)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        twice += cross(ring[i], ring[(i + 1) % ring.size()]);
    return twice / 2;
}

/// Area that two convex counter-clockwise rings share (Sutherland and Hodgman).
inline double sharedArea(std::vector<Eigen::Vector2d> a, const std::vector<Eigen::Vector2d>& b)
{
    for (std::size_t i = 0; i < b.size() && !a.empty(); ++i)
    {
        const Eigen::Vector2d from = b[i], along = b[(i + 1) % b.size()] - from;
        std::vector<Eigen::Vector2d> kept;
        for (std::size_t k = 0; k < a.size(); ++k)
        {
            const Eigen::Vector2d &p = a[k], &q = a[(k + 1) % a.size()];
            const double sideP = cross(along, p - from), sideQ = cross(along, q - from);
            if (sideP >= 0)
                kept.push_back(p);
            if ((sideP >= 0) != (sideQ >= 0))
                kept.push_back(p + (q - p) * (sideP / (sideP - sideQ)));
        }
        a = std::move(kept);
    }
    return ringArea(a);
}

/// The largest area that two walls of one storey share in plan.
inline double largestOverlap(const std::vector<Wall>& walls)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < walls.size(); ++i)
        for (std::size_t j = i + 1; j < walls.size(); ++j)
            if (walls[i].storey == walls[j].storey && walls[i].bulge == 0.0 && walls[j].bulge == 0.0)
                largest = std::max(largest, sharedArea(walls[i].outline(), walls[j].outline()));
    return largest;
}

inline double distanceToLine(const Wall& wall, const Eigen::Vector2d& p)
{
    return std::abs(cross(wall.direction(), p - wall.start));
}

/// How far the axes of joined walls miss each other, at worst [m].
inline double largestJunctionGap(const std::vector<Wall>& walls, const std::vector<Junction>& junctions)
{
    const auto find = [&](ElementId id) -> const Wall&
    { return *std::find_if(walls.begin(), walls.end(), [&](const Wall& w) { return w.id == id; }); };
    const auto at = [](const Wall& w, JunctionEnd end) { return end == JunctionEnd::Start ? w.start : w.end; };
    double largest = 0.0;
    for (const Junction& j : junctions)
    {
        const Wall &a = find(j.wallA), &b = find(j.wallB);
        if (j.endA != JunctionEnd::Path && j.endB != JunctionEnd::Path)
            largest = std::max(largest, (at(a, j.endA) - at(b, j.endB)).norm());
        else if (j.endA != JunctionEnd::Path)
            largest = std::max(largest, distanceToLine(b, at(a, j.endA)));
        else if (j.endB != JunctionEnd::Path)
            largest = std::max(largest, distanceToLine(a, at(b, j.endB)));
    }
    return largest;
}

/// The wall whose axis line passes within `reach` of p and whose axis runs along `direction` there; null without one.
inline const Wall* wallThrough(const std::vector<Wall>& walls, const Eigen::Vector2d& p,
                               const Eigen::Vector2d& direction, double reach = 0.3)
{
    const Wall* best = nullptr;
    double nearest = reach;
    for (const Wall& w : walls)
    {
        const double s = w.direction().dot(p - w.start);
        if (std::abs(cross(w.direction(), direction.normalized())) < 0.05 && s > -0.01 && s < w.axisLength_m() + 0.01 &&
            distanceToLine(w, p) < nearest)
        {
            nearest = distanceToLine(w, p);
            best = &w;
        }
    }
    return best;
}

/// Length of a wall's body along its axis [m].
inline double bodyLength(const Wall& w)
{
    return w.bodyEnd_m - w.bodyStart_m;
}

/// Is the point inside some wall's body?
inline bool isInSomeBody(const std::vector<Wall>& walls, const Eigen::Vector2d& p)
{
    return std::any_of(walls.begin(), walls.end(),
                       [&](const Wall& w)
                       {
                           const double s = w.direction().dot(p - w.start);
                           return s >= w.bodyStart_m && s <= w.bodyEnd_m &&
                                  distanceToLine(w, p) <= w.thickness.value_m / 2;
                       });
}

}  // namespace s2b::test

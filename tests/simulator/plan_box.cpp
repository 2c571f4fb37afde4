// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/plan_box.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace s2b::sim
{

namespace
{

/// Counter-clockwise hull (monotone chain).
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points)
{
    const auto less = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
    { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); };
    std::sort(points.begin(), points.end(), less);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3)
        return points;
    std::vector<Eigen::Vector2d> hull;
    for (int pass = 0; pass < 2; ++pass)
    {
        const std::size_t first = hull.size();
        for (const Eigen::Vector2d& p : points)
        {
            while (hull.size() >= first + 2)
            {
                const Eigen::Vector2d a = hull.back() - hull[hull.size() - 2];
                const Eigen::Vector2d b = p - hull.back();
                if (a.x() * b.y() - a.y() * b.x() > 0.0)
                    break;
                hull.pop_back();
            }
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

}  // namespace

PlanBox boxAlong(const std::vector<Eigen::Vector2d>& points, double yaw_rad)
{
    const Eigen::Vector2d u(std::cos(yaw_rad), std::sin(yaw_rad));
    const Eigen::Vector2d n(-u.y(), u.x());
    Eigen::Vector2d low(1e300, 1e300);
    Eigen::Vector2d high(-1e300, -1e300);
    for (const Eigen::Vector2d& p : points)
    {
        const Eigen::Vector2d q(p.dot(u), p.dot(n));
        low = low.cwiseMin(q);
        high = high.cwiseMax(q);
    }
    const Eigen::Vector2d middle = (low + high) / 2.0;
    return {u * middle.x() + n * middle.y(), (high - low) / 2.0, yaw_rad};
}

PlanBox smallestBox(std::vector<Eigen::Vector2d> points)
{
    const std::vector<Eigen::Vector2d> hull = convexHull(std::move(points));
    PlanBox best;
    double bestArea = -1.0;
    for (std::size_t i = 0; i < hull.size(); ++i)
    {
        const Eigen::Vector2d d = hull[(i + 1) % hull.size()] - hull[i];
        const PlanBox box = boxAlong(hull, std::atan2(d.y(), d.x()));
        const double area = box.half.x() * box.half.y();
        if (bestArea >= 0.0 && area >= bestArea - 1e-9)
            continue;
        bestArea = area;
        best = box;
    }
    if (best.half.y() > best.half.x())
        best = {best.center, {best.half.y(), best.half.x()}, best.yaw_rad + std::numbers::pi / 2.0};
    best.yaw_rad = std::fmod(std::fmod(best.yaw_rad, std::numbers::pi) + std::numbers::pi, std::numbers::pi);
    return best;
}

}  // namespace s2b::sim

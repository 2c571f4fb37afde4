// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc/wall_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace s2b::ifc
{
namespace
{

Eigen::Vector2d leftOf(const Eigen::Vector2d& v)
{
    return {-v.y(), v.x()};
}

/// Length of the union of intervals.
double unionLength(std::vector<std::pair<double, double>> intervals)
{
    std::sort(intervals.begin(), intervals.end());
    double length = 0.0;
    double reached = -std::numeric_limits<double>::infinity();
    for (const auto& [from, to] : intervals)
    {
        length += std::max(0.0, to - std::max(from, reached));
        reached = std::max(reached, to);
    }
    return length;
}

}  // namespace

WallGeometry::WallGeometry(const Wall& wall) : m_wall(wall), m_length(wall.bodyEnd_m - wall.bodyStart_m)
{
    m_x = (wall.end - wall.start).normalized();
    if (wall.bulge == 0.0)
    {
        m_origin = wall.start + m_x * wall.bodyStart_m - leftOf(m_x) * (0.5 * thickness_m());
        return;
    }
    const double sweep = 4.0 * std::atan(wall.bulge);
    m_turn = sweep > 0.0 ? 1.0 : -1.0;
    m_center = 0.5 * (wall.start + wall.end) + leftOf(wall.end - wall.start) * (0.5 / std::tan(0.5 * sweep));
    const Eigen::Vector2d arm = wall.start - m_center;
    m_radius = arm.norm();
    m_startAngle = std::atan2(arm.y(), arm.x());

    // The lower-left corner of an arc's box: extremes are at the four end corners or where the arc runs along x or y.
    const double from = m_startAngle + m_turn * wall.bodyStart_m / m_radius;
    const double to = from + m_turn * m_length / m_radius;
    const double chordAngle = std::atan2(m_x.y(), m_x.x());
    std::vector<double> angles = {from, to};
    for (double k = std::ceil((std::min(from, to) - chordAngle) / M_PI_2); chordAngle + k * M_PI_2 < std::max(from, to);
         k += 1.0)
        angles.push_back(chordAngle + k * M_PI_2);
    Eigen::Vector2d least = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
    for (const double angle : angles)
        for (const double radius : {m_radius - 0.5 * thickness_m(), m_radius + 0.5 * thickness_m()})
        {
            const Eigen::Vector2d p = m_center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
            least = least.cwiseMin(Eigen::Vector2d(p.dot(m_x), p.dot(leftOf(m_x))));
        }
    m_origin = m_x * least.x() + leftOf(m_x) * least.y();
}

Eigen::Vector2d WallGeometry::at(double s, double left) const
{
    if (!isArc())
        return {s - m_wall.bodyStart_m, left + 0.5 * thickness_m()};
    const double angle = m_startAngle + m_turn * s / m_radius;
    const Eigen::Vector2d p =
        m_center + (m_radius - m_turn * left) * Eigen::Vector2d(std::cos(angle), std::sin(angle)) - m_origin;
    return {p.dot(m_x), p.dot(leftOf(m_x))};
}

Eigen::Vector2d WallGeometry::tangent(double s) const
{
    if (!isArc())
        return Eigen::Vector2d::UnitX();
    const double angle = m_startAngle + m_turn * s / m_radius;
    const Eigen::Vector2d t = m_turn * Eigen::Vector2d(-std::sin(angle), std::cos(angle));
    return {t.dot(m_x), t.dot(leftOf(m_x))};
}

double WallGeometry::top_m(double s) const
{
    const auto& profile = m_wall.topProfile;
    if (profile.empty())
        return m_wall.base_m + m_wall.height.value_m;
    const auto after = std::upper_bound(profile.begin(), profile.end(), s,
                                        [](double value, const Eigen::Vector2d& p) { return value < p.x(); });
    if (after == profile.begin())
        return profile.front().y();
    if (after == profile.end())
        return profile.back().y();
    const Eigen::Vector2d& a = *(after - 1);
    return a.y() + (after->y() - a.y()) * (s - a.x()) / (after->x() - a.x());
}

double WallGeometry::lowestTop_m() const
{
    double z = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& p : topEdge())
        z = std::min(z, p.y());
    return z;
}

double WallGeometry::highestTop_m() const
{
    double z = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& p : topEdge())
        z = std::max(z, p.y());
    return z;
}

std::vector<Eigen::Vector2d> WallGeometry::topEdge() const
{
    constexpr double kSame_m = 1e-6;
    std::vector<Eigen::Vector2d> edge = {{m_wall.bodyStart_m, top_m(m_wall.bodyStart_m)}};
    for (const Eigen::Vector2d& p : m_wall.topProfile)
        if (p.x() > m_wall.bodyStart_m + kSame_m && p.x() < m_wall.bodyEnd_m - kSame_m &&
            (p - edge.back()).norm() > kSame_m)
            edge.push_back(p);
    edge.emplace_back(m_wall.bodyEnd_m, top_m(m_wall.bodyEnd_m));
    return edge;
}

double WallGeometry::openingPlanArea(const Opening& opening) const
{
    const double width = opening.width.value_m;
    if (!isArc())
        return width * thickness_m();
    // The void is a box about the tangent: between two circles, |u| <= width / 2.
    const double half = 0.5 * width;
    const auto under = [&](double r)
    {
        const double u = std::min(half, r);
        return u * std::sqrt(std::max(0.0, r * r - u * u)) + r * r * std::asin(u / r);
    };
    return under(m_radius + 0.5 * thickness_m()) - under(m_radius - 0.5 * thickness_m());
}

WallGeometry::Quantities WallGeometry::quantities(const std::vector<const Opening*>& openings) const
{
    struct Rectangle
    {
        double from, to, bottom, top;
    };
    const double base = m_wall.base_m;
    std::vector<Rectangle> holes;
    const std::vector<Eigen::Vector2d> edge = topEdge();
    std::vector<double> breaks;
    for (const Eigen::Vector2d& p : edge)
        breaks.push_back(p.x());
    for (const Opening* o : openings)
    {
        const double sill = base + o->sill.value_m;
        const Rectangle r = {std::max(o->offset_m, m_wall.bodyStart_m),
                             std::min(o->offset_m + o->width.value_m, m_wall.bodyEnd_m), std::max(sill, base),
                             sill + o->height.value_m};
        if (r.from >= r.to || r.bottom >= r.top)
            continue;
        holes.push_back(r);
        breaks.insert(breaks.end(), {r.from, r.to});
        // Where a sloped top crosses the opening's edges.
        for (std::size_t i = 0; i + 1 < edge.size(); ++i)
            for (const double z : {r.bottom, r.top})
                if ((edge[i].y() < z) != (edge[i + 1].y() < z))
                    breaks.push_back(edge[i].x() + (edge[i + 1].x() - edge[i].x()) * (z - edge[i].y()) /
                                                       (edge[i + 1].y() - edge[i].y()));
    }
    std::sort(breaks.begin(), breaks.end());

    // Everything is linear between two breaks, so the value at the middle is exact.
    Quantities q;
    double holesSide = 0.0;
    double holesFoot = 0.0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    {
        const double width = breaks[i + 1] - breaks[i];
        const double middle = 0.5 * (breaks[i] + breaks[i + 1]);
        const double top = top_m(middle);
        std::vector<std::pair<double, double>> cut;
        bool atBase = false;
        for (const Rectangle& r : holes)
            if (r.from < middle && middle < r.to && r.bottom < top)
            {
                cut.emplace_back(r.bottom, std::min(r.top, top));
                atBase = atBase || r.bottom <= base;
            }
        q.grossSide_m2 += width * (top - base);
        holesSide += width * unionLength(std::move(cut));
        holesFoot += atBase ? width : 0.0;
    }
    // An arc's voids have parallel jambs: their plan area is not width times thickness.
    double boxArea = 0.0;
    double planArea = 0.0;
    for (const Opening* o : openings)
    {
        const double clear = o->height.value_m;
        boxArea += clear * o->width.value_m * thickness_m();
        planArea += clear * openingPlanArea(*o);
    }
    const double voidDepth = thickness_m() * (boxArea > 0.0 ? planArea / boxArea : 1.0);
    q.netSide_m2 = q.grossSide_m2 - holesSide;
    q.grossFootprint_m2 = m_length * thickness_m();
    q.netFootprint_m2 = q.grossFootprint_m2 - holesFoot * voidDepth;
    q.grossVolume_m3 = q.grossSide_m2 * thickness_m();
    q.netVolume_m3 = q.grossVolume_m3 - holesSide * voidDepth;
    return q;
}

}  // namespace s2b::ifc

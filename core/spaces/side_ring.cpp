// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spaces/side_ring.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace s2b
{
namespace
{

constexpr double kParallel = 1e-3;  // sine of the angle below which neighbours have no corner worth computing
constexpr double kSameLine_m = 1e-6;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

Eigen::Vector2d meet(const Side& a, const Side& b)
{
    return a.from + a.t * (cross(b.from - a.from, b.t) / cross(a.t, b.t));
}

bool isParallel(const Side& a, const Side& b)
{
    return std::abs(cross(a.t, b.t)) < kParallel;
}

}  // namespace

bool SideRing::close()
{
    while (m_sides.size() >= 3)
    {
        // Parallel neighbours: one line continues, or a step leads from one to the other.
        for (std::size_t i = 0; i < m_sides.size() && m_sides.size() >= 3;)
        {
            Side& a = m_sides[i];
            Side& b = m_sides[(i + 1) % m_sides.size()];
            if (!isParallel(a, b))
            {
                ++i;
                continue;
            }
            if (a.t.dot(b.t) > 0 && std::abs(cross(a.t, b.from - a.from)) < kSameLine_m)
            {
                a.to = b.to;
                drop((i + 1) % m_sides.size());
                i = 0;
                continue;
            }
            const Eigen::Vector2d at = (a.to + b.from) / 2;
            Side step;
            step.from = a.from + a.t * a.t.dot(at - a.from);
            step.to = b.from + a.t * a.t.dot(at - b.from);
            if (step.length() < kSameLine_m)  // back on the same line
            {
                drop((i + 1) % m_sides.size());
                i = 0;
                continue;
            }
            step.t = (step.to - step.from).normalized();
            m_sides.insert(m_sides.begin() + static_cast<std::ptrdiff_t>(i) + 1, step);
            i += 2;
        }
        if (m_sides.size() < 3)
            return false;
        const std::size_t n = m_sides.size();
        for (std::size_t i = 0; i < n; ++i)
        {
            Side& a = m_sides[i];
            Side& b = m_sides[(i + 1) % n];
            a.to = meet(a, b);
        }
        for (std::size_t i = 0; i < n; ++i)
            m_sides[(i + 1) % n].from = m_sides[i].to;
        std::size_t worst = n;
        double least = -1e-9;
        for (std::size_t i = 0; i < n; ++i)
            if (const double along = m_sides[i].t.dot(m_sides[i].to - m_sides[i].from); along < least)
                least = along, worst = i;
        if (worst == n)
            return true;
        // Its neighbours meet now. Two that run against each other have passed each other: the longer one stays.
        const std::size_t before = (worst + n - 1) % n, after = (worst + 1) % n;
        const Side& a = m_sides[before];
        const Side& b = m_sides[after];
        if (isParallel(a, b) && a.t.dot(b.t) < 0)
        {
            const std::size_t shorter = a.length() < b.length() ? before : after;
            drop(std::max(worst, shorter));
            drop(std::min(worst, shorter));
        }
        else
            drop(worst);
    }
    return false;
}

void SideRing::removeSteps(double step_m)
{
    while (m_sides.size() > 4)
    {
        const std::size_t n = m_sides.size();
        std::size_t best = n;
        double shortest = step_m;
        for (std::size_t i = 0; i < n; ++i)
        {
            const Side& before = m_sides[(i + n - 1) % n];
            const Side& after = m_sides[(i + 1) % n];
            if (m_sides[i].length() < shortest && isParallel(before, after) && before.t.dot(after.t) > 0)
                shortest = m_sides[i].length(), best = i;
        }
        if (best == n)
            return;
        Side& before = m_sides[(best + n - 1) % n];
        Side& after = m_sides[(best + 1) % n];
        const Eigen::Vector2d end = after.to;
        if (after.length() > before.length())
            before.shift(before.outward() * before.outward().dot(after.from - before.from));
        before.to = before.from + before.t * before.t.dot(end - before.from);
        const std::size_t next = (best + 1) % n;
        drop(std::max(best, next));
        drop(std::min(best, next));
        if (!close())
            return;
    }
}

Ring SideRing::corners() const
{
    Ring ring;
    for (const Side& s : m_sides)
        ring.push_back(s.from);
    return ring;
}

SideRing sidesOf(const Ring& ring)
{
    std::vector<Side> sides;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const Eigen::Vector2d& a = ring[i];
        const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
        if (const double length = (b - a).norm(); length > 1e-9)
            sides.push_back({(b - a) / length, a, b});
    }
    return SideRing(std::move(sides));
}

}  // namespace s2b

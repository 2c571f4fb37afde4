// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/triangulate.h"

#include <algorithm>
#include <cstddef>

namespace s2b::sim
{

namespace
{

using Ring = std::vector<Eigen::Vector2d>;

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

bool crosses(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d)
{
    return turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0;
}

bool crossesRing(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Ring& ring)
{
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (crosses(a, b, ring[i], ring[(i + 1) % ring.size()]))
            return true;
    return false;
}

/// Cuts the ring open to the hole along the shortest free segment.
void bridge(Ring& ring, const Ring& hole)
{
    std::size_t bestRing = 0;
    std::size_t bestHole = 0;
    double best = -1.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        for (std::size_t j = 0; j < hole.size(); ++j)
        {
            const double length = (ring[i] - hole[j]).norm();
            if ((best >= 0.0 && length >= best) || crossesRing(ring[i], hole[j], ring) ||
                crossesRing(ring[i], hole[j], hole))
                continue;
            best = length;
            bestRing = i;
            bestHole = j;
        }
    Ring detour;
    for (std::size_t j = 0; j <= hole.size(); ++j)
        detour.push_back(hole[(bestHole + j) % hole.size()]);
    detour.push_back(ring[bestRing]);
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(bestRing) + 1, detour.begin(), detour.end());
}

}  // namespace

std::vector<std::array<Eigen::Vector2d, 3>> triangulate(const Polygon& polygon)
{
    Ring ring = polygon.outer;
    for (const Ring& hole : polygon.holes)
        bridge(ring, hole);
    std::vector<std::array<Eigen::Vector2d, 3>> triangles;
    while (ring.size() > 3)
    {
        const std::size_t n = ring.size();
        std::size_t ear = n;
        double best = 0.0;
        for (std::size_t i = 0; i < n; ++i)
        {
            const Eigen::Vector2d& a = ring[(i + n - 1) % n];
            const Eigen::Vector2d& b = ring[i];
            const Eigen::Vector2d& c = ring[(i + 1) % n];
            const double size = turn(a, b, c);
            if (size <= best)
                continue;
            const bool isEar = std::none_of(ring.begin(), ring.end(),
                                            [&](const Eigen::Vector2d& p)
                                            {
                                                return p != a && p != b && p != c && turn(a, b, p) > -1e-12 &&
                                                       turn(b, c, p) > -1e-12 && turn(c, a, p) > -1e-12;
                                            });
            if (!isEar)
                continue;
            best = size;
            ear = i;
        }
        if (ear == n)
        {
            // Only corners without an area are left.
            ring.erase(std::min_element(ring.begin(), ring.end() - 1,
                                        [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
                                        { return a.x() + a.y() < b.x() + b.y(); }));
            continue;
        }
        triangles.push_back({ring[(ear + n - 1) % n], ring[ear], ring[(ear + 1) % n]});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    if (ring.size() == 3 && turn(ring[0], ring[1], ring[2]) > 0.0)
        triangles.push_back({ring[0], ring[1], ring[2]});
    return triangles;
}

}  // namespace s2b::sim

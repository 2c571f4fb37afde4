// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace s2b
{

namespace
{

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

bool isBefore(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

/// Calls visit(a, b) for the edges of all rings.
template <class Visit>
void forEachEdge(const Polygon& polygon, Visit visit)
{
    const auto walk = [&](const Ring& ring)
    {
        for (std::size_t i = 0; i < ring.size(); ++i)
            visit(ring[i], ring[(i + 1) % ring.size()]);
    };
    walk(polygon.outer);
    for (const Ring& hole : polygon.holes)
        walk(hole);
}

/// Without repeated points, in the given direction, beginning at the smallest point. Empty when it is no ring.
Ring canonicalRing(Ring ring, bool counterClockwise)
{
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back())
        ring.pop_back();
    const double enclosed = signedArea(ring);
    if (ring.size() < 3 || enclosed == 0.0)
        return {};
    if ((enclosed > 0.0) != counterClockwise)
        std::ranges::reverse(ring);
    std::ranges::rotate(ring, std::ranges::min_element(ring, isBefore));
    return ring;
}

}  // namespace

double signedArea(std::span<const Eigen::Vector2d> ring)
{
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);  // relative: no loss far from the origin
    return 0.5 * twice;
}

double area(const Polygon& polygon)
{
    double sum = std::abs(signedArea(polygon.outer));
    for (const Ring& hole : polygon.holes)
        sum -= std::abs(signedArea(hole));
    return sum;
}

double perimeter(const Polygon& polygon)
{
    double sum = 0.0;
    forEachEdge(polygon, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { sum += (b - a).norm(); });
    return sum;
}

Eigen::Vector2d centroid(const Polygon& polygon)
{
    if (polygon.outer.empty())
        return Eigen::Vector2d::Zero();
    const Eigen::Vector2d reference = polygon.outer.front();
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    double sum = 0.0;
    const auto add = [&](const Ring& ring, double sign)
    {
        const double direction = signedArea(ring) < 0.0 ? -sign : sign;
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            const Eigen::Vector2d a = ring[i] - reference;
            const Eigen::Vector2d b = ring[(i + 1) % ring.size()] - reference;
            const double triangle = 0.5 * direction * cross(a, b);
            sum += triangle;
            moment += triangle * (a + b) / 3.0;
        }
    };
    add(polygon.outer, 1.0);
    for (const Ring& hole : polygon.holes)
        add(hole, -1.0);
    if (sum > 0.0)
        return reference + moment / sum;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& p : polygon.outer)
        mean += p - reference;
    return reference + mean / static_cast<double>(polygon.outer.size());
}

bool contains(const Polygon& polygon, const Eigen::Vector2d& p)
{
    bool inside = false;
    forEachEdge(polygon,
                [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
                {
                    if ((a.y() > p.y()) == (b.y() > p.y()))
                        return;
                    // Whether the edge crosses the ray to the right of p; lower end first, so that the shared edge of
                    // two polygons gives the same answer for both.
                    const Eigen::Vector2d& low = a.y() < b.y() ? a : b;
                    const Eigen::Vector2d& high = a.y() < b.y() ? b : a;
                    inside ^= cross(high - low, p - low) > 0.0;
                });
    return inside;
}

Polygon canonical(const Polygon& polygon)
{
    Polygon result;
    result.outer = canonicalRing(polygon.outer, true);
    if (result.outer.empty())
        return result;
    for (const Ring& hole : polygon.holes)
    {
        Ring ring = canonicalRing(hole, false);
        if (!ring.empty())
            result.holes.push_back(std::move(ring));
    }
    std::ranges::sort(result.holes, [](const Ring& a, const Ring& b)
                      { return std::ranges::lexicographical_compare(a, b, isBefore); });
    return result;
}

void sortPolygons(std::vector<Polygon>& polygons)
{
    std::ranges::sort(polygons, [](const Polygon& a, const Polygon& b)
                      { return std::ranges::lexicographical_compare(a.outer, b.outer, isBefore); });
}

}  // namespace s2b

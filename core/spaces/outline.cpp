// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spaces/outline.h"

#include "core/spaces/side_ring.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace s2b
{
namespace
{

constexpr double kSmallest_m2 = 1e-4;
constexpr double kSnapAngle = 0.26;  // sides within 15 degrees of a direction take it

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Makes valid polygons of rings that may cross, and drops specks.
std::vector<Polygon> cleaned(const Polygon& polygon)
{
    if (polygon.outer.size() < 3)
        return {};
    const std::vector<Polygon> one{polygon};
    std::vector<Polygon> result = unite(one);
    std::erase_if(result, [](const Polygon& p) { return area(p) < kSmallest_m2; });
    return result;
}

template <typename Change>
std::vector<Polygon> changedRings(const Polygon& polygon, Change&& change)
{
    Polygon result;
    if (std::optional<Ring> outer = change(polygon.outer))
        result.outer = std::move(*outer);
    for (const Ring& hole : polygon.holes)
        if (std::optional<Ring> ring = change(hole))
            result.holes.push_back(std::move(*ring));
    return cleaned(result);
}

/// The line through a piece of jagged outline: its direction from the list when one is near, its place the mean of the
/// outline's own points.
Side fitSide(const Ring& outline, std::size_t begin, std::size_t count, const StraightenOptions& options)
{
    const std::size_t n = outline.size();
    Side side;
    side.from = outline[begin];
    side.to = outline[(begin + count) % n];
    side.t = (side.to - side.from).normalized();
    const double angle = std::atan2(side.t.y(), side.t.x());
    double nearest = kSnapAngle;
    for (const double d : options.directions)
        for (const double turned : {d, d + std::numbers::pi})
        {
            const double off = std::remainder(turned - angle, 2 * std::numbers::pi);
            if (std::abs(off) < std::abs(nearest) - 1e-9)
            {
                nearest = off;
                side.t = {std::cos(turned), std::sin(turned)};
            }
        }
    // Mean offset along the outline, each of its small edges by its length along the side.
    double weight = 0, sum = 0;
    for (std::size_t k = 0; k < count; ++k)
    {
        const Eigen::Vector2d& a = outline[(begin + k) % n];
        const Eigen::Vector2d& b = outline[(begin + k + 1) % n];
        const double along = std::max(0.0, side.t.dot(b - a));
        weight += along;
        sum += along * side.outward().dot((a + b) / 2 - side.from);
    }
    if (weight > 0)
        side.shift(side.outward() * (sum / weight));
    side.to = side.from + side.t * side.t.dot(side.to - side.from);
    return side;
}

bool isAligned(const Side& side, const StraightenOptions& options)
{
    return std::any_of(options.directions.begin(), options.directions.end(), [&](double d)
                       { return std::abs(cross(side.t, Eigen::Vector2d(std::cos(d), std::sin(d)))) < 1e-6; });
}

bool isSquare(const Side& a, const Side& b)
{
    return std::abs(a.t.dot(b.t)) < kSnapAngle;
}

/// How much of the corner of its neighbours a side cuts off: its distance from there, or two thirds of its length
/// where they run alike.
double cutOff(const Side& side, const Side& before, const Side& after)
{
    const double turn = cross(before.t, after.t);
    if (std::abs(turn) < kSnapAngle)
        return 0.67 * side.length();
    const Eigen::Vector2d corner = before.from + before.t * (cross(after.from - before.from, after.t) / turn);
    return std::abs(side.outward().dot(corner - side.from));
}

/// Moves a side onto the face that runs along most of it.
void snapToFace(Side& side, const StraightenOptions& options)
{
    double best = 0.3 * side.length(), shift = 0;
    for (const Segment& f : options.faces)
    {
        const Eigen::Vector2d d = f.b - f.a;
        const double length = d.norm();
        if (length < 0.05 || std::abs(cross(side.t, d)) > 0.01 * length)
            continue;
        const double off = side.outward().dot((f.a + f.b) / 2 - side.from);
        if (std::abs(off) > options.snap_m)
            continue;
        const double u = side.t.dot(f.a - side.from), v = side.t.dot(f.b - side.from);
        const double overlap = std::min(std::max(u, v), side.length()) - std::max(std::min(u, v), 0.0);
        // The longest face wins, a nearer one among equals.
        if (overlap - 0.5 * std::abs(off) > best)
            best = overlap - 0.5 * std::abs(off), shift = off;
    }
    side.shift(side.outward() * shift);
}

std::optional<Ring> straightened(const Ring& outline, const Ring& simple, const StraightenOptions& options)
{
    // `simple` has some of the outline's points, in its order.
    const auto indexOf = [&](const Eigen::Vector2d& p)
    {
        std::size_t best = 0;
        for (std::size_t i = 1; i < outline.size(); ++i)
            if ((outline[i] - p).squaredNorm() < (outline[best] - p).squaredNorm())
                best = i;
        return best;
    };
    std::vector<std::size_t> at;
    for (const Eigen::Vector2d& p : simple)
        at.push_back(indexOf(p));
    std::vector<Side> sides;
    for (std::size_t i = 0; i < at.size(); ++i)
    {
        const std::size_t count = (at[(i + 1) % at.size()] + outline.size() - at[i]) % outline.size();
        if (count == 0)
            continue;
        Side side = fitSide(outline, at[i], count, options);
        sides.push_back(side);
    }
    // A corner cut off by the raster or by what stands in it: its neighbours meet in the corner.
    std::vector<Side> kept;
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
        const Side& before = sides[(i + sides.size() - 1) % sides.size()];
        const Side& after = sides[(i + 1) % sides.size()];
        const bool isStep = isAligned(sides[i], options) && (isSquare(sides[i], before) || isSquare(sides[i], after));
        if (!isStep && cutOff(sides[i], before, after) < options.detail_m)
            continue;
        snapToFace(sides[i], options);
        kept.push_back(sides[i]);
    }
    SideRing ring(std::move(kept));
    if (!ring.close())
        return std::nullopt;
    ring.removeSteps(options.detail_m);
    return ring.corners();
}

}  // namespace

std::vector<Segment> edgesOf(std::span<const Polygon> polygons)
{
    std::vector<Segment> edges;
    const auto add = [&](const Ring& ring)
    {
        for (std::size_t i = 0; i < ring.size(); ++i)
            edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    };
    for (const Polygon& p : polygons)
    {
        add(p.outer);
        for (const Ring& hole : p.holes)
            add(hole);
    }
    return edges;
}

std::vector<Polygon> offsetEdges(const Polygon& polygon, const std::function<double(const Segment&)>& distance)
{
    return changedRings(polygon,
                        [&](const Ring& ring) -> std::optional<Ring>
                        {
                            SideRing sides = sidesOf(ring);
                            for (Side& s : sides.sides())
                                s.shift(s.outward() * distance({s.from, s.to}));
                            if (!sides.close())
                                return std::nullopt;
                            return sides.corners();
                        });
}

std::vector<Polygon> straightOutlines(const PlanBits& bits, const PlanGrid& grid, const StraightenOptions& options)
{
    std::vector<Polygon> result;
    for (const Polygon& outline : traceMask(bits, grid.width, grid.height, grid.low, grid.pixel_m))
    {
        if (area(outline) < options.detail_m * options.detail_m)
            continue;
        const Polygon simple = simplify(outline, std::max(options.detail_m / 2, 1.5 * grid.pixel_m));
        Polygon straight;
        // Rings are matched by their first points: simplification may move the order of small holes.
        const auto original = [&](const Ring& ring) -> const Ring&
        {
            const Ring* best = &outline.outer;
            double nearest = std::numeric_limits<double>::infinity();
            const auto consider = [&](const Ring& candidate)
            {
                for (const Eigen::Vector2d& p : candidate)
                    if (const double d = (p - ring.front()).squaredNorm(); d < nearest)
                        nearest = d, best = &candidate;
            };
            consider(outline.outer);
            for (const Ring& hole : outline.holes)
                consider(hole);
            return *best;
        };
        for (Polygon& p :
             changedRings(simple, [&](const Ring& ring) { return straightened(original(ring), ring, options); }))
            result.push_back(std::move(p));
    }
    return unite(result);
}

std::vector<Polygon> withoutSteps(const Polygon& polygon, double step_m)
{
    return changedRings(polygon,
                        [&](const Ring& ring) -> std::optional<Ring>
                        {
                            SideRing sides = sidesOf(ring);
                            sides.removeSteps(step_m);
                            return sides.corners();
                        });
}

}  // namespace s2b

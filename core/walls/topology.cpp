// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/topology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>

namespace s2b
{
namespace
{

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

Eigen::Vector2d at(const WallBody& b, double s, double d)
{
    return b.t * s + b.n() * d;
}

/// Share of a body's cross section between two places that shows room.
double freeBetween(const WallBody& b, double from, double to, const PlanMask& mask)
{
    const double inset = std::min(0.03, b.thickness() / 4);
    return mask.freeShare(at(b, from, 0), at(b, to, 0), b.low + inset, b.high - inset);
}

/// Are two bodies of one line pieces of one wall?
bool isOneWall(const WallBody& a, const WallBody& b, const PlanMask& mask, const WallParams& params)
{
    if (std::abs(cross(a.t, b.t)) > 1e-6)
        return false;
    const bool lowFits = std::abs(a.low - b.low) < params.mergeOffset_m,
               highFits = std::abs(a.high - b.high) < params.mergeOffset_m;
    const bool sameFace = (lowFits && a.lowSeen && b.lowSeen) || (highFits && a.highSeen && b.highSeen);
    // Each face must agree where both saw it; an assumed one follows the other.
    if ((a.lowSeen && b.lowSeen && !lowFits) || (a.highSeen && b.highSeen && !highFits))
        return false;
    if (!sameFace && !(lowFits && highFits))
        return false;
    const double gap = std::max(a.begin, b.begin) - std::min(a.end, b.end);
    // Nothing passes through a crack, whatever a pixel of the mask in it says.
    constexpr double crack_m = 0.15;
    if (gap <= crack_m)
        return true;
    if (gap > params.mergeUnseen_m)
        return false;
    const WallBody& first = a.begin < b.begin ? a : b;
    const WallBody& second = a.begin < b.begin ? b : a;
    const WallBody& measured = a.bothSeen() || !b.bothSeen() ? a : b;
    const double free = freeBetween(measured, first.end + 0.02, second.begin - 0.02, mask);
    if (gap <= params.mergeGap_m)
        return free < 0.4;
    // A doorway below a low lintel: the faces were not seen above it, but neither was the ceiling.
    constexpr double doorway_m = 1.3;
    if (gap <= doorway_m && (a.bothSeen() || b.bothSeen()) && lowFits && highFits)
        return free < 0.5;
    // A longer gap was hidden, not open: nothing seen in it, and the pieces are long and agree closely.
    return free < 0.03 && gap < a.end - a.begin && gap < b.end - b.begin &&
           (!sameFace || std::min(std::abs(a.low - b.low), std::abs(a.high - b.high)) < 0.5 * params.mergeOffset_m);
}

void absorb(WallBody& a, const WallBody& b)
{
    const double la = a.end - a.begin, lb = b.end - b.begin;
    const auto mean = [&](double va, bool seenA, double vb, bool seenB) -> double
    { return seenA && seenB ? (va * la + vb * lb) / (la + lb) : (seenB ? vb : va); };
    // Each unseen side keeps its distance to the seen one of the piece that knows more.
    const bool bKnowsMore = b.bothSeen() && !a.bothSeen();
    const double low = mean(a.low, a.lowSeen, b.low, b.lowSeen), high = mean(a.high, a.highSeen, b.high, b.highSeen);
    if (!a.bothSeen() && !b.bothSeen() && a.lowSeen == b.lowSeen)
    {
        const double thickness = la >= lb ? a.thickness() : b.thickness();
        a.low = a.lowSeen ? low : high - thickness;
        a.high = a.lowSeen ? low + thickness : high;
    }
    else
        a.low = bKnowsMore && !a.lowSeen ? b.low : low, a.high = bKnowsMore && !a.highSeen ? b.high : high;
    if (bKnowsMore || (!a.bothSeen() && !b.bothSeen() && lb > la))
        a.thicknessSource = b.thicknessSource;
    a.lowSeen = a.lowSeen || b.lowSeen;
    a.highSeen = a.highSeen || b.highSeen;
    if (a.bothSeen())
        a.thicknessSource = ThicknessSource::Faces;
    a.begin = std::min(a.begin, b.begin);
    a.end = std::max(a.end, b.end);
    a.lowFaces.insert(a.lowFaces.end(), b.lowFaces.begin(), b.lowFaces.end());
    a.highFaces.insert(a.highFaces.end(), b.highFaces.begin(), b.highFaces.end());
}

/// Share of a's plan rectangle that lies within b's (both of any direction), by sampling.
double coveredBy(const WallBody& a, const WallBody& b)
{
    constexpr int n = 24, m = 5;
    int inside = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j)
        {
            const Eigen::Vector2d p =
                at(a, a.begin + (a.end - a.begin) * (i + 0.5) / n, a.low + a.thickness() * (j + 0.5) / m);
            const double s = b.t.dot(p), d = b.n().dot(p);
            inside += s > b.begin && s < b.end && d > b.low && d < b.high;
        }
    return static_cast<double>(inside) / (n * m);
}

/// Half of what b's body takes of a's length where the two meet, both corners of a outside b.
double halfAcrossOf(const WallBody& a, const WallBody& b)
{
    return (b.thickness() / 2 + std::abs(a.t.dot(b.t)) * a.thickness() / 2) / std::abs(cross(a.t, b.t));
}

/// What an end of a wall could meet.
struct Meeting
{
    std::uint32_t other = 0;
    double s = 0;       ///< on the wall's axis
    double sOther = 0;  ///< on the other's axis
    double move = 0;    ///< how far the end has to be drawn (to the other's near face)
};

std::optional<Meeting> meetingOf(const WallBody& a, bool atEnd, const WallBody& b, std::uint32_t other,
                                 const PlanMask& mask, const WallParams& params)
{
    const double sine = cross(a.t, b.t);
    if (std::abs(sine) < std::sin(10 * std::numbers::pi / 180))
        return std::nullopt;
    // Intersection of the centre lines.
    const Eigen::Vector2d pa = a.n() * a.middle(), pb = b.n() * b.middle();
    Meeting m;
    m.other = other;
    m.s = cross(pb - pa, b.t) / sine;
    m.sOther = cross(pb - pa, a.t) / sine;
    const double halfAcross = halfAcrossOf(a, b);
    const double end = atEnd ? a.end : a.begin, out = atEnd ? 1.0 : -1.0;
    const double beyond = out * (m.s - end);  // > 0: the axis has to be drawn
    m.move = beyond - halfAcross;             // to the near face of the other
    if (m.move > params.closeGap_m || beyond < -halfAcross - 0.25)
        return std::nullopt;
    const double halfAlong = (a.thickness() / 2 + std::abs(a.t.dot(b.t)) * b.thickness() / 2) / std::abs(sine);
    if (m.sOther < b.begin - halfAlong - params.closeGap_m || m.sOther > b.end + halfAlong + params.closeGap_m)
        return std::nullopt;
    // A gap with room in it is a passage.
    if (m.move > 0.08 &&
        freeBetween(a, std::min(end, end + out * m.move), std::max(end, end + out * m.move), mask) > 0.4)
        return std::nullopt;
    return m;
}

/// Where one body runs through another the shorter one is split: it ends on the other from both sides.
void splitCrossings(std::vector<WallBody>& bodies, double minimumLength)
{
    const auto splitOne = [&]
    {
        for (std::size_t i = 0; i < bodies.size(); ++i)
            for (std::size_t j = 0; j < bodies.size(); ++j)
            {
                WallBody& a = bodies[i];
                const WallBody& b = bodies[j];
                const double sine = cross(a.t, b.t);
                if (i == j || std::abs(sine) < std::sin(10 * std::numbers::pi / 180) ||
                    std::tuple(a.end - a.begin, i) > std::tuple(b.end - b.begin, j) || a.bottom >= b.top ||
                    b.bottom >= a.top)
                    continue;
                const Eigen::Vector2d between = b.n() * b.middle() - a.n() * a.middle();
                const double sa = cross(between, b.t) / sine, sb = cross(between, a.t) / sine,
                             half = halfAcrossOf(a, b);
                if (sa - half < a.begin + minimumLength || sa + half > a.end - minimumLength ||
                    sb < b.begin + minimumLength || sb > b.end - minimumLength)
                    continue;
                WallBody rest = a;
                a.end = sa - half;
                rest.begin = sa + half;
                bodies.push_back(std::move(rest));
                return true;
            }
        return false;
    };
    while (splitOne())
    {
    }
}

}  // namespace

std::vector<WallBody> mergeBodies(std::vector<WallBody> bodies, const PlanMask& mask, const WallParams& params)
{
    std::sort(bodies.begin(), bodies.end(),
              [](const WallBody& a, const WallBody& b)
              {
                  return std::tuple(!a.bothSeen(), -(a.end - a.begin), a.begin, a.low) <
                         std::tuple(!b.bothSeen(), -(b.end - b.begin), b.begin, b.low);
              });
    for (bool changed = true; changed;)
    {
        changed = false;
        for (std::size_t i = 0; i < bodies.size(); ++i)
            for (std::size_t j = i + 1; j < bodies.size();)
                if (isOneWall(bodies[i], bodies[j], mask, params))
                {
                    absorb(bodies[i], bodies[j]);
                    bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(j));
                    changed = true;
                }
                else
                    ++j;
    }
    // A body within another is the other's furring, frame or reveal.
    for (std::size_t i = bodies.size(); i-- > 0;)
        for (std::size_t j = 0; j < bodies.size(); ++j)
            if (i != j && bodies[j].end - bodies[j].begin >= bodies[i].end - bodies[i].begin &&
                coveredBy(bodies[i], bodies[j]) > 0.6)
            {
                bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(i));
                break;
            }
    return bodies;
}

Plan connectWalls(std::vector<WallBody> bodies, const PlanMask& mask, const WallParams& params)
{
    Plan plan;
    std::erase_if(bodies, [&](const WallBody& b)
                  { return b.end - b.begin < params.minimumLength_m || b.thickness() < params.minimumThickness_m; });
    splitCrossings(bodies, params.minimumLength_m);
    for (const WallBody& b : bodies)
        plan.walls.push_back({b, b.begin, b.end});

    // Each end is drawn to the axis it meets; the nearest near face wins.
    for (std::uint32_t i = 0; i < bodies.size(); ++i)
        for (const bool atEnd : {false, true})
        {
            std::optional<Meeting> best;
            for (std::uint32_t j = 0; j < bodies.size(); ++j)
                if (j != i)
                    if (const auto m = meetingOf(bodies[i], atEnd, bodies[j], j, mask, params))
                        if (!best || std::abs(m->move) < std::abs(best->move))
                            best = m;
            if (!best)
                continue;
            const WallBody& other = bodies[best->other];
            const double reach = bodies[i].thickness() / 2 + params.closeGap_m;
            BodyJunction junction{i, atEnd, best->other, 0, at(bodies[i], best->s, bodies[i].middle())};
            const double toBegin = best->sOther - other.begin, toEnd = other.end - best->sOther;
            // Near the other's end it is a corner, unless the other clearly runs on.
            if (std::min(toBegin, toEnd) < std::max(bodies[i].thickness() * 0.75 + 0.05, 0.15) &&
                std::min(toBegin, toEnd) > -reach)
                junction.otherEnd = toBegin < toEnd ? -1 : 1;
            (atEnd ? plan.walls[i].axisEnd : plan.walls[i].axisBegin) = best->s;
            plan.junctions.push_back(junction);
        }
    // Bodies: cut at the other's near face where a wall ends on another; at a corner the longer one runs to the far
    // face.
    for (const BodyJunction& j : plan.junctions)
    {
        WallBody& a = plan.walls[j.wall].body;
        const WallBody& b = bodies[j.other];
        const double sine = std::abs(cross(a.t, b.t));
        // A wall that ends on another one does so where its first corner touches it; one that runs through covers it.
        const double half = b.thickness() / 2 / sine;
        const double s = j.atEnd ? plan.walls[j.wall].axisEnd : plan.walls[j.wall].axisBegin;
        const double out = j.atEnd ? 1.0 : -1.0;
        const double lengthA = bodies[j.wall].end - bodies[j.wall].begin, lengthB = b.end - b.begin;
        const bool through = j.otherEnd != 0 && std::tuple(lengthA, j.wall) > std::tuple(lengthB, j.other);
        (j.atEnd ? a.end : a.begin) = s + out * (through ? half : -halfAcrossOf(a, b));
    }
    return plan;
}

void dropFreePieces(Plan& plan, double minimumFreeLength_m)
{
    std::vector<char> meets(plan.walls.size(), 0);
    for (const BodyJunction& j : plan.junctions)
        meets[j.wall] = meets[j.other] = 1;
    std::vector<std::uint32_t> place(plan.walls.size(), 0);
    std::vector<PlanWall> kept;
    for (std::size_t i = 0; i < plan.walls.size(); ++i)
        if (meets[i] || plan.walls[i].body.end - plan.walls[i].body.begin >= minimumFreeLength_m)
        {
            place[i] = static_cast<std::uint32_t>(kept.size());
            kept.push_back(std::move(plan.walls[i]));
        }
    plan.walls = std::move(kept);
    for (BodyJunction& j : plan.junctions)
        j.wall = place[j.wall], j.other = place[j.other];
}

}  // namespace s2b

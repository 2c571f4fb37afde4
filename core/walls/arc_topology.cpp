// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/arc_topology.h"

#include "core/model/wall_axis.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

namespace s2b
{
namespace
{

constexpr double kPi = std::numbers::pi;
constexpr double kTangent_m = 0.06;     // how far a tangent's line may miss the arc's axis
constexpr double kSmallestSine = 0.17;  // 10 degrees: below, two axes have no definite crossing
constexpr double kSmallestPiece_m = 0.3;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

bool isArc(const Wall& w)
{
    return w.bulge != 0.0;
}

double endOf(const WallAxis& axis, bool atEnd)
{
    return atEnd ? axis.length_m() : 0.0;
}

/// Moves an end of a wall's axis to p, which lies on its line, or next to its circle; the body stays where it is.
void moveEnd(Wall& w, bool atEnd, const Eigen::Vector2d& p)
{
    const WallAxis before(w);
    const Eigen::Vector2d bodyFrom = before.at(w.bodyStart_m), bodyTo = before.at(w.bodyEnd_m);
    const Eigen::Vector2d other = atEnd ? w.start : w.end;
    if ((p - other).norm() < 1e-6)
        return;
    if (isArc(w))
    {
        const double s = before.project(p).x(), middle = ((atEnd ? 0.0 : before.length_m()) + s) / 2;
        const Eigen::Vector2d from = atEnd ? other : p, to = atEnd ? p : other, chord = to - from;
        // To the right of the chord for a counter-clockwise arc.
        const double sagitta = cross(before.at(middle) - from, chord) / chord.norm();
        w.bulge = 2 * sagitta / chord.norm();
    }
    (atEnd ? w.end : w.start) = p;
    const WallAxis after(w);
    w.bodyStart_m = after.project(bodyFrom).x();
    w.bodyEnd_m = after.project(bodyTo).x();
}

/// Where two axes cross, at least one of them an arc's.
std::vector<Eigen::Vector2d> crossings(const WallAxis& a, const WallAxis& b)
{
    if (!a.isArc())
        return b.isArc() ? crossings(b, a) : std::vector<Eigen::Vector2d>{};
    Eigen::Vector2d foot, along;
    double half2 = 0;
    if (!b.isArc())
    {
        along = b.direction(0);
        foot = b.at(b.project(a.center()).x());
        half2 = a.radius_m() * a.radius_m() - (foot - a.center()).squaredNorm();
    }
    else
    {
        const Eigen::Vector2d d = b.center() - a.center();
        const double distance = d.norm();
        if (distance < 1e-6)
            return {};
        const double x =
            (distance * distance + a.radius_m() * a.radius_m() - b.radius_m() * b.radius_m()) / (2 * distance);
        foot = a.center() + d / distance * x;
        along = Eigen::Vector2d(-d.y(), d.x()) / distance;
        half2 = a.radius_m() * a.radius_m() - x * x;
    }
    if (half2 <= 0)
        return {};
    return {foot - along * std::sqrt(half2), foot + along * std::sqrt(half2)};
}

/// Where the body of a wall that meets another at s on its axis has to end: the first place at which all of its end
/// lies outside the other's body.
double cutAt(const Wall& w, bool atEnd, double s, const Wall& other)
{
    const WallAxis axis(w), otherAxis(other);
    const double back = atEnd ? -1.0 : 1.0, half = w.thickness.value_m / 2, otherHalf = other.thickness.value_m / 2;
    const auto isOutside = [&](double by)
    {
        constexpr int places = 8;
        for (int i = 0; i <= places; ++i)
            if (std::abs(otherAxis.project(axis.at(s + back * by, half * (2.0 * i / places - 1))).y()) < otherHalf)
                return false;
        return true;
    };
    constexpr double step = 0.01, farthest = 2.0;
    double by = 0;
    while (by < farthest && !isOutside(by))
        by += step;
    double low = std::max(0.0, by - step);
    for (int round = 0; round < 24; ++round)
        (isOutside((low + by) / 2) ? by : low) = (low + by) / 2;
    return s + back * by;
}

/// What an end of a wall could meet.
struct Meeting
{
    std::size_t other = 0;
    Eigen::Vector2d point = Eigen::Vector2d::Zero();
    double move = 0;   ///< how far the end has to be drawn
    int otherEnd = 0;  ///< -1: the other's start, +1: its end, 0: along its path
    bool isTangent = false;
};

class Connector
{
public:
    Connector(std::vector<Wall>& walls, std::vector<Junction>& junctions, const PlanMask& mask,
              const WallParams& params)
        : m_walls(walls), m_junctions(junctions), m_mask(mask), m_params(params)
    {
    }

    void splitCrossings(std::uint32_t& nextId)
    {
        for (std::size_t i = 0; i < m_walls.size(); ++i)
            for (std::size_t j = 0; !isArc(m_walls[i]) && j < m_walls.size(); ++j)
                if (isArc(m_walls[j]))
                    split(i, j, nextId);
    }

    /// Joins all ends of the curved walls, then the straight walls that end on one.
    void connect()
    {
        for (const bool curved : {true, false})
            for (std::size_t i = 0; i < m_walls.size(); ++i)
                for (const bool atEnd : {false, true})
                    if (isArc(m_walls[i]) == curved && !isJoinedTo(i, atEnd, curved))
                        if (const auto m = bestMeeting(i, atEnd))
                            join(i, atEnd, *m);
    }

private:
    [[nodiscard]] static JunctionEnd nameOf(bool atEnd) { return atEnd ? JunctionEnd::End : JunctionEnd::Start; }

    /// Does the end meet a wall already: any, or a curved one?
    [[nodiscard]] bool isJoinedTo(std::size_t wall, bool atEnd, bool any) const
    {
        const auto ofCurved = [&](ElementId id)
        { return std::any_of(m_walls.begin(), m_walls.end(), [&](const Wall& w) { return w.id == id && isArc(w); }); };
        return std::any_of(m_junctions.begin(), m_junctions.end(),
                           [&](const Junction& j)
                           {
                               const ElementId id = m_walls[wall].id;
                               return (j.wallA == id && j.endA == nameOf(atEnd) && (any || ofCurved(j.wallB))) ||
                                      (j.wallB == id && j.endB == nameOf(atEnd) && (any || ofCurved(j.wallA)));
                           });
    }

    [[nodiscard]] std::optional<Meeting> bestMeeting(std::size_t i, bool atEnd) const
    {
        std::optional<Meeting> best;
        for (std::size_t j = 0; j < m_walls.size(); ++j)
        {
            if (j == i || (!isArc(m_walls[i]) && !isArc(m_walls[j])))
                continue;
            for (const auto& m : {tangentOf(i, atEnd, j), crossingOf(i, atEnd, j)})
                if (m && (!best || std::tuple(!m->isTangent, std::abs(m->move)) <
                                       std::tuple(!best->isTangent, std::abs(best->move))))
                    best = m;
        }
        return best;
    }

    /// The other end that goes on where this one stops, in the same direction.
    [[nodiscard]] std::optional<Meeting> tangentOf(std::size_t i, bool atEnd, std::size_t j) const
    {
        const WallAxis a(m_walls[i]), b(m_walls[j]);
        // Both are drawn out too far where the one's face hardly leaves the other's.
        const double radius = std::min(a.isArc() ? a.radius_m() : 1e9, b.isArc() ? b.radius_m() : 1e9);
        const double reach = m_params.closeGap_m + std::sqrt(2 * radius * m_params.planeDistance_m);
        std::optional<Meeting> best;
        for (const bool otherAtEnd : {false, true})
        {
            const double sa = endOf(a, atEnd), sb = endOf(b, otherAtEnd);
            Eigen::Vector2d point = (a.at(sa) + b.at(sb)) / 2;
            if (a.isArc() != b.isArc())
                point = a.isArc() ? b.at(b.project(a.center()).x()) : a.at(a.project(b.center()).x());
            const Eigen::Vector2d onA = a.project(point), onB = b.project(point);
            const double moveA = (atEnd ? 1 : -1) * (onA.x() - sa), moveB = (otherAtEnd ? 1 : -1) * (onB.x() - sb);
            if (std::abs(moveA) > reach || std::abs(moveB) > reach || std::abs(onA.y()) > kTangent_m ||
                std::abs(onB.y()) > kTangent_m || a.length_m() + moveA < kSmallestPiece_m ||
                b.length_m() + moveB < kSmallestPiece_m ||
                (atEnd ? 1 : -1) * a.direction(onA.x()).dot((otherAtEnd ? 1 : -1) * b.direction(onB.x())) > -0.94)
                continue;
            if (isFree(m_walls[i], a.at(sa), point, moveA) || isFree(m_walls[j], b.at(sb), point, moveB))
                continue;
            const Meeting m{j, point, std::max(std::abs(moveA), std::abs(moveB)), otherAtEnd ? 1 : -1, true};
            if (!best || m.move < best->move)
                best = m;
        }
        return best;
    }

    [[nodiscard]] std::optional<Meeting> crossingOf(std::size_t i, bool atEnd, std::size_t j) const
    {
        const Wall &wa = m_walls[i], &wb = m_walls[j];
        const WallAxis a(wa), b(wb);
        const double out = atEnd ? 1.0 : -1.0, close = m_params.closeGap_m;
        // A joined end of a straight wall was drawn already: only what lies on its way can be nearer.
        const bool isJoined = !isArc(wa) && isJoinedTo(i, atEnd, true);
        const double end = isJoined ? endOf(a, atEnd) : (atEnd ? wa.bodyEnd_m : wa.bodyStart_m);
        std::optional<Meeting> best;
        for (const Eigen::Vector2d& p : crossings(a, b))
        {
            const double s = a.project(p).x(), sOther = b.project(p).x();
            const double sine = std::abs(cross(a.direction(s), b.direction(sOther))),
                         cosine = std::abs(a.direction(s).dot(b.direction(sOther)));
            if (sine < kSmallestSine)
                continue;
            const double across = (wb.thickness.value_m / 2 + cosine * wa.thickness.value_m / 2) / sine,
                         along = (wa.thickness.value_m / 2 + cosine * wb.thickness.value_m / 2) / sine;
            const double beyond = out * (s - end), move = beyond - across;
            const double length = (atEnd ? s : a.length_m() - s);
            if (move > close || beyond < -across - (isJoined ? 1.2 : 0.25) || (isJoined && beyond > 0) ||
                length < kSmallestPiece_m || sOther < wb.bodyStart_m - along - close ||
                sOther > wb.bodyEnd_m + along + close)
                continue;
            if (isFree(wa, a.at(end), a.at(end + out * move), move))
                continue;
            Meeting m{j, p, move, 0, false};
            const double toBegin = sOther - wb.bodyStart_m, toEnd = wb.bodyEnd_m - sOther;
            // Near the other's free end it is a corner, unless the other clearly runs on.
            if (std::min(toBegin, toEnd) < std::max(wa.thickness.value_m * 0.75 + 0.05, 0.15) &&
                std::min(toBegin, toEnd) > -wa.thickness.value_m / 2 - close && !isJoinedTo(j, toEnd < toBegin, true))
                m.otherEnd = toBegin < toEnd ? -1 : 1;
            if (!best || std::abs(m.move) < std::abs(best->move))
                best = m;
        }
        return best;
    }

    /// A gap with room in it is a passage.
    [[nodiscard]] bool isFree(const Wall& w, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double gap) const
    {
        const double half = w.thickness.value_m / 2 - std::min(0.03, w.thickness.value_m / 4);
        return gap > 0.08 && m_mask.freeShare(from, to, -half, half) > 0.4;
    }

    void join(std::size_t i, bool atEnd, const Meeting& m)
    {
        Wall &a = m_walls[i], &b = m_walls[m.other];
        const bool otherAtEnd = m.otherEnd > 0;
        std::erase_if(
            m_junctions, [&](const Junction& j)
            { return (j.wallA == a.id && j.endA == nameOf(atEnd)) || (j.wallB == a.id && j.endB == nameOf(atEnd)); });
        moveEnd(a, atEnd, m.point);
        if (m.otherEnd != 0)
            moveEnd(b, otherAtEnd, m.point);
        const double sa = endOf(WallAxis(a), atEnd), sb = endOf(WallAxis(b), otherAtEnd);
        double& bodyA = atEnd ? a.bodyEnd_m : a.bodyStart_m;
        double& bodyB = otherAtEnd ? b.bodyEnd_m : b.bodyStart_m;
        if (m.isTangent)
        {
            bodyA = sa;
            bodyB = sb;
        }
        else
        {
            const bool through =
                m.otherEnd != 0 && std::tuple(WallAxis(a).length_m(), b.id) > std::tuple(WallAxis(b).length_m(), a.id);
            const auto runThrough = [](const Wall& w, bool end, double s, const Wall& other)
            {
                const WallAxis axis(w), otherAxis(other);
                const Eigen::Vector2d p = axis.at(s);
                const double sine = std::abs(cross(axis.direction(s), otherAxis.direction(otherAxis.project(p).x())));
                return s + (end ? 1 : -1) * other.thickness.value_m / 2 / sine;
            };
            if (through)
            {
                bodyA = runThrough(a, atEnd, sa, b);
                bodyB = cutAt(b, otherAtEnd, sb, a);
            }
            else
            {
                if (m.otherEnd != 0)
                    bodyB = runThrough(b, otherAtEnd, sb, a);
                bodyA = cutAt(a, atEnd, sa, b);
            }
        }
        m_junctions.push_back({a.id, b.id, nameOf(atEnd), m.otherEnd == 0 ? JunctionEnd::Path : nameOf(otherAtEnd)});
    }

    void split(std::size_t i, std::size_t j, std::uint32_t& nextId)
    {
        const WallAxis a(m_walls[i]), b(m_walls[j]);
        for (const Eigen::Vector2d& p : crossings(a, b))
        {
            const double s = a.project(p).x(), sOther = b.project(p).x();
            const double room = kSmallestPiece_m + m_walls[j].thickness.value_m;
            if (s < m_walls[i].bodyStart_m + room || s > m_walls[i].bodyEnd_m - room ||
                sOther < m_walls[j].bodyStart_m || sOther > m_walls[j].bodyEnd_m)
                continue;
            Wall rest = m_walls[i];
            rest.id = ElementId{nextId++};
            for (Junction& k : m_junctions)
                for (auto [id, end, other] :
                     {std::tuple(&k.wallA, k.endA, k.wallB), std::tuple(&k.wallB, k.endB, k.wallA)})
                    if (*id == m_walls[i].id &&
                        (end == JunctionEnd::End || (end == JunctionEnd::Path && isBeyond(other, a, s))))
                        *id = rest.id;
            moveEnd(m_walls[i], true, p);
            moveEnd(rest, false, p);
            m_walls[i].bodyEnd_m = cutAt(m_walls[i], true, WallAxis(m_walls[i]).length_m(), m_walls[j]);
            rest.bodyStart_m = cutAt(rest, false, 0.0, m_walls[j]);
            m_junctions.push_back({m_walls[i].id, m_walls[j].id, JunctionEnd::End, JunctionEnd::Path});
            m_junctions.push_back({rest.id, m_walls[j].id, JunctionEnd::Start, JunctionEnd::Path});
            m_walls.push_back(std::move(rest));
            return;  // the rest comes later in the list
        }
    }

    /// Does the wall of that id lie beyond s of a?
    [[nodiscard]] bool isBeyond(ElementId id, const WallAxis& a, double s) const
    {
        for (const Wall& w : m_walls)
            if (w.id == id)
            {
                const Eigen::Vector2d start = a.project(w.start), end = a.project(w.end);
                return (std::abs(start.y()) < std::abs(end.y()) ? start : end).x() > s;
            }
        return false;
    }

    std::vector<Wall>& m_walls;
    std::vector<Junction>& m_junctions;
    const PlanMask& m_mask;
    const WallParams& m_params;
};

}  // namespace

void dropWithinArcs(std::vector<WallBody>& bodies, const ArcScenes& arcs)
{
    std::erase_if(
        bodies,
        [&](const WallBody& body)
        {
            constexpr int n = 24, m = 5;
            constexpr double beside = 0.05;
            int inside = 0;
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < m; ++j)
                {
                    const Eigen::Vector2d p = body.t * (body.begin + (body.end - body.begin) * (i + 0.5) / n) +
                                              body.n() * (body.low + body.thickness() * (j + 0.5) / m);
                    inside += std::any_of(arcs.begin(), arcs.end(),
                                          [&](const auto& arc)
                                          {
                                              const Eigen::Vector2d q = arc->unrolling.fromPlan(p);
                                              return std::any_of(arc->bodies.begin(), arc->bodies.end(),
                                                                 [&](const WallBody& b)
                                                                 {
                                                                     return q.x() > b.begin && q.x() < b.end &&
                                                                            q.y() > b.low - beside &&
                                                                            q.y() < b.high + beside;
                                                                 });
                                          });
                }
            return 10 * inside > 6 * n * m;
        });
}

void bend(Wall& wall, const Unrolling& unrolling)
{
    // Straight in the unrolled plan, along x: the axis' own radius takes its lengths.
    const double radius = unrolling.radius_m - wall.start.y(), scale = radius / unrolling.radius_m;
    const double sweep = (wall.end.x() - wall.start.x()) / unrolling.radius_m;
    wall.start = unrolling.toPlan(wall.start);
    wall.end = unrolling.toPlan(wall.end);
    wall.bulge = std::tan(sweep / 4);
    wall.bodyStart_m *= scale;
    wall.bodyEnd_m *= scale;
}

void connectArcs(std::vector<Wall>& walls, std::vector<Junction>& junctions, const PlanMask& mask,
                 std::uint32_t& nextId, const WallParams& params)
{
    if (std::none_of(walls.begin(), walls.end(), isArc))
        return;
    Connector connector(walls, junctions, mask, params);
    connector.splitCrossings(nextId);
    connector.connect();
}

}  // namespace s2b

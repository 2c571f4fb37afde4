// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/arcs.h"

#include "core/walls/curved_runs.h"
#include "core/walls/faces.h"
#include "core/walls/heights.h"
#include "core/walls/thickness.h"
#include "core/walls/topology.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace s2b
{
namespace
{

constexpr double kPi = std::numbers::pi;
constexpr double kAround_m = 4.5;  // on both sides of the circle: as far as anyone asks for room beside a wall
constexpr double kMargin_m = 0.6;
constexpr double kBesideFace_m = 0.045;  // what still belongs to a face

/// Angles [begin, begin + sweep] that two runs cover together, the shorter way round.
struct AngleRange
{
    double begin = 0, sweep = 0;
    [[nodiscard]] double end() const { return begin + sweep; }
    void add(double from, double by)
    {
        double a = begin + std::remainder(from + by / 2 - begin - sweep / 2, 2 * kPi) + sweep / 2 - by / 2;
        const double low = std::min(begin, a), high = std::max(end(), a + by);
        begin = low;
        sweep = std::min(high - low, 2 * kPi);
    }
    /// Angle between it and another range, 0 when they overlap.
    [[nodiscard]] double gapTo(double from, double by) const
    {
        const double a = std::abs(std::remainder(from + by / 2 - begin - sweep / 2, 2 * kPi));
        return std::max(0.0, a - (sweep + by) / 2);
    }
};

/// Runs about one centre that may be the faces of one wall.
struct Ring
{
    std::vector<CurvedRun> runs;
    AngleRange range;
};

/// Runs that are faces, or pieces of a face, of one wall share their centre.
std::vector<Ring> groupRuns(std::vector<CurvedRun> runs, const WallParams& params)
{
    std::vector<Ring> rings;
    for (CurvedRun& run : runs)
    {
        Ring* home = nullptr;
        for (Ring& ring : rings)
        {
            const double apart = std::abs(ring.runs.front().radius_m - run.radius_m);
            // A short arc says little of where its centre is.
            if ((ring.runs.front().center - run.center).norm() > 0.15 * run.radius_m + 0.1 ||
                apart > params.maximumThickness_m + 0.15 * run.radius_m ||
                ring.range.gapTo(run.begin_rad, run.sweep_rad()) * run.radius_m > 4.0)
                continue;
            std::vector<CurvedRun> together = ring.runs;
            together.push_back(run);
            std::vector<CurvedRun*> pointers;
            double worst = 0.0015;
            for (CurvedRun& r : together)
                pointers.push_back(&r), worst = std::max(worst, 1.5 * r.rms_m);
            alignRuns(pointers, worst);
            const double width = std::abs(together.back().radius_m - together.front().radius_m);
            if (together.front().center != together.back().center || width > params.maximumThickness_m)
                continue;
            ring.runs = std::move(together);
            home = &ring;
            break;
        }
        if (home)
            home->range.add(run.begin_rad, run.sweep_rad());
        else
            rings.push_back({{run}, {run.begin_rad, run.sweep_rad()}});
    }
    return rings;
}

SurfaceCells unrolled(const SurfaceCells& cells, const Level& level, const Unrolling& u)
{
    SurfaceCells result = cells.empty();
    const double inner = std::max(0.15 * u.radius_m, u.radius_m - kAround_m), outer = u.radius_m + kAround_m;
    for (const SurfaceCell& c : cellsOf(cells, level))
    {
        const Eigen::Vector2d arm = c.position.head<2>().cast<double>() - u.center;
        const double r = arm.norm();
        if (r < inner || r > outer)
            continue;
        const Eigen::Vector2d q = u.fromPlan(u.center + arm);
        if (!u.contains(q))
            continue;
        const Eigen::Vector2d inwards = -arm / r, along(inwards.y(), -inwards.x());
        const Eigen::Vector2d n = c.normal.head<2>().cast<double>();
        SurfaceCell flat = c;
        flat.position.head<2>() = q.cast<float>();
        flat.normal.head<2>() = Eigen::Vector2d(along.dot(n), inwards.dot(n)).cast<float>();
        result.cells.push_back(flat);
    }
    return result;
}

/// Where a ring is best cut in two: both places well covered, so that no opening lies there.
double cutAngle(const Ring& ring)
{
    constexpr int steps = 72;
    std::array<double, steps> covered{};
    for (const CurvedRun& run : ring.runs)
        for (const Eigen::Vector2d& p : run.places)
        {
            const double a = std::atan2(p.y() - run.center.y(), p.x() - run.center.x());
            covered[static_cast<std::size_t>(std::floor((a + kPi) / (2 * kPi) * steps + 0.5)) % steps] += 1;
        }
    int best = 0;
    double most = -1;
    for (int i = 0; i < steps / 2; ++i)
    {
        double least = 1e9;
        for (int k = -2; k <= 2; ++k)
            for (const int half : {0, steps / 2})
                least = std::min(least, covered[static_cast<std::size_t>((i + half + k + steps) % steps)]);
        if (least > 1.1 * most)
            most = least, best = i;
    }
    return 2 * kPi * best / steps - kPi;
}

/// Faces and bodies along the circle; empty when nothing there is a wall's.
void findBodies(ArcScene& scene, const Level& level, const WallParams& params, const Context& context)
{
    scene.faces = findFaces(scene.cells, level, scene.mask, params, context);
    alignFaces(scene.faces);
    // Only what runs along the circle itself: all else is bent by the unrolling.
    std::erase_if(scene.faces, [](const Face& f) { return std::abs(f.t.y()) > 1e-9; });
    scene.bodies = pairFaces(scene.faces, scene.mask, params);
    const double length = scene.unrolling.length_m;
    std::erase_if(scene.bodies,
                  [&](const WallBody& b)
                  {
                      const double reach = params.maximumThickness_m / 2 + 0.05;
                      return b.end < 0.05 || b.begin > length - 0.05 ||
                             std::min(std::abs(b.low), std::abs(b.high)) > reach;
                  });
    for (WallBody& b : scene.bodies)
        b.begin = std::max(b.begin, 0.0), b.end = std::min(b.end, length);
    // A straight wall that goes on along the tangent keeps near the circle for a while.
    const double nearTangent = std::sqrt(2 * scene.unrolling.radius_m * 3 * params.planeDistance_m);
    double longest = 0;
    for (const WallBody& b : scene.bodies)
        longest = std::max(longest, b.end - b.begin);
    std::erase_if(scene.bodies,
                  [&](const WallBody& b)
                  {
                      return b.end - b.begin < std::min(nearTangent, 0.3 * longest) &&
                             (b.begin < 0.05 || b.end > length - 0.05);
                  });
}

/// The circle through the middle of the longest body, so that lengths along x are those on the wall's axis.
std::optional<Unrolling> aboutAxis(const ArcScene& scene)
{
    const WallBody* longest = nullptr;
    for (const WallBody& b : scene.bodies)
        if (!longest ||
            std::tuple(b.bothSeen(), b.end - b.begin) > std::tuple(longest->bothSeen(), longest->end - longest->begin))
            longest = &b;
    if (!longest)
        return std::nullopt;
    Unrolling u = scene.unrolling;
    const double scale = 1 - longest->middle() / u.radius_m;
    u.radius_m *= scale, u.length_m *= scale;
    return u;
}

}  // namespace

Eigen::Vector2d Unrolling::fromPlan(const Eigen::Vector2d& p) const
{
    const Eigen::Vector2d arm = p - center;
    const double middle = angle_rad + length_m / 2 / radius_m;
    const double turn = std::remainder(std::atan2(arm.y(), arm.x()) - middle, 2 * kPi);
    return {length_m / 2 + turn * radius_m, radius_m - arm.norm()};
}

Eigen::Vector2d Unrolling::toPlan(const Eigen::Vector2d& q) const
{
    const double angle = angle_rad + q.x() / radius_m;
    return center + (radius_m - q.y()) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

bool Unrolling::contains(const Eigen::Vector2d& q) const
{
    return q.x() > -margin_m && q.x() < length_m + margin_m;
}

ArcScene::ArcScene(const Unrolling& about, SurfaceCells unrolledCells, const Level& level)
    : unrolling(about),
      cells(std::move(unrolledCells)),
      mask(cells, level),
      index(cells, level.floor_m - 0.2, level.ceiling_m + 0.4)
{
}

ArcScenes findArcs(const SurfaceCells& cells, const Level& level, const WallParams& params, const Context& context)
{
    ArcScenes arcs;
    for (const Ring& ring : groupRuns(findCurvedRuns(cells, level, params, context), params))
    {
        context.checkCancelled();
        double inner = ring.runs.front().radius_m, outer = inner;
        for (const CurvedRun& r : ring.runs)
            inner = std::min(inner, r.radius_m), outer = std::max(outer, r.radius_m);
        std::vector<Unrolling> parts;
        Unrolling whole;
        whole.center = ring.runs.front().center;
        whole.radius_m = (inner + outer) / 2;
        const bool isClosed = ring.range.sweep > 300 * kPi / 180;
        const double sweep = isClosed ? kPi : ring.range.sweep;
        whole.angle_rad = isClosed ? cutAngle(ring) : ring.range.begin;
        whole.length_m = sweep * whole.radius_m;
        whole.margin_m = std::min(kMargin_m, 0.9 * (kPi - sweep / 2) * whole.radius_m);
        parts.push_back(whole);
        if (isClosed)
        {
            parts.push_back(whole);
            parts.back().angle_rad += kPi;
        }
        for (const Unrolling& part : parts)
        {
            auto scene = std::make_unique<ArcScene>(part, unrolled(cells, level, part), level);
            findBodies(*scene, level, params, context);
            const auto about = aboutAxis(*scene);
            if (!about)
                continue;
            scene = std::make_unique<ArcScene>(*about, unrolled(cells, level, *about), level);
            scene->isClosed = isClosed;
            findBodies(*scene, level, params, context);
            if (!scene->bodies.empty())
                arcs.push_back(std::move(scene));
        }
    }
    return arcs;
}

SurfaceCells withoutArcs(const SurfaceCells& cells, const Level& level, const ArcScenes& arcs)
{
    SurfaceCells rest = cells.empty();
    for (const SurfaceCell& c : cellsOf(cells, level))
    {
        const bool isArc = std::abs(c.normal.z()) < 0.5f &&
                           std::any_of(
                               arcs.begin(), arcs.end(),
                               [&](const auto& arc)
                               {
                                   const Eigen::Vector2d p = c.position.template head<2>().template cast<double>();
                                   if (std::abs((p - arc->unrolling.center).norm() - arc->unrolling.radius_m) > 1.0)
                                       return false;
                                   const Eigen::Vector2d q = arc->unrolling.fromPlan(p);
                                   return std::any_of(arc->bodies.begin(), arc->bodies.end(),
                                                      [&](const WallBody& b)
                                                      {
                                                          return q.x() > b.begin && q.x() < b.end &&
                                                                 q.y() > b.low - kBesideFace_m &&
                                                                 q.y() < b.high + kBesideFace_m;
                                                      });
                               });
        if (!isArc)
            rest.cells.push_back(c);
    }
    return rest;
}

void settleArcs(ArcScenes& arcs, const std::vector<WallBody>& straight, const Level& level, const WallParams& params)
{
    for (auto& arc : arcs)
    {
        // The straight walls far away: all that is asked of them is how thick walls are here.
        std::vector<WallBody> bodies = arc->bodies;
        const std::size_t own = bodies.size();
        for (const WallBody& b : straight)
            if (b.bothSeen())
            {
                WallBody far = b;
                far.t = Eigen::Vector2d::UnitX();
                far.low += 1e4, far.high += 1e4;
                bodies.push_back(std::move(far));
            }
        settleThickness(bodies, arc->cells, arc->index, level, arc->mask, params);
        bodies.resize(own);
        bodies = mergeBodies(std::move(bodies), arc->mask, params);
        arc->bodies = settleHeights(std::move(bodies), arc->faces, level, arc->mask, params);
        std::erase_if(
            arc->bodies, [&](const WallBody& b)
            { return b.end - b.begin < params.minimumLength_m || b.thickness() < params.minimumThickness_m; });
        std::sort(arc->bodies.begin(), arc->bodies.end(), [](const WallBody& a, const WallBody& b)
                  { return std::tuple(a.begin, a.low) < std::tuple(b.begin, b.low); });
    }
}

}  // namespace s2b

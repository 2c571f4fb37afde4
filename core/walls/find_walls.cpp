// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/arc_topology.h"
#include "core/walls/arcs.h"
#include "core/walls/evidence.h"
#include "core/walls/faces.h"
#include "core/walls/heights.h"
#include "core/walls/parallel_planes.h"
#include "core/walls/plan_mask.h"
#include "core/walls/sloped_top.h"
#include "core/walls/thickness.h"
#include "core/walls/topology.h"
#include "core/walls/walls.h"

#include <algorithm>
#include <cmath>
#include <format>
#include <limits>
#include <optional>

namespace s2b
{
namespace
{

const char* sourceText(ThicknessSource source)
{
    switch (source)
    {
        case ThicknessSource::Faces:
            return "as its faces say";
        case ThicknessSource::SameWall:
            return "as where both of its faces were seen";
        case ThicknessSource::Reveals:
            return "as deep as its openings";
        case ThicknessSource::OtherWalls:
            return "as the other walls of its kind";
        case ThicknessSource::Default:
            return "the default";
    }
    return "";
}

/// 1 when nothing of the building was seen on exactly one side, 0 when both sides show room, -1 when it can't be said.
int externalOf(const WallBody& body, const PlanMask& mask)
{
    const Eigen::Vector2d from = body.t * body.begin, to = body.t * body.end;
    const auto ceilingBeside = [&](double low, double high)
    { return mask.share(from, to, low, high, PlanMask::Ceiling) > 0.15; };
    const bool below = ceilingBeside(body.low - 0.8, body.low - 0.1),
               above = ceilingBeside(body.high + 0.1, body.high + 0.8);
    if (below && above)
        return 0;
    return body.bothSeen() && below != above ? 1 : -1;
}

/// The sloped top edge of what topology left of a body, along its axis; empty when that is level.
std::vector<Eigen::Vector2d> topProfileOf(const PlanWall& p)
{
    std::vector<Eigen::Vector2d> profile;
    if (p.body.topEdge.empty())
        return profile;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Eigen::Vector2d& v : topBetween(p.body.topEdge, p.body.begin, p.body.end))
    {
        profile.emplace_back(v.x() - p.axisBegin, v.y());
        low = std::min(low, v.y());
        high = std::max(high, v.y());
    }
    const bool isSloped = high - low > kLeastTopRise_m && low > p.body.bottom;
    return isSloped ? profile : std::vector<Eigen::Vector2d>{};
}

/// The wall that a body makes; nothing when it is too small for one.
std::optional<Wall> wallOf(const PlanWall& p, const std::vector<Face>& faces, double cell_m, const PlanMask& mask,
                           const Level& level, ElementId storey, const WallParams& params)
{
    const bool reachesCeiling = p.body.top >= level.ceiling_m;
    const std::vector<Eigen::Vector2d> profile = topProfileOf(p);
    double height = p.body.top - p.body.bottom;
    if (!profile.empty())  // of its highest point
        height = std::ranges::max(profile, {}, [](const auto& v) { return v.y(); }).y() - p.body.bottom;
    if (height < params.minimumHeight_m || p.axisEnd - p.axisBegin < 0.5 * params.minimumLength_m ||
        p.body.end - p.body.begin < 0.5 * params.minimumLength_m)
        return std::nullopt;
    Wall w;
    w.storey = storey;
    const double middle = p.body.middle();
    w.start = p.body.t * p.axisBegin + p.body.n() * middle;
    w.end = p.body.t * p.axisEnd + p.body.n() * middle;
    w.bodyStart_m = p.body.begin - p.axisBegin;
    w.bodyEnd_m = p.body.end - p.axisBegin;
    w.base_m = p.body.bottom;
    w.topProfile = profile;
    w.height = {
        height,
        level.ceilingSeen || !reachesCeiling || !w.topProfile.empty() ? Provenance::Measured : Provenance::Assumed,
        level.floorRms_m};
    w.evidence = evidenceOf(p.body, faces, cell_m);
    w.thickness = {p.body.thickness(), p.body.bothSeen() ? Provenance::Measured : Provenance::Assumed,
                   w.evidence.rms_m};
    const int external = externalOf(p.body, mask);
    w.isExternalKnown = external >= 0;
    w.isExternal = external == 1;
    return w;
}

/// Drops planes of stray points. Where the scan covers its walls thinly itself (the lines of a rotating scanner), less
/// is asked for.
void dropGhosts(std::vector<WallBody>& bodies, const std::vector<Face>& faces, double cell_m, const WallParams& params)
{
    std::vector<std::pair<double, double>> shares;  // and length
    double total = 0, sum = 0, best = 1;
    for (const WallBody& b : bodies)
    {
        shares.emplace_back(seenShare(b, faces, cell_m), b.end - b.begin);
        total += b.end - b.begin;
    }
    std::vector<std::pair<double, double>> sorted = shares;
    std::sort(sorted.begin(), sorted.end());
    for (const auto& [share, length] : sorted)
        if ((sum += length) >= 0.8 * total)
        {
            best = share;
            break;
        }
    const double limit = std::min(params.minimumCoverage, 0.3 * best);
    std::size_t i = 0;
    std::erase_if(bodies, [&](const WallBody&) { return shares[i++].first < limit; });
}

}  // namespace

WallResult findWalls(const SurfaceCells& cells, const CellIndex& index, const Level& level, ElementId storey,
                     std::uint32_t& nextId, const WallParams& params, const Context& context)
{
    WallResult result;
    const PlanMask mask(cells, level);
    ArcScenes arcs = findArcs(cells, level, params, context);
    std::optional<SurfaceCells> rest;
    if (!arcs.empty())
        rest = withoutArcs(cells, level, arcs);
    std::vector<Face> faces = findFaces(rest ? *rest : cells, level, mask, params, context);
    alignFaces(faces);
    std::vector<WallBody> bodies = pairFaces(faces, mask, params);
    settleThickness(bodies, cells, index, level, mask, params);
    bodies = mergeBodies(std::move(bodies), mask, params);
    settleArcs(arcs, bodies, level, params);
    dropWithinArcs(bodies, arcs);
    bodies = settleHeights(std::move(bodies), faces, level, mask, params);
    dropGhosts(bodies, faces, cells.size_m, params);
    context.checkCancelled();
    Plan plan = connectWalls(std::move(bodies), mask, params);
    dropFreePieces(plan, params.minimumFreeLength_m);

    const auto add = [&](Wall w, ThicknessSource source)
    {
        w.id = ElementId{nextId++};
        if (w.evidence.facesSeen < 2)
            result.diagnostics.push_back(
                {Severity::Warning, "walls", "ThicknessAssumed",
                 std::format("Only one face of the wall was seen; its thickness of {:.3f} m is assumed, {}.",
                             w.thickness.value_m, sourceText(source)),
                 w.id, Eigen::Vector3d((w.start.x() + w.end.x()) / 2, (w.start.y() + w.end.y()) / 2, level.floor_m)});
        result.walls.push_back(std::move(w));
        return result.walls.back().id;
    };
    std::vector<ElementId> idOf(plan.walls.size());
    for (std::size_t i = 0; i < plan.walls.size(); ++i)
        if (std::optional<Wall> w = wallOf(plan.walls[i], faces, cells.size_m, mask, level, storey, params))
            idOf[i] = add(std::move(*w), plan.walls[i].body.thicknessSource);
    for (const BodyJunction& j : plan.junctions)
    {
        if (idOf[j.wall].value == 0 || idOf[j.other].value == 0)
            continue;
        const auto endOf = [](int e)
        { return e < 0 ? JunctionEnd::Start : (e > 0 ? JunctionEnd::End : JunctionEnd::Path); };
        // A corner is found from both walls; it is one junction.
        const bool known = std::any_of(result.junctions.begin(), result.junctions.end(), [&](const Junction& k)
                                       { return k.wallA == idOf[j.other] && k.wallB == idOf[j.wall]; });
        if (!known)
            result.junctions.push_back(
                {idOf[j.wall], idOf[j.other], j.atEnd ? JunctionEnd::End : JunctionEnd::Start, endOf(j.otherEnd)});
    }
    for (const auto& arc : arcs)
        for (WallBody& body : arc->bodies)
        {
            body.topEdge.clear();  // the top of a bent wall under a sloped ceiling is no few straight pieces
            if (std::optional<Wall> w =
                    wallOf({body, body.begin, body.end}, arc->faces, cells.size_m, arc->mask, level, storey, params))
            {
                bend(*w, arc->unrolling);
                add(std::move(*w), body.thicknessSource);
            }
        }
    connectArcs(result.walls, result.junctions, mask, nextId, params);
    return result;
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/model/wall_axis.h"
#include "core/openings/hole_edges.h"
#include "core/openings/leaf.h"
#include "core/openings/openings.h"
#include "core/openings/wall_view.h"
#include "core/walls/plan_mask.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace s2b
{
namespace
{

bool isEmptyDoor(const Hole& h, const OpeningParams& params)
{
    return h.width() > params.minimumEmptyDoorWidth_m && h.width() < params.maximumEmptyDoorWidth_m &&
           h.top > params.minimumEmptyDoorHeight_m && h.top < params.maximumEmptyDoorHeight_m;
}

Opening openingOf(const Hole& h, OpeningKind kind, const Wall& wall)
{
    Opening o;
    o.host = wall.id;
    o.kind = kind;
    o.offset_m = h.begin;
    const double sill = kind == OpeningKind::Window ? std::max(0.0, h.bottom) : 0.0;
    o.width = {h.width(), h.sides, 0.0};
    o.sill = {sill, Provenance::Measured, 0.0};
    o.height = {std::min(h.top, wall.height.value_m) - sill, h.head, 0.0};
    o.evidence.points = h.points;
    o.evidence.labelShare = h.labelShare;
    return o;
}

/// From the floor up and as large as doors are: glazed or not, one can go through it.
bool isDoorShaped(const Hole& h, const OpeningParams& params)
{
    return h.bottom < 0.04 && h.top > params.minimumEmptyDoorHeight_m && h.top < params.maximumEmptyDoorHeight_m &&
           h.width() < 2.2 && h.width() > 0.7 * params.minimumDoorWidth_m;  // a leaf is narrower than its hole
}

/// A door that a model half saw, as wide and high as the faces show it: they end about it, and leave a doorway whole.
Hole wholeDoor(const WallView& view, const Hole& seen, const std::vector<Hole>& voids, const OpeningParams& params)
{
    Hole door = grownToFaces(view, seen);
    const auto doorway = std::ranges::find_if(
        voids, [&](const Hole& v) { return isEmptyDoor(v, params) && v.overlaps(seen) && v.holds(seen); });
    if (doorway != voids.end())
    {
        door.begin = std::min(door.begin, doorway->begin), door.end = std::max(door.end, doorway->end);
        door.top = std::max(door.top, doorway->top);
    }
    return door;
}

struct Candidate
{
    Opening opening;
    const Wall* wall;
    [[nodiscard]] Eigen::Vector2d centre() const
    {
        return WallAxis(*wall).at(opening.offset_m + opening.width.value_m / 2);
    }
    [[nodiscard]] double bottom() const { return wall->base_m + opening.sill.value_m; }
    [[nodiscard]] double top() const { return bottom() + opening.height.value_m; }
};

/// What can be openings of one wall.
std::vector<Candidate> candidatesOf(const Wall& wall, const SurfaceCells& cells, const CellIndex& index,
                                    const PlanMask& mask, const std::set<OpeningKind>& kinds,
                                    const OpeningParams& params, const Sightlines& sightlines)
{
    std::vector<Candidate> candidates;
    WallView view = viewWall(wall, cells, index, params.leafReach_m);
    view.through = SeenThrough(wall, sightlines);
    std::vector<Hole> taken;
    // The leaf closes what is clear between the frame's jambs.
    const auto add = [&](const Hole& h, OpeningKind kind, const std::optional<Hole>& clear = {})
    {
        taken.push_back(h);
        if (!kinds.contains(kind))
            return;
        Candidate c{openingOf(h, kind, wall), &wall};
        if (kind == OpeningKind::Door)
        {
            findLeaf(c.opening, view, clear.value_or(h));
            if (h.labelShare == 0 && h.points == 0 && c.opening.leafState == LeafState::Unknown)
                c.opening.leafState = LeafState::Removed;
        }
        candidates.push_back(c);
    };
    const WallAxis axis(wall);
    const auto floorSeen = [&](double from, double to)
    {
        const double inset = std::min(0.02, view.half_m / 3);
        // Along an arc by chords.
        const int pieces = axis.isArc() ? std::max(1, static_cast<int>((to - from) / 0.1)) : 1;
        double sum = 0;
        for (int i = 0; i < pieces; ++i)
            sum += mask.share(axis.at(from + (to - from) * i / pieces), axis.at(from + (to - from) * (i + 1) / pieces),
                              -view.half_m + inset, view.half_m - inset, PlanMask::Floor);
        return sum / pieces;
    };
    if (cells.hasLabels)
    {
        const double doorRadius = std::max(params.clusterRadius_m, 2.5 * cells.size_m),
                     windowRadius = std::max(0.05, 2.0 * cells.size_m);
        const std::vector<Hole> voids =
            cells.hasGuesses ? voidsFromFloor(view, {}, floorSeen, params) : std::vector<Hole>{};
        for (const Hole& h : labelledHoles(view, OpeningKind::Door, doorRadius, params.maximumDoorWidth_m))
            if (h.width() >= params.minimumDoorWidth_m && h.top >= params.minimumDoorHeight_m)
            {
                Hole door = cells.hasGuesses ? wholeDoor(view, h, voids, params) : h;
                door.bottom = 0.0;
                add(door, OpeningKind::Door);
            }
        for (const Hole& seen : labelledHoles(view, OpeningKind::Window, windowRadius, params.maximumDoorWidth_m))
            if (const Hole h = cells.hasGuesses ? grownToFaces(view, seen) : seen;
                h.width() >= params.minimumWindowWidth_m && h.height() >= params.minimumWindowHeight_m &&
                static_cast<double>(h.points) > 20)
                add(h, cells.hasGuesses && isDoorShaped(h, params) ? OpeningKind::Door : OpeningKind::Window);
    }
    for (const Hole& h : voidsFromFloor(view, taken, floorSeen, params))
    {
        if (std::any_of(taken.begin(), taken.end(), [&](const Hole& k) { return k.overlaps(h); }))
            continue;
        Opening leaf;
        findLeaf(leaf, view, h);
        const bool isDoor = leaf.leafState == LeafState::Open || isEmptyDoor(h, params);
        Hole whole = !cells.labelsAreSure() && isDoor ? grownToFaces(view, h) : h;
        whole.bottom = h.bottom;
        add(whole, isDoor ? OpeningKind::Door : OpeningKind::Plain, h);
    }
    if (!cells.hasLabels || cells.hasGuesses)
        for (const Hole& h : recessedHoles(view, taken, params.minimumWindowWidth_m, params.maximumWindowWidth_m,
                                           params.minimumWindowHeight_m))
            if (std::none_of(taken.begin(), taken.end(), [&](const Hole& k) { return k.overlaps(h); }))
                isDoorShaped(h, params) ? add(grownToFaces(view, h), OpeningKind::Door, h)
                                        : add(h, OpeningKind::Window);
    return candidates;
}

}  // namespace

OpeningResult findOpenings(const SurfaceCells& cells, const CellIndex& index, const Level& level,
                           const std::vector<Wall>& walls, const std::set<OpeningKind>& kinds, std::uint32_t& nextId,
                           const OpeningParams& params, const Context& context, const Sightlines& sightlines)
{
    OpeningResult result;
    const PlanMask mask(cells, level);
    std::vector<std::vector<Candidate>> ofWall(walls.size());
    parallelChunks(walls.size(), 1, context, [&](std::size_t i, std::size_t)
                   { ofWall[i] = candidatesOf(walls[i], cells, index, mask, kinds, params, sightlines); });
    context.checkCancelled();
    std::vector<Candidate> candidates;
    for (const std::vector<Candidate>& found : ofWall)
        candidates.insert(candidates.end(), found.begin(), found.end());
    // One hole belongs to one wall: where two claim the same place, the one with more points has it.
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b)
                     { return a.opening.evidence.points > b.opening.evidence.points; });
    std::vector<Candidate> kept;
    for (const Candidate& c : candidates)
        if (std::none_of(kept.begin(), kept.end(),
                         [&](const Candidate& k)
                         {
                             return k.wall != c.wall && k.bottom() < c.top() && c.bottom() < k.top() &&
                                    (k.centre() - c.centre()).norm() <
                                        0.5 * std::max(k.opening.width.value_m, c.opening.width.value_m);
                         }))
            kept.push_back(c);
    std::sort(kept.begin(), kept.end(),
              [](const Candidate& a, const Candidate& b)
              {
                  return std::tie(a.opening.host, a.opening.offset_m, a.opening.sill.value_m) <
                         std::tie(b.opening.host, b.opening.offset_m, b.opening.sill.value_m);
              });
    for (Candidate& c : kept)
    {
        c.opening.id = ElementId{nextId++};
        if (c.opening.leafState == LeafState::Removed)
            result.diagnostics.push_back(
                {Severity::Info, "doors", "NoLeafSeen",
                 "The opening has a door's size but no leaf or frame was seen; it is modelled as a door.", c.opening.id,
                 Eigen::Vector3d(c.centre().x(), c.centre().y(), level.floor_m)});
        result.openings.push_back(c.opening);
    }
    return result;
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/openings/leaf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace s2b
{
namespace
{

/// From labelled points: in the hole, or beside the wall within a leaf's reach of one jamb.
void findLabelledLeaf(Opening& o, const WallView& view, const Hole& hole)
{
    std::array<std::array<double, 2>, 2> cells{};  // [jamb][side]
    double inHole = 0;
    for (const WallPoint& p : view.points)
    {
        if (p.label != Label::Door || p.z < 0.2 || p.z > hole.top)
            continue;
        if (p.s > hole.begin + 0.08 && p.s < hole.end - 0.08 && std::abs(p.d) < view.half_m)
            inHole += 1;
        if (std::abs(p.d) < view.half_m + 0.08)
            continue;
        const double reach = hole.width() + 0.1;
        for (std::size_t jamb = 0; jamb < 2; ++jamb)
            if (std::hypot(p.s - (jamb == 0 ? hole.begin : hole.end), std::abs(p.d) - view.half_m) < reach)
                cells[jamb][p.d > 0 ? 0 : 1] += 1 / (0.3 + std::abs(p.s - (jamb == 0 ? hole.begin : hole.end)));
    }
    const double area = view.cell_m * view.cell_m;
    if (inHole * area > 0.25 * hole.width() * hole.height())
    {
        o.leafState = LeafState::Closed;
        return;
    }
    double best = 0;
    for (std::size_t jamb = 0; jamb < 2; ++jamb)
        for (std::size_t side = 0; side < 2; ++side)
            if (cells[jamb][side] > best)
            {
                best = cells[jamb][side];
                o.hingeAtStart = jamb == 0;
                o.opensToLeft = side == 0;
            }
    if (best * area > 0.2 * hole.width() * hole.height())
    {
        o.leafState = LeafState::Open;
        o.leaves = 1;
    }
    else
        o.hingeAtStart = o.opensToLeft = false;
}

/// Does an upright plate of about this width and the hole's height stand out from the hinge on one side of the wall?
/// @return the share of such a plate that was seen, 0 when it is something else (a wall goes on above and beyond).
double plateAt(const WallView& view, const Hole& hole, double hinge, bool left, double width)
{
    constexpr double binAngle = 3.0 * std::numbers::pi / 180, nearest = 0.12, step = 0.05;
    constexpr std::size_t bins = 60;
    struct Bin
    {
        double plate = 0, above = 0, beyond = 0;
        std::array<char, 48> rings{};
    };
    std::vector<Bin> angles(bins);
    for (const WallPoint& p : view.points)
    {
        const double out = (left ? p.d : -p.d) - view.half_m, along = p.s - hinge, r = std::hypot(out, along);
        if (out < 0.05 || p.upward > 0.4 || r < nearest || r > width + 0.6 || p.z < 0.2)
            continue;
        // Its surface runs along the radius.
        const double cosine = std::abs(along) / r, sine = out / r;
        if (std::abs(p.along * cosine - p.across * sine) > 0.4 && p.along * cosine + p.across * sine > 0.4)
            continue;
        Bin& bin = angles[std::min(bins - 1, static_cast<std::size_t>(std::atan2(out, along) / binAngle))];
        if (p.z > hole.top + 0.15)
            bin.above += 1;
        else if (r > width + 0.12)
            bin.beyond += 1;
        else if (p.z < hole.top)
        {
            bin.plate += 1;
            bin.rings[std::min(bin.rings.size() - 1, static_cast<std::size_t>((r - nearest) / step))] = 1;
        }
    }
    const double cellArea = view.cell_m * view.cell_m, plateArea = (width - nearest) * (hole.top - 0.2);
    const auto wanted = static_cast<std::size_t>(std::max(1.0, (width - nearest) / step));
    double best = 0;
    for (std::size_t i = 3; i + 4 < bins; ++i)  // flat on the wall it would be the wall
    {
        double plate = 0, above = 0, beyond = 0;
        std::size_t rings = 0;
        for (std::size_t k = i; k < i + 2; ++k)
            plate += angles[k].plate, above += angles[k].above, beyond += angles[k].beyond;
        for (std::size_t ring = 0; ring < wanted && ring < angles[i].rings.size(); ++ring)
            rings += angles[i].rings[ring] || angles[i + 1].rings[ring];
        const double share = plate * cellArea / plateArea;
        if (10 * rings > 7 * wanted && above < 0.15 * plate && beyond < 0.15 * plate)
            best = std::max(best, share);
    }
    return best;
}

void findPlateLeaf(Opening& o, const WallView& view, const Hole& hole)
{
    constexpr double leastShare = 0.35;
    struct Leaf
    {
        double share = 0;
        bool left = false;
    };
    const auto bestSide = [&](double hinge, double width)
    {
        const double l = plateAt(view, hole, hinge, true, width), r = plateAt(view, hole, hinge, false, width);
        return Leaf{std::max(l, r), l >= r};
    };
    if (hole.width() < 1.35)
    {
        const Leaf start = bestSide(hole.begin, hole.width()), end = bestSide(hole.end, hole.width());
        const Leaf& best = start.share >= end.share ? start : end;
        if (best.share < leastShare)
            return;
        o.leafState = LeafState::Open, o.leaves = 1;
        o.hingeAtStart = start.share >= end.share, o.opensToLeft = best.left;
        return;
    }
    const Leaf start = bestSide(hole.begin, hole.width() / 2), end = bestSide(hole.end, hole.width() / 2);
    if (std::max(start.share, end.share) < leastShare)
        return;
    o.leafState = LeafState::Open, o.leaves = 2;
    o.opensToLeft = start.share >= end.share ? start.left : end.left;
}

}  // namespace

void findLeaf(Opening& opening, const WallView& view, const Hole& hole)
{
    if (view.hasLabels)
        findLabelledLeaf(opening, view, hole);
    else
        findPlateLeaf(opening, view, hole);
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/heights.h"

#include "core/walls/sloped_top.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace s2b
{
namespace
{

constexpr double kStep_m = 0.10;  // along the wall
constexpr double kSmallestPiece_m = 0.8;

struct Place
{
    double top = 0, bottom = 0;
    bool seen = false;
};

/// Highest and lowest surface of the body's faces, place by place.
std::vector<Place> placesOf(const WallBody& body, const std::vector<Face>& faces, const Level& level)
{
    std::vector<Place> places(static_cast<std::size_t>(std::max(1.0, std::ceil((body.end - body.begin) / kStep_m))));
    for (const auto* list : {&body.lowFaces, &body.highFaces})
        for (const std::uint32_t f : *list)
            for (std::size_t b = 0; b < faces[f].rows.size(); ++b)
            {
                const std::uint64_t rows = faces[f].rows[b];
                const double s = faces[f].begin + (static_cast<double>(b) + 0.5) * Face::kBin_m;
                const auto i = static_cast<std::ptrdiff_t>(std::floor((s - body.begin) / kStep_m));
                if (!rows || i < 0 || i >= static_cast<std::ptrdiff_t>(places.size()))
                    continue;
                Place& p = places[static_cast<std::size_t>(i)];
                const double top = level.floor_m + Face::kRow_m * (64 - std::countl_zero(rows)),
                             bottom = level.floor_m + Face::kRow_m * std::countr_zero(rows);
                p.top = p.seen ? std::max(p.top, top) : top;
                p.bottom = p.seen ? std::min(p.bottom, bottom) : bottom;
                p.seen = true;
            }
    return places;
}

double quantile(std::vector<double> values, double q)
{
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Top edge of a body that follows a sloped ceiling; empty when it is level, or can't be told from a hidden top.
std::vector<Eigen::Vector2d> slopedTopOf(const WallBody& body, const std::vector<Place>& places, const Level& level)
{
    // With one face seen, a lower top under a level ceiling may as well be hidden (stairs).
    if (!body.bothSeen() && level.ceilingSeen)
        return {};
    const double limit = level.ceilingSeen ? level.highestCeiling_m() : std::numeric_limits<double>::infinity();
    std::vector<Eigen::Vector2d> tops;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i].seen)
            // The edge is somewhere within the highest row.
            tops.emplace_back(body.begin + (static_cast<double>(i) + 0.5) * kStep_m,
                              std::min(limit, places[i].top - Face::kRow_m / 2));
    std::vector<Eigen::Vector2d> edge = fitSlopedTop(tops, body.begin, body.end, places.size());
    // A place's highest point is at its upper side, not in its middle.
    std::vector<double> slopes;
    for (std::size_t i = 0; i + 1 < edge.size(); ++i)
        slopes.push_back(std::abs((edge[i + 1].y() - edge[i].y()) / (edge[i + 1].x() - edge[i].x())));
    for (std::size_t i = 0; i < edge.size(); ++i)
        edge[i].y() -= (slopes[std::max<std::size_t>(i, 1) - 1] + slopes[std::min(i, slopes.size() - 1)]) / 4 * kStep_m;
    return edge;
}

/// Stretches where only the upper part was seen and the floor runs through below: a beam, no wall. [first, last)
/// places.
std::vector<std::pair<std::size_t, std::size_t>> beamsOf(const WallBody& body, const std::vector<Place>& places,
                                                         const Level& level, const PlanMask& mask,
                                                         const WallParams& params)
{
    std::vector<std::pair<std::size_t, std::size_t>> beams;
    const double inset = std::min(0.03, body.thickness() / 4);
    for (std::size_t i = 0; i < places.size();)
    {
        std::size_t last = i;
        while (last < places.size() &&
               (!places[last].seen || (places[last].bottom > level.floor_m + 1.7 &&
                                       places[last].top - places[last].bottom < params.deepestBeam_m)))
            ++last;
        const double length = static_cast<double>(last - i) * kStep_m;
        if (length >= params.widestOpening_m)
        {
            const Eigen::Vector2d a = body.t * (body.begin + static_cast<double>(i) * kStep_m), b = a + body.t * length;
            if (mask.share(a, b, body.low + inset, body.high - inset, PlanMask::Floor) > 0.5)
                beams.emplace_back(i, last);
        }
        i = std::max(last, i + 1);
    }
    return beams;
}

/// Where the top changes for good: places to split at, ascending.
std::vector<std::size_t> splitsOf(const std::vector<Place>& places, double minimumStep_m)
{
    std::vector<std::size_t> splits;
    const auto window = static_cast<std::size_t>(kSmallestPiece_m / kStep_m);
    // Median top of a stretch that has one top; -1 for a sloped or hardly seen one.
    const auto topOf = [&](std::size_t first, std::size_t last)
    {
        std::vector<double> tops;
        for (std::size_t i = first; i < last; ++i)
            if (places[i].seen)
                tops.push_back(places[i].top);
        if (tops.size() * 4 < (last - first) * 3 || quantile(tops, 0.85) - quantile(tops, 0.15) > 1.5 * Face::kRow_m)
            return -1.0;
        return quantile(tops, 0.5);
    };
    std::size_t i = window;
    while (i + window <= places.size())
    {
        const double before = topOf(i - window, i), after = topOf(i, i + window);
        if (before < 0 || after < 0 || std::abs(before - after) < minimumStep_m)
        {
            ++i;
            continue;
        }
        // The exact place: where single places change sides.
        const double middle = (before + after) / 2;
        std::size_t at = i;
        std::size_t fewest = places.size();
        for (std::size_t k = i - window / 2; k <= std::min(places.size() - 1, i + window); ++k)
        {
            std::size_t wrong = 0;
            for (std::size_t m = i - window; m < std::min(places.size(), i + 2 * window); ++m)
                wrong += places[m].seen && ((places[m].top > middle) != (m < k ? before > middle : after > middle));
            if (wrong < fewest)
                fewest = wrong, at = k;
        }
        // A step is abrupt; anything else is a slope.
        const double justBefore = topOf(at - 2, at), justAfter = topOf(at, std::min(places.size(), at + 2));
        if (justBefore >= 0 && justAfter >= 0 && std::abs(justBefore - justAfter) > 0.6 * std::abs(before - after))
            splits.push_back(at);
        i = at + window;
    }
    return splits;
}

}  // namespace

std::vector<WallBody> settleHeights(std::vector<WallBody> bodies, const std::vector<Face>& faces, const Level& level,
                                    const PlanMask& mask, const WallParams& params)
{
    std::vector<WallBody> result;
    for (const WallBody& whole : bodies)
    {
        const std::vector<Place> places = placesOf(whole, faces, level);
        // With one face seen a lower top may as well be hidden (stairs, furniture).
        std::vector<std::size_t> ends =
            whole.bothSeen() ? splitsOf(places, params.minimumTopStep_m) : std::vector<std::size_t>{};
        const auto beams = beamsOf(whole, places, level, mask, params);
        for (const auto& [from, to] : beams)
            ends.insert(ends.end(), {from, to});
        ends.push_back(places.size());
        std::sort(ends.begin(), ends.end());
        const std::vector<Eigen::Vector2d> edge =
            ends.size() == 1 ? slopedTopOf(whole, places, level) : std::vector<Eigen::Vector2d>{};
        std::size_t first = 0;
        for (const std::size_t last : ends)
        {
            const bool isBeam = std::any_of(beams.begin(), beams.end(),
                                            [&](const auto& b) { return first >= b.first && last <= b.second; });
            if (last == first || isBeam)
            {
                first = last;
                continue;
            }
            WallBody piece = whole;
            piece.begin = first == 0 ? whole.begin : whole.begin + static_cast<double>(first) * kStep_m;
            piece.end = last == places.size() ? whole.end : whole.begin + static_cast<double>(last) * kStep_m;
            std::vector<double> tops, bottoms;
            for (std::size_t i = first; i < last; ++i)
                if (places[i].seen)
                    tops.push_back(places[i].top), bottoms.push_back(places[i].bottom);
            first = last;
            piece.bottom = level.floor_m;
            piece.top = level.ceiling_m;
            if (!tops.empty())
            {
                const double top = quantile(tops, 0.75), bottom = quantile(bottoms, 0.1);
                if (top < level.ceiling_m - 0.35)
                    piece.top = top;
                // Beside rooms with a higher ceiling the wall goes up to that.
                for (const double c : level.ceilings)
                    if (c > piece.top && top > c - 1.5 * Face::kRow_m)
                        piece.top = c;
                const Eigen::Vector2d a = piece.t * piece.begin, b = piece.t * piece.end;
                const double inset = std::min(0.03, piece.thickness() / 4);
                if (bottom > level.floor_m + 1.0 &&
                    mask.share(a, b, piece.low + inset, piece.high - inset, PlanMask::Floor) > 0.5)
                    piece.bottom = bottom;
            }
            if (!edge.empty())
                piece.topEdge = edge;
            result.push_back(std::move(piece));
        }
    }
    return result;
}

}  // namespace s2b

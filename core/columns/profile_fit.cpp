// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/columns/profile_fit.h"

#include "core/columns/profile_search.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>

namespace s2b
{
namespace
{

// One noisy face that is taken for two gives a plate of 2.7 times its RMS; two stations that are badly registered, one
// of some millimetres.
constexpr double kResolved = 3.0;
constexpr double kRegistered_m = 0.008;
constexpr double kBin_m = 0.01;      // along an edge
constexpr double kSeen = 1.0 / 3.0;  // share of an edge's bins
constexpr double kInliers = 0.85;    // share of the points that lie on the outline
constexpr double kPlain_m = 0.005;   // RMS about a rectangle: nothing finer to look for
constexpr double kRectangle = 0.25;  // of a rectangle's cost: more, and it may be one
constexpr double kRunnerUp = 1.3;    // of the best one's cost: less, and it may be that one
constexpr double kSnap_rad = 0.5 * std::numbers::pi / 180.0;
constexpr std::size_t kSearched = 1500, kFitted = 20000;  // points

/// Evenly chosen, at most `count`.
ProfilePoints sample(const ProfilePoints& points, std::size_t count)
{
    if (points.size() <= count)
        return points;
    ProfilePoints result;
    for (std::size_t i = 0; i < count; ++i)
        result.push_back(points[i * points.size() / count]);
    return result;
}

/// Without what stands alone in plan: a column's surface is stacked.
ProfilePoints withoutStrays(const ProfilePoints& points)
{
    constexpr double kCell_m = 0.01;
    constexpr double kShare = 0.05;  // of the median
    const auto key = [](const Eigen::Vector2d& p, int dx, int dy)
    {
        const auto x = static_cast<std::int64_t>(std::floor(p.x() / kCell_m)) + dx,
                   y = static_cast<std::int64_t>(std::floor(p.y() / kCell_m)) + dy;
        return x * 1000003 + y;
    };
    std::unordered_map<std::int64_t, int> counts;
    for (const Eigen::Vector2d& p : points)
        ++counts[key(p, 0, 0)];
    std::vector<int> around;
    for (const Eigen::Vector2d& p : points)
    {
        int sum = 0;
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy)
                if (const auto it = counts.find(key(p, dx, dy)); it != counts.end())
                    sum += it->second;
        around.push_back(sum);
    }
    std::vector<int> sorted = around;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
    const double least = kShare * sorted[sorted.size() / 2];
    ProfilePoints result;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (around[i] >= least)
            result.push_back(points[i]);
    return result;
}

/// How sharply the points gather in lines along and across a direction.
double sharpness(const ProfilePoints& points, double yaw_rad)
{
    constexpr double kLine_m = 0.004;
    const ProfilePoints local = turnedBack(points, yaw_rad);
    double sum = 0;
    for (const int axis : {0, 1})
    {
        std::unordered_map<int, double> counts;
        for (const Eigen::Vector2d& p : local)
            ++counts[static_cast<int>(std::floor(p[axis] / kLine_m))];
        for (const auto& [line, count] : counts)
            sum += count * count;
    }
    return sum;
}

/// The direction of most of the edges, to a degree; the given one where it is nearly as good.
double directionOf(const ProfilePoints& points, const Eigen::Vector2d& axis)
{
    constexpr double kAsGood = 0.95;
    const double preferred = std::atan2(axis.y(), axis.x());
    double best = preferred, sharpest = sharpness(points, preferred) / kAsGood;
    for (int degrees = 1; degrees < 90; ++degrees)
    {
        const double yaw = preferred + degrees * std::numbers::pi / 180.0;
        if (const double s = sharpness(points, yaw); s > sharpest)
            sharpest = s, best = yaw;
    }
    return best;
}

/// How many edges of each role have to be seen for a section to be one of this shape, and its plates to have a
/// thickness.
struct Needed
{
    int web, flange, tip, outer;
};
Needed neededOf(ProfileShape shape)
{
    switch (shape)
    {
        case ProfileShape::I:
            return {2, 3, 0, 1};  // two flanges of one thickness: one outer face will do
        case ProfileShape::L:
            return {1, 1, 2, 2};
        case ProfileShape::U:
            return {1, 2, 2, 3};
        case ProfileShape::T:
            break;
    }
    return {2, 2, 3, 1};
}

struct Check
{
    bool isSeen = false;
    double inlierShare = 0;
    double rms_m = 0;
};

Check checkOf(const ProfilePoints& points, const ProfileHypothesis& h)
{
    const ProfilePoints local = turnedBack(points, h.yaw_rad);
    const std::vector<PlacedEdge> edges = placedEdges(h);
    std::vector<std::vector<int>> bins;
    std::size_t binCount = 0;
    for (const PlacedEdge& e : edges)
    {
        bins.emplace_back(static_cast<std::size_t>(std::max(1.0, std::round((e.end - e.begin) / kBin_m))), 0);
        binCount += bins.back().size();
    }
    Check check;
    double square = 0, inliers = 0;
    for (const Eigen::Vector2d& p : local)
    {
        const NearestEdge n = nearestEdge(p, edges);
        if (n.square > kOutline_m * kOutline_m)
            continue;
        inliers += 1, square += n.square;
        const PlacedEdge& e = edges[n.edge];
        const double share = ((e.isVertical ? p.y() : p.x()) - e.begin) / (e.end - e.begin);
        std::vector<int>& b = bins[n.edge];
        ++b[static_cast<std::size_t>(std::clamp(share, 0.0, 0.9999) * static_cast<double>(b.size()))];
    }
    if (inliers == 0)
        return check;
    check.inlierShare = inliers / static_cast<double>(points.size());
    check.rms_m = std::sqrt(square / inliers);
    if (!h.shape)
        return check;
    const double least = std::max(2.0, 0.1 * inliers / static_cast<double>(binCount));
    std::array<int, 4> seen{};
    const std::vector<ProfileEdge>& kind = edgesOf(h.shape);
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
        const auto full = std::count_if(bins[i].begin(), bins[i].end(), [&](int n) { return n >= least; });
        if (static_cast<double>(full) >= kSeen * static_cast<double>(bins[i].size()))
            ++seen[static_cast<std::size_t>(kind[i].role)];
    }
    const Needed needed = neededOf(*h.shape);
    check.isSeen = seen[static_cast<std::size_t>(EdgeRole::Web)] >= needed.web &&
                   seen[static_cast<std::size_t>(EdgeRole::Flange)] >= needed.flange &&
                   seen[static_cast<std::size_t>(EdgeRole::Tip)] >= needed.tip &&
                   seen[static_cast<std::size_t>(EdgeRole::Outer)] >= needed.outer;
    return check;
}

/// The shape that explains the points, when only one does.
std::optional<ProfileHypothesis> choose(const ProfilePoints& points, double yaw_rad)
{
    const double rectangle = searchProfile(points, std::nullopt, yaw_rad).cost;
    if (rectangle < kPlain_m * kPlain_m)
        return std::nullopt;
    std::vector<ProfileHypothesis> seen;
    for (const ProfileShape shape : {ProfileShape::I, ProfileShape::L, ProfileShape::U, ProfileShape::T})
        for (int quarter = 0; quarter < (shape == ProfileShape::I ? 2 : 4); ++quarter)
        {
            const ProfileHypothesis h = searchProfile(points, shape, yaw_rad + quarter * std::numbers::pi / 2);
            if (std::isfinite(h.cost) && checkOf(points, h).isSeen)
                seen.push_back(h);
        }
    if (seen.empty())
        return std::nullopt;
    std::stable_sort(seen.begin(), seen.end(),
                     [](const ProfileHypothesis& a, const ProfileHypothesis& b) { return a.cost < b.cost; });
    if (seen[0].cost > kRectangle * rectangle || (seen.size() > 1 && seen[1].cost < kRunnerUp * seen[0].cost))
        return std::nullopt;
    return seen[0];
}

}  // namespace

std::optional<ProfileFit> fitProfile(std::span<const Eigen::Vector2d> points, const Eigen::Vector2d& axis,
                                     const ProfileFitOptions& options)
{
    constexpr std::size_t kFewest = 100;
    if (points.size() < kFewest)
        return std::nullopt;
    // About their mean, so that turning and moving don't mix.
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& p : points)
        origin += p / static_cast<double>(points.size());
    ProfilePoints local;
    for (const Eigen::Vector2d& p : points)
        local.emplace_back(p - origin);
    local = withoutStrays(sample(local, kFitted));
    const ProfilePoints few = sample(local, kSearched);

    const double preferred = std::atan2(axis.y(), axis.x());
    std::optional<ProfileHypothesis> best = choose(few, directionOf(few, axis));
    if (!best)
        return std::nullopt;
    static constexpr std::array<double, 4> kLast{kOutline_m, kOutline_m, kOutline_m, kOutline_m};
    refineProfile(local, *best, kLast, true);
    const double off = std::remainder(best->yaw_rad - preferred, std::numbers::pi / 2);
    if (std::abs(off) < kSnap_rad)
    {
        best->yaw_rad -= off;
        refineProfile(local, *best, kLast, false);
    }
    const Check check = checkOf(local, *best);
    const ProfileLengths& l = best->lengths;
    ProfileFit fit;
    fit.section = {*best->shape, l[1] - l[0], l[3] - l[2], l[4], l[5]};
    const double largest = std::max(fit.section.width_m, fit.section.depth_m),
                 smallest = std::min(fit.section.width_m, fit.section.depth_m);
    if (!std::isfinite(best->cost) || !check.isSeen || check.inlierShare < kInliers ||
        check.rms_m > options.tolerance_m || std::min(l[4], l[5]) < std::max(kRegistered_m, kResolved * check.rms_m) ||
        largest > options.maximumSize_m || smallest < options.minimumSize_m)
        return std::nullopt;
    fit.center = origin + Eigen::Rotation2Dd(best->yaw_rad) * Eigen::Vector2d((l[0] + l[1]) / 2, (l[2] + l[3]) / 2);
    // An I looks the same from both ends.
    fit.yaw_rad =
        std::remainder(best->yaw_rad, *best->shape == ProfileShape::I ? std::numbers::pi : 2 * std::numbers::pi);
    fit.rms_m = check.rms_m;
    fit.inlierShare = check.inlierShare;
    return fit;
}

}  // namespace s2b

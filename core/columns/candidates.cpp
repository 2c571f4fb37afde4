// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/columns/candidates.h"

#include "core/geometry/dbscan.h"
#include "core/geometry/rectangle.h"
#include "core/model/wall_axis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace s2b
{
namespace
{

constexpr double kRow_m = 0.10;

bool isInWall(const Eigen::Vector2d& p, const std::vector<Wall>& walls)
{
    constexpr double margin = 0.06;
    return std::any_of(walls.begin(), walls.end(),
                       [&](const Wall& w)
                       {
                           if (w.bulge != 0.0)
                           {
                               const Eigen::Vector2d q = WallAxis(w).project(p);
                               return q.x() > w.bodyStart_m - margin && q.x() < w.bodyEnd_m + margin &&
                                      std::abs(q.y()) < w.thickness.value_m / 2 + margin;
                           }
                           const Eigen::Vector2d d = p - w.start;
                           const double s = w.direction().dot(d);
                           return s > w.bodyStart_m - margin && s < w.bodyEnd_m + margin &&
                                  std::abs(w.normal().dot(d)) < w.thickness.value_m / 2 + margin;
                       });
}

std::vector<ColumnSpot> spotsOf(const SurfaceCells& cells, const Level& level, const std::vector<Wall>& walls,
                                const ColumnParams& params)
{
    const double margin = std::min(params.sliceMargin_m, 0.25 * (level.ceiling_m - level.floor_m));
    std::map<std::pair<int, int>, ColumnSpot> spots;
    for (const SurfaceCell& c : cellsOf(cells, level))
    {
        const double z = static_cast<double>(c.position.z());
        if (c.normal.isZero() || std::abs(c.normal.z()) > 0.4f || z < level.floor_m + margin ||
            z > level.ceiling_m - margin || (cells.hasLabels && c.label != Label::Column))
            continue;
        const Eigen::Vector2d p = c.position.head<2>().cast<double>();
        ColumnSpot& s = spots[{static_cast<int>(std::floor(p.x() / cells.size_m)),
                               static_cast<int>(std::floor(p.y() / cells.size_m))}];
        s.position += p;
        s.weight += 1;
        s.points += c.count;
        s.rows |= 1ull << std::min(63, static_cast<int>((z - level.floor_m) / kRow_m));
        const Eigen::Vector2d n = c.normal.head<2>().cast<double>();
        s.normal += n.dot(s.normal) < 0 ? Eigen::Vector2d(-n) : n;
    }
    std::vector<ColumnSpot> result;
    for (auto& [key, s] : spots)
    {
        s.position /= s.weight;
        s.normal.normalize();
        if (cells.hasLabels || !isInWall(s.position, walls))
            result.push_back(s);
    }
    return result;
}

/// Position of one side of a rectangle: the mean of the surface that faces it, or the outermost points without any.
double sidePosition(const std::vector<ColumnSpot>& spots, const Eigen::Vector2d& direction, double tolerance)
{
    std::vector<std::pair<double, double>> along;
    double total = 0;
    for (const ColumnSpot& s : spots)
        along.emplace_back(direction.dot(s.position), s.weight), total += s.weight;
    std::sort(along.begin(), along.end());
    double sum = 0, outermost = along.back().first;
    for (auto it = along.rbegin(); it != along.rend(); ++it)
    {
        sum += it->second;
        if (sum > 0.02 * total)
        {
            outermost = it->first;
            break;
        }
    }
    double w = 0, mean = 0;
    for (const ColumnSpot& s : spots)
    {
        const double v = direction.dot(s.position);
        if (v > outermost - tolerance && v < outermost + tolerance && std::abs(direction.dot(s.normal)) > 0.85)
            w += s.weight, mean += s.weight * v;
    }
    return w > 0.03 * total ? mean / w : outermost;
}

CircleOptions circleOptions(const ColumnParams& params, const Context& context)
{
    CircleOptions o;
    o.trials = params.circleTrials;
    o.maximumRadius_m = params.maximumSize_m / 2;
    o.seed = context.seed;
    return o;
}

void fitRectangle(ColumnCandidate& c)
{
    // Along the building's axes unless another direction is clearly tighter.
    const OrientedRectangle tight = minimumRectangle(c.points),
                            straight = rectangleAlong(c.points, Eigen::Vector2d::UnitX());
    if (tight.area() > 0 && tight.area() < 0.85 * straight.area())
        c.x = tight.axis;
    const Eigen::Vector2d y(-c.x.y(), c.x.x());
    constexpr double tolerance = 0.02;
    const double xHigh = sidePosition(c.spots, c.x, tolerance), xLow = -sidePosition(c.spots, -c.x, tolerance);
    const double yHigh = sidePosition(c.spots, y, tolerance), yLow = -sidePosition(c.spots, -y, tolerance);
    c.width = xHigh - xLow;
    c.depth = yHigh - yLow;
    c.center = c.x * ((xLow + xHigh) / 2) + y * ((yLow + yHigh) / 2);
    double square = 0;
    for (const ColumnSpot& s : c.spots)
    {
        const double u = c.x.dot(s.position), v = y.dot(s.position);
        const double d = std::min({std::abs(u - xLow), std::abs(u - xHigh), std::abs(v - yLow), std::abs(v - yHigh)});
        square += s.weight * d * d;
    }
    c.rectangleRms = std::sqrt(square / c.weight);
}

/// Share of the circle between the first and the last point seen from its centre: all but the widest gap.
double seenArc(const ColumnCandidate& c, const CircleFit& f)
{
    std::vector<double> angles;
    for (const Eigen::Vector2d& p : c.points)
        angles.push_back(std::atan2(p.y() - f.center.y(), p.x() - f.center.x()));
    std::sort(angles.begin(), angles.end());
    double widest = angles.front() + 2 * std::numbers::pi - angles.back();
    for (std::size_t i = 1; i < angles.size(); ++i)
        widest = std::max(widest, angles[i] - angles[i - 1]);
    return 1 - widest / (2 * std::numbers::pi);
}

bool isCircle(const ColumnCandidate& c, const CircleFit& f, const ColumnParams& params, double coverage)
{
    return f.rms_m < params.circleTolerance_m && f.inlierShare > 0.8 && seenArc(c, f) > coverage &&
           (f.rms_m < c.rectangleRms || coverage < 0.3) && 2 * f.radius_m <= params.maximumSize_m;
}

/// Does the candidate stand on the floor and reach the ceiling, without a large gap? With labels less has to be seen:
/// they say what it is, but wrong ones gather in patches.
bool isFullHeight(const std::vector<ColumnSpot>& spots, const Level& level, bool hasLabels, const ColumnParams& params)
{
    std::uint64_t rows = 0;
    for (const ColumnSpot& s : spots)
        rows |= s.rows;
    const double margin = std::min(params.sliceMargin_m, 0.25 * (level.ceiling_m - level.floor_m));
    const int first = static_cast<int>(std::ceil(margin / kRow_m)) + 1,
              last = std::min(63, static_cast<int>((level.ceiling_m - level.floor_m - margin) / kRow_m) - 1);
    int seen = 0;
    for (int r = first; r <= last; ++r)
        seen += static_cast<int>(rows >> r & 1);
    if (hasLabels)
        return seen >= 0.35 * (last - first + 1);
    return last > first && seen >= 0.8 * (last - first + 1) && (rows >> (last - 1)) != 0;
}

}  // namespace

std::vector<ColumnCandidate> columnCandidates(const SurfaceCells& cells, const Level& level,
                                              const std::vector<Wall>& walls, const ColumnParams& params,
                                              const Context& context)
{
    const std::vector<ColumnSpot> spots = spotsOf(cells, level, walls, params);
    std::vector<Eigen::Vector2d> positions;
    for (const ColumnSpot& s : spots)
        positions.push_back(s.position);
    const std::vector<int> id = dbscan(positions, std::max(params.clusterRadius_m, 2.5 * cells.size_m), 2);
    std::map<int, std::vector<ColumnSpot>> clusters;
    for (std::size_t i = 0; i < id.size(); ++i)
        if (id[i] >= 0)
            clusters[id[i]].push_back(spots[i]);
    std::vector<ColumnCandidate> candidates;
    for (auto& [k, members] : clusters)
    {
        context.checkCancelled();
        if (!isFullHeight(members, level, cells.hasLabels, params))
            continue;
        // Stray cells (mixed pixels, wrong labels) stand alone; a column's surface is stacked.
        ColumnCandidate c;
        double highest = 0;
        for (const ColumnSpot& s : members)
            highest = std::max(highest, s.weight);
        std::erase_if(members, [&](const ColumnSpot& s) { return s.weight < 0.12 * highest; });
        c.spots = std::move(members);
        for (const ColumnSpot& s : c.spots)
            c.points.push_back(s.position), c.weights.push_back(s.weight), c.weight += s.weight;
        if (c.weight < params.clusterMinimumCells || c.spots.size() < 4)
            continue;
        fitRectangle(c);
        c.circle = fitCircle(c.points, c.weights, circleOptions(params, context));
        c.isRound = c.circle && isCircle(c, *c.circle, params, 0.35);
        candidates.push_back(std::move(c));
    }
    return candidates;
}

void shareRadius(std::vector<ColumnCandidate>& candidates, const ColumnParams& params, const Context& context)
{
    std::vector<double> radii;
    for (const ColumnCandidate& c : candidates)
        if (c.isRound && seenArc(c, *c.circle) > 0.6)
            radii.push_back(c.circle->radius_m);
    if (radii.size() < 3)
        return;
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), middle, radii.end());
    for (ColumnCandidate& c : candidates)
    {
        if ((c.isRound && seenArc(c, *c.circle) > 0.6) || std::max(c.width, c.depth) > 2.3 * *middle)
            continue;
        CircleOptions options = circleOptions(params, context);
        options.knownRadius_m = *middle;
        if (const auto fit = fitCircle(c.points, c.weights, options); fit && isCircle(c, *fit, params, 0.1))
            c.circle = fit, c.isRound = true;
    }
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/columns/columns.h"
#include "core/geometry/circle.h"
#include "core/geometry/dbscan.h"
#include "core/geometry/rectangle.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace s2b
{
namespace
{

/// Surface seen from the top: the cells above one small square of the plan.
struct Spot
{
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    Eigen::Vector2d normal = Eigen::Vector2d::Zero();
    double weight = 0;  ///< cells above each other
};

std::vector<Spot> spotsOf(const SurfaceCells& cells, const Level& level, const ColumnParams& params)
{
    const double margin = std::min(params.sliceMargin_m, 0.25 * (level.ceiling_m - level.floor_m));
    std::map<std::pair<int, int>, Spot> spots;
    for (const SurfaceCell& c : cells.cells)
    {
        const double z = static_cast<double>(c.position.z());
        if (c.label != Label::Column || c.normal.isZero() || std::abs(c.normal.z()) > 0.4f || z < level.floor_m + margin ||
            z > level.ceiling_m - margin)
            continue;
        const Eigen::Vector2d p = c.position.head<2>().cast<double>();
        Spot& s = spots[{static_cast<int>(std::floor(p.x() / cells.size_m)), static_cast<int>(std::floor(p.y() / cells.size_m))}];
        s.position += p;
        s.weight += 1;
        Eigen::Vector2d n = c.normal.head<2>().cast<double>();
        s.normal += n.dot(s.normal) < 0 ? Eigen::Vector2d(-n) : n;
    }
    std::vector<Spot> result;
    for (auto& [key, s] : spots)
    {
        s.position /= s.weight;
        s.normal.normalize();
        result.push_back(s);
    }
    return result;
}

/// Position of one side of a rectangle: the mean of the surface that faces it, or the outermost points without any.
double sidePosition(const std::vector<Spot>& spots, const Eigen::Vector2d& direction, double tolerance)
{
    std::vector<std::pair<double, double>> along;
    double total = 0;
    for (const Spot& s : spots)
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
    for (const Spot& s : spots)
    {
        const double v = direction.dot(s.position);
        if (v > outermost - tolerance && v < outermost + tolerance && std::abs(direction.dot(s.normal)) > 0.85)
            w += s.weight, mean += s.weight * v;
    }
    return w > 0.03 * total ? mean / w : outermost;
}

}  // namespace

ColumnResult findColumns(const SurfaceCells& cells, const Level& level, ElementId storey, std::uint32_t& nextId,
                         const ColumnParams& params, const Context& context)
{
    ColumnResult result;
    const std::vector<Spot> spots = spotsOf(cells, level, params);
    if (spots.empty())
        return result;
    std::vector<Eigen::Vector2d> positions;
    for (const Spot& s : spots)
        positions.push_back(s.position);
    const std::vector<int> id = dbscan(positions, std::max(params.clusterRadius_m, 2.5 * cells.size_m), 2);
    std::map<int, std::vector<Spot>> clusters;
    for (std::size_t i = 0; i < id.size(); ++i)
        if (id[i] >= 0)
            clusters[id[i]].push_back(spots[i]);
    for (auto& [k, members] : clusters)
    {
        context.checkCancelled();
        // Stray cells (mixed pixels, wrong labels) stand alone; a column's surface is stacked.
        double highest = 0, weight = 0;
        for (const Spot& s : members)
            highest = std::max(highest, s.weight);
        std::erase_if(members, [&](const Spot& s) { return s.weight < 0.12 * highest; });
        for (const Spot& s : members)
            weight += s.weight;
        if (weight < params.clusterMinimumCells || members.size() < 4)
            continue;
        std::vector<Eigen::Vector2d> points;
        std::vector<double> weights;
        for (const Spot& s : members)
            points.push_back(s.position), weights.push_back(s.weight);

        Column c;
        c.storey = storey;
        c.base_m = level.floor_m;
        c.height = {level.ceiling_m - level.floor_m, level.ceilingSeen ? Provenance::Measured : Provenance::Assumed, 0.0};
        // A rectangle along the building's axes unless another direction is clearly tighter.
        const OrientedRectangle tight = minimumRectangle(points);
        const OrientedRectangle straight = rectangleAlong(points, Eigen::Vector2d::UnitX());
        const bool turned = tight.area() < 0.85 * straight.area() && tight.area() > 0;
        const Eigen::Vector2d x = turned ? tight.axis : Eigen::Vector2d::UnitX(), y(-x.y(), x.x());
        const double tolerance = 0.02;
        const double xHigh = sidePosition(members, x, tolerance), xLow = -sidePosition(members, -x, tolerance);
        const double yHigh = sidePosition(members, y, tolerance), yLow = -sidePosition(members, -y, tolerance);
        const double width = xHigh - xLow, depth = yHigh - yLow;
        // How well the outline of the rectangle explains the points, and how well a circle does.
        double square = 0;
        for (const Spot& s : members)
        {
            const double u = x.dot(s.position), v = y.dot(s.position);
            const double d = std::min({std::abs(u - xLow), std::abs(u - xHigh), std::abs(v - yLow), std::abs(v - yHigh)});
            square += s.weight * d * d;
        }
        CircleOptions circleOptions;
        circleOptions.trials = params.circleTrials;
        circleOptions.maximumRadius_m = params.maximumSize_m / 2;
        circleOptions.seed = context.seed;
        const double rectangleRms = std::sqrt(square / weight);
        const std::optional<CircleFit> circle = fitCircle(points, weights, circleOptions);
        const bool isRound = circle && circle->rms_m < params.circleTolerance_m && circle->rms_m < rectangleRms &&
                             2 * circle->radius_m <= params.maximumSize_m && circle->arcCoverage > 0.3 && circle->inlierShare > 0.8;
        if (isRound)
        {
            c.center = circle->center;
            c.section = CircleSection{circle->radius_m};
            c.evidence.rms_m = circle->rms_m;
        }
        else
        {
            c.center = x * ((xLow + xHigh) / 2) + y * ((yLow + yHigh) / 2);
            c.yaw_rad = std::atan2(x.y(), x.x());
            c.section = RectangleSection{width, depth};
            c.evidence.rms_m = rectangleRms;
        }
        const double size = isRound ? 2 * circle->radius_m : std::max(width, depth);
        const double smallest = isRound ? size : std::min(width, depth);
        if (size > params.maximumSize_m || smallest < params.minimumSize_m)
        {
            result.diagnostics.push_back({Severity::Warning, "columns", "SizeOutOfRange",
                                          "Points labelled column form no column of a permitted size.", {},
                                          Eigen::Vector3d(c.center.x(), c.center.y(), level.floor_m)});
            continue;
        }
        c.id = ElementId{nextId++};
        c.evidence.points = static_cast<std::uint64_t>(weight);
        c.evidence.facesSeen = 2;
        c.evidence.labelShare = 1.0;
        result.columns.push_back(c);
    }
    return result;
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/columns/columns.h"
#include "core/geometry/circle.h"
#include "core/geometry/dbscan.h"
#include "core/geometry/rectangle.h"
#include "core/model/wall_axis.h"
#include "core/walls/plan_mask.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace s2b
{
namespace
{

constexpr double kRow_m = 0.10;
constexpr double kLeastSeen = 0.06;  // share of a column's surface; one side in four, half hidden, shows twice that

/// Surface seen from the top: the cells above one small square of the plan.
struct Spot
{
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    Eigen::Vector2d normal = Eigen::Vector2d::Zero();
    double weight = 0;  ///< cells above each other
    std::uint64_t points = 0;
    std::uint64_t rows = 0;  ///< bit r: something was seen at that height above the floor
};

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

std::vector<Spot> spotsOf(const SurfaceCells& cells, const Level& level, const std::vector<Wall>& walls,
                          const ColumnParams& params)
{
    const double margin = std::min(params.sliceMargin_m, 0.25 * (level.ceiling_m - level.floor_m));
    std::map<std::pair<int, int>, Spot> spots;
    for (const SurfaceCell& c : cells.cells)
    {
        const double z = static_cast<double>(c.position.z());
        if (c.normal.isZero() || std::abs(c.normal.z()) > 0.4f || z < level.floor_m + margin ||
            z > level.ceiling_m - margin || (cells.hasLabels && c.label != Label::Column))
            continue;
        const Eigen::Vector2d p = c.position.head<2>().cast<double>();
        Spot& s = spots[{static_cast<int>(std::floor(p.x() / cells.size_m)),
                         static_cast<int>(std::floor(p.y() / cells.size_m))}];
        s.position += p;
        s.weight += 1;
        s.points += c.count;
        s.rows |= 1ull << std::min(63, static_cast<int>((z - level.floor_m) / kRow_m));
        const Eigen::Vector2d n = c.normal.head<2>().cast<double>();
        s.normal += n.dot(s.normal) < 0 ? Eigen::Vector2d(-n) : n;
    }
    std::vector<Spot> result;
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

/// The points of one column candidate and what fits them.
struct Candidate
{
    std::vector<Spot> spots;
    std::vector<Eigen::Vector2d> points;
    std::vector<double> weights;
    double weight = 0;
    Eigen::Vector2d x = Eigen::Vector2d::UnitX(), center = Eigen::Vector2d::Zero();
    double width = 0, depth = 0, rectangleRms = 0;
    std::optional<CircleFit> circle;
    bool isRound = false;
    bool isEngaged = false;  ///< stands in a wall: the part within is assumed
};

CircleOptions circleOptions(const ColumnParams& params, const Context& context)
{
    CircleOptions o;
    o.trials = params.circleTrials;
    o.maximumRadius_m = params.maximumSize_m / 2;
    o.seed = context.seed;
    return o;
}

void fitRectangle(Candidate& c)
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
    for (const Spot& s : c.spots)
    {
        const double u = c.x.dot(s.position), v = y.dot(s.position);
        const double d = std::min({std::abs(u - xLow), std::abs(u - xHigh), std::abs(v - yLow), std::abs(v - yHigh)});
        square += s.weight * d * d;
    }
    c.rectangleRms = std::sqrt(square / c.weight);
}

/// Share of the circle between the first and the last point seen from its centre: all but the widest gap.
double seenArc(const Candidate& c, const CircleFit& f)
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

bool isCircle(const Candidate& c, const CircleFit& f, const ColumnParams& params, double coverage)
{
    return f.rms_m < params.circleTolerance_m && f.inlierShare > 0.8 && seenArc(c, f) > coverage &&
           (f.rms_m < c.rectangleRms || coverage < 0.3) && 2 * f.radius_m <= params.maximumSize_m;
}

/// Does the candidate stand on the floor and reach the ceiling, without a large gap? With labels less has to be seen:
/// they say what it is, but wrong ones gather in patches.
bool isFullHeight(const std::vector<Spot>& spots, const Level& level, bool hasLabels, const ColumnParams& params)
{
    std::uint64_t rows = 0;
    for (const Spot& s : spots)
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

std::vector<Candidate> candidatesOf(const SurfaceCells& cells, const Level& level, const std::vector<Wall>& walls,
                                    const ColumnParams& params, const Context& context)
{
    const std::vector<Spot> spots = spotsOf(cells, level, walls, params);
    std::vector<Eigen::Vector2d> positions;
    for (const Spot& s : spots)
        positions.push_back(s.position);
    const std::vector<int> id = dbscan(positions, std::max(params.clusterRadius_m, 2.5 * cells.size_m), 2);
    std::map<int, std::vector<Spot>> clusters;
    for (std::size_t i = 0; i < id.size(); ++i)
        if (id[i] >= 0)
            clusters[id[i]].push_back(spots[i]);
    std::vector<Candidate> candidates;
    for (auto& [k, members] : clusters)
    {
        context.checkCancelled();
        if (!isFullHeight(members, level, cells.hasLabels, params))
            continue;
        // Stray cells (mixed pixels, wrong labels) stand alone; a column's surface is stacked.
        Candidate c;
        double highest = 0;
        for (const Spot& s : members)
            highest = std::max(highest, s.weight);
        std::erase_if(members, [&](const Spot& s) { return s.weight < 0.12 * highest; });
        c.spots = std::move(members);
        for (const Spot& s : c.spots)
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

/// Round columns of one storey mostly have one radius: it settles those of which little was seen.
void shareRadius(std::vector<Candidate>& candidates, const ColumnParams& params, const Context& context)
{
    std::vector<double> radii;
    for (const Candidate& c : candidates)
        if (c.isRound && seenArc(c, *c.circle) > 0.6)
            radii.push_back(c.circle->radius_m);
    if (radii.size() < 3)
        return;
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), middle, radii.end());
    for (Candidate& c : candidates)
    {
        if ((c.isRound && seenArc(c, *c.circle) > 0.6) || std::max(c.width, c.depth) > 2.3 * *middle)
            continue;
        CircleOptions options = circleOptions(params, context);
        options.knownRadius_m = *middle;
        if (const auto fit = fitCircle(c.points, c.weights, options); fit && isCircle(c, *fit, params, 0.1))
            c.circle = fit, c.isRound = true;
    }
}

/// A column that a wall hides in part: what shows is its front. Of a rectangle flush with a wall's face, less deep than
/// wide, the depth within the wall is assumed: a square section, up to the wall's other face.
void completeEngaged(Candidate& c, const std::vector<Wall>& walls)
{
    constexpr double flush_m = 0.08;  // cells at the inner edge have no clear normal: the sides begin some cells off
    for (int side = 0; side < 4 && !c.isEngaged; ++side)
    {
        const Eigen::Vector2d y(-c.x.y(), c.x.x());
        const Eigen::Vector2d out = (side < 2 ? c.x : y) * (side % 2 ? -1.0 : 1.0);
        double& deep = side < 2 ? c.width : c.depth;
        const double wide = side < 2 ? c.depth : c.width;
        if (deep >= wide)
            continue;
        const Eigen::Vector2d back = c.center + out * (deep / 2);
        for (const Wall& w : walls)
        {
            if (w.bulge != 0 || std::abs(w.normal().dot(out)) < 0.995)
                continue;
            const Eigen::Vector2d d = back - w.start;
            const double s = w.direction().dot(d), half = w.thickness.value_m / 2,
                         inside = half + w.normal().dot(d) * (w.normal().dot(out) > 0 ? 1.0 : -1.0);
            if (s < w.bodyStart_m || s > w.bodyEnd_m || std::abs(inside) > flush_m)
                continue;
            const double more = std::min(wide - deep, 2 * half - inside);
            c.center += out * (more / 2);
            deep += more;
            c.isEngaged = true;
            break;
        }
    }
}

/// Floor or ceiling of the storey (whichever its mask knows better) was seen around it: not a tree, not a lamp post.
bool standsInBuilding(const Candidate& c, const PlanMask& mask)
{
    const double reach = std::max(c.width, c.depth) / 2 + 0.4;
    const Eigen::Vector2d middle = c.isRound ? c.circle->center : c.center;
    return mask.share(middle - reach * c.x, middle + reach * c.x, -reach, reach, mask.mainLayer()) > 0.15;
}

}  // namespace

ColumnResult findColumns(const SurfaceCells& cells, const Level& level, const std::vector<Wall>& walls,
                         ElementId storey, std::uint32_t& nextId, const ColumnParams& params, const Context& context)
{
    ColumnResult result;
    std::vector<Candidate> candidates = candidatesOf(cells, level, walls, params, context);
    shareRadius(candidates, params, context);
    const PlanMask mask(cells, level);
    for (Candidate& k : candidates)
    {
        if (!cells.hasLabels && !standsInBuilding(k, mask))
            continue;
        if (!k.isRound)
            completeEngaged(k, walls);
        Column c;
        c.storey = storey;
        c.base_m = level.floor_m;
        c.height = {level.ceiling_m - level.floor_m, level.ceilingSeen ? Provenance::Measured : Provenance::Assumed,
                    0.0};
        if (k.isRound)
        {
            c.center = k.circle->center;
            c.section = CircleSection{k.circle->radius_m};
            c.evidence.rms_m = k.circle->rms_m;
        }
        else
        {
            c.center = k.center;
            c.yaw_rad = std::atan2(k.x.y(), k.x.x());
            c.section = RectangleSection{k.width, k.depth};
            c.evidence.rms_m = k.rectangleRms;
        }
        const double largest = k.isRound ? 2 * k.circle->radius_m : std::max(k.width, k.depth);
        const double smallest = k.isRound ? largest : std::min(k.width, k.depth);
        // Without labels a thin or long thing is a panel or a piece of wall.
        const bool isSlender = !cells.hasLabels && (largest > 1.0 || smallest < 0.4 * largest);
        // Stray wrong labels are spread thinly over what they would make.
        const double seen = k.weight * cells.size_m * cells.size_m /
                            (2 * (largest + smallest) * std::max(0.1, level.ceiling_m - level.floor_m));
        const bool isGhost = seen < kLeastSeen;
        if (largest > params.maximumSize_m || smallest < params.minimumSize_m || isSlender || isGhost)
        {
            if (cells.hasLabels && !isGhost)
                result.diagnostics.push_back({Severity::Warning,
                                              "columns",
                                              "SizeOutOfRange",
                                              "Points labelled column form no column of a permitted size.",
                                              {},
                                              Eigen::Vector3d(c.center.x(), c.center.y(), level.floor_m)});
            continue;
        }
        c.id = ElementId{nextId++};
        for (const Spot& s : k.spots)
            c.evidence.points += s.points;
        c.sectionProvenance = k.isEngaged ? Provenance::Assumed : Provenance::Measured;
        if (k.isEngaged)
            result.diagnostics.push_back({Severity::Warning, "columns", "DepthAssumed",
                                          "The column stands in a wall; its depth within the wall is assumed.", c.id,
                                          Eigen::Vector3d(c.center.x(), c.center.y(), level.floor_m)});
        c.evidence.facesSeen = 2;
        c.evidence.labelShare = cells.hasLabels ? 1.0 : 0.0;
        result.columns.push_back(c);
    }
    return result;
}

}  // namespace s2b

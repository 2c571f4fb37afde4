// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/face_lines.h"

#include "core/geometry/dbscan.h"
#include "core/geometry/line.h"
#include "core/geometry/plane.h"
#include "core/walls/axis_sort.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

namespace s2b
{
namespace
{

/// The offset that most of the pixels that are left agree on (HYSAC), and its weight.
OffsetConsensus bestOffset(const std::vector<PlanPixel>& pixels, const std::vector<std::uint32_t>& left,
                           const Eigen::Vector2d& n, double tolerance)
{
    std::vector<double> offsets, weights;
    offsets.reserve(left.size()), weights.reserve(left.size());
    for (const std::uint32_t i : left)
        offsets.push_back(n.dot(pixels[i].position)), weights.push_back(pixels[i].weight);
    return findOffset(offsets, weights, tolerance);
}

/// Least squares of the chosen pixels.
bool refit(const std::vector<PlanPixel>& pixels, const std::vector<std::uint32_t>& chosen, FaceLine& line)
{
    std::vector<Eigen::Vector2d> points;
    std::vector<double> weights;
    points.reserve(chosen.size()), weights.reserve(chosen.size());
    for (const std::uint32_t i : chosen)
        points.push_back(pixels[i].position), weights.push_back(pixels[i].weight);
    const LineFit fit = fitLine(points, weights);
    if (fit.weight <= 0 || fit.direction.isZero())
        return false;
    line.t = fit.direction.dot(line.t) < 0 ? Eigen::Vector2d(-fit.direction) : fit.direction;
    line.offset = line.n().dot(fit.point);
    return true;
}

/// The heaviest run of pixels along the line without a gap wider than `gap`; sets begin and end.
std::vector<std::uint32_t> heaviestRun(const std::vector<PlanPixel>& pixels, std::vector<std::uint32_t> chosen,
                                       double gap, FaceLine& line)
{
    std::vector<std::pair<double, std::uint32_t>> order;
    order.reserve(chosen.size());
    for (const std::uint32_t i : chosen)
        order.emplace_back(line.t.dot(pixels[i].position), i);
    std::sort(order.begin(), order.end());
    std::size_t bestFirst = 0, bestLast = 0;
    double bestWeight = -1;
    for (std::size_t i = 0; i < order.size();)
    {
        std::size_t j = i;
        double w = pixels[order[i].second].weight;
        while (j + 1 < order.size() && order[j + 1].first - order[j].first <= gap)
            w += pixels[order[++j].second].weight;
        if (w > bestWeight)
            bestWeight = w, bestFirst = i, bestLast = j;
        i = j + 1;
    }
    chosen.clear();
    for (std::size_t i = bestFirst; i <= bestLast && i < order.size(); ++i)
        chosen.push_back(order[i].second);
    if (!chosen.empty())
        line.begin = order[bestFirst].first, line.end = order[bestLast].first;
    return chosen;
}

/// What no plane of the set's direction explains may still be a plane of another (a facet of a curved wall): RANSAC
/// without the constraint, on the pixels drawn out to vertical lines.
bool drawLine(const std::vector<PlanPixel>& pixels, const std::vector<std::uint32_t>& left, const WallParams& params,
              const Context& context, FaceLine& line)
{
    std::vector<Eigen::Vector3f> points;
    points.reserve(2 * left.size());
    const Eigen::Vector2d origin = pixels[left.front()].position;
    for (const std::uint32_t i : left)
        for (const float z : {0.0f, 1.0f})
            points.emplace_back(static_cast<float>(pixels[i].position.x() - origin.x()),
                                static_cast<float>(pixels[i].position.y() - origin.y()), z);
    PlaneOptions options;
    options.tolerance_m = params.planeDistance_m;
    options.seed = context.seed;
    const std::optional<PlaneFit> fit = fitPlane(points, options);
    if (!fit || std::abs(fit->normal.z()) > 0.05)
        return false;
    const Eigen::Vector2d n = fit->normal.head<2>().normalized();
    line.t = {n.y(), -n.x()};
    line.offset = fit->offset_m + n.dot(origin);
    return true;
}

/// Lines of one instance, the heaviest first.
std::vector<FaceLine> linesOfInstance(const std::vector<PlanPixel>& pixels, std::vector<std::uint32_t> left,
                                      double normalAngle, double cell, const WallParams& params, const Context& context)
{
    std::vector<FaceLine> lines;
    const Eigen::Vector2d axisNormal(std::cos(normalAngle), std::sin(normalAngle));
    const Eigen::Vector2d axis(axisNormal.y(), -axisNormal.x());  // its normal (turned +90 degrees) is axisNormal
    const double minimumWeight = params.minimumFaceArea_m2 / (cell * cell);
    const double gap = std::max(0.30, 4 * cell);
    const double cosine = std::cos(20.0 * std::numbers::pi / 180);
    while (left.size() >= 3)
    {
        FaceLine line;
        line.t = axis;
        const OffsetConsensus consensus = bestOffset(pixels, left, line.n(), params.planeDistance_m);
        if (consensus.weight >= minimumWeight)
            line.offset = consensus.offset;
        else if (!drawLine(pixels, left, params, context, line))
            break;
        const Eigen::Vector2d guess = line.t;
        std::vector<std::uint32_t> chosen;
        const auto collect = [&](double tolerance)
        {
            chosen.clear();
            for (const std::uint32_t i : left)
                if (std::abs(line.n().dot(pixels[i].position) - line.offset) < tolerance &&
                    std::abs(line.n().dot(pixels[i].normal)) > cosine)
                    chosen.push_back(i);
            chosen = heaviestRun(pixels, std::move(chosen), gap, line);
        };
        collect(1.5 * params.planeDistance_m);
        bool fits = true;
        for (int round = 0; round < 8 && fits; ++round)
        {
            const FaceLine before = line;
            fits = chosen.size() >= 3 && refit(pixels, chosen, line);
            // A short piece says little about its own direction.
            if (fits && line.end - line.begin < 0.6)
            {
                const double mid = (line.begin + line.end) / 2;
                const Eigen::Vector2d centre = line.t * mid + line.n() * line.offset;
                line.t = guess;
                line.offset = line.n().dot(centre);
            }
            if (fits)
                collect(1.5 * params.planeDistance_m);
            if (fits && std::abs(line.offset - before.offset) < 1e-5 && std::abs(line.begin - before.begin) < 1e-5 &&
                std::abs(line.end - before.end) < 1e-5)
                break;
        }
        double sum = 0;
        for (const std::uint32_t i : chosen)
            sum += pixels[i].weight;
        line.weight = sum;
        // Pixels beside the line belong to it as well (noise, rough plaster): they must not become a second face.
        std::vector<char> taken(pixels.size(), 0);
        for (const std::uint32_t i : left)
        {
            const double s = line.t.dot(pixels[i].position);
            if (std::abs(line.n().dot(pixels[i].position) - line.offset) < 1.8 * params.planeDistance_m &&
                s >= line.begin - cell && s <= line.end + cell)
                taken[i] = 1;
        }
        const std::size_t before = left.size();
        std::erase_if(left, [&](std::uint32_t i) { return taken[i] != 0; });
        if (fits && sum >= minimumWeight)
            lines.push_back(line);
        else if (left.size() == before)
            break;
        if (left.size() == before)
            break;
    }
    return lines;
}

}  // namespace

std::vector<FaceLine> findLines(const SurfaceCells& cells, const Level& level, const WallParams& params,
                                const Context& context)
{
    std::vector<FaceLine> lines;
    for (const AxisSet& set : sortByAxis(cells, level, params, context))
    {
        context.checkCancelled();
        std::vector<Eigen::Vector2d> positions;
        positions.reserve(set.pixels.size());
        for (const PlanPixel& p : set.pixels)
            positions.push_back(p.position);
        const double radius = std::max(params.clusterRadius_m, 2.5 * cells.size_m);
        const std::vector<int> instance = dbscan(positions, radius, std::min(params.clusterMinimumCells, 3));
        std::map<int, std::vector<std::uint32_t>> members;
        for (std::size_t i = 0; i < instance.size(); ++i)
            if (instance[i] >= 0)
                members[instance[i]].push_back(static_cast<std::uint32_t>(i));
        for (auto& [id, list] : members)
        {
            const std::vector<FaceLine> found =
                linesOfInstance(set.pixels, std::move(list), set.angle_rad, cells.size_m, params, context);
            lines.insert(lines.end(), found.begin(), found.end());
        }
    }
    // The same direction for all faces that nearly agree, so that begin, end and offset can be compared.
    for (FaceLine& l : lines)
        if (l.t.x() + l.t.y() < 0)  // directions in [-45, 135) degrees: both axes are far from the seam
        {
            l.t = -l.t;
            l.offset = -l.offset;
            std::tie(l.begin, l.end) = std::pair(-l.end, -l.begin);
        }
    return lines;
}

}  // namespace s2b

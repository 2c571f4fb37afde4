// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/faces.h"

#include "core/geometry/dbscan.h"
#include "core/geometry/line.h"
#include "core/geometry/plane.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <unordered_map>

namespace s2b
{
namespace
{

/// A line in plan with the pixels on it.
struct Line
{
    Eigen::Vector2d t = Eigen::Vector2d::UnitX();
    double offset = 0.0;
    double begin = 0.0, end = 0.0;
    double weight = 0.0;

    [[nodiscard]] Eigen::Vector2d n() const { return {-t.y(), t.x()}; }
};

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
bool refit(const std::vector<PlanPixel>& pixels, const std::vector<std::uint32_t>& chosen, Line& line)
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
                                       double gap, Line& line)
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
              const Context& context, Line& line)
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
std::vector<Line> linesOfInstance(const std::vector<PlanPixel>& pixels, std::vector<std::uint32_t> left,
                                  double normalAngle, double cell, const WallParams& params, const Context& context)
{
    std::vector<Line> lines;
    const Eigen::Vector2d axisNormal(std::cos(normalAngle), std::sin(normalAngle));
    const Eigen::Vector2d axis(axisNormal.y(), -axisNormal.x());  // its normal (turned +90 degrees) is axisNormal
    const double minimumWeight = params.minimumFaceArea_m2 / (cell * cell);
    const double gap = std::max(0.30, 4 * cell);
    const double cosine = std::cos(20.0 * std::numbers::pi / 180);
    while (left.size() >= 3)
    {
        Line line;
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
            const Line before = line;
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

/// Gathers the storey's cells onto the faces: coverage, robust offset, labels.
class FaceGatherer
{
public:
    FaceGatherer(const std::vector<Line>& lines, double tolerance) : m_tolerance(tolerance)
    {
        for (std::size_t k = 0; k < lines.size(); ++k)
        {
            const Line& l = lines[k];
            const int steps = static_cast<int>(std::ceil((l.end - l.begin) / (0.5 * kTile))) + 1;
            std::uint64_t last = ~0ull;
            for (int i = 0; i <= steps; ++i)
                for (int side = -1; side <= 1; ++side)
                {
                    const double s = l.begin + (l.end - l.begin) * i / steps;
                    const std::uint64_t key = tileOf(l.t * s + l.n() * (l.offset + side * 0.04));
                    if (key == last)
                        continue;
                    last = key;
                    auto& list = m_tiles[key];
                    if (std::find(list.begin(), list.end(), static_cast<std::uint32_t>(k)) == list.end())
                        list.push_back(static_cast<std::uint32_t>(k));
                }
        }
    }
    /// Line nearest to a cell within the tolerance, or -1.
    [[nodiscard]] int nearest(const std::vector<Line>& lines, const Eigen::Vector2d& p,
                              const Eigen::Vector2d& normal) const
    {
        const auto tile = m_tiles.find(tileOf(p));
        if (tile == m_tiles.end())
            return -1;
        int best = -1;
        double bestDistance = m_tolerance;
        for (const std::uint32_t k : tile->second)
        {
            const Line& l = lines[k];
            const double s = l.t.dot(p), d = std::abs(l.n().dot(p) - l.offset);
            if (d < bestDistance && s >= l.begin - 0.03 && s <= l.end + 0.03 && std::abs(l.n().dot(normal)) > 0.9)
                bestDistance = d, best = static_cast<int>(k);
        }
        return best;
    }

private:
    static constexpr double kTile = 0.25;
    [[nodiscard]] static std::uint64_t tileOf(const Eigen::Vector2d& p)
    {
        const auto part = [](double v)
        { return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v / kTile)) + (1 << 30)); };
        return part(p.x()) | part(p.y()) << 32;
    }
    double m_tolerance;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_tiles;
};

std::vector<Face> gather(const std::vector<Line>& lines, const SurfaceCells& cells, const Level& level,
                         const WallParams& params)
{
    const FaceGatherer gatherer(lines, 1.5 * params.planeDistance_m);
    std::vector<Face> faces(lines.size());
    struct Sums
    {
        double w = 0, d = 0, dd = 0, wall = 0, cells = 0, all = 0;
    };
    std::vector<Sums> sums(lines.size());
    for (std::size_t k = 0; k < lines.size(); ++k)
    {
        faces[k].t = lines[k].t;
        faces[k].offset = lines[k].offset;
        faces[k].begin = lines[k].begin - 0.5 * cells.size_m;
        faces[k].end = lines[k].end + 0.5 * cells.size_m;
        faces[k].rows.assign(static_cast<std::size_t>(std::max(1.0, std::ceil(faces[k].length() / Face::kBin_m))), 0);
    }
    for (const SurfaceCell& c : cells.cells)
    {
        const double z = static_cast<double>(c.position.z());
        if (c.normal.isZero() || std::abs(c.normal.z()) > 0.3f || z < level.floor_m ||
            z > level.highestCeiling_m() + 0.3)
            continue;
        const double weight = wallWeight(cells, c);
        if (c.label == Label::Door || c.label == Label::Window)
            continue;
        const Eigen::Vector2d p = c.position.head<2>().cast<double>();
        const int k = gatherer.nearest(lines, p, c.normal.head<2>().cast<double>());
        if (k < 0)
            continue;
        Face& f = faces[static_cast<std::size_t>(k)];
        Sums& s = sums[static_cast<std::size_t>(k)];
        s.all += 1;
        if (weight <= 0)
            continue;
        const double d = f.n().dot(p) - f.offset, n = c.count;
        s.w += n, s.d += n * d, s.dd += n * d * d, s.cells += 1;
        s.wall += c.label == Label::Wall ? 1 : 0;
        f.points += c.count;
        const auto bin = static_cast<std::ptrdiff_t>(std::floor((f.t.dot(p) - f.begin) / Face::kBin_m));
        const auto row = static_cast<std::ptrdiff_t>(std::floor((z - level.floor_m) / Face::kRow_m));
        if (bin >= 0 && bin < static_cast<std::ptrdiff_t>(f.rows.size()) && row >= 0 && row < 64)
            f.rows[static_cast<std::size_t>(bin)] |= 1ull << row;
    }
    for (std::size_t k = 0; k < faces.size(); ++k)
    {
        const Sums& s = sums[k];
        if (s.w <= 0)
            continue;
        faces[k].offset += s.d / s.w;
        faces[k].rms_m = std::sqrt(std::max(0.0, s.dd / s.w - (s.d / s.w) * (s.d / s.w)));
        faces[k].wallShare = s.wall / s.all;
        faces[k].area_m2 = s.cells * cells.size_m * cells.size_m;
    }
    std::erase_if(faces, [&](const Face& f) { return f.area_m2 < params.minimumFaceArea_m2; });
    return faces;
}

/// Walls reach the ceiling above them, at least where no opening interrupts them; leaves, cupboards and sills don't.
bool reachesCeiling(const Face& face, const PlanMask& mask)
{
    // No furniture is as long and as high as this, whatever roof is above it.
    constexpr double tall_m = 2.3, long_m = 2.5;
    std::size_t seen = 0, reaching = 0, tall = 0;
    for (std::size_t b = 0; b < face.rows.size(); ++b)
    {
        if (!face.rows[b])
            continue;
        tall += Face::kRow_m * (64 - std::countl_zero(face.rows[b])) >= tall_m;
        const double s = face.begin + (static_cast<double>(b) + 0.5) * Face::kBin_m;
        double overhead = -1;
        for (const double d : {-0.45, -0.2, 0.2, 0.45})
            overhead = std::max(overhead, mask.overhead_m(face.at(s) + d * face.n()));
        if (overhead < 0)
            overhead = 1.6;  // nothing above it was seen (outdoors, no ceiling): as high as a person will do
        ++seen;
        reaching += Face::kRow_m * (64 - std::countl_zero(face.rows[b])) >= overhead - 0.3;
    }
    return 2 * reaching > seen || static_cast<double>(tall) * Face::kBin_m > long_m;
}

/// Is it a face of a wall, or of something that stands in the room or hangs on a wall? Labels and shape weigh each
/// other: what has a wall's shape needs few labels, what hasn't needs many; without labels the shape decides.
bool isWallFace(const Face& face, const SurfaceCells& cells, const PlanMask& mask)
{
    const bool reaches = reachesCeiling(face, mask);
    if (!cells.hasLabels)
        return reaches;
    return reaches ? face.wallShare > 0.4 : face.wallShare > 0.8 && face.area_m2 > 0.4;
}

/// A face behind a longer one, where that one has a hole: a pane, frame, leaf or niche within its wall.
bool isRecessed(const Face& face, const std::vector<Face>& faces)
{
    for (const Face& front : faces)
    {
        if (&front == &face || front.side == 0 || std::abs(front.t.dot(face.n())) > 0.03 ||
            front.length() < 1.2 * face.length())
            continue;
        const double behind = (front.offset - face.offset) * front.side;
        if (behind < 0.015 || behind > 0.5 ||
            std::min(front.end, face.end) - std::max(front.begin, face.begin) < 0.8 * face.length())
            continue;
        std::size_t bins = 0, missing = 0;
        for (std::size_t b = 0; b < face.rows.size(); ++b)
        {
            const double s = face.begin + (static_cast<double>(b) + 0.5) * Face::kBin_m;
            const auto k = static_cast<std::ptrdiff_t>((s - front.begin) / Face::kBin_m);
            if (!face.rows[b] || k < 0 || k >= static_cast<std::ptrdiff_t>(front.rows.size()))
                continue;
            ++bins;
            // The front one is missing where this one is, and goes on above it.
            const std::uint64_t rows = front.rows[static_cast<std::size_t>(k)];
            missing += 10 * std::popcount(rows & face.rows[b]) < 4 * std::popcount(face.rows[b]) && rows > face.rows[b];
        }
        if (bins > 0 && 2 * missing > bins)
            return true;
    }
    return false;
}

/// Without labels, what shows no floor or ceiling of this storey beside it stands outside: trees, fences, other
/// buildings.
bool isOutside(const Face& face, const PlanMask& mask)
{
    const Eigen::Vector2d a = face.at(face.begin), b = face.at(face.end);
    const auto roomBeside = [&](double low, double high)
    { return std::max(mask.share(a, b, low, high, PlanMask::Ceiling), mask.share(a, b, low, high, PlanMask::Floor)); };
    return std::max(roomBeside(0.05, 0.8), roomBeside(-0.8, -0.05)) < 0.15;
}

/// Which side of the face shows floor or ceiling right beside it: that is the room's. Where neither does, free space
/// further away on one side only is seen across the wall's own body (the outer face of an external wall).
struct Side
{
    int side = 0;           ///< as Face::side
    bool isBeside = false;  ///< seen right beside the face, not across a body
};

Side roomSide(const Face& face, const PlanMask& mask, PlanMask::Layer layer)
{
    // The pixel that the face itself lies in says nothing.
    const double nearBegin = 0.75 * mask.pixel_m(), nearEnd = std::max(0.10, 2.5 * mask.pixel_m()), farEnd = 0.7;
    const Eigen::Vector2d a = face.at(face.begin), b = face.at(face.end);
    const double left = mask.share(a, b, nearBegin, nearEnd, layer),
                 right = mask.share(a, b, -nearEnd, -nearBegin, layer);
    if (std::max(left, right) > 0.4)
        return {std::abs(left - right) > 0.2 ? (left > right ? 1 : -1) : 0, true};
    const double farLeft = mask.share(a, b, nearEnd, farEnd, layer),
                 farRight = mask.share(a, b, -farEnd, -nearEnd, layer);
    if (std::max(farLeft, farRight) < 0.2 || std::min(farLeft, farRight) > 0.08)
        return {};
    return {farLeft > farRight ? -1 : 1, false};
}

/// Sides of all faces. A face without free space right beside it (a stair, a shaft) follows a collinear one that has
/// it.
void findSides(std::vector<Face>& faces, const PlanMask& mask, double sameOffset)
{
    const PlanMask::Layer main = mask.mainLayer(),
                          second = main == PlanMask::Ceiling ? PlanMask::Floor : PlanMask::Ceiling;
    std::vector<char> isSure(faces.size(), 0);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
        Side best = roomSide(faces[i], mask, faces[i].isLow ? PlanMask::Floor : main);
        // Free space on both sides is an answer too (a leaf, a panel): then the other layer is not asked.
        if (!best.isBeside && !faces[i].isLow)
            if (const Side other = roomSide(faces[i], mask, second);
                best.side == 0 || (other.isBeside && other.side != 0))
                best = other;
        faces[i].side = best.side;
        faces[i].isBesideRoom = best.isBeside;
        isSure[i] = best.isBeside && best.side != 0;
    }
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
        if (faces[i].isBesideRoom)
            continue;
        double nearest = 10.0;
        for (std::size_t j = 0; j < faces.size(); ++j)
        {
            if (!isSure[j] || std::abs(faces[i].t.dot(faces[j].n())) > 0.02)
                continue;
            const double gap = std::max(faces[j].begin - faces[i].end, faces[i].begin - faces[j].end);
            const double offset = faces[i].n().dot(faces[j].at((faces[j].begin + faces[j].end) / 2)) - faces[i].offset;
            if (gap < nearest && std::abs(offset) < sameOffset)
                nearest = gap, faces[i].side = faces[j].side;
        }
    }
}

}  // namespace

std::vector<Face> findFaces(const SurfaceCells& cells, const Level& level, const PlanMask& mask,
                            const WallParams& params, const Context& context)
{
    std::vector<Line> lines;
    for (const AxisSet& set : sortByAxis(cells, level, params))
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
            const std::vector<Line> found =
                linesOfInstance(set.pixels, std::move(list), set.angle_rad, cells.size_m, params, context);
            lines.insert(lines.end(), found.begin(), found.end());
        }
    }
    // The same direction for all faces that nearly agree, so that begin, end and offset can be compared.
    for (Line& l : lines)
        if (l.t.x() + l.t.y() < 0)  // directions in [-45, 135) degrees: both axes are far from the seam
        {
            l.t = -l.t;
            l.offset = -l.offset;
            std::tie(l.begin, l.end) = std::pair(-l.end, -l.begin);
        }
    std::vector<Face> faces = gather(lines, cells, level, params);
    std::erase_if(faces, [&](const Face& f) { return !isWallFace(f, cells, mask); });
    for (Face& f : faces)
        f.isLow = !reachesCeiling(f, mask);
    findSides(faces, mask, params.mergeOffset_m);
    std::vector<Face> kept;
    for (const Face& f : faces)
        if (!isRecessed(f, faces) && (cells.hasLabels || !isOutside(f, mask)))
            kept.push_back(f);
    faces = std::move(kept);
    return faces;
}

}  // namespace s2b

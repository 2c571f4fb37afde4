// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/parallel_planes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace s2b
{
namespace
{

constexpr double kDegree = std::numbers::pi / 180;

double angleOf(const Eigen::Vector2d& t)
{
    return std::atan2(t.y(), t.x());
}

/// Turns the face about its middle.
void setDirection(Face& f, const Eigen::Vector2d& t)
{
    const Eigen::Vector2d middle = f.at((f.begin + f.end) / 2);
    const double half = f.length() / 2;
    const Eigen::Vector2d before = f.t;
    f.t = t;
    f.offset = f.n().dot(middle);
    const bool reversed = t.dot(before) < 0;
    f.begin = t.dot(middle) - half;
    f.end = t.dot(middle) + half;
    if (reversed)
    {
        f.side = -f.side;
        f.scannedSide = -f.scannedSide;
        std::reverse(f.rows.begin(), f.rows.end());
    }
}

/// Two faces that look away from each other, and where along them.
struct Pair
{
    std::uint32_t low = 0, high = 0;
    double begin = 0, end = 0;
};

/// Bin of a place within the face.
std::size_t binOf(const Face& face, double s)
{
    return std::min(face.rows.size() - 1, static_cast<std::size_t>(std::max(0.0, (s - face.begin) / Face::kBin_m)));
}

/// Share of the place between two faces, d apart, that shows room.
double roomBetween(const Face& low, const Face& high, double s, double d, const PlanMask& mask)
{
    const double inset = std::min(0.03, d / 4);
    const auto shareOf = [&](PlanMask::Layer layer)
    { return mask.share(low.at(s - Face::kBin_m), low.at(s + Face::kBin_m), inset, d - inset, layer); };
    // Each was scanned from its own side: a ceiling above both is what the wall doesn't reach.
    if (low.scannedSide < 0 && high.scannedSide > 0)
        return std::min(shareOf(PlanMask::Floor), shareOf(PlanMask::Ceiling));
    return shareOf(low.isLow && high.isLow ? PlanMask::Floor : mask.mainLayer());
}

bool isParallel(const Face& a, const Face& b)
{
    return std::abs(a.t.x() * b.t.y() - a.t.y() * b.t.x()) < std::sin(1.0 * kDegree);
}

}  // namespace

void alignFaces(std::vector<Face>& faces)
{
    // Heaviest first: a face joins the direction of a heavier one if its own length can't tell the two apart.
    std::vector<Eigen::Vector2d> directions{{1, 0}, {0, 1}};
    std::vector<std::uint32_t> order(faces.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b)
              { return std::tuple(-faces[a].length(), a) < std::tuple(-faces[b].length(), b); });
    for (const std::uint32_t i : order)
    {
        Face& f = faces[i];
        const double tolerance = std::clamp(std::atan(0.03 / f.length()), 0.35 * kDegree, 6.0 * kDegree);
        const Eigen::Vector2d* best = nullptr;
        double bestTurn = tolerance;
        for (const Eigen::Vector2d& d : directions)
        {
            const double turn = std::abs(std::remainder(angleOf(f.t) - angleOf(d), std::numbers::pi));
            if (turn < bestTurn)
                bestTurn = turn, best = &d;
        }
        if (!best)
        {
            directions.push_back(f.t);
            continue;
        }
        setDirection(f, *best);
    }
}

std::vector<WallBody> pairFaces(const std::vector<Face>& faces, const PlanMask& mask, const WallParams& params)
{
    constexpr double step = Face::kBin_m;
    std::vector<Pair> pairs;
    // Per face and bin: is it part of a pair already?
    std::vector<std::vector<char>> paired(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
        paired[i].assign(faces[i].rows.size(), 0);

    // First faces that look away from each other; then those of which one does and the other's side was only guessed.
    for (const bool isSecond : {false, true})
        for (std::uint32_t i = 0; i < faces.size(); ++i)
        {
            const Face& low = faces[i];
            if (low.side > 0 && !(isSecond && !low.isBesideRoom))
                continue;
            // For each place along the face: the nearest face behind it that looks the other way.
            std::map<std::uint32_t, std::vector<double>> partner;
            std::vector<std::pair<double, std::uint32_t>> behind;
            for (std::uint32_t j = 0; j < faces.size(); ++j)
            {
                const Face& high = faces[j];
                const double d = high.offset - low.offset;
                const bool lowFits = low.side < 0, highFits = high.side > 0;
                if (j == i || (high.side < 0 && !(isSecond && !high.isBesideRoom)) || (!lowFits && !highFits) ||
                    !isParallel(low, high) || d < params.minimumThickness_m || d > params.maximumThickness_m)
                    continue;
                if (std::min(low.end, high.end) - std::max(low.begin, high.begin) < 0.15)
                    continue;
                behind.emplace_back(d, j);
            }
            std::sort(behind.begin(), behind.end());
            for (std::size_t b = 0; b < low.rows.size(); ++b)
            {
                if (isSecond && paired[i][b])
                    continue;
                const double s = low.begin + (static_cast<double>(b) + 0.5) * step;
                for (const auto& [d, j] : behind)
                {
                    const Face& high = faces[j];
                    if (s < high.begin || s > high.end || (isSecond && paired[j][binOf(high, s)]))
                        continue;
                    if (d > 0.12 && roomBetween(low, high, s, d, mask) > 0.5)
                        break;  // there is room between the two: not one wall, and nothing behind it either
                    partner[j].push_back(s);
                    break;
                }
            }
            for (const auto& [j, places] : partner)
            {
                const Face& high = faces[j];
                const double overlap = static_cast<double>(places.size()) * step;
                const double possible = std::min(low.length(), high.length());
                if (overlap < 0.25 && overlap < 0.6 * possible)
                    continue;
                pairs.push_back({i, j, places.front() - step / 2, places.back() + step / 2});
                for (const double s : places)
                {
                    paired[i][binOf(low, s)] = paired[j][binOf(high, s)] = 1;
                }
            }
        }

    std::vector<WallBody> bodies;
    for (const Pair& p : pairs)
    {
        WallBody b;
        b.t = faces[p.low].t;
        b.low = faces[p.low].offset;
        b.high = faces[p.high].offset;
        b.lowSeen = b.highSeen = true;
        b.begin = p.begin;
        b.end = p.end;
        b.lowFaces = {p.low};
        b.highFaces = {p.high};
        bodies.push_back(std::move(b));
    }
    // What is left of a face continues its nearest paired stretch, or stands alone.
    for (std::uint32_t i = 0; i < faces.size(); ++i)
    {
        const Face& f = faces[i];
        for (std::size_t b = 0; b < f.rows.size();)
        {
            if (paired[i][b])
            {
                ++b;
                continue;
            }
            std::size_t e = b;
            while (e < f.rows.size() && !paired[i][e])
                ++e;
            const double begin = f.begin + static_cast<double>(b) * step,
                         end = std::min(f.end, f.begin + static_cast<double>(e) * step);
            WallBody* nearest = nullptr;
            for (std::size_t k = 0; k < pairs.size(); ++k)
                // A short pair (a pane behind an opening) says nothing of a long rest.
                if ((pairs[k].low == i || pairs[k].high == i) && bodies[k].begin < end + step &&
                    bodies[k].end > begin - step && pairs[k].end - pairs[k].begin > 0.3 * (end - begin))
                {
                    if (!nearest || bodies[k].end - bodies[k].begin > nearest->end - nearest->begin)
                        nearest = &bodies[k];
                }
            if (nearest)
                nearest->begin = std::min(nearest->begin, begin), nearest->end = std::max(nearest->end, end);
            else if (end - begin > 0.10 && f.side != 0)
            {
                WallBody w;
                w.t = f.t;
                w.low = w.high = f.offset;
                w.begin = begin;
                w.end = end;
                if (f.side < 0)
                    w.lowSeen = true, w.lowFaces = {i};
                else
                    w.highSeen = true, w.highFaces = {i};
                bodies.push_back(std::move(w));
            }
            b = e;
        }
    }
    return bodies;
}

}  // namespace s2b

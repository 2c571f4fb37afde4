// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/dbscan.h"
#include "core/openings/wall_view.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace s2b
{
namespace
{

double quantile(std::vector<double>& values, double q)
{
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

void join(Hole& a, const Hole& b)
{
    a.begin = std::min(a.begin, b.begin), a.end = std::max(a.end, b.end);
    a.bottom = std::min(a.bottom, b.bottom), a.top = std::max(a.top, b.top);
    a.points += b.points;
}

/// Share of a rectangle of the wall that is covered by wall points on its faces.
double wallShare(const WallView& view, double begin, double end, double bottom, double top)
{
    const double step = 2 * std::max(0.04, view.cell_m);
    const int columns = std::max(1, static_cast<int>((end - begin) / step)),
              rows = std::max(1, static_cast<int>((top - bottom) / step));
    std::vector<char> covered(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
    for (const WallPoint& p : view.points)
    {
        if (p.label != Label::Wall || std::abs(std::abs(p.d) - view.half_m) > 0.04)
            continue;
        const int x = static_cast<int>(std::floor((p.s - begin) / (end - begin) * columns)),
                  y = static_cast<int>(std::floor((p.z - bottom) / (top - bottom) * rows));
        if (x >= 0 && x < columns && y >= 0 && y < rows)
            covered[static_cast<std::size_t>(x) + static_cast<std::size_t>(columns) * static_cast<std::size_t>(y)] = 1;
    }
    return static_cast<double>(std::count(covered.begin(), covered.end(), 1)) / static_cast<double>(covered.size());
}

}  // namespace

std::vector<Hole> labelledHoles(const WallView& view, OpeningKind kind, double clusterRadius_m,
                                double maximumDoorWidth_m)
{
    const Label label = kind == OpeningKind::Door ? Label::Door : Label::Window;
    // Strictly inside the body: a lining on the face or a leaf beside it is no part of the hole. On a side that was not
    // seen the body may reach further than assumed.
    const double inset = std::min(0.015, view.half_m / 3), beyond = 0.15;
    std::vector<const WallPoint*> inside;
    std::vector<Eigen::Vector2d> plane;
    for (const WallPoint& p : view.points)
        if (p.label == label && p.d < view.half_m + (view.leftSeen ? -inset : beyond) &&
            p.d > -view.half_m - (view.rightSeen ? -inset : beyond))
        {
            inside.push_back(&p);
            plane.emplace_back(p.s, p.z);
        }
    const std::vector<int> id = dbscan(plane, clusterRadius_m, 4);
    std::map<int, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < id.size(); ++i)
        if (id[i] >= 0)
            members[id[i]].push_back(i);
    std::vector<Hole> holes;
    for (const auto& [k, list] : members)
    {
        std::vector<double> s, z;
        Hole h;
        for (const std::size_t i : list)
        {
            s.push_back(inside[i]->s), z.push_back(inside[i]->z);
            h.points += inside[i]->count;
        }
        h.begin = quantile(s, 0.005), h.end = quantile(s, 0.995);
        h.bottom = quantile(z, 0.005), h.top = quantile(z, 0.995);
        h.labelShare = 1.0;
        holes.push_back(h);
    }
    // Pieces of one frame, and two jambs with nothing of the wall's faces between them.
    for (bool changed = true; changed;)
    {
        changed = false;
        std::sort(holes.begin(), holes.end(), [](const Hole& a, const Hole& b)
                  { return std::tie(a.begin, a.bottom) < std::tie(b.begin, b.bottom); });
        for (std::size_t i = 0; i < holes.size() && !changed; ++i)
            for (std::size_t j = i + 1; j < holes.size() && !changed; ++j)
            {
                const Hole &a = holes[i], &b = holes[j];
                const double from = std::min(a.end, b.end), to = std::max(a.begin, b.begin);
                const double bottom = std::max(a.bottom, b.bottom), top = std::min(a.top, b.top);
                const bool jambs = kind == OpeningKind::Door && to > from && top - bottom > 0.5 &&
                                   std::max(a.end, b.end) - std::min(a.begin, b.begin) < maximumDoorWidth_m &&
                                   wallShare(view, from, to, bottom + 0.1, top - 0.2) < 0.15;
                if (a.overlaps(b) || jambs)
                {
                    join(holes[i], holes[j]);
                    holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(j));
                    changed = true;
                }
            }
    }
    return holes;
}

}  // namespace s2b

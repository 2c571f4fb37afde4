// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/openings/hole_edges.h"

#include <algorithm>
#include <cmath>

namespace s2b
{
namespace
{

double median(std::vector<double>& v)
{
    const auto at = v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2);
    std::nth_element(v.begin(), at, v.end());
    return *at;
}

}  // namespace

std::optional<double> jambNear(const WallView& view, double s, double bottom, double top, double reach)
{
    std::vector<double> at;
    for (const WallPoint& p : view.points)
        if (p.along > 0.8 && view.isInBody(p, 0.01) && std::abs(p.s - s) < reach && p.z > bottom && p.z < top &&
            (!view.hasLabels || p.label == Label::Wall || p.label == Label::Door))
            at.push_back(p.s);
    if (static_cast<double>(at.size()) * view.cell_m * view.cell_m < 0.02)
        return std::nullopt;
    return median(at);
}

std::optional<double> headNear(const WallView& view, double begin, double end, double z)
{
    std::vector<double> at;
    for (const WallPoint& p : view.points)
        if (p.upward > 0.8 && view.isInBody(p, 0.005) && p.s > begin && p.s < end && std::abs(p.z - z) < 0.12)
            at.push_back(p.z);
    if (static_cast<double>(at.size()) * view.cell_m * view.cell_m < 0.005)
        return std::nullopt;
    return median(at);
}

std::optional<double> sillAbove(const WallView& view, double begin, double end, double reach)
{
    constexpr double threshold_m = 0.04;  // lower than this one steps over it
    const double step = std::max(0.05, 1.5 * view.cell_m);
    std::vector<char> covered(static_cast<std::size_t>(std::max(1.0, std::ceil((end - begin) / step))), 0);
    std::vector<double> at;
    for (const WallPoint& p : view.points)
        if (p.upward > 0.8 && view.isInBody(p, 0.005) && p.s > begin && p.s < end && p.z > threshold_m && p.z < reach)
        {
            at.push_back(p.z);
            covered[std::min(covered.size() - 1, static_cast<std::size_t>((p.s - begin) / step))] = 1;
        }
    if (2 * std::count(covered.begin(), covered.end(), 1) < static_cast<std::ptrdiff_t>(covered.size()))
        return std::nullopt;
    return median(at);
}

double faceEdge(const WallView& view, double s, bool holeIsRight, double bottom, double top)
{
    std::vector<double> at;
    for (const WallPoint& p : view.points)
        if (std::abs(std::abs(p.d) - view.half_m) < 0.03 && p.z > bottom && p.z < top && std::abs(p.s - s) < 0.15 &&
            (!view.hasLabels || p.label == Label::Wall))
            at.push_back(holeIsRight ? p.s : -p.s);
    if (at.size() < 10)
        return s;
    const auto high = at.begin() + static_cast<std::ptrdiff_t>(0.97 * static_cast<double>(at.size() - 1));
    std::nth_element(at.begin(), high, at.end());
    return holeIsRight ? *high : -*high;
}

}  // namespace s2b

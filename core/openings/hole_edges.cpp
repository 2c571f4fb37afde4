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

/// An edge of a hole in one face: `outward` is the coordinate that leaves the hole there, `beside` the other one.
struct EdgeSearch
{
    double at = 0;            ///< the edge so far, along `outward`
    double from = 0, to = 0;  ///< its extent, along `beside`
    double (*outward)(const WallPoint&) = nullptr;
    double (*beside)(const WallPoint&) = nullptr;
};

/// Where one face begins beyond an edge, or nothing where it was not seen along most of it or is hidden in part.
std::optional<double> faceBeyond(const WallView& view, bool left, const EdgeSearch& e)
{
    constexpr double reach_m = 0.25, onFace_m = 0.025, inFront_m = 0.10, within_m = 0.02;
    const double step = std::max(0.05, 1.5 * view.cell_m);
    const auto rows = static_cast<std::size_t>((e.to - e.from) / step);
    if (rows < 4)
        return std::nullopt;
    constexpr double none = 1e9;
    std::vector<double> nearest(rows, none), front(rows, none);
    for (const WallPoint& p : view.points)
    {
        const double row = (e.beside(p) - e.from) / step, out = e.outward(p), off = (left ? p.d : -p.d) - view.half_m;
        if (row < 0 || row >= static_cast<double>(rows) || out < e.at - within_m || out > e.at + reach_m)
            continue;
        const auto k = static_cast<std::size_t>(row);
        if (std::abs(off) < onFace_m && p.across > 0.7)
            nearest[k] = std::min(nearest[k], out);
        else if (off >= onFace_m && off < inFront_m)
            front[k] = std::min(front[k], out);
    }
    std::vector<double> at;
    std::size_t hidden = 0;
    for (std::size_t k = 0; k < rows; ++k)
    {
        if (nearest[k] < none)
            at.push_back(nearest[k]);
        hidden += front[k] < std::min(nearest[k], e.at + reach_m);
    }
    if (10 * at.size() < 6 * rows || 10 * hidden > 3 * rows)
        return std::nullopt;
    // A cell's centroid lies behind its edge: of the rows, the nearer ones.
    const auto quarter = at.begin() + static_cast<std::ptrdiff_t>(at.size() / 4);
    std::nth_element(at.begin(), quarter, at.end());
    return *quarter;
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

Hole grownToFaces(const WallView& view, const Hole& hole)
{
    const double s0 = hole.begin + 0.1 * hole.width(), s1 = hole.end - 0.1 * hole.width();
    const double z0 = hole.bottom + 0.1 * hole.height(), z1 = hole.top - 0.1 * hole.height();
    const auto right = [](const WallPoint& p) { return p.s; };
    const auto left = [](const WallPoint& p) { return -p.s; };
    const auto up = [](const WallPoint& p) { return p.z; };
    const auto down = [](const WallPoint& p) { return -p.z; };
    Hole grown = hole;
    for (const bool side : {true, false})
    {
        if (!(side ? view.leftSeen : view.rightSeen))
            continue;
        if (const auto at = faceBeyond(view, side, {-hole.begin, z0, z1, left, up}))
            grown.begin = std::min(grown.begin, -*at);
        if (const auto at = faceBeyond(view, side, {hole.end, z0, z1, right, up}))
            grown.end = std::max(grown.end, *at);
        if (const auto at = faceBeyond(view, side, {hole.top, s0, s1, up, right}))
            grown.top = std::max(grown.top, *at);
        if (const auto at = faceBeyond(view, side, {-hole.bottom, s0, s1, down, right}))
            grown.bottom = std::min(grown.bottom, -*at);
    }
    return grown;
}

}  // namespace s2b

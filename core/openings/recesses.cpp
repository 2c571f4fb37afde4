// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/openings/hole_edges.h"
#include "core/openings/wall_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace s2b
{
namespace
{

/// Squares of one face: seen, or something seen behind it within the wall's depth.
struct Raster
{
    double step = 0.05, begin = 0;
    int columns = 0, rows = 0;
    std::vector<char> face, behind;

    [[nodiscard]] std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(x) + static_cast<std::size_t>(columns) * static_cast<std::size_t>(y);
    }
};

Raster rasterOf(const WallView& view, bool left, const std::vector<Hole>& taken)
{
    Raster r;
    r.step = std::max(0.05, 1.5 * view.cell_m);
    r.begin = view.wall->bodyStart_m;
    r.columns = std::max(1, static_cast<int>(std::ceil((view.wall->bodyEnd_m - r.begin) / r.step)));
    r.rows = std::max(1, static_cast<int>(std::ceil(view.wall->height.value_m / r.step)));
    r.face.assign(static_cast<std::size_t>(r.columns) * static_cast<std::size_t>(r.rows), 0);
    r.behind = r.face;
    const double otherBeyond = (left ? view.rightSeen : view.leftSeen) ? 0.03 : 0.15;
    for (const WallPoint& p : view.points)
    {
        const int x = static_cast<int>(std::floor((p.s - r.begin) / r.step)),
                  y = static_cast<int>(std::floor(p.z / r.step));
        if (x < 0 || x >= r.columns || y < 0 || y >= r.rows)
            continue;
        const double depth = left ? view.half_m - p.d : p.d + view.half_m;
        if (std::abs(depth) < 0.025 && p.across > 0.7)
            r.face[r.at(x, y)] = 1;
        else if (depth > 0.025 && depth < 2 * view.half_m + otherBeyond)
            r.behind[r.at(x, y)] = 1;
    }
    for (const Hole& h : taken)
        for (int x = 0; x < r.columns; ++x)
            for (int y = 0; y < r.rows; ++y)
                if (const double s = r.begin + (x + 0.5) * r.step, z = (y + 0.5) * r.step;
                    s > h.begin && s < h.end && z > h.bottom && z < h.top)
                    r.face[r.at(x, y)] = 1;
    // Single squares missed between points are no holes.
    const std::vector<char> once = r.face;
    for (int y = 0; y < r.rows; ++y)
        for (int x = 0; x < r.columns; ++x)
        {
            const auto seen = [&](int dx, int dy)
            {
                return x + dx < 0 || x + dx >= r.columns || y + dy < 0 || y + dy >= r.rows ||
                       once[r.at(x + dx, y + dy)];
            };
            if ((seen(-1, 0) && seen(1, 0)) || (seen(0, -1) && seen(0, 1)))
                r.face[r.at(x, y)] = 1;
        }
    return r;
}

/// A connected region of missing face, as its box of squares [x0, x1) x [y0, y1).
struct Region
{
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    std::vector<std::pair<int, int>> squares;
};

std::vector<Region> missingRegions(const Raster& r)
{
    std::vector<Region> regions;
    std::vector<char> visited = r.face;
    std::vector<std::pair<int, int>> stack;
    for (int y = 0; y < r.rows; ++y)
        for (int x = 0; x < r.columns; ++x)
        {
            if (visited[r.at(x, y)])
                continue;
            Region region{x, x + 1, y, y + 1, {}};
            stack.assign(1, {x, y});
            visited[r.at(x, y)] = 1;
            while (!stack.empty())
            {
                const auto [u, v] = stack.back();
                stack.pop_back();
                region.squares.emplace_back(u, v);
                region.x0 = std::min(region.x0, u), region.x1 = std::max(region.x1, u + 1);
                region.y0 = std::min(region.y0, v), region.y1 = std::max(region.y1, v + 1);
                for (const auto& [dx, dy] : std::array<std::pair<int, int>, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}})
                {
                    const int a = u + dx, b = v + dy;
                    if (a >= 0 && a < r.columns && b >= 0 && b < r.rows && !visited[r.at(a, b)])
                    {
                        visited[r.at(a, b)] = 1;
                        stack.emplace_back(a, b);
                    }
                }
            }
            regions.push_back(region);
        }
    return regions;
}

/// Share of a box's squares that show something behind the face.
double behindShare(const Raster& r, int x0, int x1, int y0, int y1)
{
    int hits = 0, all = 0;
    for (int y = std::max(0, y0); y < std::min(r.rows, y1); ++y)
        for (int x = std::max(0, x0); x < std::min(r.columns, x1); ++x)
            hits += r.behind[r.at(x, y)], ++all;
    return all ? static_cast<double>(hits) / all : 0.0;
}

/// Share of the squares along a line of the box that has something behind it within two squares.
double edgeShare(const Raster& r, const Region& g, int side)
{
    const bool vertical = side < 2;
    const int length = vertical ? g.y1 - g.y0 : g.x1 - g.x0;
    int hits = 0;
    for (int i = 0; i < length; ++i)
    {
        bool hit = false;
        for (int k = -1; k < 2 && !hit; ++k)
        {
            const int x = side == 0 ? g.x0 + k : (side == 1 ? g.x1 - 1 - k : g.x0 + i);
            const int y = vertical ? g.y0 + i : (side == 2 ? g.y0 + k : g.y1 - 1 - k);
            hit = x >= 0 && x < r.columns && y >= 0 && y < r.rows && r.behind[r.at(x, y)];
        }
        hits += hit;
    }
    return static_cast<double>(hits) / std::max(1, length);
}

/// Shrinks the region to the box of what was seen behind: furniture in front of a wall hides more than its window.
void trimHidden(const Raster& r, Region& g)
{
    std::vector<int> columns(static_cast<std::size_t>(r.columns), 0), rows(static_cast<std::size_t>(r.rows), 0);
    for (const auto& [x, y] : g.squares)
        if (r.behind[r.at(x, y)])
            ++columns[static_cast<std::size_t>(x)], ++rows[static_cast<std::size_t>(y)];
    // Jambs, sill and head fill their column or row; stray points don't.
    const auto shrink = [](const std::vector<int>& counts, int& from, int& to, int least)
    {
        while (from < to && counts[static_cast<std::size_t>(from)] < least)
            ++from;
        while (to > from && counts[static_cast<std::size_t>(to - 1)] < least)
            --to;
    };
    const int leastInColumn = std::max(2, (g.y1 - g.y0) / 6), leastInRow = std::max(2, (g.x1 - g.x0) / 6);
    shrink(columns, g.x0, g.x1, leastInColumn);
    shrink(rows, g.y0, g.y1, leastInRow);
    std::erase_if(g.squares, [&](const auto& q)
                  { return q.first < g.x0 || q.first >= g.x1 || q.second < g.y0 || q.second >= g.y1; });
}

}  // namespace

std::vector<Hole> recessedHoles(const WallView& view, const std::vector<Hole>& taken, double minimumWidth_m,
                                double maximumWidth_m, double minimumHeight_m)
{
    std::vector<Hole> holes;
    for (const bool left : {true, false})
    {
        if (!(left ? view.leftSeen : view.rightSeen))
            continue;
        std::vector<Hole> known = taken;
        known.insert(known.end(), holes.begin(), holes.end());
        const Raster r = rasterOf(view, left, known);
        for (Region g : missingRegions(r))
        {
            trimHidden(r, g);
            const double width = (g.x1 - g.x0) * r.step, height = (g.y1 - g.y0) * r.step;
            const double fill = static_cast<double>(g.squares.size()) / std::max(1, (g.x1 - g.x0) * (g.y1 - g.y0));
            if (width < minimumWidth_m || width > maximumWidth_m || height < minimumHeight_m || fill < 0.7)
                continue;
            // A shadow has nothing behind it; a hole shows its reveals, frame, pane or leaf, on most of its sides.
            int sides = 0;
            for (int side = 0; side < 4; ++side)
                sides += edgeShare(r, g, side) > 0.4;
            if (sides < 3 || behindShare(r, g.x0, g.x1, g.y0, g.y1) < 0.12)
                continue;
            Hole h;
            h.begin = r.begin + g.x0 * r.step, h.end = r.begin + g.x1 * r.step;
            h.bottom = g.y0 * r.step, h.top = g.y1 * r.step;
            const double low = h.bottom + 0.1 * height, high = h.top - 0.1 * height;
            const std::optional<double> begin = jambNear(view, h.begin, low, high, 0.10),
                                        end = jambNear(view, h.end, low, high, 0.10),
                                        head = headNear(view, h.begin + 0.05, h.end - 0.05, h.top);
            // Furniture hides one face and leaves the other; only a hole has jambs and a head.
            if (begin.has_value() + end.has_value() + head.has_value() < 2)
                continue;
            // At the wall's end the face may just not have been seen; above a window there is some of it.
            if ((g.x0 == 0 || g.x1 == r.columns) && !(begin && end && head && g.y1 + 1 < r.rows))
                continue;
            h.begin = begin.value_or(faceEdge(view, h.begin, true, low, high));
            h.end = end.value_or(faceEdge(view, h.end, false, low, high));
            h.top = head.value_or(h.top);
            if (g.y0 > 1)
                h.bottom = headNear(view, h.begin + 0.05, h.end - 0.05, h.bottom).value_or(h.bottom);
            else
                h.bottom = sillAbove(view, h.begin + 0.05, h.end - 0.05, 0.3).value_or(0.0);
            h.points = g.squares.size();
            if (h.width() >= minimumWidth_m && h.height() >= minimumHeight_m)
                holes.push_back(h);
        }
    }
    return holes;
}

}  // namespace s2b

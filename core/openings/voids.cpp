// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/openings/hole_edges.h"
#include "core/openings/openings.h"
#include "core/openings/wall_view.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace s2b
{
namespace
{

/// Which squares of a wall's faces were seen; both faces together, as a hole is missing in both.
class FaceRaster
{
public:
    FaceRaster(const WallView& view, const std::vector<Hole>& taken)
        : m_step(std::max(0.04, 1.5 * view.cell_m)),
          m_begin(view.wall->bodyStart_m),
          m_columns(std::max(1, static_cast<int>(std::ceil((view.wall->bodyEnd_m - m_begin) / m_step)))),
          m_rows(std::max(1, static_cast<int>(std::ceil(view.wall->height.value_m / m_step)))),
          m_covered(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows), 0)
    {
        for (const WallPoint& p : view.points)
        {
            if (std::abs(std::abs(p.d) - view.half_m) > 0.03 || p.across < 0.7 ||
                (view.hasLabels && p.label != Label::Wall))
                continue;
            const int x = static_cast<int>(std::floor((p.s - m_begin) / m_step)),
                      y = static_cast<int>(std::floor(p.z / m_step));
            if (x >= 0 && x < m_columns && y >= 0 && y < m_rows)
                m_covered[at(x, y)] = 1;
        }
        // A hole that is known already is no part of another.
        for (const Hole& h : taken)
            for (int x = 0; x < m_columns; ++x)
                if (const double centre = s(x) + m_step / 2; centre > h.begin && centre < h.end)
                    for (int y = 0; y < m_rows; ++y)
                        if (y * m_step > h.bottom - m_step && y * m_step < h.top)
                            m_covered[at(x, y)] = 1;
    }
    [[nodiscard]] int columns() const { return m_columns; }
    [[nodiscard]] double s(int column) const { return m_begin + m_step * column; }
    /// Height up to which nothing of the faces was seen above 0.1 m; a stray square does not end it.
    [[nodiscard]] double openUpTo(int column) const
    {
        for (int y = static_cast<int>(0.1 / m_step) + 1; y < m_rows; ++y)
            if (m_covered[at(column, y)] && (y + 1 >= m_rows || m_covered[at(column, y + 1)]))
                return y * m_step;
        return m_rows * m_step;
    }

private:
    [[nodiscard]] std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(x) + static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(y);
    }
    double m_step, m_begin;
    int m_columns, m_rows;
    std::vector<char> m_covered;
};

/// Door points within a leaf's reach outside the body.
bool leafBeside(const WallView& view, const Hole& h)
{
    double cells = 0;
    for (const WallPoint& p : view.points)
        cells += p.label == Label::Door && p.s > h.begin - h.width() - 0.1 && p.s < h.end + h.width() + 0.1 &&
                 std::abs(p.d) < view.half_m + h.width() + 0.1 && p.z < h.top + 0.1;
    return cells * view.cell_m * view.cell_m > 0.2 * h.width() * h.height();
}

}  // namespace

std::vector<Hole> voidsFromFloor(const WallView& view, const std::vector<Hole>& taken,
                                 const std::function<double(double, double)>& floorSeen, const OpeningParams& params)
{
    const double minimumWidth_m = params.minimumDoorWidth_m, maximumWidth_m = params.maximumDoorWidth_m,
                 minimumHeight_m = params.minimumDoorHeight_m;
    std::vector<Hole> holes;
    if (!view.leftSeen && !view.rightSeen)
        return holes;
    const FaceRaster raster(view, taken);
    for (int c = 0; c < raster.columns();)
    {
        if (raster.openUpTo(c) < minimumHeight_m)
        {
            ++c;
            continue;
        }
        int e = c, last = c;
        std::vector<double> tops;
        for (; e < raster.columns() && e - last <= 1; ++e)
            if (const double top = raster.openUpTo(e); top >= minimumHeight_m)
                last = e, tops.push_back(top);
        Hole h;
        h.begin = raster.s(c), h.end = raster.s(last + 1);
        std::nth_element(tops.begin(), tops.begin() + static_cast<std::ptrdiff_t>(tops.size() / 2), tops.end());
        h.top = tops[tops.size() / 2];
        c = last + 1;
        // At the wall's ends, where another wall takes over, the faces end as well.
        if (h.begin < view.wall->bodyStart_m + 0.02 || h.end > view.wall->bodyEnd_m - 0.02 ||
            h.width() < minimumWidth_m - 0.1 || h.width() > maximumWidth_m + 0.1)
            continue;
        const double low = 0.2, high = h.top - 0.15;
        const std::optional<double> left = jambNear(view, h.begin, low, high, 0.12),
                                    right = jambNear(view, h.end, low, high, 0.12);
        const std::optional<double> head = headNear(view, h.begin + 0.05, h.end - 0.05, h.top);
        // Open is what was seen through: the floor runs on through the wall, jambs and head show the wall's depth, or a
        // leaf stands beside it. One sign alone may be a shadow.
        const bool floorRunsOn = floorSeen(h.begin + 0.1, h.end - 0.1) > 0.25 ||
                                 view.through.share(h.begin + 0.1, h.end - 0.1, low, high) > params.minimumSeenThrough;
        const int signs =
            2 * floorRunsOn + left.has_value() + right.has_value() + head.has_value() + leafBeside(view, h);
        // Below a window the wall may be hidden by furniture: a doorway shows its jambs down to the floor.
        const bool reachesFloor =
            floorRunsOn || jambNear(view, h.begin, 0.1, 0.7, 0.12) || jambNear(view, h.end, 0.1, 0.7, 0.12);
        if (signs < 2 || (!view.hasLabels && (!reachesFloor || sillAbove(view, h.begin + 0.1, h.end - 0.1, 0.3))))
            continue;
        h.begin = left.value_or(faceEdge(view, h.begin, true, low, high));
        h.end = right.value_or(faceEdge(view, h.end, false, low, high));
        h.top = head.value_or(h.top);
        if (h.width() >= minimumWidth_m && h.width() <= maximumWidth_m)
            holes.push_back(h);
    }
    return holes;
}

}  // namespace s2b

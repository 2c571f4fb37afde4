// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/openings/seen_through.h"

#include "core/model/wall_axis.h"

#include <algorithm>
#include <cmath>

namespace s2b
{
namespace
{

constexpr double kReach_m = 25.0;   // from further away the map's squares are as wide as a jamb is deep
constexpr double kBeyond_m = 0.10;  // past the far face: not the face itself, with its noise
constexpr int kNear = 2;            // squares

}  // namespace

SeenThrough::SeenThrough(const Wall& wall, const Sightlines& sightlines) : m_begin(wall.bodyStart_m)
{
    if (sightlines.empty())
        return;
    m_columns = std::max(1, static_cast<int>(std::ceil((wall.bodyEnd_m - m_begin) / kStep_m)));
    m_rows = std::max(1, static_cast<int>(std::ceil(wall.height.value_m / kStep_m)));
    m_passed.assign(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows), 0);
    const WallAxis axis(wall);
    const Eigen::Vector2d middle = axis.at((wall.bodyStart_m + wall.bodyEnd_m) / 2);
    const auto stations =
        sightlines.near({middle.x(), middle.y(), wall.base_m + 1.5}, kReach_m + (wall.bodyEnd_m - m_begin) / 2);
    for (int x = 0; x < m_columns; ++x)
    {
        const double s = m_begin + (x + 0.5) * kStep_m;
        const Eigen::Vector2d p = axis.at(s), n = axis.normal(s);
        for (int y = 0; y < m_rows; ++y)
            m_passed[static_cast<std::size_t>(x) + static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(y)] =
                sightlines.passed({p.x(), p.y(), wall.base_m + (y + 0.5) * kStep_m}, {n.x(), n.y(), 0.0},
                                  wall.thickness.value_m / 2 + kBeyond_m, stations);
    }
}

bool SeenThrough::isNear(int x, int y) const
{
    for (int v = std::max(0, y - kNear); v <= std::min(m_rows - 1, y + kNear); ++v)
        for (int u = std::max(0, x - kNear); u <= std::min(m_columns - 1, x + kNear); ++u)
            if (m_passed[static_cast<std::size_t>(u) +
                         static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(v)])
                return true;
    return false;
}

double SeenThrough::share(double begin, double end, double bottom, double top) const
{
    const int x0 = std::max(0, static_cast<int>(std::floor((begin - m_begin) / kStep_m))),
              x1 = std::min(m_columns, static_cast<int>(std::ceil((end - m_begin) / kStep_m))),
              y0 = std::max(0, static_cast<int>(std::floor(bottom / kStep_m))),
              y1 = std::min(m_rows, static_cast<int>(std::ceil(top / kStep_m)));
    int hits = 0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            hits += isNear(x, y);
    return x1 > x0 && y1 > y0 ? static_cast<double>(hits) / ((x1 - x0) * (y1 - y0)) : 0.0;
}

}  // namespace s2b

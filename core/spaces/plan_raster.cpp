// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spaces/plan_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace s2b
{
namespace
{

constexpr double kPixel_m = 0.05;
constexpr double kRim_m = 1.0;
constexpr double kMostPixels = 4e6;  // a site of 100 m by 100 m in full resolution
constexpr double kHead_m = 1.9;      // what is higher above the floor is overhead

std::uint8_t layersOf(const SurfaceCells& cells, const SurfaceCell& c, const Level& level)
{
    const double nz = std::abs(static_cast<double>(c.normal.z()));
    const double z = static_cast<double>(c.position.z());
    if (nz < 0.4 || z < level.floor_m - 0.10)
        return 0;
    if (cells.hasLabels && (c.label == Label::Wall || c.label == Label::Window || c.label == Label::Door ||
                            c.label == Label::Furniture || c.label == Label::Column))
        return 0;
    if (z < level.floor_m + 0.10)
        return nz > 0.9 ? kFloorLayer : 0;
    if (z < level.floor_m + kHead_m)
    {
        if (nz > 0.9)
            return kBetweenLayer;
        // The low end of a pitched roof is overhead as well.
        return !level.ceilingSeen && z > level.floor_m + 1.4 ? kCeilingLayer | kCoverLayer : 0;
    }
    // The next storey's floor is seen from above and says nothing of this one.
    return z < level.ceiling_m + (level.ceilingSeen ? 0.08 : 0.4) ? kCeilingLayer | kCoverLayer : kCoverLayer;
}

/// Sets a pixel when any within `reach` of it in its row (step 1) or column (step width) has the value `wanted`.
void spread(const PlanBits& from, PlanBits& to, std::size_t lines, std::size_t lineStep, std::size_t length, std::size_t step,
            int reach, bool wanted)
{
    const auto r = static_cast<std::ptrdiff_t>(reach);
    for (std::size_t line = 0; line < lines; ++line)
    {
        std::ptrdiff_t last = -r - 1;  // the last wanted pixel before i + r
        const std::size_t begin = line * lineStep;
        const auto n = static_cast<std::ptrdiff_t>(length);
        for (std::ptrdiff_t ahead = 0; ahead < n + r; ++ahead)
        {
            if (ahead < n && (from[begin + static_cast<std::size_t>(ahead) * step] != 0) == wanted)
                last = ahead;
            const std::ptrdiff_t i = ahead - r;
            if (i >= 0)
                to[begin + static_cast<std::size_t>(i) * step] = (last >= i - r) == wanted;
        }
    }
}

PlanBits spreadBothWays(const PlanBits& bits, const PlanGrid& grid, int reach, bool wanted)
{
    PlanBits rows(bits.size()), all(bits.size());
    const auto w = static_cast<std::size_t>(grid.width), h = static_cast<std::size_t>(grid.height);
    spread(bits, rows, h, w, w, 1, reach, wanted);
    spread(rows, all, w, 1, h, w, reach, wanted);
    return all;
}

}  // namespace

std::size_t PlanGrid::find(const Eigen::Vector2d& p) const
{
    const Eigen::Array2d i = ((p - low) / pixel_m).array().floor();
    if (!(i.x() >= 0 && i.y() >= 0 && i.x() < width && i.y() < height))
        return size();
    return at(static_cast<int>(i.x()), static_cast<int>(i.y()));
}

int PlanGrid::reach(double metres) const { return std::max(1, static_cast<int>(std::lround(metres / pixel_m))); }

PlanGrid planGridOf(const SurfaceCells& cells)
{
    PlanGrid grid;
    if (cells.cells.empty())
        return grid;
    Eigen::Vector2f low = Eigen::Vector2f::Constant(std::numeric_limits<float>::infinity()), high = -low;
    for (const SurfaceCell& c : cells.cells)
    {
        low = low.cwiseMin(c.position.head<2>());
        high = high.cwiseMax(c.position.head<2>());
    }
    const Eigen::Vector2d extent = (high - low).cast<double>() + Eigen::Vector2d::Constant(2 * kRim_m);
    grid.pixel_m = std::max({kPixel_m, 2 * cells.size_m, std::sqrt(extent.prod() / kMostPixels)});
    grid.low = low.cast<double>() - Eigen::Vector2d::Constant(kRim_m);
    const Eigen::Vector2i size = (extent / grid.pixel_m).array().ceil().cast<int>();
    grid.width = size.x();
    grid.height = size.y();
    return grid;
}

PlanBits rasterOf(const SurfaceCells& cells, const Level& level, const PlanGrid& grid)
{
    PlanBits bits(grid.size(), 0);
    for (const SurfaceCell& c : cells.cells)
        if (const std::uint8_t layers = layersOf(cells, c, level))
            if (const std::size_t i = grid.find(c.position.head<2>().cast<double>()); i < bits.size())
                bits[i] |= layers;
    return bits;
}

void forEachPixel(const Polygon& polygon, const PlanGrid& grid, const std::function<void(std::size_t)>& visit)
{
    if (polygon.outer.empty())
        return;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Eigen::Vector2d& p : polygon.outer)
        low = std::min(low, p.y()), high = std::max(high, p.y());
    const auto row = [&](double y) { return static_cast<int>(std::floor((y - grid.low.y()) / grid.pixel_m)); };
    std::vector<double> crossings;
    for (int y = std::max(0, row(low)); y <= std::min(grid.height - 1, row(high)); ++y)
    {
        const double at = grid.low.y() + (y + 0.5) * grid.pixel_m;
        crossings.clear();
        const auto cross = [&](const std::vector<Eigen::Vector2d>& ring)
        {
            for (std::size_t i = 0; i < ring.size(); ++i)
            {
                const Eigen::Vector2d& a = ring[i];
                const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
                if ((a.y() > at) != (b.y() > at))
                    crossings.push_back(a.x() + (at - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
            }
        };
        cross(polygon.outer);
        for (const auto& hole : polygon.holes)
            cross(hole);
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        {
            const auto column = [&](double x) { return static_cast<int>(std::ceil((x - grid.low.x()) / grid.pixel_m - 0.5)); };
            for (int x = std::max(0, column(crossings[k])); x < std::min(grid.width, column(crossings[k + 1])); ++x)
                visit(grid.at(x, y));
        }
    }
}

PlanBits dilated(const PlanBits& bits, const PlanGrid& grid, int reach) { return spreadBothWays(bits, grid, reach, true); }

PlanBits eroded(const PlanBits& bits, const PlanGrid& grid, int reach) { return spreadBothWays(bits, grid, reach, false); }

}  // namespace s2b

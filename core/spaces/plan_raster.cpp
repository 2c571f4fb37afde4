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
constexpr double kMostPixels = 2e6;    // a site of 70 m by 70 m in full resolution
constexpr double kFloorBand_m = 0.07;  // thinner than a slab, so that its underside is not taken for it
constexpr double kHead_m = 1.9;        // what is higher above the floor is overhead

/// Whether a cell says something of a room's floor or ceiling.
bool isOfRoom(const PlanCells& cells, const PlanCell& c)
{
    return !cells.hasLabels || (c.label != Label::Wall && c.label != Label::Window && c.label != Label::Door &&
                                c.label != Label::Furniture && c.label != Label::Column);
}

/// A pitched roof, down to where it meets the floor. Below the height of heads it has to be smooth: furniture slopes
/// too.
bool isSlope(const PlanCell& c, const Level& level)
{
    const double z = static_cast<double>(c.z), above = z - level.floor_m;
    return !level.ceilingSeen && c.upward < 0.97f && above > 0.2 && z < level.ceiling_m + 0.4 &&
           (above > 1.4 || c.isSmooth);
}

std::uint8_t layersOf(const PlanCells& cells, const PlanCell& c, const Level& level)
{
    const double z = static_cast<double>(c.z);
    if (z < level.floor_m - kFloorBand_m || !isOfRoom(cells, c))
        return 0;
    if (z < level.floor_m + kFloorBand_m)
        return c.upward > 0.9f ? kFloorLayer : 0;
    if (isSlope(c, level))
        return kCeilingLayer | kCoverLayer;
    if (z < level.floor_m + kHead_m)
        return c.upward > 0.9f ? kBetweenLayer : 0;
    // The next storey's floor is seen from above and says nothing of this one.
    return z < level.ceiling_m + (level.ceilingSeen ? 0.08 : 0.4) ? kCeilingLayer | kCoverLayer : kCoverLayer;
}

/// Sets a pixel when any within `reach` of it in its row has the value `wanted`.
void spreadAlongRows(const PlanBits& from, PlanBits& to, const PlanGrid& grid, int reach, bool wanted)
{
    for (int y = 0; y < grid.height; ++y)
    {
        int last = -reach - 1;  // the last wanted pixel up to x + reach
        for (int ahead = 0; ahead < grid.width + reach; ++ahead)
        {
            if (ahead < grid.width && (from[grid.at(ahead, y)] != 0) == wanted)
                last = ahead;
            if (ahead >= reach)
                to[grid.at(ahead - reach, y)] = (last >= ahead - 2 * reach) == wanted;
        }
    }
}

/// The same along columns; row by row, as they lie in memory.
void spreadAlongColumns(const PlanBits& from, PlanBits& to, const PlanGrid& grid, int reach, bool wanted)
{
    std::vector<int> last(static_cast<std::size_t>(grid.width), -reach - 1);
    for (int ahead = 0; ahead < grid.height + reach; ++ahead)
        for (int x = 0; x < grid.width; ++x)
        {
            int& seen = last[static_cast<std::size_t>(x)];
            if (ahead < grid.height && (from[grid.at(x, ahead)] != 0) == wanted)
                seen = ahead;
            if (ahead >= reach)
                to[grid.at(x, ahead - reach)] = (seen >= ahead - 2 * reach) == wanted;
        }
}

PlanBits spreadBothWays(const PlanBits& bits, const PlanGrid& grid, int reach, bool wanted)
{
    PlanBits rows(bits.size()), all(bits.size());
    spreadAlongRows(bits, rows, grid, reach, wanted);
    spreadAlongColumns(rows, all, grid, reach, wanted);
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

int PlanGrid::reach(double metres) const
{
    return std::max(1, static_cast<int>(std::lround(metres / pixel_m)));
}

PlanCells planCellsOf(const SurfaceCells& cells)
{
    PlanCells result;
    result.size_m = cells.size_m;
    result.hasLabels = cells.labelsAreSure();
    if (cells.cells.empty())
        return result;
    Eigen::Vector2f low = Eigen::Vector2f::Constant(std::numeric_limits<float>::infinity()), high = -low;
    for (const SurfaceCell& c : cells.cells)
    {
        low = low.cwiseMin(c.position.head<2>());
        high = high.cwiseMax(c.position.head<2>());
    }
    const Eigen::Vector2d extent = (high - low).cast<double>() + Eigen::Vector2d::Constant(2 * kRim_m);
    PlanGrid& grid = result.grid;
    grid.pixel_m = std::max({kPixel_m, 2 * cells.size_m, std::sqrt(extent.prod() / kMostPixels)});
    grid.low = low.cast<double>() - Eigen::Vector2d::Constant(kRim_m);
    const Eigen::Vector2i size = (extent / grid.pixel_m).array().ceil().cast<int>();
    grid.width = size.x();
    grid.height = size.y();
    const float smooth = static_cast<float>(0.35 * cells.size_m);
    for (const SurfaceCell& c : cells.cells)
        if (const float upward = std::abs(c.normal.z()); upward >= 0.4f)
            if (const std::size_t i = grid.find(c.position.head<2>().cast<double>()); i < grid.size())
                result.cells.push_back(
                    {static_cast<std::uint32_t>(i), c.position.z(), c.count, upward, c.label, c.flatness < smooth});
    return result;
}

PlanBits rasterOf(const PlanCells& cells, const Level& level)
{
    PlanBits bits(cells.grid.size(), 0);
    for (const PlanCell& c : cells.cells)
        bits[c.pixel] |= layersOf(cells, c, level);
    return bits;
}

std::vector<float> slopesOf(const PlanCells& cells, const Level& level)
{
    if (level.ceilingSeen)
        return {};
    std::vector<float> lowest(cells.grid.size(), std::numeric_limits<float>::quiet_NaN());
    for (const PlanCell& c : cells.cells)
        if (isOfRoom(cells, c) && isSlope(c, level))
            lowest[c.pixel] = std::fmin(lowest[c.pixel], c.z);
    return lowest;
}

std::vector<PixelSpan> pixelsOf(const Polygon& polygon, const PlanGrid& grid)
{
    std::vector<PixelSpan> spans;
    if (polygon.outer.empty())
        return spans;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Eigen::Vector2d& p : polygon.outer)
        low = std::min(low, p.y()), high = std::max(high, p.y());
    const auto row = [&](double y) { return static_cast<int>(std::floor((y - grid.low.y()) / grid.pixel_m)); };
    const auto column = [&](double x) { return static_cast<int>(std::ceil((x - grid.low.x()) / grid.pixel_m - 0.5)); };
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
            const int begin = std::max(0, column(crossings[k])), end = std::min(grid.width, column(crossings[k + 1]));
            if (begin < end)
                spans.push_back({grid.at(begin, y), grid.at(begin, y) + static_cast<std::size_t>(end - begin)});
        }
    }
    return spans;
}

PlanBits dilated(const PlanBits& bits, const PlanGrid& grid, int reach)
{
    return spreadBothWays(bits, grid, reach, true);
}

PlanBits eroded(const PlanBits& bits, const PlanGrid& grid, int reach)
{
    return spreadBothWays(bits, grid, reach, false);
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spaces/room_heights.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace s2b
{
namespace
{

constexpr double kBin_m = 0.01;
constexpr double kBand_m = 0.03;  // half of the height range that is one ceiling
constexpr double kFloorBand_m = 0.06;
constexpr double kHead_m = 1.9;
constexpr double kCeilingShare = 1.0 / 3;  // of a room's plan, for its ceiling to be called seen

/// The cells of a height range of kBin_m.
struct Bin
{
    double cells = 0, sum = 0, square = 0;  ///< number, and moments of their heights above the histogram's foot

    void add(double z)
    {
        cells += 1;
        sum += z;
        square += z * z;
    }
    void add(const Bin& other)
    {
        cells += other.cells;
        sum += other.sum;
        square += other.square;
    }
};

struct Heights
{
    std::vector<Bin> floor, overhead;
    std::size_t pixels = 0;
};

/// Mean height within the band about the fullest place of a histogram, and how much of it there is.
struct Peak
{
    double z = 0, rms = 0;
    double cells = 0;
};

Peak peakOf(const std::vector<Bin>& bins, double low)
{
    const int reach = static_cast<int>(std::lround(kBand_m / kBin_m));
    const int n = static_cast<int>(bins.size());
    Bin fullest;
    for (int i = 0; i < n; ++i)
    {
        Bin band;
        for (int k = std::max(0, i - reach); k <= std::min(n - 1, i + reach); ++k)
            band.add(bins[static_cast<std::size_t>(k)]);
        if (band.cells > fullest.cells)
            fullest = band;
    }
    Peak peak;
    if (fullest.cells == 0)
        return peak;
    const double mean = fullest.sum / fullest.cells;
    peak.z = low + mean;
    peak.rms = std::sqrt(std::max(0.0, fullest.square / fullest.cells - mean * mean));
    peak.cells = fullest.cells;
    return peak;
}

bool isSurfaceOfRoom(const PlanCells& cells, const PlanCell& c)
{
    if (c.upward < 0.9f)
        return false;
    return !cells.hasLabels || (c.label != Label::Wall && c.label != Label::Window && c.label != Label::Door &&
                                c.label != Label::Furniture && c.label != Label::Column && c.label != Label::Stair);
}

}  // namespace

void measureHeights(const PlanCells& cells, RoomPlan& plan)
{
    const Level& level = plan.level;
    std::vector<std::uint32_t> roomOf(plan.grid.size(), 0);  // 1 + index
    std::vector<Heights> heights(plan.rooms.size());
    const double floorLow = level.floor_m - kFloorBand_m, overheadLow = level.floor_m + kHead_m,
                 overheadHigh = level.ceiling_m + 0.08;
    const auto bins = [](double length) { return static_cast<std::size_t>(std::max(1.0, std::ceil(length / kBin_m))); };
    for (std::size_t r = 0; r < plan.rooms.size(); ++r)
    {
        forEachPixel(plan.rooms[r].outline, plan.grid,
                     [&](std::size_t i)
                     {
                         roomOf[i] = static_cast<std::uint32_t>(r + 1);
                         ++heights[r].pixels;
                     });
        heights[r].floor.resize(bins(2 * kFloorBand_m));
        heights[r].overhead.resize(bins(overheadHigh - overheadLow));
    }
    for (const PlanCell& c : cells.cells)
    {
        const double z = static_cast<double>(c.z);
        if (z < floorLow || z > overheadHigh || !isSurfaceOfRoom(cells, c))
            continue;
        if (roomOf[c.pixel] == 0)
            continue;
        Heights& h = heights[roomOf[c.pixel] - 1];
        const auto add = [&](std::vector<Bin>& histogram, double low)
        {
            const double bin = (z - low) / kBin_m;
            if (bin >= 0 && bin < static_cast<double>(histogram.size()))
                histogram[static_cast<std::size_t>(bin)].add(z - low);
        };
        add(h.floor, floorLow);
        add(h.overhead, overheadLow);
    }
    const double cellsPerPixel = (plan.grid.pixel_m / cells.size_m) * (plan.grid.pixel_m / cells.size_m);
    for (std::size_t r = 0; r < plan.rooms.size(); ++r)
    {
        Room& room = plan.rooms[r];
        const double full = static_cast<double>(heights[r].pixels) * cellsPerPixel;
        const Peak floor = peakOf(heights[r].floor, floorLow), ceiling = peakOf(heights[r].overhead, overheadLow);
        room.floor_m = floor.cells > 0.1 * full ? floor.z : level.floor_m;
        room.ceilingSeen = ceiling.cells > kCeilingShare * full;
        room.ceiling_m = room.ceilingSeen ? ceiling.z : level.ceiling_m;
        room.ceilingRms_m = room.ceilingSeen ? ceiling.rms : 0;
    }
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spaces/plan_raster.h"

#include "core/base/random.h"
#include "core/geometry/polygon.h"
#include "tests/unit/spaces/plan_scene.h"

#include <gtest/gtest.h>

namespace
{

using namespace s2b;
using namespace s2b::test;

PlanBits randomBitsOf(const PlanGrid& grid)
{
    PlanBits bits(grid.size());
    for (std::size_t i = 0; i < bits.size(); ++i)
        bits[i] = randomShare(5, 0, i) < 0.2;
    return bits;
}

TEST(PlanRaster, DilatesAndErodesAsBruteForceDoes)
{
    const PlanGrid grid{{0, 0}, 0.1, 23, 17};
    const PlanBits bits = randomBitsOf(grid);
    for (const int reach : {1, 2, 5})
    {
        const PlanBits wide = dilated(bits, grid, reach), narrow = eroded(wide, grid, reach);
        for (int y = 0; y < grid.height; ++y)
            for (int x = 0; x < grid.width; ++x)
            {
                bool any = false, all = true;
                for (int v = std::max(0, y - reach); v <= std::min(grid.height - 1, y + reach); ++v)
                    for (int u = std::max(0, x - reach); u <= std::min(grid.width - 1, x + reach); ++u)
                    {
                        any = any || bits[grid.at(u, v)];
                        all = all && wide[grid.at(u, v)];
                    }
                ASSERT_EQ(wide[grid.at(x, y)] != 0, any) << x << ' ' << y << ' ' << reach;
                ASSERT_EQ(narrow[grid.at(x, y)] != 0, all) << x << ' ' << y << ' ' << reach;
            }
    }
}

TEST(PlanRaster, FillsThePixelsWhoseCentresAreInside)
{
    const PlanGrid grid{{-1, -1}, 0.05, 120, 100};
    const Polygon polygon{{{0, 0}, {4, 0.3}, {3.2, 3}, {0.4, 2.7}}, {{{1, 1}, {1, 2}, {2, 1.5}}}};
    PlanBits bits(grid.size(), 0);
    forEachPixel(polygon, grid, [&](std::size_t i) { ++bits[i]; });
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x)
            ASSERT_EQ(bits[grid.at(x, y)],
                      contains(polygon, grid.low + grid.pixel_m * Eigen::Vector2d(x + 0.5, y + 0.5)));
}

TEST(PlanRaster, TellsFloorCeilingAndWhatIsBetween)
{
    PlanScene scene;
    scene.level({{0, 0}, {1, 1}}, 0.0, Label::Floor);
    scene.level({{0, 0}, {1, 1}}, 2.6, Label::Ceiling);
    scene.level({{2, 0}, {3, 1}}, 0.9, Label::Stair);
    scene.level({{4, 0}, {5, 1}}, 5.6, Label::Ceiling);    // a stairwell's, a storey higher
    scene.level({{6, 0}, {7, 1}}, 0.0, Label::Furniture);  // not the floor
    const PlanCells cells = scene.cells();
    const PlanBits bits = rasterOf(cells, levelAt(0.0, 2.6));
    const auto at = [&](double x) { return static_cast<int>(bits[cells.grid.find({x, 0.5})]); };
    EXPECT_EQ(at(0.5), kFloorLayer | kCeilingLayer | kCoverLayer);
    EXPECT_EQ(at(2.5), kBetweenLayer);
    EXPECT_EQ(at(4.5), kCoverLayer);
    EXPECT_EQ(at(6.5), 0);
}

TEST(PlanRaster, KeepsASiteOfAnySizeInBounds)
{
    PlanScene scene;
    scene.level({{0, 0}, {0.5, 0.5}}, 0.0, Label::Floor);
    scene.level({{900, 700}, {900.5, 700.5}}, 0.0, Label::Floor);
    const PlanCells cells = scene.cells();
    EXPECT_LE(cells.grid.size(), 2'100'000U);
    EXPECT_EQ(cells.cells.size(), 800U);
}

}  // namespace

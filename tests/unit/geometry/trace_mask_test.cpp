// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace s2b;

struct Mask
{
    std::vector<std::uint8_t> cells;
    int width = 0;
    int height = 0;

    [[nodiscard]] std::vector<Polygon> trace(const Eigen::Vector2d& origin = {0, 0}, double cell = 1.0) const
    {
        return traceMask(cells, width, height, origin, cell);
    }
};

/// Rows from the top, as they look; '#' is set.
Mask drawn(const std::vector<std::string>& rows)
{
    Mask mask;
    mask.height = int(rows.size());
    mask.width = int(rows.front().size());
    for (auto row = rows.rbegin(); row != rows.rend(); ++row)
        for (const char c : *row)
            mask.cells.push_back(c == '#' ? 1 : 0);
    return mask;
}

Ring box(double x0, double y0, double x1, double y1)
{
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

TEST(TraceMask, OutlinesRegionsWithHoles)
{
    const std::vector<Polygon> polygons = drawn({"#####.", "#...#.", "#.#.##", "#...#.", "#####."}).trace();
    ASSERT_EQ(polygons.size(), 2u);
    EXPECT_EQ(polygons[0].outer, (Ring{{0, 0}, {5, 0}, {5, 2}, {6, 2}, {6, 3}, {5, 3}, {5, 5}, {0, 5}}));
    ASSERT_EQ(polygons[0].holes.size(), 1u);
    EXPECT_EQ(polygons[0].holes[0], (Ring{{1, 1}, {1, 4}, {4, 4}, {4, 1}}));
    EXPECT_EQ(polygons[1].outer, box(2, 2, 3, 3));
}

TEST(TraceMask, PlacesCellsByOriginAndSize)
{
    const std::vector<Polygon> polygons = drawn({".#", ".."}).trace({1e6, -2.0}, 0.25);
    ASSERT_EQ(polygons.size(), 1u);
    EXPECT_EQ(polygons[0].outer, box(1e6 + 0.25, -1.75, 1e6 + 0.5, -1.5));
}

TEST(TraceMask, CellsThatTouchInACornerAreTwoPolygons)
{
    const std::vector<Polygon> polygons = drawn({".#", "#."}).trace();
    ASSERT_EQ(polygons.size(), 2u);
    EXPECT_EQ(polygons[0].outer, box(0, 0, 1, 1));
    EXPECT_EQ(polygons[1].outer, box(1, 1, 2, 2));
}

TEST(TraceMask, ARingThatClosesInACornerHasAHole)
{
    // The gap touches the outside in a corner: an outer ring and a hole that share one point.
    const std::vector<Polygon> polygons = drawn({"##.", "#.#", "###"}).trace();
    ASSERT_EQ(polygons.size(), 1u);
    EXPECT_EQ(polygons[0].outer, (Ring{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 3}, {0, 3}}));
    ASSERT_EQ(polygons[0].holes.size(), 1u);
    EXPECT_EQ(polygons[0].holes[0], (Ring{{1, 1}, {1, 2}, {2, 2}, {2, 1}}));
}

TEST(TraceMask, HolesThatTouchInACornerAreTwo)
{
    const std::vector<Polygon> polygons = drawn({"####", "##.#", "#.##", "####"}).trace();
    ASSERT_EQ(polygons.size(), 1u);
    ASSERT_EQ(polygons[0].holes.size(), 2u);
    EXPECT_EQ(polygons[0].holes[0], (Ring{{1, 1}, {1, 2}, {2, 2}, {2, 1}}));
    EXPECT_EQ(polygons[0].holes[1], (Ring{{2, 2}, {2, 3}, {3, 3}, {3, 2}}));
}

TEST(TraceMask, RingsOfAnyMaskAreSimpleAndCoverItsCells)
{
    for (unsigned seed = 0; seed < 60; ++seed)
    {
        std::mt19937 generator(seed);
        std::bernoulli_distribution isSet(0.3 + 0.01 * double(seed % 50));
        Mask mask;
        mask.width = 1 + int(seed % 23);
        mask.height = 1 + int(seed * 7 % 19);
        for (int i = 0; i < mask.width * mask.height; ++i)
            mask.cells.push_back(isSet(generator) ? 255 : 0);
        const std::vector<Polygon> polygons = mask.trace();
        double covered = 0.0;
        for (const Polygon& polygon : polygons)
        {
            covered += area(polygon);
            EXPECT_GT(signedArea(polygon.outer), 0.0);
            std::vector<Ring> rings = polygon.holes;
            for (const Ring& hole : rings)
                EXPECT_LT(signedArea(hole), 0.0);
            rings.push_back(polygon.outer);
            for (const Ring& ring : rings)
            {
                std::set<std::pair<double, double>> corners;
                for (const Eigen::Vector2d& p : ring)
                    EXPECT_TRUE(corners.emplace(p.x(), p.y()).second) << "seed " << seed;
            }
        }
        EXPECT_EQ(covered, double(std::ranges::count(mask.cells, 255)));
        for (int y = 0; y < mask.height; ++y)
        {
            for (int x = 0; x < mask.width; ++x)
            {
                const auto holds = std::ranges::count_if(
                    polygons, [&](const Polygon& polygon) { return contains(polygon, {x + 0.5, y + 0.5}); });
                ASSERT_EQ(holds, mask.cells[std::size_t(y * mask.width + x)] != 0 ? 1 : 0) << "seed " << seed;
            }
        }
    }
}

TEST(TraceMask, HandlesEmptyFullAndOneCellMasks)
{
    EXPECT_TRUE(traceMask({}, 0, 0, {0, 0}, 1.0).empty());
    EXPECT_TRUE(drawn({"...", "..."}).trace().empty());
    const std::vector<Polygon> full = drawn({"###", "###"}).trace();
    ASSERT_EQ(full.size(), 1u);
    EXPECT_EQ(full[0].outer, box(0, 0, 3, 2));
    EXPECT_EQ(drawn({"#"}).trace({0, 0}, 1e-6).size(), 1u);
    EXPECT_THROW((void)traceMask(std::vector<std::uint8_t>(5, 1), 2, 3, {0, 0}, 1.0), Error);
    EXPECT_THROW((void)traceMask({}, -1, 0, {0, 0}, 1.0), Error);
}

}  // namespace

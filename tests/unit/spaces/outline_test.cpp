// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spaces/outline.h"

#include <gtest/gtest.h>

#include <numbers>

namespace
{

using namespace s2b;

constexpr double kRounding = 1e-9;  // of new corners to double

Polygon rectangle(double x0, double y0, double x1, double y1)
{
    return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

TEST(OffsetEdges, WidensWithSharpCornersAndShrinksHoles)
{
    Polygon p = rectangle(0, 0, 4, 3);
    p.holes.push_back({{1, 1}, {1, 2}, {2, 2}, {2, 1}});
    const std::vector<Polygon> wide = offsetEdges(p, [](const Segment&) { return 0.1; });
    ASSERT_EQ(wide.size(), 1U);
    EXPECT_NEAR(area(wide[0]), 4.2 * 3.2 - 0.8 * 0.8, kRounding);
    const std::vector<Polygon> back = offsetEdges(wide[0], [](const Segment&) { return -0.1; });
    ASSERT_EQ(back.size(), 1U);
    EXPECT_NEAR(area(back[0]), 4 * 3 - 1, kRounding);
}

TEST(OffsetEdges, MovesEachEdgeByItsOwnDistance)
{
    const auto onlyLowest = [](const Segment& e) { return e.a.y() == 0 && e.b.y() == 0 ? 0.5 : 0.0; };
    const std::vector<Polygon> moved = offsetEdges(rectangle(0, 0, 4, 3), onlyLowest);
    ASSERT_EQ(moved.size(), 1U);
    EXPECT_NEAR(area(moved[0]), 4 * 3.5, kRounding);
}

TEST(OffsetEdges, ClosesANotchThatIsNarrowerThanTheWayThereAndBack)
{
    const Polygon notched{{{0, 0}, {4, 0}, {4, 3}, {2.1, 3}, {2.1, 1}, {1.9, 1}, {1.9, 3}, {0, 3}}, {}};
    const std::vector<Polygon> wide = offsetEdges(notched, [](const Segment&) { return 0.3; });
    ASSERT_EQ(wide.size(), 1U);
    const std::vector<Polygon> back = offsetEdges(wide[0], [](const Segment&) { return -0.3; });
    ASSERT_EQ(back.size(), 1U);
    EXPECT_NEAR(area(back[0]), 4 * 3, kRounding);
}

TEST(OffsetEdges, ClosesANotchBesideAStep)
{
    // The notch's left side is 1 m higher than its right one.
    const Polygon notched{{{0, 0}, {4, 0}, {4, 3}, {2.1, 3}, {2.1, 1}, {1.9, 1}, {1.9, 4}, {0, 4}}, {}};
    const std::vector<Polygon> wide = offsetEdges(notched, [](const Segment&) { return 0.3; });
    ASSERT_EQ(wide.size(), 1U);
    const std::vector<Polygon> back = offsetEdges(wide[0], [](const Segment&) { return -0.3; });
    ASSERT_EQ(back.size(), 1U);
    EXPECT_NEAR(area(back[0]), 4 * 3 + 1.9, kRounding);
}

TEST(OffsetEdges, LeavesNothingOfWhatIsNarrowerThanTheOffset)
{
    EXPECT_TRUE(offsetEdges(rectangle(0, 0, 4, 0.1), [](const Segment&) { return -0.2; }).empty());
}

TEST(WithoutSteps, PutsTheShorterSideOntoTheLongerOnesLine)
{
    const Polygon stepped{{{0, 0}, {4, 0}, {4, 3}, {1, 3}, {1, 3.03}, {0, 3.03}}, {}};
    const std::vector<Polygon> straight = withoutSteps(stepped, 0.05);
    ASSERT_EQ(straight.size(), 1U);
    EXPECT_EQ(straight[0].outer.size(), 4U);
    EXPECT_NEAR(area(straight[0]), 4 * 3, kRounding);
    EXPECT_EQ(withoutSteps(stepped, 0.02)[0].outer.size(), 6U);
}

PlanGrid gridOf(int width, int height)
{
    return {{0, 0}, 0.05, width, height};
}

/// The pixels of a polygon, without every seventh at its border.
PlanBits jaggedPixels(const Polygon& polygon, const PlanGrid& grid)
{
    PlanBits bits(grid.size(), 0);
    forEachPixel(polygon, grid, [&](std::size_t i) { bits[i] = 1; });
    const PlanBits inner = eroded(bits, grid, 1);
    for (std::size_t i = 0; i < bits.size(); i += 7)
        bits[i] = inner[i];
    return bits;
}

TEST(StraightOutlines, MakesARectangleOfAJaggedOne)
{
    const PlanGrid grid = gridOf(140, 100);
    StraightenOptions options;
    options.directions = {0.0, std::numbers::pi / 2};
    const std::vector<Polygon> outlines = straightOutlines(jaggedPixels(rectangle(1, 1, 6, 4), grid), grid, options);
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_EQ(outlines[0].outer.size(), 4U);
    // A seventh of the border's pixels of 5 cm moves a side by 7 mm in the mean; 16 m around.
    EXPECT_NEAR(area(outlines[0]), 15, 0.02 * 16);
}

TEST(StraightOutlines, TakesObliqueDirectionsAndNearbyFaces)
{
    const PlanGrid grid = gridOf(160, 160);
    const Eigen::Rotation2Dd turn(0.5);
    Polygon oblique = rectangle(0, 0, 4, 3);
    for (Eigen::Vector2d& p : oblique.outer)
        p = turn * p + Eigen::Vector2d(2.5, 1);
    StraightenOptions options;
    options.directions = {0.0, std::numbers::pi / 2, 0.5, 0.5 + std::numbers::pi / 2};
    options.faces = edgesOf(std::span(&oblique, 1));
    const std::vector<Polygon> outlines = straightOutlines(jaggedPixels(oblique, grid), grid, options);
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_EQ(outlines[0].outer.size(), 4U);
    EXPECT_NEAR(area(outlines[0]), 12, 1e-6);  // all sides lie on the faces
}

TEST(StraightOutlines, KeepsHoles)
{
    const PlanGrid grid = gridOf(140, 100);
    Polygon ring = rectangle(1, 1, 6, 4);
    ring.holes.push_back({{2, 2}, {2, 3}, {4, 3}, {4, 2}});
    StraightenOptions options;
    options.directions = {0.0, std::numbers::pi / 2};
    const std::vector<Polygon> outlines = straightOutlines(jaggedPixels(ring, grid), grid, options);
    ASSERT_EQ(outlines.size(), 1U);
    ASSERT_EQ(outlines[0].holes.size(), 1U);
    EXPECT_NEAR(area(outlines[0]), 13, 0.02 * 22);  // as above, 22 m around
}

}  // namespace

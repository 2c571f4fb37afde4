// SPDX-License-Identifier: GPL-3.0-or-later
/// Walls under a sloped ceiling: the edge that is fitted to their tops, and the walls of hand-made rooms.
#include "core/walls/sloped_top.h"
#include "tests/support/plan_geometry.h"
#include "tests/support/stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace s2b
{
namespace
{

using Edge = std::vector<Eigen::Vector2d>;

/// Tops along an edge, one each 0.1 m, rounded to rows of 0.1 m as faces keep them.
Edge topsOf(const Edge& edge)
{
    Edge tops;
    for (double s = edge.front().x() + 0.05; s < edge.back().x(); s += 0.1)
        tops.emplace_back(s, 0.1 * std::floor(10 * topAt(edge, s)) + 0.05);
    return tops;
}

Edge fitted(const Edge& edge, const Edge& tops)
{
    return fitSlopedTop(tops, edge.front().x(), edge.back().x(), topsOf(edge).size());
}

void expectEdge(const Edge& found, const Edge& truth)
{
    ASSERT_EQ(found.size(), truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
        // Rows of 0.1 m: rounding evens out along a slope, and puts a level piece half a row off.
        EXPECT_NEAR(found[i].x(), truth[i].x(), 0.1) << "vertex " << i;
        EXPECT_NEAR(found[i].y(), truth[i].y(), 0.055) << "vertex " << i;
    }
}

TEST(SlopedTop, FindsMonoPitchGableAndCutOffGableWithTheFewestVertices)
{
    for (const Edge& truth : {Edge{{0, 2.2}, {5, 3.6}}, Edge{{-1, 2.0}, {2, 4.1}, {5.5, 1.9}},
                              Edge{{0, 1.2}, {1.7, 2.6}, {6, 2.6}}, Edge{{0, 1.2}, {1.7, 2.6}, {4.1, 2.6}, {6, 1.1}}})
        expectEdge(fitted(truth, topsOf(truth)), truth);
}

TEST(SlopedTop, DoesNotFollowPlacesWithAHiddenTop)
{
    const Edge truth{{0, 2.0}, {3, 4.1}, {6, 2.0}};
    Edge tops = topsOf(truth);
    for (std::size_t i = 12; i < 18; ++i)  // a tenth of them behind a cupboard
        tops[i].y() = 1.85;
    expectEdge(fitted(truth, tops), truth);
}

TEST(SlopedTop, LeavesLevelTopsStepsAndHardlySeenOnesAlone)
{
    const Edge level{{0, 2.6}, {6, 2.65}};
    EXPECT_TRUE(fitted(level, topsOf(level)).empty());

    Edge step = topsOf(level);
    for (std::size_t i = step.size() / 2; i < step.size(); ++i)
        step[i].y() -= 0.8;
    EXPECT_TRUE(fitted(level, step).empty()) << "a step is no slope";

    const Edge gable{{0, 2.0}, {3, 4.1}, {6, 2.0}};
    Edge half = topsOf(gable);
    half.resize(half.size() / 2);
    EXPECT_TRUE(fitted(gable, half).empty()) << "half of it was seen";

    Edge jagged = topsOf(gable);
    for (std::size_t i = 0; i < jagged.size(); ++i)
        jagged[i].y() = 2.0 + 0.1 * static_cast<double>(i * 7 % 13);
    EXPECT_TRUE(fitted(gable, jagged).empty()) << "furniture on shelves";
}

TEST(SlopedTop, IsCutOrDrawnOnToTheWallsEnds)
{
    const Edge gable{{0, 2.0}, {3, 4.0}, {6, 2.0}};
    EXPECT_EQ(topBetween(gable, 3.5, 6.3).size(), 2U);
    const Edge longer = topBetween(gable, -0.3, 6.3);
    ASSERT_EQ(longer.size(), 3U);
    EXPECT_NEAR(longer[0].y(), 1.8, 1e-9);
    EXPECT_NEAR(longer[1].y(), 4.0, 1e-9);
    EXPECT_NEAR(longer[2].y(), 1.8, 1e-9);
}

/// One triangle's worth of wall: points of a rectangle that lie under the line.
void gableFace(test::HandMadeCloud& cloud, double y, double x0, double x1, const Edge& edge)
{
    for (double x = x0 + 0.005; x < x1; x += 0.01)
        for (double z = 0.005; z < topAt(edge, x); z += 0.01)
            cloud.point({x, y, z}, Label::Wall);
}

/// A room under a roof: gables at y = 0 and y = 4 (seen from inside, and from outside 0.3 m further), low walls at its
/// eaves.
test::HandMadeCloud attic(const Edge& gable)
{
    test::HandMadeCloud cloud(0.02);
    const double length = gable.back().x();
    for (const double y : {-0.3, 0.0, 4.0, 4.3})
        gableFace(cloud, y, 0, length, gable);
    for (const double x : {0.0, length})
        cloud.wallFace({x, 0}, {x, 4}, 0, topAt(gable, x));
    for (const double x : {-0.3, length + 0.3})
        cloud.wallFace({x, -0.3}, {x, 4.3}, 0, 1.4);
    cloud.horizontal({0, 0}, {length, 4}, 0.0, Label::Floor);
    for (std::size_t i = 0; i + 1 < gable.size(); ++i)
        cloud.rectangle({gable[i].x(), 0, gable[i].y()},
                        {gable[i + 1].x() - gable[i].x(), 0, gable[i + 1].y() - gable[i].y()}, {0, 4, 0},
                        Label::Ceiling);
    return cloud;
}

TEST(SlopedTop, GableWallsOfAnAtticGetIt)
{
    const Edge gable{{0, 1.5}, {3, 3.6}, {6, 1.5}};
    const test::HandMadeCloud cloud = attic(gable);
    const SurfaceCells cells = test::cellsOf(cloud);
    Level level;
    level.ceiling_m = 3.6;
    std::uint32_t nextId = 2;
    const WallResult result =
        findWalls(cells, CellIndex(cells, -0.2, 4.0), level, ElementId{1}, nextId, WallParams{}, Context{});
    for (const double y : {-0.15, 4.15})
    {
        const Wall* wall = test::wallThrough(result.walls, {3.0, y}, Eigen::Vector2d::UnitX());
        ASSERT_NE(wall, nullptr);
        ASSERT_EQ(wall->topProfile.size(), 3U);
        const double x0 = wall->start.x(), sign = wall->direction().x();
        for (const Eigen::Vector2d& v : wall->topProfile)
        {
            // Within the wall's own room: a corner draws the edge on.
            const double x = std::clamp(x0 + sign * v.x(), 0.0, 6.0);
            const double s = (x - x0) / sign;
            EXPECT_NEAR(topAt(wall->topProfile, s), topAt(gable, x), 0.05) << "at " << x;  // half a row
        }
        EXPECT_NEAR(wall->topProfile[1].x(), std::abs(3.0 - x0), 0.1);
        EXPECT_NEAR(wall->base_m + wall->height.value_m, 3.6, 0.05) << "height is that of the highest vertex";
        EXPECT_EQ(wall->height.provenance, Provenance::Measured);
        EXPECT_GT(std::min(wall->evidence.faceCoverage[0], wall->evidence.faceCoverage[1]), 0.85)
            << "of the face, not of the box around it";
    }
    for (const double x : {-0.15, 6.15})
    {
        const Wall* wall = test::wallThrough(result.walls, {x, 2.0}, Eigen::Vector2d::UnitY());
        ASSERT_NE(wall, nullptr);
        EXPECT_TRUE(wall->topProfile.empty()) << "the eaves are level";
    }
}

TEST(SlopedTop, AWallUnderALevelCeilingSeenFromOneSideKeepsIt)
{
    // Stairs hide the lower part of a wall's face... and here, its upper part.
    test::HandMadeCloud cloud(0.02);
    const Edge stairs{{0, 2.6}, {4, 0.6}};
    gableFace(cloud, 0.0, 0, 4, stairs);
    cloud.wallFace({0, 3}, {4, 3}, 0, 2.6);
    cloud.wallFace({0, 0}, {0, 3}, 0, 2.6);
    cloud.wallFace({4, 0}, {4, 3}, 0, 2.6);
    cloud.horizontal({0, 0}, {4, 3}, 0.0, Label::Floor);
    cloud.horizontal({0, 0}, {4, 3}, 2.6, Label::Ceiling);
    const auto result = test::storeyOf(cloud);
    const Wall* wall = test::wallThrough(result.walls.walls, {2.0, 0.0}, Eigen::Vector2d::UnitX());
    for (const Wall& w : result.walls.walls)
        EXPECT_TRUE(w.topProfile.empty());
    EXPECT_NE(wall, nullptr);
}

}  // namespace
}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/geometry/polygon.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

namespace
{

using namespace s2b;
using Polygons = std::vector<Polygon>;

Polygon box(double x0, double y0, double x1, double y1)
{
    return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

Polygon turned(const Polygon& polygon, double angle, const Eigen::Vector2d& shift)
{
    const Eigen::Rotation2Dd rotation(angle);
    Polygon result = polygon;
    for (Eigen::Vector2d& p : result.outer)
        p = rotation * p + shift;
    return result;
}

double totalArea(const Polygons& polygons)
{
    return std::accumulate(polygons.begin(), polygons.end(), 0.0,
                           [](double sum, const Polygon& polygon) { return sum + area(polygon); });
}

bool containsAny(const Polygons& polygons, const Eigen::Vector2d& p)
{
    return std::ranges::any_of(polygons, [&](const Polygon& polygon) { return contains(polygon, p); });
}

TEST(PolygonUnion, JoinsAndDropsCornersThatDoNotBend)
{
    const Polygons united = unite(Polygons{box(0, 0, 1, 1), box(1, 0, 2, 1)});
    ASSERT_EQ(united.size(), 1u);
    EXPECT_EQ(united[0].outer, box(0, 0, 2, 1).outer);
    EXPECT_TRUE(united[0].holes.empty());
}

TEST(PolygonUnion, OfARingOfWallsHasAHole)
{
    const Polygons united = unite(Polygons{box(0, 0, 5, 1), box(4, 0, 5, 5), box(0, 4, 5, 5), box(0, 0, 1, 5)});
    ASSERT_EQ(united.size(), 1u);
    EXPECT_EQ(united[0].outer, box(0, 0, 5, 5).outer);
    ASSERT_EQ(united[0].holes.size(), 1u);
    EXPECT_EQ(united[0].holes[0], (Ring{{1, 1}, {1, 4}, {4, 4}, {4, 1}}));
}

TEST(PolygonUnion, KeepsSeparateOnesSortedWhateverTheirOrder)
{
    const Polygons a = unite(Polygons{box(8, 0, 9, 1), box(0, 0, 1, 1), box(3, 0, 4, 1)});
    const Polygons b = unite(Polygons{box(3, 0, 4, 1), box(8, 0, 9, 1), box(0, 0, 1, 1)});
    ASSERT_EQ(a.size(), 3u);
    ASSERT_EQ(b.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(a[i].outer, b[i].outer);
    EXPECT_EQ(a[1].outer.front(), Eigen::Vector2d(3, 0));
}

TEST(PolygonDifference, CutsHolesAndSplits)
{
    const Polygons withHole = subtract(Polygons{box(0, 0, 4, 3)}, Polygons{box(1, 1, 2, 2)});
    ASSERT_EQ(withHole.size(), 1u);
    EXPECT_EQ(withHole[0].holes.size(), 1u);
    EXPECT_EQ(area(withHole[0]), 11.0);
    const Polygons halves = subtract(Polygons{box(0, 0, 4, 3)}, Polygons{box(1, -1, 2, 5)});
    ASSERT_EQ(halves.size(), 2u);
    EXPECT_EQ(halves[0].outer, box(0, 0, 1, 3).outer);
    EXPECT_EQ(halves[1].outer, box(2, 0, 4, 3).outer);
    EXPECT_TRUE(subtract(Polygons{box(0, 0, 1, 1)}, Polygons{box(-1, -1, 2, 2)}).empty());
}

TEST(PolygonIntersection, IsWhatBothCover)
{
    const Polygons both = intersect(Polygons{box(0, 0, 3, 3)}, Polygons{box(1, 1, 5, 5), box(-1, -1, 0.5, 0.5)});
    ASSERT_EQ(both.size(), 2u);
    EXPECT_EQ(both[0].outer, box(0, 0, 0.5, 0.5).outer);
    EXPECT_EQ(both[1].outer, box(1, 1, 3, 3).outer);
    EXPECT_TRUE(intersect(Polygons{box(0, 0, 1, 1)}, Polygons{box(1, 0, 2, 1)}).empty());  // only an edge
}

TEST(PolygonBooleans, AgreeWithPointsAndWithEachOther)
{
    for (unsigned seed = 0; seed < 8; ++seed)
    {
        std::mt19937 generator(seed);
        std::uniform_real_distribution<double> place(-3.0, 3.0);
        std::uniform_real_distribution<double> size(0.1, 2.5);
        std::uniform_real_distribution<double> angle(0.0, std::numbers::pi);
        const auto boxes = [&]
        {
            Polygons result;
            for (int i = 0; i < 6; ++i)
                result.push_back(turned(box(0, 0, size(generator), size(generator)), angle(generator),
                                        {place(generator), place(generator)}));
            return result;
        };
        const Polygons a = boxes();
        const Polygons b = boxes();
        const Polygons united = unite(a);
        const Polygons common = intersect(a, b);
        const Polygons rest = subtract(a, b);
        // New corners are rounded at 1e-15 m, over a boundary of some 50 m; parts below 1e-6 m2 are dropped.
        EXPECT_NEAR(totalArea(common) + totalArea(rest), totalArea(united), 1e-5) << seed;
        for (int i = 0; i < 2000; ++i)
        {
            const Eigen::Vector2d p(place(generator), place(generator));
            const bool inA = containsAny(a, p);
            const bool inB = containsAny(b, p);
            ASSERT_EQ(containsAny(united, p), inA);
            ASSERT_EQ(containsAny(common, p), inA && inB);
            ASSERT_EQ(containsAny(rest, p), inA && !inB);
        }
    }
}

TEST(PolygonBooleans, TakeAnyRings)
{
    // A bow tie: its two triangles.
    const Polygons bow = unite(Polygons{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}});
    EXPECT_NEAR(totalArea(bow), 2.0, 1e-12);
    // Clockwise, with repeated and collinear points, and a hole the wrong way round.
    const Polygons wrong = unite(Polygons{{{{0, 0}, {0, 2}, {0, 3}, {0, 3}, {4, 3}, {4, 0}}, {box(1, 1, 2, 2).outer}}});
    ASSERT_EQ(wrong.size(), 1u);
    EXPECT_EQ(area(wrong[0]), 11.0);
    EXPECT_EQ(wrong[0].outer.size(), 4u);
    // A hole that reaches beyond its polygon, a spike, and no polygon at all.
    EXPECT_NO_THROW((void)unite(Polygons{{box(0, 0, 1, 1).outer, {box(0.5, 0.5, 2, 2).outer}}}));
    const Polygons spike = unite(Polygons{{{{0, 0}, {1, 0}, {5, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}});
    ASSERT_EQ(spike.size(), 1u);
    EXPECT_EQ(spike[0].outer, box(0, 0, 1, 1).outer);
    EXPECT_TRUE(unite(Polygons{{{{0, 0}, {1, 1}}, {}}, {}}).empty());
    EXPECT_TRUE(unite({}).empty());
    EXPECT_TRUE(subtract({}, Polygons{box(0, 0, 1, 1)}).empty());
    EXPECT_EQ(subtract(Polygons{box(0, 0, 1, 1)}, {}).size(), 1u);
}

TEST(PolygonBooleans, KeepMillimetresFarFromTheOrigin)
{
    const Eigen::Vector2d far(4.5e6, 5.4e6);
    const Polygons united = unite(Polygons{turned(box(0, 0, 2, 0.2), 0.4, far), turned(box(1.8, 0, 2, 3), 0.4, far)});
    ASSERT_EQ(united.size(), 1u);
    // 0.4 + 0.6 - 0.04; the corners themselves are on a lattice of 1e-9, along sides of some metres.
    EXPECT_NEAR(totalArea(united), 0.96, 1e-7);
}

TEST(PolygonBooleans, RefuseCoordinatesThatAreNotFinite)
{
    Polygon bad = box(0, 0, 1, 1);
    bad.outer[2].x() = std::nan("");
    EXPECT_THROW((void)unite(Polygons{bad}), Error);
}

}  // namespace

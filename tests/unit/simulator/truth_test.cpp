// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "tests/simulator/axis_curve.h"
#include "tests/simulator/building_spec.h"
#include "tests/simulator/triangulate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace s2b::sim
{
namespace
{

/// A point of one wall's body that is inside another's: how deep [m].
double overlap(const Wall& a, const Wall& b)
{
    const AxisCurve curve(a);
    const AxisCurve other(b);
    double deepest = 0.0;
    for (int i = 0; i <= 400; ++i)
        for (const double side : {-0.5, 0.0, 0.5})
        {
            const double s = a.bodyStart_m + (a.bodyEnd_m - a.bodyStart_m) * i / 400.0;
            const Eigen::Vector2d q = other.project(curve.at(s, side * a.thickness.value_m));
            const double depth =
                std::min({b.thickness.value_m / 2.0 - std::abs(q.y()), q.x() - b.bodyStart_m, b.bodyEnd_m - q.x()});
            deepest = std::max(deepest, depth);
        }
    return deepest;
}

double area(const std::vector<Eigen::Vector2d>& ring)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const Eigen::Vector2d& a = ring[i];
        const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2.0;
}

class EverySeed : public testing::TestWithParam<std::uint64_t>
{
protected:
    static BuildingSpec spec()
    {
        BuildingSpec s;
        s.seed = GetParam();
        s.facadeAngle_deg = GetParam() % 3 == 0 ? 8.0 : 0.0;
        s.curvedFacade = GetParam() % 3 == 1;
        s.suspendedCeilings = GetParam() % 2 == 0;
        s.stairs = GetParam() % 2 == 1;
        return s;
    }
};

TEST_P(EverySeed, AxesOfJoinedWallsMeet)
{
    const Building building = makeBuilding(spec()).truth;
    ASSERT_FALSE(building.junctions.empty());
    for (const Junction& j : building.junctions)
    {
        const AxisCurve a(*building.wall(j.wallA));
        const AxisCurve b(*building.wall(j.wallB));
        const Eigen::Vector2d end = a.at(j.endA == JunctionEnd::Start ? 0.0 : a.length());
        // 1e-9: double arithmetic at some 20 m.
        if (j.endB == JunctionEnd::Path)
            EXPECT_NEAR(b.project(end).y(), 0.0, 1e-9);
        else
            EXPECT_NEAR((end - b.at(j.endB == JunctionEnd::Start ? 0.0 : b.length())).norm(), 0.0, 1e-9);
    }
}

TEST_P(EverySeed, WallBodiesOfAStoreyDoNotOverlap)
{
    const Building building = makeBuilding(spec()).truth;
    for (const Wall& a : building.walls)
        for (const Wall& b : building.walls)
            if (a.id != b.id && a.storey == b.storey)
            {
                // 1e-6: the ends are found by bisection. The ends of facades at a corner out of square are cut square:
                // they may reach in by thickness x tan(30 deg / 2), 0.13 m.
                const bool isSkewCorner = a.isExternal && b.isExternal && (GetParam() % 3 != 2);
                EXPECT_LT(overlap(a, b), isSkewCorner ? 0.13 : 1e-6) << a.id.value << " in " << b.id.value;
            }
}

TEST_P(EverySeed, OpeningsLieWithinTheirHostsAndApart)
{
    const Building building = makeBuilding(spec()).truth;
    ASSERT_FALSE(building.openings.empty());
    for (const Opening& o : building.openings)
    {
        const Wall* host = building.wall(o.host);
        ASSERT_NE(host, nullptr);
        EXPECT_GE(o.offset_m, host->bodyStart_m);
        EXPECT_LE(o.offset_m + o.width.value_m, host->bodyEnd_m);
        EXPECT_LT(o.sill.value_m + o.height.value_m, host->height.value_m);
        for (const Opening& p : building.openings)
            if (p.id != o.id && p.host == o.host)
            {
                EXPECT_TRUE(o.offset_m + o.width.value_m < p.offset_m || p.offset_m + p.width.value_m < o.offset_m);
            }
    }
}

TEST_P(EverySeed, RoomsWallsAndFloorAddUp)
{
    const Building building = makeBuilding(spec()).truth;
    for (const Storey& storey : building.storeys)
    {
        double sum = 0.0;
        for (const Space& space : building.spaces)
            if (space.storey == storey.id)
                sum += space.area_m2;
        for (const Wall& wall : building.walls)
            if (wall.storey == storey.id)
                sum += (wall.bodyEnd_m - wall.bodyStart_m) * wall.thickness.value_m;
        const auto slab = std::find_if(building.slabs.begin(), building.slabs.end(),
                                       [&](const Slab& s) { return s.storey == storey.id; });
        ASSERT_NE(slab, building.slabs.end());
        // 0.2 m2: wedges at oblique joints and skew corners, whose walls are cut square.
        EXPECT_NEAR(sum, area(slab->outline.outer), 0.2);
    }
}

TEST_P(EverySeed, HasEveryFeatureThatIsAskedFor)
{
    const SimulatedBuilding simulated = makeBuilding(spec());
    const Building& building = simulated.truth;
    EXPECT_TRUE(std::any_of(building.walls.begin(), building.walls.end(),
                            [](const Wall& w) { return w.bulge != 0.0 && !w.isExternal; }));
    for (const double angle_deg : {4.0, 30.0})
        EXPECT_TRUE(std::any_of(building.walls.begin(), building.walls.end(),
                                [&](const Wall& w)
                                {
                                    const Eigen::Vector2d d = (w.end - w.start).normalized();
                                    return !w.isExternal && std::abs(std::abs(std::atan2(d.x(), std::abs(d.y()))) *
                                                                         180.0 / std::numbers::pi -
                                                                     angle_deg) < 1e-6;
                                }))
            << angle_deg;
    for (const OpeningKind kind : {OpeningKind::Door, OpeningKind::Window, OpeningKind::Plain})
        EXPECT_TRUE(std::any_of(building.openings.begin(), building.openings.end(),
                                [&](const Opening& o) { return o.kind == kind; }));
    EXPECT_TRUE(std::any_of(building.columns.begin(), building.columns.end(),
                            [](const Column& c) { return std::holds_alternative<CircleSection>(c.section); }));
    EXPECT_TRUE(std::any_of(building.columns.begin(), building.columns.end(),
                            [](const Column& c) { return std::holds_alternative<RectangleSection>(c.section); }));
    EXPECT_TRUE(
        std::any_of(building.spaces.begin(), building.spaces.end(), [](const Space& s) { return s.area_m2 < 2.0; }));
    EXPECT_TRUE(std::any_of(simulated.props.begin(), simulated.props.end(),
                            [](const Prop& p) { return p.label == Label::Furniture; }));
    EXPECT_EQ(
        std::any_of(simulated.props.begin(), simulated.props.end(), [](const Prop& p) { return p.kind == "stair"; }),
        spec().stairs);
}

INSTANTIATE_TEST_SUITE_P(Buildings, EverySeed, testing::Range<std::uint64_t>(1, 13));

TEST(MakeBuilding, GivesARoomOfTheAskedSize)
{
    const Building building = makeBuilding(oneRoom(6.0, 3.5, 2.5)).truth;
    ASSERT_EQ(building.walls.size(), 4U);
    ASSERT_EQ(building.spaces.size(), 1U);
    EXPECT_NEAR(building.spaces[0].area_m2, 21.0, 1e-9);
    EXPECT_EQ(building.spaces[0].height.value_m, 2.5);
    EXPECT_TRUE(building.openings.empty());
    EXPECT_TRUE(building.columns.empty());
}

TEST(MakeBuilding, GivesTwoRoomsWithADoorBetween)
{
    const Building building = makeBuilding(twoRoomsWithDoor()).truth;
    ASSERT_EQ(building.walls.size(), 5U);
    ASSERT_EQ(building.openings.size(), 1U);
    EXPECT_EQ(building.openings[0].host, building.walls[4].id);
    EXPECT_FALSE(building.walls[4].isExternal);
}

TEST(MakeBuilding, IsTheSameForTheSameSeedOnly)
{
    const auto widths = [](std::uint64_t seed)
    {
        BuildingSpec spec;
        spec.seed = seed;
        std::vector<double> result;
        for (const Opening& o : makeBuilding(spec).truth.openings)
            result.push_back(o.offset_m);
        return result;
    };
    EXPECT_EQ(widths(5), widths(5));
    EXPECT_NE(widths(5), widths(6));
}

TEST(MakeBuilding, KeepsTheWallsWhenFurnitureIsLeftOut)
{
    BuildingSpec spec;
    const SimulatedBuilding with = makeBuilding(spec);
    spec.furniture = false;
    const SimulatedBuilding without = makeBuilding(spec);
    EXPECT_LT(without.props.size(), with.props.size());
    ASSERT_EQ(with.truth.walls.size(), without.truth.walls.size());
    for (std::size_t i = 0; i < with.truth.walls.size(); ++i)
        EXPECT_EQ(with.truth.walls[i].start, without.truth.walls[i].start);
}

TEST(MakeBuilding, RefusesValuesOutOfRange)
{
    BuildingSpec spec;
    spec.storeys = 0;
    EXPECT_THROW((void)makeBuilding(spec), Error);
    spec = {};
    spec.openDoors = 0.7;
    spec.removedDoors = 0.7;
    EXPECT_THROW((void)makeBuilding(spec), Error);
    spec = {};
    spec.yaw_deg = std::nan("");
    EXPECT_THROW((void)makeBuilding(spec), Error);
}

TEST(AxisCurve, FollowsAQuarterCircle)
{
    // From (1, 0) to (0, 1) about the origin, counter-clockwise: tan(90 deg / 4).
    const AxisCurve arc({1.0, 0.0}, {0.0, 1.0}, std::tan(std::numbers::pi / 8.0));
    EXPECT_NEAR(arc.length(), std::numbers::pi / 2.0, 1e-12);
    EXPECT_NEAR((arc.at(arc.length() / 2.0) - Eigen::Vector2d(std::sqrt(0.5), std::sqrt(0.5))).norm(), 0.0, 1e-12);
    EXPECT_NEAR(arc.at(0.3, 0.25).norm(), 0.75, 1e-12);  // left is inwards
    const Eigen::Vector2d q = arc.project(arc.at(0.4, -0.1));
    EXPECT_NEAR(q.x(), 0.4, 1e-12);
    EXPECT_NEAR(q.y(), -0.1, 1e-12);
    const AxisCurve clockwise({0.0, 1.0}, {1.0, 0.0}, -std::tan(std::numbers::pi / 8.0));
    EXPECT_NEAR(clockwise.at(0.3, 0.25).norm(), 1.25, 1e-12);
}

TEST(Triangulate, KeepsTheAreaOfARingWithAHole)
{
    Polygon polygon;
    polygon.outer = {{0, 0}, {6, 0}, {6, 4}, {3, 2.5}, {0, 4}};
    polygon.holes = {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}};
    double sum = 0.0;
    for (const auto& t : triangulate(polygon))
    {
        const double size = area({t[0], t[1], t[2]});
        EXPECT_GT(size, 0.0);
        sum += size;
    }
    EXPECT_NEAR(sum, area(polygon.outer) - 1.0, 1e-9);
}

}  // namespace
}  // namespace s2b::sim

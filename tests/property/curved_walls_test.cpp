// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/wall_axis.h"
#include "tests/property/curved_buildings.h"
#include "tests/property/simulated_survey.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <string>

namespace s2b::test
{
namespace
{

SimulatedSurvey surveyOf(const CurvedBuilding& b, std::uint64_t seed, double noise_m = 0.003)
{
    sim::SimulatedBuilding building = b.building;
    building.truth.frame.yaw_rad = 17.0 * std::numbers::pi / 180;
    const sim::Scene scene = sim::makeScene(building, seed);
    std::vector<sim::Station> stations = b.stations;
    for (sim::Station& s : stations)
        s.position = building.truth.frame.toWorld(s.position);
    sim::ScanSettings settings;
    settings.seed = seed;
    settings.step_deg = 0.35;
    settings.noise_m = noise_m;
    settings.voxel_m = 0.012;
    return {building.truth, sim::scan(scene, stations, settings).toPointCloud()};
}

struct ArcWall
{
    const Wall* wall = nullptr;
    WallAxis axis;

    [[nodiscard]] bool holds(const Eigen::Vector2d& p) const
    {
        const Eigen::Vector2d q = axis.project(p);
        return q.x() >= wall->bodyStart_m && q.x() <= wall->bodyEnd_m && std::abs(q.y()) <= wall->thickness.value_m / 2;
    }
};

std::vector<ArcWall> arcsOf(const Building& b)
{
    std::vector<ArcWall> arcs;
    for (const Wall& w : b.walls)
        if (w.bulge != 0.0)
            arcs.push_back({&w, WallAxis(w)});
    return arcs;
}

/// Area in the plan that the curved walls of both have in common, as a share of what either has; by sampling.
double planIou(const Building& truth, const Building& result)
{
    const std::vector<ArcWall> real = arcsOf(truth), found = arcsOf(result);
    const auto isIn = [](const Building& b, const std::vector<ArcWall>& arcs, const Eigen::Vector2d& world)
    {
        const Eigen::Vector2d p = b.frame.toBuilding({world.x(), world.y(), 0}).head<2>();
        return std::any_of(arcs.begin(), arcs.end(), [&](const ArcWall& a) { return a.holds(p); });
    };
    Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9), high = -low;
    for (const ArcWall& a : real)
        for (const Eigen::Vector2d& p : a.wall->outline())
        {
            const Eigen::Vector2d q = truth.frame.toWorld({p.x(), p.y(), 0}).head<2>();
            low = low.cwiseMin(q), high = high.cwiseMax(q);
        }
    double both = 0, any = 0;
    constexpr double step = 0.013, rim = 0.5;
    for (double x = low.x() - rim; x < high.x() + rim; x += step)
        for (double y = low.y() - rim; y < high.y() + rim; y += step)
        {
            const bool a = isIn(truth, real, {x, y}), b = isIn(result, found, {x, y});
            both += a && b, any += a || b;
        }
    return any > 0 ? both / any : 0;
}

/// How far the axes of joined walls miss each other, at worst.
double worstJunction(const Building& b)
{
    double worst = 0;
    for (const Junction& j : b.junctions)
    {
        const Wall &a = *b.wall(j.wallA), &c = *b.wall(j.wallB);
        const auto at = [](const Wall& w, JunctionEnd end) { return end == JunctionEnd::Start ? w.start : w.end; };
        if (j.endB == JunctionEnd::Path)
            worst = std::max(worst, std::abs(WallAxis(c).project(at(a, j.endA)).y()));
        else if (j.endA == JunctionEnd::Path)
            worst = std::max(worst, std::abs(WallAxis(a).project(at(c, j.endB)).y()));
        else
            worst = std::max(worst, (at(a, j.endA) - at(c, j.endB)).norm());
    }
    return worst;
}

struct Case
{
    std::string name;
    std::function<CurvedBuilding()> make;
    std::uint64_t seed = 1;
    double noise_m = 0.003;
};

void PrintTo(const Case& c, std::ostream* out)
{
    *out << c.name;
}

class CurvedWalls : public testing::TestWithParam<Case>
{
};

// What is asked for is an IoU of 0.8; the losses are the ends at slanted junctions and half a voxel at the faces.
TEST_P(CurvedWalls, SeenFromBothSidesAreTheArcsThatTheyAre)
{
    const SimulatedSurvey s = surveyOf(GetParam().make(), GetParam().seed, GetParam().noise_m);
    for (const bool geometryOnly : {false, true})
    {
        SCOPED_TRACE(geometryOnly ? "geometry only" : "labelled");
        const Building b = reconstructed(s, geometryOnly);
        const std::vector<ArcWall> real = arcsOf(s.truth), found = arcsOf(b);
        ASSERT_EQ(found.size(), real.size());
        EXPECT_EQ(b.walls.size(), s.truth.walls.size());
        EXPECT_GT(planIou(s.truth, b), 0.93);
        for (const ArcWall& a : found)
        {
            EXPECT_NEAR(a.axis.radius_m(), real.front().axis.radius_m(), 0.01 * real.front().axis.radius_m());
            EXPECT_NEAR(a.wall->thickness.value_m, real.front().wall->thickness.value_m, 0.005);
            EXPECT_NEAR(a.wall->height.value_m, 2.8, 0.02);
            EXPECT_EQ(a.wall->evidence.facesSeen, 2);
            EXPECT_EQ(a.wall->thickness.provenance, Provenance::Measured);
        }
        EXPECT_GE(b.junctions.size(), s.truth.walls.size());  // each of these plans is closed
        EXPECT_LT(worstJunction(b), 1e-9);                    // common points are exact but for rounding
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, CurvedWalls,
                         testing::Values(Case{"RoundRoom", [] { return roundRoom(2.0, 0.12); }, 1},
                                         Case{"LargeRoundRoom", [] { return roundRoom(5.0, 0.3); }, 2},
                                         Case{"Apse", [] { return apse(2.5, 0.3, true); }, 3},
                                         Case{"ThinApse", [] { return apse(4.0, 0.12, true); }, 4},
                                         Case{"RoundCorner", [] { return roundCorner(2.0, 0.3); }, 5},
                                         Case{"ThinRoundCorner", [] { return roundCorner(5.0, 0.12); }, 6},
                                         Case{"Partition", [] { return partition(3.0, 70, 0.15); }, 7},
                                         Case{"WidePartition", [] { return partition(15.0, 40, 0.2); }, 8},
                                         Case{"HardlyCurved", [] { return partition(25.0, 20, 0.12); }, 9},
                                         Case{"Noisy", [] { return roundCorner(3.0, 0.2); }, 10, 0.008}),
                         [](const auto& i) { return i.param.name; });

TEST(CurvedWallsSeenFromOneSide, AssumeTheirThicknessOnTheOther)
{
    const SimulatedSurvey s = surveyOf(apse(3.0, 0.3, false), 11);
    const Building b = reconstructed(s);
    const std::vector<ArcWall> found = arcsOf(b);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found.front().wall->evidence.facesSeen, 1);
    EXPECT_EQ(found.front().wall->thickness.provenance, Provenance::Assumed);
    // The face that was seen stays where the points are.
    EXPECT_NEAR(found.front().axis.radius_m() - found.front().wall->thickness.value_m / 2, 3.0 - 0.15, 0.003);
    EXPECT_TRUE(std::any_of(b.diagnostics.begin(), b.diagnostics.end(), [&](const Diagnostic& d)
                            { return d.code == "ThicknessAssumed" && d.element == found.front().wall->id; }));
}

TEST(CurvedWallsWithADoor, HostItAtItsArcLength)
{
    const SimulatedSurvey s = surveyOf(roundRoom(3.0, 0.15, true), 12);
    const Opening& truth = s.truth.openings.front();
    const auto edges = [](const Building& b, const Opening& o)
    {
        const WallAxis axis(*b.wall(o.host));
        const auto at = [&](double u) -> Eigen::Vector2d
        {
            const Eigen::Vector2d p = axis.at(u);
            return b.frame.toWorld({p.x(), p.y(), 0}).head<2>();
        };
        return std::pair(at(o.offset_m), at(o.offset_m + o.width.value_m));
    };
    for (const bool geometryOnly : {false, true})
    {
        SCOPED_TRACE(geometryOnly ? "geometry only" : "labelled");
        const Building b = reconstructed(s, geometryOnly);
        ASSERT_EQ(b.openings.size(), 1u);
        const Opening& o = b.openings.front();
        EXPECT_EQ(o.kind, OpeningKind::Door);
        EXPECT_NE(b.wall(o.host)->bulge, 0.0);
        const auto [from, to] = edges(b, o);
        const auto [trueFrom, trueTo] = edges(s.truth, truth);
        // A lining hides 5 cm of each jamb where there are no labels to tell it from the wall.
        EXPECT_LT((from - trueFrom).norm(), geometryOnly ? 0.08 : 0.03);
        EXPECT_LT((to - trueTo).norm(), geometryOnly ? 0.08 : 0.03);
        EXPECT_NEAR(o.height.value_m, 2.1, geometryOnly ? 0.08 : 0.04);
    }
}

TEST(CurvedWallsAroundARoom, BoundIt)
{
    const SimulatedSurvey s = surveyOf(roundRoom(3.0, 0.15), 13);
    const Building b = reconstructed(s);
    const double area = std::numbers::pi * 2.925 * 2.925;
    EXPECT_TRUE(std::any_of(b.spaces.begin(), b.spaces.end(),
                            [&](const Space& space) { return std::abs(space.area_m2 - area) < 0.01 * area; }));
}

class StraightWalls : public testing::TestWithParam<Case>
{
};

TEST_P(StraightWalls, AreNeverArcs)
{
    const SimulatedSurvey s = surveyOf(GetParam().make(), GetParam().seed, GetParam().noise_m);
    for (const bool geometryOnly : {false, true})
        EXPECT_TRUE(arcsOf(reconstructed(s, geometryOnly)).empty());
}

INSTANTIATE_TEST_SUITE_P(Polygons, StraightWalls,
                         testing::Values(Case{"Octagon", [] { return octagon(4.0, 0.2); }, 1},
                                         Case{"NoisyOctagon", [] { return octagon(3.0, 0.3); }, 2, 0.008},
                                         Case{"Dodecagon", [] { return octagon(4.0, 0.12, 12); }, 3}),
                         [](const auto& i) { return i.param.name; });

TEST(StraightWallsOfAnOffice, AreNeverArcs)
{
    for (const std::uint64_t seed : {1u, 2u, 3u})
    {
        sim::BuildingSpec spec = smallOffice();
        spec.seed = seed;
        spec.yaw_deg = 11.0 * static_cast<double>(seed);
        const SimulatedSurvey s = survey(spec, quickScan());
        for (const bool geometryOnly : {false, true})
            EXPECT_TRUE(arcsOf(reconstructed(s, geometryOnly)).empty()) << "seed " << seed;
    }
}

TEST(CurvedWallsOfAnOffice, AreFoundAmongTheStraightOnes)
{
    sim::BuildingSpec spec = smallOffice();
    spec.curvedWalls = true;
    spec.obliqueWalls = false;  // with two rooms a side they take the arc's place
    const SimulatedSurvey s = survey(spec, quickScan());
    for (const bool geometryOnly : {false, true})
    {
        SCOPED_TRACE(geometryOnly ? "geometry only" : "labelled");
        const Building b = reconstructed(s, geometryOnly);
        EXPECT_EQ(arcsOf(b).size(), 1u);
        EXPECT_GT(planIou(s.truth, b), 0.8);
    }
}

}  // namespace
}  // namespace s2b::test

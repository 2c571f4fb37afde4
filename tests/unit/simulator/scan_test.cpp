// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "tests/simulator/scanner.h"

#include <Eigen/Eigenvalues>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace s2b::sim
{
namespace
{

struct Scan
{
    SimulatedBuilding building;
    Scene scene;
    std::vector<Station> stations;
    Survey survey;
};

Scan scanOf(const BuildingSpec& spec, ScanSettings settings = {}, bool outside = false)
{
    Scan s;
    s.building = makeBuilding(spec);
    s.scene = makeScene(s.building, spec.seed);
    s.stations = chooseStations(s.building, s.scene, outside, spec.seed);
    s.survey = scan(s.scene, s.stations, settings);
    return s;
}

ScanSettings coarse(double step_deg = 1.0)
{
    ScanSettings settings;
    settings.step_deg = step_deg;
    return settings;
}

std::size_t count(const Survey& survey, Label label)
{
    return static_cast<std::size_t>(std::count(survey.labels.begin(), survey.labels.end(), label));
}

TEST(Scan, IsTheSameForAnyNumberOfThreads)
{
    ScanSettings settings = coarse();
    settings.labelErrors = 0.05;
    settings.voxel_m = 0.03;
    settings.threads = 1;
    const Survey one = scanOf({}, settings).survey;
    settings.threads = 2;
    const Survey two = scanOf({}, settings).survey;
    EXPECT_GT(one.size(), 100000U);
    EXPECT_EQ(one.points, two.points);
    EXPECT_EQ(one.labels, two.labels);
    EXPECT_EQ(one.colours, two.colours);
    EXPECT_EQ(one.triangles, two.triangles);
    settings.seed = 2;
    EXPECT_NE(one.points, scanOf({}, settings).survey.points);
}

TEST(Scan, PutsPointsOnTheRoomsFacesWithinTheNoise)
{
    ScanSettings settings = coarse();
    settings.noise_m = 0.003;
    settings.mixedPixels = 0.0;
    const Survey survey = scanOf(oneRoom(5.0, 4.0, 2.7), settings).survey;
    // The room is [0.15, 5.15] x [0.15, 4.15] x [0, 2.7] in the frame of the wall axes.
    double sum = 0.0;
    double largest = 0.0;
    for (const Eigen::Vector3f& p : survey.points)
    {
        const Eigen::Vector3d q = p.cast<double>();
        const double d = std::min({std::abs(q.x() - 0.15), std::abs(q.x() - 5.15), std::abs(q.y() - 0.15),
                                   std::abs(q.y() - 4.15), std::abs(q.z()), std::abs(q.z() - 2.7)});
        sum += d * d;
        largest = std::max(largest, d);
    }
    const double rms = std::sqrt(sum / static_cast<double>(survey.size()));
    // Ranges here are 1 to 4 m, incidence 0 to 75 degrees: sigma 0.8 to 1.7 times 3 mm along the ray, times the cosine
    // across the face.
    EXPECT_GT(rms, 0.001);
    EXPECT_LT(rms, 0.003);
    EXPECT_LT(largest, 6.0 * 1.7 * 0.003);  // 6 sigma
}

TEST(Scan, HitsExactlyWithoutNoise)
{
    ScanSettings settings = coarse();
    settings.noise_m = 0.0;
    settings.mixedPixels = 0.0;
    BuildingSpec spec;
    spec.yaw_deg = 23.0;
    const Scan s = scanOf(spec, settings);
    double largest = 0.0;
    for (std::size_t i = 0; i < s.survey.size(); ++i)
    {
        const std::uint32_t t = s.survey.triangles[i];
        const Eigen::Vector3d d = s.survey.points[i].cast<double>() - s.scene.vertices[s.scene.triangles[t][0]];
        largest = std::max(largest, std::abs(d.dot(s.scene.normal(t))));
    }
    EXPECT_LT(largest, 5e-5);  // float coordinates and ranges at up to 40 m
}

TEST(Scan, LabelsAreTrueWithoutErrors)
{
    ScanSettings settings = coarse();
    settings.mixedPixels = 0.0;
    const Survey survey = scanOf(oneRoom(5.0, 4.0, 2.7), settings).survey;
    for (std::size_t i = 0; i < survey.size(); ++i)
    {
        const float z = survey.points[i].z();
        // 0.05 m off the corners, where a point may be either's.
        if (std::abs(z) < 0.03F)
            EXPECT_TRUE(survey.labels[i] == Label::Floor || survey.labels[i] == Label::Wall);
        else if (std::abs(z - 2.7F) < 0.03F)
            EXPECT_TRUE(survey.labels[i] == Label::Ceiling || survey.labels[i] == Label::Wall);
        else
            EXPECT_EQ(survey.labels[i], Label::Wall);
    }
    for (const Label label : {Label::Floor, Label::Ceiling, Label::Wall})
        EXPECT_GT(count(survey, label), survey.size() / 20);
}

TEST(Scan, MixesPixelsAtEdgesOnly)
{
    const auto share = [](const Survey& survey)
    {
        const auto mixed = std::count(survey.triangles.begin(), survey.triangles.end(), Survey::kNoTriangle);
        return static_cast<double>(mixed) / static_cast<double>(survey.size());
    };
    // An empty room has no edge with something behind it: what is left is corners seen at a grazing angle.
    EXPECT_LT(share(scanOf(oneRoom(), coarse(0.5)).survey), 0.0002);
    EXPECT_GT(share(scanOf({}, coarse()).survey), 0.001);
}

TEST(Scan, FlipsTheAskedShareOfLabels)
{
    ScanSettings settings = coarse();
    settings.labelErrors = 0.1;
    settings.mixedPixels = 0.0;
    const Scan s = scanOf({}, settings);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < s.survey.size(); ++i)
        wrong += s.survey.labels[i] != s.scene.surfaces[s.survey.triangles[i]].label ? 1U : 0U;
    // Half of the errors come in some thousand patches of unequal size: the share varies by a tenth of itself.
    EXPECT_NEAR(static_cast<double>(wrong) / static_cast<double>(s.survey.size()), 0.1, 0.015);
}

TEST(Scan, SeesEveryClassOfTheDefaultBuilding)
{
    const Survey survey = scanOf({}, coarse()).survey;
    for (const Label label : {Label::Floor, Label::Ceiling, Label::Wall, Label::Column, Label::Door, Label::Window,
                              Label::Furniture, Label::Unassigned})
        EXPECT_GT(count(survey, label), 500U) << static_cast<int>(label);
}

TEST(Scan, SeesNothingBehindAClosedDoorAndMuchBehindARemovedOne)
{
    const auto behind = [](double removed)
    {
        BuildingSpec spec = twoRoomsWithDoor();
        spec.openDoors = 0.0;
        spec.removedDoors = removed;
        const SimulatedBuilding building = makeBuilding(spec);
        const Scene scene = makeScene(building);
        const double partition = building.truth.walls[4].start.x();
        // One station, in the first room.
        const Survey survey = scan(scene, {{{partition / 2.0, 2.0, 1.5}, 0}}, coarse(0.5));
        return std::count_if(survey.points.begin(), survey.points.end(),
                             [&](const Eigen::Vector3f& p) { return static_cast<double>(p.x()) > partition + 0.15; });
    };
    EXPECT_EQ(behind(0.0), 0);
    EXPECT_GT(behind(1.0),
              1000);  // a door of 0.8 m by 2 m in the clear at 2.5 m: some 18 by 38 degrees of half-degree steps
}

TEST(Scan, NoLightComesThroughOuterWallsAndJoints)
{
    // Without openings and from inside, nothing beyond the outer faces may be seen, whatever the joints' angles.
    BuildingSpec spec;
    spec.doors = spec.windows = false;
    spec.facadeAngle_deg = 8.0;
    const Survey survey = scanOf(spec, coarse()).survey;
    EXPECT_EQ(std::count_if(survey.points.begin(), survey.points.end(),
                            [](const Eigen::Vector3f& p) { return p.x() < -0.5F || p.y() < -0.5F; }),
              0);
    spec.facadeAngle_deg = 0.0;
    spec.curvedFacade = true;
    const Scan curved = scanOf(spec, coarse());
    EXPECT_TRUE(std::none_of(curved.survey.triangles.begin(), curved.survey.triangles.end(),
                             [&](std::uint32_t t)
                             {
                                 return t != Survey::kNoTriangle &&
                                        curved.scene.elements[curved.scene.surfaces[t].element].type == "ground";
                             }));
}

TEST(Scan, SeesEachRoomsFloor)
{
    const Scan s = scanOf({}, coarse());
    for (const Space& space : s.building.truth.spaces)
    {
        Eigen::Vector2d low = space.outline.outer.front();
        Eigen::Vector2d high = low;
        for (const Eigen::Vector2d& p : space.outline.outer)
        {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        std::size_t points = 0;
        for (std::size_t i = 0; i < s.survey.size(); ++i)
        {
            const Eigen::Vector3d p = s.survey.points[i].cast<double>();
            points += s.survey.labels[i] == Label::Floor && std::abs(p.z() - space.floor_m) < 0.05 &&
                              (p.head<2>().array() > low.array()).all() && (p.head<2>().array() < high.array()).all()
                          ? 1U
                          : 0U;
        }
        // In a cubicle the tripod hides all but a strip at its far end.
        EXPECT_GT(points, space.area_m2 < 3.0 ? 30U : 300U) << space.name;
    }
}

TEST(Scan, DensityFallsWithTheSquareOfTheRange)
{
    const Survey survey =
        scan(makeScene(makeBuilding(oneRoom(20.0, 4.0, 2.7))), {{{2.15, 2.15, 1.5}, 0}}, coarse(0.25));
    const auto onWall = [&](double x, double y0)
    {
        return std::count_if(survey.points.begin(), survey.points.end(),
                             [&](const Eigen::Vector3f& p)
                             {
                                 return std::abs(static_cast<double>(p.x()) - x) < 0.03 &&
                                        static_cast<double>(p.y()) > y0 && static_cast<double>(p.z()) > 1.0 &&
                                        static_cast<double>(p.z()) < 2.0;
                             });
    };
    // End walls at 2 m and 18 m: 81 times fewer points on the same square metre; a factor of 2 for incidence and
    // drop-out.
    const double near = static_cast<double>(onWall(0.15, 1.65));
    const double far = static_cast<double>(onWall(20.15, 1.65));
    EXPECT_GT(near / far, 40.0);
    EXPECT_LT(near / far, 160.0);
}

TEST(Scan, GlassReturnsLittle)
{
    BuildingSpec spec;
    spec.storeys = 1;
    ScanSettings settings = coarse();
    const auto onGlass = [&](const Scan& s)
    {
        return std::count_if(s.survey.triangles.begin(), s.survey.triangles.end(), [&](std::uint32_t t)
                             { return t != Survey::kNoTriangle && s.scene.surfaces[t].material == Material::Glass; });
    };
    const Scan real = scanOf(spec, settings);
    settings.glassReturn = 1.0;
    const auto all = onGlass(scanOf(spec, settings));
    EXPECT_GT(onGlass(real), 0);
    EXPECT_LT(onGlass(real), all / 5);
    // What it lets through lies on the ground outside.
    EXPECT_TRUE(std::any_of(
        real.survey.triangles.begin(), real.survey.triangles.end(), [&](std::uint32_t t)
        { return t != Survey::kNoTriangle && real.scene.elements[real.scene.surfaces[t].element].type == "ground"; }));
}

TEST(Scan, KeepsOnePointAVoxel)
{
    ScanSettings settings = coarse();
    settings.voxel_m = 0.05;
    const Survey survey = scanOf(oneRoom(), settings).survey;
    std::set<std::array<int, 3>> voxels;
    for (const Eigen::Vector3f& p : survey.points)
        voxels.insert({static_cast<int>(std::floor(static_cast<double>(p.x()) * (1.0 / 0.05))),
                       static_cast<int>(std::floor(static_cast<double>(p.y()) * (1.0 / 0.05))),
                       static_cast<int>(std::floor(static_cast<double>(p.z()) * (1.0 / 0.05)))});
    EXPECT_EQ(voxels.size(), survey.size());
}

TEST(Scan, RespectsTheRangeLimits)
{
    ScanSettings settings = coarse(2.0);
    settings.noise_m = 0.0;
    settings.mixedPixels = 0.0;
    settings.rangeMin_m = 1.0;
    settings.rangeMax_m = 3.0;
    const Scan s = scanOf({}, settings);
    for (std::size_t i = 0; i < s.survey.size(); ++i)
    {
        const double range = (s.survey.points[i].cast<double>() - s.stations[s.survey.stations[i]].position).norm();
        EXPECT_GT(range, 1.0 - 1e-4);  // float
        EXPECT_LT(range, 3.0 + 1e-4);
    }
}

TEST(Scan, LinesOfALineLaserMeetAtTheZenith)
{
    const Scene scene = makeScene(makeBuilding(oneRoom()));
    const Eigen::Vector3d at(2.0, 2.0, 1.5);
    ScanSettings settings = coarse();
    const Survey thinned = scan(scene, {{at, 0}}, settings);
    settings.lineStep_deg = 2.0;
    const Survey lines = scan(scene, {{at, 0}}, settings);
    const auto above = [&](const Survey& survey)
    {
        return std::count_if(survey.points.begin(), survey.points.end(), [&](const Eigen::Vector3f& p)
                             { return p.z() > 2.0F && (p.head<2>().cast<double>() - at.head<2>()).norm() < 0.1; });
    };
    EXPECT_GT(above(lines), 4 * above(thinned));
    // Lines are 2 degrees apart, and so are nearly all points 2 degrees or nothing from the first line.
    const double phase = std::atan2(lines.points[0].y() - 2.0, lines.points[0].x() - 2.0) * 90.0 / std::numbers::pi;
    const auto onLines = std::count_if(
        lines.points.begin(), lines.points.end(),
        [&](const Eigen::Vector3f& p)
        {
            return std::abs(std::remainder(std::atan2(p.y() - 2.0, p.x() - 2.0) * 90.0 / std::numbers::pi - phase,
                                           1.0)) < 0.15;
        });
    EXPECT_GT(static_cast<double>(onLines), 0.98 * static_cast<double>(lines.size()));
}

TEST(Scan, RoundsTheRange)
{
    ScanSettings settings = coarse();
    settings.rangeStep_m = 0.05;
    const Eigen::Vector3d at(2.0, 2.0, 1.5);
    for (const Eigen::Vector3f& p : scan(makeScene(makeBuilding(oneRoom())), {{at, 0}}, settings).points)
        ASSERT_NEAR(std::remainder((p.cast<double>() - at).norm(), 0.05), 0.0, 1e-5);
}

TEST(Scan, ATiltedSetUpGivesALeaningRoomAndAWarpABentOne)
{
    const Scene scene = makeScene(makeBuilding(oneRoom()));
    // Normal of the floor's best plane, and the RMS distance from it.
    const auto floorOf = [&](const ScanSettings& settings)
    {
        const Survey survey = scan(scene, {{{2.0, 2.0, 1.5}, 0}}, settings);
        Eigen::MatrixX3d points(static_cast<Eigen::Index>(count(survey, Label::Floor)), 3);
        Eigen::Index row = 0;
        for (std::size_t i = 0; i < survey.size(); ++i)
            if (survey.labels[i] == Label::Floor)
                points.row(row++) = survey.points[i].cast<double>().transpose();
        points.rowwise() -= points.colwise().mean().eval();
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(points.transpose() * points);
        return std::pair{Eigen::Vector3d(solver.eigenvectors().col(0)),
                         std::sqrt(std::max(0.0, solver.eigenvalues()[0]) / static_cast<double>(row))};
    };
    ScanSettings settings = coarse();
    settings.noise_m = settings.mixedPixels = 0.0;
    settings.tilt_deg = 5.0;
    const auto [leaning, flat] = floorOf(settings);
    EXPECT_NEAR(std::acos(std::abs(leaning.z())) * 180.0 / std::numbers::pi, 5.0, 0.01);
    EXPECT_LT(flat, 1e-4);
    settings.tilt_deg = 0.0;
    settings.warp_m = 0.05;
    EXPECT_GT(floorOf(settings).second, 0.003);
    EXPECT_LT(floorOf(settings).second, 0.05);
}

TEST(Scan, FewStationsAreNeighboursWithinTheBuilding)
{
    const SimulatedBuilding building = makeBuilding({});
    const std::vector<Station> all = chooseStations(building, makeScene(building), true);
    for (std::uint64_t seed = 1; seed < 20; ++seed)
    {
        const std::vector<Station> few = fewStations(all, 3, seed);
        ASSERT_EQ(few.size(), 3U);
        const double reach = (few.back().position - few.front().position).norm();
        for (const Station& s : few)
            EXPECT_EQ(s.storey, few.front().storey);
        EXPECT_EQ(std::count_if(
                      all.begin(), all.end(), [&](const Station& s)
                      { return s.storey == few.front().storey && (s.position - few.front().position).norm() < reach; }),
                  2);
    }
    EXPECT_EQ(fewStations(all, 0, 1).size(), all.size());
}

TEST(Scan, ScansAMillionRaysASecond)
{
    const SimulatedBuilding building = makeBuilding({});
    const Scene scene = makeScene(building);
    const std::vector<Station> stations = chooseStations(building, scene, false);
    const auto start = std::chrono::steady_clock::now();
    const Survey survey = scan(scene, stations, coarse());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    RecordProperty("points_per_second", std::to_string(static_cast<double>(survey.size()) / seconds));
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    // An idle core does more than three million; a tenth of it leaves room for a busy machine.
    EXPECT_GT(static_cast<double>(survey.size()) / seconds, 3e5);
#endif
}

TEST(Scan, CoverageStationsSeeWhatRoomStationsSee)
{
    const SimulatedBuilding building = makeBuilding({});
    const Scene scene = makeScene(building);
    const std::vector<Station> stations = chooseStations(scene, false);
    EXPECT_GT(stations.size(), 10U);
    EXPECT_LT(stations.size(), 80U);
    const Survey survey = scan(scene, stations, coarse());
    std::set<std::uint32_t> walls;
    for (const std::uint32_t t : survey.triangles)
        if (t != Survey::kNoTriangle && scene.surfaces[t].label == Label::Wall)
            walls.insert(scene.surfaces[t].element);
    EXPECT_EQ(walls.size(), building.truth.walls.size());
}

TEST(Scan, RefusesSettingsOutOfRange)
{
    const Scene scene = makeScene(makeBuilding(oneRoom()));
    const std::vector<Station> stations{{{2.0, 2.0, 1.5}, 0}};
    ScanSettings settings;
    settings.step_deg = 0.0;
    EXPECT_THROW((void)scan(scene, stations, settings), Error);
    settings = {};
    settings.lineStep_deg = 20.0;
    EXPECT_THROW((void)scan(scene, stations, settings), Error);
    settings = {};
    settings.labelErrors = 1.5;
    EXPECT_THROW((void)scan(scene, stations, settings), Error);
    EXPECT_THROW((void)scan(scene, {}, {}), Error);
}

}  // namespace
}  // namespace s2b::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/validation/loa.h"
#include "tests/validation/sample_bims.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <stop_token>

namespace s2b
{
namespace
{

using namespace test;

// Points are floats near the origin: 1e-7 m. Sums are in whole micrometres: half of one at most is lost per point.
constexpr double kRounding = 1e-6;
// Quantiles are read from bins of 0.1 mm.
constexpr double kBin = 1e-4;

/// The wall y in [-0.1, 0.1], x in [0, 4], z in [0, 3].
Bim oneWall()
{
    return bimOf({wall({0, 0}, {4, 0}, 0.2)});
}

TEST(Deviation, OfAPlaneIsItsOffset)
{
    Points points;
    points.face({0, -0.103, 0}, {4, 0, 0}, {0, 0, 3});
    const CloudDeviation d = measureDeviation(oneWall(), points.view(), {}, true, {});
    const Deviation& e = d.elements.front();
    EXPECT_EQ(e.points, points.labels.size());
    EXPECT_NEAR(e.meanAbsolute_m, 0.003, kRounding);
    EXPECT_NEAR(e.meanSigned_m, 0.003, kRounding) << "outside";
    EXPECT_NEAR(e.rms_m, 0.003, kRounding);
    EXPECT_NEAR(e.median_m, 0.003, kBin);
    EXPECT_NEAR(e.p95_m, 0.003, kBin);
    EXPECT_NEAR(d.wallMeanAbsolute_m, 0.003, kRounding);
    EXPECT_EQ(e.band, LoaBand::Loa40);
    EXPECT_EQ(e.verdict, Verdict::Within);
    EXPECT_NEAR(d.distance_m.front(), 0.003, kRounding);
    EXPECT_EQ(d.element.front(), 0);
}

TEST(Deviation, InsideIsNegative)
{
    Points points;
    points.face({0, -0.08, 0.1}, {4, 0, 0}, {0, 0, 2.8});
    points.face({0, 0.12, 0.1}, {4, 0, 0}, {0, 0, 2.8});
    const Deviation e = measureDeviation(oneWall(), points.view(), {}, false, {}).elements.front();
    EXPECT_NEAR(e.meanAbsolute_m, 0.02, kRounding);
    EXPECT_NEAR(e.meanSigned_m, 0.0, kRounding);
    EXPECT_NEAR(e.rms_m, 0.02, kRounding);
}

TEST(Deviation, TheSideIsRightBesideEdgesAndCorners)
{
    Points points;
    points.add({-0.03, -0.14, 1.0});   // beside an edge: 3 and 4 cm
    points.add({-0.03, -0.14, 3.12});  // beyond a corner: 3, 4 and 12 cm
    points.add({0.01, -0.09, 1.0});    // inside, as near to two faces
    const CloudDeviation d = measureDeviation(oneWall(), points.view(), {}, true, {});
    EXPECT_NEAR(d.distance_m[0], 0.05, kRounding);
    EXPECT_NEAR(d.distance_m[1], 0.13, kRounding);
    EXPECT_NEAR(d.distance_m[2], -0.01, kRounding);
}

TEST(Deviation, AnInsideOutMeshIsTurned)
{
    Bim bim = oneWall();
    for (auto& t : bim.elements[0].mesh.triangles)
        std::swap(t[0], t[1]);
    Points points;
    points.add({1, -0.15, 1});
    EXPECT_NEAR(measureDeviation(bim, points.view(), {}, true, {}).distance_m[0], 0.05, kRounding);
}

TEST(Deviation, TrianglesWithoutAnAreaAreNoSurface)
{
    Bim bim = oneWall();
    Mesh& mesh = bim.elements[0].mesh;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    // A needle of 1e-9 m (two corners are the same float), two equal corners, three in a line: all nearer than the
    // wall.
    mesh.vertices.emplace_back(1.0, -0.15, 1.0);
    mesh.vertices.emplace_back(1.0 + 1e-9, -0.15, 1.0);
    mesh.vertices.emplace_back(1.5, -0.15, 1.4);
    mesh.vertices.emplace_back(2.0, -0.15, 1.8);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
    Points points;
    points.add({1.0, -0.16, 1});
    EXPECT_NEAR(measureDeviation(bim, points.view(), {}, true, {}).distance_m[0], 0.06, kRounding);
}

TEST(Deviation, PointsBeyondTheRangeAreNotOfTheBuilding)
{
    Points points;
    points.add({1, -0.29, 1});
    points.add({1, -0.31, 1});
    points.add({std::nan(""), 0, 1});
    const CloudDeviation d = measureDeviation(oneWall(), points.view(), {}, true, {});
    EXPECT_EQ(d.elements[0].points, 1U);
    EXPECT_NEAR(d.distance_m[0], 0.19, kRounding);
    EXPECT_TRUE(std::isnan(d.distance_m[1]));
    EXPECT_EQ(d.element[1], -1);
    EXPECT_TRUE(std::isnan(d.distance_m[2]));
}

TEST(Deviation, QuantilesAndBandsAreThoseOfTheDistances)
{
    // 100 points at 0, 0.1 ... 9.9 mm: the median lies at 5, 95 % below 9.5 mm.
    Points points;
    for (int i = 0; i < 100; ++i)
        points.add({0.02 + 0.04 * i, -0.1 - 1e-4 * i, 1.5});
    const Deviation e = measureDeviation(oneWall(), points.view(), {.minimumCoverage = 0.0}, false, {}).elements[0];
    EXPECT_NEAR(e.median_m, 0.005, 2 * kBin);
    EXPECT_NEAR(e.p95_m, 0.0095, 2 * kBin);
    EXPECT_EQ(e.band, LoaBand::Loa30);
    EXPECT_NEAR(e.meanAbsolute_m, 0.00495, kRounding);
}

TEST(Deviation, BandsEndAtTheirLimits)
{
    const ValidationParams params;
    EXPECT_EQ(bandOf(0.001, params), LoaBand::Loa50);
    EXPECT_EQ(bandOf(0.0011, params), LoaBand::Loa40);
    EXPECT_EQ(bandOf(0.005, params), LoaBand::Loa40);
    EXPECT_EQ(bandOf(0.015, params), LoaBand::Loa30);
    EXPECT_EQ(bandOf(0.05, params), LoaBand::Loa20);
    EXPECT_EQ(bandOf(0.15, params), LoaBand::Loa10);
    EXPECT_EQ(bandOf(0.151, params), LoaBand::Beyond);
}

TEST(Deviation, TheVerdictFollowsTheToleranceAskedFor)
{
    Points points;
    points.face({0, -0.12, 0}, {4, 0, 0}, {0, 0, 3});  // 2 cm: LOA20
    EXPECT_EQ(measureDeviation(oneWall(), points.view(), {.tolerance = 30}, false, {}).elements[0].verdict,
              Verdict::OutOfTolerance);
    EXPECT_EQ(measureDeviation(oneWall(), points.view(), {.tolerance = 20}, false, {}).elements[0].verdict,
              Verdict::Within);
    EXPECT_EQ(measureDeviation(oneWall(), Points{}.view(), {}, false, {}).elements[0].verdict, Verdict::NoData);
}

TEST(Deviation, CoverageIsTheShareOfTheSurfaceThatHasPoints)
{
    // Half of one of the two long faces (2 x 12 m2); ends, top and bottom are 2 * 0.6 + 2 * 0.8 m2.
    Points points;
    points.face({0, -0.1, 0}, {2, 0, 0}, {0, 0, 3});
    const Deviation e = measureDeviation(oneWall(), points.view(), {}, false, {}).elements[0];
    EXPECT_NEAR(e.coverage, 6.0 / 26.8, 1e-5) << "cells fit the faces exactly";
}

TEST(Deviation, FacesThatTouchOtherElementsCanNotBeSeen)
{
    // Between two slabs and two walls only the long faces of the middle wall can have points.
    const Bim bim = bimOf({wall({0, 0}, {4, 0}, 0.2), wall({-0.1, -2}, {-0.1, 2}, 0.2), wall({4.1, -2}, {4.1, 2}, 0.2),
                           box(ElementClass::Slab, rectangle(-1, -2, 5, 2), -0.2, 0),
                           box(ElementClass::Slab, rectangle(-1, -2, 5, 2), 3, 3.2)});
    Points points;
    points.face({0, -0.1, 0}, {4, 0, 0}, {0, 0, 3});
    EXPECT_NEAR(measureDeviation(bim, points.view(), {}, false, {}).elements[0].coverage, 0.5, 1e-5);
}

TEST(Deviation, AnOpeningIsNoSurface)
{
    BimElement door = box(ElementClass::Door, rectangle(1, -0.1, 2, 0.1), 0, 2);
    door.host = 0;
    const Bim bim = bimOf({wall({0, 0}, {4, 0}, 0.2), door});
    Points points;
    points.add({1.5, 0.1, 1.0});  // in the middle of the opening: the leaf, 5 cm thick, is nearer than the reveal
    const CloudDeviation d = measureDeviation(bim, points.view(), {}, true, {});
    EXPECT_EQ(d.element[0], 1);
    EXPECT_NEAR(d.distance_m[0], 0.075, kRounding);
}

TEST(Deviation, LabelledPointsAreComparedWithTheirOwnClassOnly)
{
    const Bim bim = bimOf({wall({0, 0}, {4, 0}, 0.2), box(ElementClass::Slab, rectangle(0, -3, 4, 3), -0.2, 0)});
    Points points;
    points.add({1, -0.15, 0.01}, Label::Wall);  // nearer to the floor than to the wall
    points.add({1, -0.15, 0.01}, Label::Floor);
    points.add({1, -0.15, 0.01}, Label::Furniture);  // stands on no element
    const CloudDeviation with = measureDeviation(bim, points.view(true), {}, true, {});
    EXPECT_EQ(with.element, (std::vector<std::int32_t>{0, 1, -1}));
    EXPECT_NEAR(with.distance_m[0], 0.05, kRounding);
    EXPECT_NEAR(with.distance_m[1], 0.01, kRounding);
    EXPECT_NEAR(with.wallMeanAbsolute_m, 0.05, kRounding);
    const CloudDeviation without = measureDeviation(bim, points.view(false), {}, true, {});
    EXPECT_EQ(without.element, (std::vector<std::int32_t>{1, 1, 1}));
}

TEST(Deviation, ClassesThatTheLabelsDoNotTellApartAreComparedWithAllPoints)
{
    const Bim bim = bimOf({wall({0, 0}, {4, 0}, 0.2), box(ElementClass::Column, rectangle(1, 0.15, 1.4, 0.55), 0, 3)});
    Points points;
    points.add({1.2, 0.14, 1}, Label::Wall);
    points.add({1.2, 0.56, 1}, Label::Furniture);
    const CloudDeviation untold = measureDeviation(bim, points.view(true), {}, true, {});
    EXPECT_EQ(untold.element, (std::vector<std::int32_t>{1, 1}));
    points.add({1.2, 0.56, 1}, Label::Column);
    const CloudDeviation told = measureDeviation(bim, points.view(true), {}, true, {});
    EXPECT_EQ(told.element, (std::vector<std::int32_t>{0, -1, 1}));
}

TEST(Deviation, TheHistogramSpansTheRange)
{
    Points points;
    points.add({1, -0.2999, 1});
    points.add({1, 0.01, 1});  // 9 cm inside
    const CloudDeviation d = measureDeviation(oneWall(), points.view(), {}, false, {});
    EXPECT_EQ(d.histogram[63], 1U);
    EXPECT_EQ(d.histogram[17], 1U) << "(-0.09 + 0.2) / 0.4 of 64 bars";
}

TEST(Deviation, IsTheSameFarFromTheOrigin)
{
    Bim bim = oneWall();
    bim.origin = {3.2e7, 5.6e6, 120};
    Points points;
    points.face({0, -0.103, 0}, {4, 0, 0}, {0, 0, 3});
    points.origin = bim.origin;
    EXPECT_NEAR(measureDeviation(bim, points.view(), {}, false, {}).elements[0].meanAbsolute_m, 0.003, kRounding);
}

/// A room with furniture and noise.
struct Room
{
    Bim bim = bimOf({wall({0, 0}, {6, 0}, 0.2), wall({6, 0}, {6, 4}, 0.2), wall({6, 4}, {0, 4}, 0.2),
                     wall({0, 4}, {0, 0}, 0.2), box(ElementClass::Slab, rectangle(0, 0, 6, 4), -0.2, 0)});
    Points points;
    explicit Room(std::uint64_t count)
    {
        for (std::uint64_t i = 0; i < count; ++i)
            points.add(
                {7 * randomShare(1, 0, i) - 0.5, 5 * randomShare(2, 0, i) - 0.5, 3.4 * randomShare(3, 0, i) - 0.2},
                randomShare(4, 0, i) < 0.5 ? Label::Wall : Label::Floor);
    }
};

TEST(Deviation, IsTheSameForAnyNumberOfThreads)
{
    const Room room(200000);
    for (const bool withLabels : {false, true})
    {
        Context one;
        one.threads = 1;
        const CloudDeviation a = measureDeviation(room.bim, room.points.view(withLabels), {}, true, one);
        Context many;
        many.threads = 7;
        const CloudDeviation b = measureDeviation(room.bim, room.points.view(withLabels), {}, true, many);
        EXPECT_EQ(a.element, b.element);
        EXPECT_EQ(a.histogram, b.histogram);
        EXPECT_EQ(a.meanAbsolute_m, b.meanAbsolute_m);
        for (std::size_t i = 0; i < a.distance_m.size(); ++i)
            ASSERT_TRUE(a.distance_m[i] == b.distance_m[i] ||
                        (std::isnan(a.distance_m[i]) && std::isnan(b.distance_m[i])));
        for (std::size_t e = 0; e < a.elements.size(); ++e)
        {
            EXPECT_EQ(a.elements[e].rms_m, b.elements[e].rms_m);
            EXPECT_EQ(a.elements[e].p95_m, b.elements[e].p95_m);
            EXPECT_EQ(a.elements[e].coverage, b.elements[e].coverage);
        }
    }
}

TEST(Deviation, EqualsTheDistanceToAllTriangles)
{
    const Room room(3000);
    const CloudDeviation d = measureDeviation(room.bim, room.points.view(), {}, true, {});
    for (std::size_t i = 0; i < d.distance_m.size(); ++i)
    {
        const Eigen::Vector3d p = Eigen::Vector3f(room.points.xyz.data() + 3 * i).cast<double>();
        // To boxes: outside the distance to the box, inside the one to its nearest face.
        double nearest = 1e9;
        for (const BimElement& e : room.bim.elements)
        {
            Eigen::AlignedBox3d box;
            for (const Eigen::Vector3d& v : e.mesh.vertices)
                box.extend(v);
            const double inside = std::min((p - box.min()).minCoeff(), (box.max() - p).minCoeff());
            nearest = std::min(nearest, inside > 0.0 ? inside : box.exteriorDistance(p));
        }
        if (nearest > 0.2)
            EXPECT_TRUE(std::isnan(d.distance_m[i]));
        else
            EXPECT_NEAR(std::abs(d.distance_m[i]), nearest, 5e-6) << "floats of up to 7 m";
    }
}

TEST(Deviation, ACancelledOneEnds)
{
    std::stop_source stop;
    stop.request_stop();
    Context context;
    context.cancel = stop.get_token();
    const Room room(1000);
    EXPECT_THROW((void)measureDeviation(room.bim, room.points.view(), {}, false, context), Cancelled);
}

TEST(Deviation, OfABimWithoutSurfacesIsEmpty)
{
    Points points;
    points.add({0, 0, 0});
    const CloudDeviation d = measureDeviation(bimOf({}), points.view(true), {}, true, {});
    EXPECT_TRUE(d.elements.empty());
    EXPECT_TRUE(std::isnan(d.distance_m[0]));
}

}  // namespace
}  // namespace s2b

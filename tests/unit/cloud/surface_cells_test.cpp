// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/surface_cells.h"
#include "tests/support/stages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace s2b
{
namespace
{

using test::cellsOf;
using test::HandMadeCloud;

std::uint64_t pointsIn(const SurfaceCells& cells)
{
    std::uint64_t sum = 0;
    for (const SurfaceCell& c : cells.cells)
        sum += c.count;
    return sum;
}

/// Share of the points whose cell has a normal within `angle_rad` of n.
double shareWithNormal(const SurfaceCells& cells, const Eigen::Vector3d& n, double angle_rad)
{
    std::uint64_t good = 0;
    for (const SurfaceCell& c : cells.cells)
        if (!c.normal.isZero() &&
            c.normal.cast<double>().normalized().cross(n.normalized()).norm() < std::sin(angle_rad))
            good += c.count;
    return static_cast<double>(good) / static_cast<double>(pointsIn(cells));
}

void expectSame(const SurfaceCells& a, const SurfaceCells& b)
{
    EXPECT_EQ(a.size_m, b.size_m);
    EXPECT_EQ(a.spacing_m, b.spacing_m);
    ASSERT_EQ(a.cells.size(), b.cells.size());
    for (std::size_t i = 0; i < a.cells.size(); ++i)
    {
        const SurfaceCell &x = a.cells[i], &y = b.cells[i];
        ASSERT_EQ(x.position, y.position) << "cell " << i;
        ASSERT_EQ(x.normal, y.normal) << "cell " << i;
        ASSERT_EQ(x.flatness, y.flatness) << "cell " << i;
        ASSERT_EQ(x.count, y.count) << "cell " << i;
        ASSERT_EQ(x.label, y.label) << "cell " << i;
        ASSERT_EQ(x.labelShare, y.labelShare) << "cell " << i;
        ASSERT_EQ(x.facesScanner, y.facesScanner) << "cell " << i;
    }
}

HandMadeCloud noisyRoom()
{
    HandMadeCloud cloud(0.02, 0.003);
    cloud.room({0.013, 0.007}, {3.0, 2.5}, 0.004);
    return cloud;
}

class PlaneNormals : public testing::TestWithParam<std::array<double, 3>>
{
};

TEST_P(PlaneNormals, AreExact)
{
    const Eigen::Vector3d n = Eigen::Vector3d(GetParam()[0], GetParam()[1], GetParam()[2]).normalized();
    const Eigen::Vector3d u = n.unitOrthogonal(), v = n.cross(u);
    HandMadeCloud cloud(0.005);
    cloud.rectangle({0.313, -0.127, 1.071}, u, v, Label::Wall);
    const SurfaceCells cells = cellsOf(cloud);
    EXPECT_EQ(cells.size_m, 0.02);
    // Positions are rounded to 1/4096 of a 2 cm cell, over a neighbourhood of 6 cm: below 2e-4. Corner cells of the
    // rectangle may hold too few points.
    EXPECT_GT(shareWithNormal(cells, n, 1e-3), 0.999);
    for (const SurfaceCell& c : cells.cells)
    {
        EXPECT_LT(std::abs(n.dot(c.position.cast<double>() - Eigen::Vector3d(0.313, -0.127, 1.071))), 1e-5);
        EXPECT_LT(c.flatness, 1e-5f);
    }
}

INSTANTIATE_TEST_SUITE_P(Directions, PlaneNormals,
                         testing::Values(std::array{1.0, 0.0, 0.0}, std::array{0.0, 1.0, 0.0},
                                         std::array{0.0, 0.0, 1.0}, std::array{1.0, 1.0, 0.0},
                                         std::array{1.0, 2.0, 3.0}, std::array{0.05, -1.0, 0.02}));

TEST(SurfaceCells, CountEveryPointOnce)
{
    const HandMadeCloud cloud = noisyRoom();
    const SurfaceCells cells = cellsOf(cloud);
    EXPECT_EQ(pointsIn(cells), cloud.size());
    EXPECT_TRUE(cells.hasLabels);
}

TEST(SurfaceCells, LeaveOutWhatLiesOutsideTheRegion)
{
    const HandMadeCloud cloud = noisyRoom();
    KeptRegion region;
    region.everything = false;
    region.center = {1.0, 1.0};
    region.half = {0.5, 0.5};
    region.zMin = -1.0;
    region.zMax = 1.0;
    std::uint64_t inside = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
        inside += region.contains({cloud.view().xyz[3 * i], cloud.view().xyz[3 * i + 1], cloud.view().xyz[3 * i + 2]});
    const SurfaceCells cells = buildSurfaceCells(cloud.view(), region, {}, {});
    EXPECT_GT(inside, 1000u);
    EXPECT_EQ(pointsIn(cells), inside);
}

TEST(SurfaceCells, TakeTheMostFrequentLabelAndItsShare)
{
    HandMadeCloud cloud;
    for (int i = 0; i < 3; ++i)
        cloud.point({0.011, 0.011, 0.011}, Label::Window);
    for (int i = 0; i < 2; ++i)
        cloud.point({0.009, 0.009, 0.009}, Label::Wall);
    const SurfaceCells cells = cellsOf(cloud);
    ASSERT_EQ(cells.cells.size(), 1u);
    EXPECT_EQ(cells.cells[0].label, Label::Window);
    EXPECT_EQ(cells.cells[0].labelShare, 255 * 3 / 5);
    EXPECT_FALSE(cellsOf(cloud, false).hasLabels);
    EXPECT_EQ(cellsOf(cloud, false).cells[0].label, Label::Unassigned);
}

TEST(SurfaceCells, WeighTheLabelsOfAModelByItsConfidence)
{
    HandMadeCloud cloud;
    for (int i = 0; i < 3; ++i)
        cloud.point({0.011, 0.011, 0.011}, Label::Window);
    for (int i = 0; i < 2; ++i)
        cloud.point({0.009, 0.009, 0.009}, Label::Wall);
    const auto cellOf = [&](const std::vector<std::uint8_t>& confidence)
    {
        CloudView view = cloud.view();
        view.confidence = confidence.data();
        const SurfaceCells cells = buildSurfaceCells(view, {}, {}, {});
        EXPECT_TRUE(cells.hasLabels && cells.hasGuesses);
        return cells.cells.at(0);
    };
    EXPECT_FALSE(cellsOf(cloud).hasGuesses);
    EXPECT_EQ(cellOf({255, 255, 255, 255, 255}).label, Label::Window);
    EXPECT_EQ(cellOf({255, 255, 255, 255, 255}).labelShare, 255 * 3 / 5) << "the same as of given labels";
    EXPECT_EQ(cellOf({100, 100, 100, 255, 255}).label, Label::Wall);
    EXPECT_EQ(cellOf({100, 100, 100, 255, 255}).labelShare, 255 * 2 / 5);
    EXPECT_EQ(cellOf({100, 100, 100, 100, 100}).label, Label::Unassigned) << "nobody is sure";
    EXPECT_EQ(cellOf({0, 0, 0, 0, 0}).label, Label::Unassigned);
}

TEST(SurfaceCells, DoNotDependOnThePointsOrder)
{
    HandMadeCloud cloud = noisyRoom();
    const SurfaceCells before = cellsOf(cloud);
    cloud.shuffle(3);
    expectSame(before, cellsOf(cloud));
}

TEST(SurfaceCells, DoNotDependOnTheNumberOfThreads)
{
    const HandMadeCloud cloud = noisyRoom();
    Context one, four;
    one.threads = 1;
    four.threads = 4;
    expectSame(buildSurfaceCells(cloud.view(), {}, {}, one), buildSurfaceCells(cloud.view(), {}, {}, four));
}

TEST(SurfaceCells, NameTheFirstPointThatIsNotFinite)
{
    HandMadeCloud cloud = noisyRoom();
    cloud.cloud().points[4321].y() = std::numeric_limits<float>::quiet_NaN();
    cloud.cloud().points[7777].z() = std::numeric_limits<float>::infinity();
    for (const unsigned threads : {1u, 2u})
    {
        Context context;
        context.threads = threads;
        try
        {
            (void)buildSurfaceCells(cloud.view(), {}, {}, context);
            FAIL() << "a point that is not finite went through";
        }
        catch (const Error& e)
        {
            EXPECT_EQ(e.code(), ErrorCode::BadCoordinates);
            EXPECT_THAT(e.what(), testing::HasSubstr("point 4321 "));
        }
    }
}

TEST(SurfaceCells, RefuseAnEmptyCloud)
{
    const auto codeOf = [](const CloudView& view, const KeptRegion& region)
    {
        try
        {
            (void)buildSurfaceCells(view, region, {}, {});
        }
        catch (const Error& e)
        {
            return e.code();
        }
        return ErrorCode::Internal;
    };
    EXPECT_EQ(codeOf({}, {}), ErrorCode::EmptyCloud);
    KeptRegion nowhere;
    nowhere.everything = false;
    nowhere.center = {1000.0, 0.0};
    EXPECT_EQ(codeOf(noisyRoom().view(), nowhere), ErrorCode::EmptyCloud);
}

TEST(SurfaceCells, RefuseACloudThatSpansKilometresWithAHint)
{
    HandMadeCloud cloud = noisyRoom();
    cloud.point({2e5, 2e5, 100.0}, Label::Unassigned);
    try
    {
        (void)cellsOf(cloud);
        FAIL() << "200 km went through";
    }
    catch (const Error& e)
    {
        EXPECT_EQ(e.code(), ErrorCode::BadCoordinates);
        EXPECT_THAT(e.what(), testing::HasSubstr("clutter filter"));
    }
}

TEST(SurfaceCells, TakeOnePointOrManyEqualOnes)
{
    HandMadeCloud cloud;
    cloud.point({-0.001, 5.0, 2.0}, Label::Wall);
    EXPECT_EQ(cellsOf(cloud).cells.size(), 1u);
    EXPECT_TRUE(cellsOf(cloud).cells[0].normal.isZero());
    for (int i = 0; i < 1000; ++i)
        cloud.point({-0.001, 5.0, 2.0}, Label::Wall);
    const SurfaceCells cells = cellsOf(cloud);
    ASSERT_EQ(cells.cells.size(), 1u);
    EXPECT_EQ(cells.cells[0].count, 1001u);
    EXPECT_TRUE(cells.cells[0].normal.isZero());
}

TEST(SurfaceCells, HoldPointsOnWholeMetres)
{
    // 49 cells a metre: 7 / (1 / 49) is 342.99999999999994 in doubles, one cell before the block of 7 m.
    CellParams params;
    params.size_m = 0.0204;
    HandMadeCloud cloud;
    for (int y = 0; y < 200; ++y)
        for (int z = 0; z < 200; ++z)
            cloud.point({7.0, 0.01 * y, 0.01 * z}, Label::Wall);
    const SurfaceCells cells = buildSurfaceCells(cloud.view(), KeptRegion{}, params, Context{});
    EXPECT_EQ(pointsIn(cells), cloud.size());
    for (const SurfaceCell& c : cells.cells)
        ASSERT_NEAR(c.position.x(), 7.0f, 1e-4f);  // positions are kept to 1/4096 of a cell
    EXPECT_GT(shareWithNormal(cells, Eigen::Vector3d::UnitX(), 1e-3), 0.99);
}

TEST(SurfaceCells, AreLargerInASparseCloud)
{
    HandMadeCloud cloud(0.05);
    cloud.rectangle({0.31, 0.02, 0.03}, {0, 5, 0}, {0, 0, 3}, Label::Wall);
    const SurfaceCells cells = cellsOf(cloud);
    // The spacing follows from counts in 8 cm squares, of which the points leave a few empty.
    EXPECT_NEAR(cells.spacing_m, 0.05, 0.01);
    EXPECT_GE(cells.size_m, cells.spacing_m);
    EXPECT_GT(shareWithNormal(cells, Eigen::Vector3d::UnitX(), 1e-3), 0.98);
}

TEST(SurfaceCells, KeepTheirNormalsIn10MillimetresOfNoise)
{
    HandMadeCloud cloud(0.005, 0.010);
    cloud.rectangle({0.31, 0.02, 0.03}, {0, 2, 0}, {0, 0, 2}, Label::Wall);
    // 400 points in a neighbourhood of 10 cm: a standard deviation of 1 degree, so 10 degrees are safe in its middle;
    // at the fringes of the noise a neighbourhood holds a part of the points only.
    EXPECT_GT(shareWithNormal(cellsOf(cloud), Eigen::Vector3d::UnitX(), 10 * std::numbers::pi / 180), 0.9);
}

TEST(SurfaceCells, StopWhenCancelled)
{
    std::stop_source stop;
    Context context;
    context.cancel = stop.get_token();
    stop.request_stop();
    EXPECT_THROW((void)buildSurfaceCells(noisyRoom().view(), {}, {}, context), Cancelled);
}

TEST(SurfaceCells, NormalsFaceTheScanner)
{
    HandMadeCloud cloud(0.02, 0.002);
    const Eigen::Vector3d station(1.0, 2.0, 1.4);
    cloud.standAt(station);
    cloud.room({0, 0}, {4, 3});
    std::size_t facing = 0, away = 0, undecided = 0;
    const SurfaceCells cells = cellsOf(cloud);
    EXPECT_TRUE(cells.hasStations);
    for (const SurfaceCell& c : cells.cells)
    {
        const bool isToStation = c.normal.dot(station.cast<float>() - c.position) > 0;
        ++(!c.facesScanner ? undecided : isToStation ? facing : away);
    }
    EXPECT_EQ(away, 0U);
    EXPECT_GT(facing, 9 * undecided);  // the far corners are seen too flat, the edges have no clear normal

    cloud.forgetStations();
    const SurfaceCells without = cellsOf(cloud);
    EXPECT_FALSE(without.hasStations);
    EXPECT_TRUE(std::none_of(without.cells.begin(), without.cells.end(), [](const auto& c) { return c.facesScanner; }));
}

TEST(SurfaceCells, SeenFromBothSidesFaceNeither)
{
    HandMadeCloud cloud;
    cloud.standAt({-2, 1, 1});
    cloud.wallFace({0, 0}, {0, 2}, 0, 2);
    cloud.standAt({2, 1, 1});
    cloud.wallFace({0, 0}, {0, 2}, 0, 2);
    const SurfaceCells cells = cellsOf(cloud);
    const auto facing =
        std::count_if(cells.cells.begin(), cells.cells.end(), [](const auto& c) { return c.facesScanner; });
    EXPECT_LT(facing, 0.3 * static_cast<double>(cells.cells.size()));  // cells of an odd number of points
}

TEST(SurfaceCells, PointsOfNoKnownStationSayNothing)
{
    HandMadeCloud cloud;
    cloud.standAt({-2, 1, 1});
    cloud.standAnywhere();
    cloud.wallFace({0, 0}, {0, 2}, 0, 2);
    const SurfaceCells cells = cellsOf(cloud);
    EXPECT_TRUE(std::none_of(cells.cells.begin(), cells.cells.end(), [](const auto& c) { return c.facesScanner; }));
}

}  // namespace
}  // namespace s2b

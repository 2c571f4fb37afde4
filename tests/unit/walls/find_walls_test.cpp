// SPDX-License-Identifier: GPL-3.0-or-later
/// From points to walls: faces, pairing, thickness, height and evidence.
#include "tests/support/plan_geometry.h"
#include "tests/support/stages.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace s2b
{
namespace
{

using test::countCode;
using test::HandMadeCloud;
using test::storeyOf;
using test::wallThrough;

const Eigen::Vector2d kAlongY = Eigen::Vector2d::UnitY();

/// Two rooms with a partition of 0.2 m between them, its axis at x = 4.1.
HandMadeCloud twoRooms(double noise = 0.0, double thickness = 0.2)
{
    HandMadeCloud cloud(0.02, noise);
    cloud.room({0, 0}, {4, 3});
    cloud.room({4 + thickness, 0}, {8 + thickness, 3});
    return cloud;
}

class WallsWithAndWithoutLabels : public testing::TestWithParam<bool>
{
};
INSTANTIATE_TEST_SUITE_P(Labels, WallsWithAndWithoutLabels, testing::Bool(),
                         [](const auto& mode) { return mode.param ? "Labelled" : "GeometryOnly"; });

TEST_P(WallsWithAndWithoutLabels, MeasureThicknessToAMillimetreBetweenTwoRooms)
{
    for (const double noise : {0.0, 0.003, 0.010})
        for (const double thickness : {0.10, 0.2, 0.365})
        {
            const auto result = storeyOf(twoRooms(noise, thickness), GetParam());
            const Wall* wall = wallThrough(result.walls.walls, {4 + thickness / 2, 1.5}, kAlongY);
            ASSERT_NE(wall, nullptr) << 1000 * noise << " mm of noise, " << thickness << " m";
            // A face is the mean of some 20 000 points: 10 mm of noise move it by 0.07 mm.
            EXPECT_NEAR(wall->thickness.value_m, thickness, 0.001) << 1000 * noise << " mm of noise";
            EXPECT_NEAR(wall->start.x(), 4 + thickness / 2, 0.0005) << 1000 * noise << " mm of noise";
            EXPECT_EQ(wall->thickness.provenance, Provenance::Measured);
            EXPECT_EQ(wall->evidence.facesSeen, 2);
            EXPECT_GT(wall->evidence.faceCoverage[0], 0.9);
            EXPECT_GT(wall->evidence.faceCoverage[1], 0.9);
            EXPECT_NEAR(wall->evidence.rms_m, noise, 0.002 + 0.3 * noise);  // cells average some of it away
        }
}

TEST_P(WallsWithAndWithoutLabels, AssumeAndReportTheThicknessBehindOneFace)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {4, 3});
    const auto result = storeyOf(cloud, GetParam());
    ASSERT_EQ(result.walls.walls.size(), 4u);
    for (const Wall& w : result.walls.walls)
    {
        EXPECT_EQ(w.thickness.provenance, Provenance::Assumed);
        EXPECT_EQ(w.evidence.facesSeen, 1);
        EXPECT_NEAR(w.thickness.value_m, WallParams{}.defaultExternalThickness_m, 1e-9);
        // The unseen side is the outer one: the room keeps its clear size.
        EXPECT_NEAR(test::distanceToLine(w, {2, 1.5}) - w.thickness.value_m / 2,
                    std::abs(w.direction().x()) > 0.5 ? 1.5 : 2.0, 0.001);
    }
    EXPECT_EQ(countCode(result.walls.diagnostics, "ThicknessAssumed"), 4u);
    for (const Diagnostic& d : result.walls.diagnostics)
        EXPECT_NE(d.element, ElementId{});
}

TEST_P(WallsWithAndWithoutLabels, TakeACorridorOf55CentimetresForNoWall)
{
    // Below walls.maximumThickness; the floor and the ceiling between the two faces say that it is a corridor.
    HandMadeCloud cloud;
    cloud.room({0, 0}, {4, 3});
    cloud.room({4.1, 0}, {4.65, 3});
    cloud.room({4.75, 0}, {8.75, 3});
    const auto result = storeyOf(cloud, GetParam());
    EXPECT_FALSE(test::isInSomeBody(result.walls.walls, {4.375, 1.5}));
    for (const double x : {4.05, 4.70})
    {
        const Wall* wall = wallThrough(result.walls.walls, {x, 1.5}, kAlongY);
        ASSERT_NE(wall, nullptr) << "at " << x;
        EXPECT_NEAR(wall->thickness.value_m, 0.1, 0.001);
        EXPECT_NEAR(wall->start.x(), x, 0.001);
    }
}

TEST_P(WallsWithAndWithoutLabels, StandFromFloorToCeiling)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {4, 3}, 1.3, 4.1);
    const auto result = storeyOf(cloud, GetParam(), {}, 1.3, 4.1);
    ASSERT_EQ(result.walls.walls.size(), 4u);
    for (const Wall& w : result.walls.walls)
    {
        EXPECT_EQ(w.base_m, 1.3);
        EXPECT_NEAR(w.height.value_m, 2.8, 1e-9);
        EXPECT_EQ(w.height.provenance, Provenance::Measured);
    }
}

TEST(FindWalls, IgnoresWhatIsLabelledFurniture)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {6, 4});
    cloud.wallFace({2, 1}, {4, 1}, 0, 2.6, Label::Furniture);
    cloud.wallFace({2, 1.2}, {4, 1.2}, 0, 2.6, Label::Furniture);
    EXPECT_EQ(storeyOf(cloud).walls.walls.size(), 4u);
}

TEST(FindWalls, TakesNoCupboardForAWallWithoutLabels)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {6, 4});
    cloud.fourWalls({2, 0.4}, {3.2, 0.9}, 0, 1.9);
    cloud.horizontal({2, 0.4}, {3.2, 0.9}, 1.9, Label::Furniture);
    EXPECT_EQ(storeyOf(cloud, false).walls.walls.size(), 4u);
}

TEST(FindWalls, KeepsADirectionThatIsNotTheBuildings)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {8, 6});
    // A free-standing wall at 30 degrees, 0.15 m thick, with the floor and ceiling left out below it.
    const Eigen::Vector2d t(std::cos(std::numbers::pi / 6), 0.5), n(-t.y(), t.x()), a(2, 1.5);
    cloud.wallFace(a, a + 3 * t, 0, 2.6);
    cloud.wallFace(a + 0.15 * n, a + 3 * t + 0.15 * n, 0, 2.6);
    HandMadeCloud cut;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        const Eigen::Vector3d p = cloud.cloud().points[i].cast<double>();
        const Eigen::Vector2d d = p.head<2>() - a;
        const bool isHidden =
            (p.z() < 0.01 || p.z() > 2.59) && t.dot(d) > 0 && t.dot(d) < 3 && n.dot(d) > 0.001 && n.dot(d) < 0.149;
        if (!isHidden)
            cut.point(p, cloud.cloud().labels[i]);
    }
    for (const bool withLabels : {true, false})
    {
        const auto result = storeyOf(cut, withLabels);
        const Wall* wall = wallThrough(result.walls.walls, a + 1.5 * t + 0.075 * n, t);
        ASSERT_NE(wall, nullptr) << "labels " << withLabels;
        EXPECT_NEAR(wall->thickness.value_m, 0.15, 0.001);
        // Over 3 m a hundredth of a degree is 0.5 mm.
        EXPECT_LT(std::abs(test::cross(wall->direction(), t)), std::sin(0.05 * std::numbers::pi / 180));
        EXPECT_NEAR(test::bodyLength(*wall), 3.0, 0.05);
    }
}

TEST(FindWalls, GivesOneFaceTheThicknessOfTheSameWallElsewhere)
{
    // The second room reaches only half as far: the rest of the partition has one face.
    HandMadeCloud cloud;
    cloud.room({0, 0}, {4, 6});
    cloud.room({4.24, 0}, {8, 3});
    const auto result = storeyOf(cloud);
    const Wall* wall = wallThrough(result.walls.walls, {4.12, 4.8}, kAlongY);
    ASSERT_NE(wall, nullptr);
    EXPECT_NEAR(wall->thickness.value_m, 0.24, 0.001);
}

TEST(FindWalls, SaysNothingAboutAnEmptyStorey)
{
    HandMadeCloud cloud;
    cloud.horizontal({0, 0}, {4, 3}, 0, Label::Floor);
    cloud.horizontal({0, 0}, {4, 3}, 2.6, Label::Ceiling);
    for (const bool withLabels : {true, false})
        EXPECT_TRUE(storeyOf(cloud, withLabels).walls.walls.empty());
}

TEST(FindWalls, NumbersTheWallsFromNextIdOn)
{
    const auto result = storeyOf(twoRooms());
    std::uint32_t expected = 2;
    for (const Wall& w : result.walls.walls)
    {
        EXPECT_EQ(w.id.value, expected++);
        EXPECT_EQ(w.storey.value, 1u);
    }
}

TEST(FindWalls, DoesNotTakeFivePercentOfWrongLabelsForWalls)
{
    HandMadeCloud cloud = twoRooms(0.003);
    for (std::size_t i = 0; i < cloud.size(); i += 20)
        cloud.cloud().labels[i] = static_cast<Label>(randomBits(1, 3, i) % kLabelCount);
    const auto clean = storeyOf(twoRooms(0.003)), dirty = storeyOf(cloud);
    ASSERT_EQ(dirty.walls.walls.size(), clean.walls.walls.size());
    for (std::size_t i = 0; i < clean.walls.walls.size(); ++i)
    {
        const Wall &a = clean.walls.walls[i], &b = dirty.walls.walls[i];
        // Cells whose majority changed drop out; the mean of the others stays.
        EXPECT_LT((a.start - b.start).norm(), 0.002);
        EXPECT_LT((a.end - b.end).norm(), 0.002);
        EXPECT_NEAR(a.thickness.value_m, b.thickness.value_m, 0.001);
    }
}

TEST(FindWalls, RespectsTheSizeLimits)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {6, 4});
    WallParams params;
    params.minimumLength_m = 4.5;
    // The room's shorter walls go.
    const auto result = storeyOf(cloud, true, params);
    ASSERT_EQ(result.walls.walls.size(), 2u);
    for (const Wall& w : result.walls.walls)
        EXPECT_GT(std::abs(w.direction().x()), 0.99);
}

TEST(FindWalls, StopsWhenCancelled)
{
    const HandMadeCloud cloud = twoRooms();
    const SurfaceCells cells = test::cellsOf(cloud);
    Level level;
    level.ceiling_m = 2.6;
    level.ceilingSeen = true;
    const CellIndex index(cells, -0.2, 3.0);
    std::stop_source stop;
    Context context;
    context.cancel = stop.get_token();
    stop.request_stop();
    std::uint32_t nextId = 2;
    EXPECT_THROW((void)findWalls(cells, index, level, {1}, nextId, {}, context), Cancelled);
}

TEST_P(WallsWithAndWithoutLabels, TakeNothingFarBeyondAWindowForItsReveal)
{
    // A garden wall seen through the window begins near its plane and runs on outside.
    HandMadeCloud cloud;
    test::RoomGaps gaps;
    gaps.east = {{1.0, 2.0, 0.9, 2.1}};
    cloud.room({0, 0}, {4, 3}, 0, 2.6, gaps);
    cloud.wallFace({4.05, 1.5}, {6.5, 1.5}, 0.9, 2.1);
    const auto result = storeyOf(cloud, GetParam());
    const Wall* wall = wallThrough(result.walls.walls, {4.05, 1.5}, kAlongY);
    ASSERT_NE(wall, nullptr);
    EXPECT_EQ(wall->thickness.provenance, Provenance::Assumed);
    EXPECT_LT(wall->thickness.value_m, 0.4);
}

}  // namespace
TEST(FindWalls, GoBehindTheFramesOfWindowsForTheirThickness)
{
    // Four windows 0.2 m behind the faces; past their frames a little of the outer reveals is seen through the glass,
    // up to 0.3 m. Through the southern one a leaf that stands open outside goes on to 0.42 m.
    constexpr double frame = 0.2, thickness = 0.3, leaf = 0.42;
    HandMadeCloud cloud(0.015);
    const test::Gap gap{1.0, 2.0, 0.9, 2.1};
    test::RoomGaps gaps;
    gaps.south = gaps.north = gaps.west = gaps.east = {gap};
    cloud.room({0, 0}, {4, 3}, 0, 2.6, gaps);
    const auto reveal = [&](const Eigen::Vector2d& corner, const Eigen::Vector2d& along, const Eigen::Vector2d& out)
    {
        for (const double s : {gap.uBegin, gap.uEnd})
        {
            const Eigen::Vector2d jamb = corner + s * along;
            cloud.wallFace(jamb, jamb + frame * out, gap.vBegin, gap.vEnd);
            cloud.wallFace(jamb + (frame + 0.06) * out, jamb + thickness * out, gap.vBegin, gap.vBegin + 0.3);
        }
        const Eigen::Vector2d pane = corner + frame * out;
        cloud.wallFace(pane + gap.uBegin * along, pane + gap.uEnd * along, gap.vBegin, gap.vEnd);
    };
    const Eigen::Vector2d x = Eigen::Vector2d::UnitX(), y = Eigen::Vector2d::UnitY();
    reveal({0, 0}, x, -y), reveal({0, 3}, x, y), reveal({0, 0}, y, -x), reveal({4, 0}, y, x);
    cloud.wallFace({1.0, -thickness}, {1.0, -leaf}, gap.vBegin, gap.vEnd);
    const auto result = storeyOf(cloud, false);
    ASSERT_EQ(result.walls.walls.size(), 4u);
    for (const Wall& w : result.walls.walls)
    {
        EXPECT_NEAR(w.thickness.value_m, thickness, 0.015);
        EXPECT_EQ(w.thickness.provenance, Provenance::Assumed);
    }
}

TEST(FindWalls, KeepTheirFaceAboveAGlazedFront)
{
    // Of the first room's northern face only a strip of 12 cm and narrow piers are left: panes 0.35 m behind it reach
    // from the floor to a head so near to the ceiling that it looks like one. The second room's northern face is whole.
    constexpr double sill = 0.15, head = 2.48;
    HandMadeCloud cloud(0.015);
    test::RoomGaps gaps;
    for (const auto& [left, right] : {std::pair(0.2, 4.6), std::pair(4.8, 5.8)})
    {
        gaps.north.push_back({left, right, sill, head});
        cloud.wallFace({left, 4.35}, {right, 4.35}, sill, head, Label::Window);
        cloud.horizontal({left, 4}, {right, 4.35}, head, Label::Wall);
        cloud.horizontal({left, 4}, {right, 4.35}, sill, Label::Wall);
        for (const double x : {left, right})
            cloud.wallFace({x, 4}, {x, 4.35}, sill, head, Label::Wall);
    }
    cloud.room({0, 0}, {6, 4}, 0, 2.6, gaps);
    cloud.room({6.2, 0}, {9, 4}, 0, 2.6);
    const auto result = storeyOf(cloud, false);
    for (const double x : {3.0, 7.5})
    {
        const Wall* front = wallThrough(result.walls.walls, {x, 4.15}, Eigen::Vector2d::UnitX());
        ASSERT_NE(front, nullptr) << "at " << x;
        EXPECT_NEAR(test::distanceToLine(*front, {x, 2.0}) - front->thickness.value_m / 2, 2.0, 0.002) << "at " << x;
    }
}

TEST(FindWalls, KeepsALowWallLow)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {6, 4});
    // A parapet of 1.1 m within the room, 0.2 m thick.
    cloud.wallFace({3, 1}, {3, 3}, 0, 1.1);
    cloud.wallFace({3.2, 1}, {3.2, 3}, 0, 1.1);
    cloud.rectangle({3, 1, 1.1}, {0.2, 0, 0}, {0, 2, 0}, Label::Wall);
    // Nothing of the floor within it: what is seen there is room.
    HandMadeCloud cut;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        const Eigen::Vector3d p = cloud.cloud().points[i].cast<double>();
        if (!(p.z() < 0.01 && p.x() > 3 && p.x() < 3.2 && p.y() > 1 && p.y() < 3))
            cut.point(p, cloud.cloud().labels[i]);
    }
    const auto result = storeyOf(cut);
    const Wall* parapet = wallThrough(result.walls.walls, {3.1, 2}, kAlongY);
    ASSERT_NE(parapet, nullptr);
    EXPECT_NEAR(parapet->height.value_m, 1.1, 0.1);  // heights are read in rows of 10 cm
    EXPECT_NEAR(parapet->thickness.value_m, 0.2, 0.001);
}

}  // namespace s2b

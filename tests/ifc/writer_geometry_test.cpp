// SPDX-License-Identifier: GPL-3.0-or-later
// What was written, read back through IfcGeom, must be the building.
#include "sample_building.h"
#include "test_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace s2b
{
namespace
{

using test::boxOf;
using test::roundTrip;
using test::volumeOf;

constexpr double kExact_m = 1e-6;  // planar faces come back as they were; the kernel's own tolerance is 1e-7
constexpr double kCurve = 0.002;   // share of a volume that 1 mm chords lose on the radii used here

class WriterGeometry : public testing::TestWithParam<const char*>
{
protected:
    [[nodiscard]] ifc::WriteOptions options() const
    {
        ifc::WriteOptions o;
        o.schema = GetParam();
        return o;
    }
};
INSTANTIATE_TEST_SUITE_P(Schemas, WriterGeometry, testing::Values("IFC4", "IFC4X3_ADD2"));

void expectBox(const ifc::MeshElement& element, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
               double tolerance = kExact_m)
{
    const test::Box box = boxOf(element);
    EXPECT_LT((box.low - low).cwiseAbs().maxCoeff(), tolerance) << element.name << " low " << box.low.transpose();
    EXPECT_LT((box.high - high).cwiseAbs().maxCoeff(), tolerance) << element.name << " high " << box.high.transpose();
}

TEST_P(WriterGeometry, StraightWallIsItsBox)
{
    const auto model = roundTrip(test::oneWall(), options());
    EXPECT_EQ(model.schema, GetParam());
    const auto& wall = test::elementOf(model, "IfcWall", "Wall 2");
    expectBox(wall, {0.0, -0.1, 0.0}, {6.0, 0.1, 2.8});
    EXPECT_NEAR(volumeOf(wall), 6.0 * 0.2 * 2.8, kExact_m);
}

TEST_P(WriterGeometry, BodyExtentAndBaseMoveTheBody)
{
    Building b = test::oneWall();
    b.walls[0].bodyStart_m = -0.15;
    b.walls[0].bodyEnd_m = 5.9;
    b.walls[0].base_m = 0.3;
    const auto model = roundTrip(b, options());
    expectBox(test::elementOf(model, "IfcWall", "Wall 2"), {-0.15, -0.1, 0.3}, {5.9, 0.1, 3.1});
}

TEST_P(WriterGeometry, StoreyElevationsAreRelativeToTheBuilding)
{
    const Building b = test::sampleBuilding();
    const auto model = roundTrip(b, options());
    ASSERT_EQ(model.storeys.size(), 2U);
    EXPECT_EQ(model.storeys[1].name, "Étage 1 – 日本");
    EXPECT_NEAR(model.storeys[0].elevation_m, 30.0, kExact_m);
    EXPECT_NEAR(model.storeys[1].elevation_m, 33.1, kExact_m);
    const auto& gable = test::elementOf(model, "IfcWall", "Wall 20");
    EXPECT_EQ(gable.storeyGuid, model.storeys[1].guid);
    EXPECT_NEAR(boxOf(gable).low.z(), 33.1, kExact_m);
    EXPECT_NEAR(boxOf(gable).high.z(), 36.1, kExact_m);
}

TEST_P(WriterGeometry, OpeningsArePlacedAlongTheAxisAndCutTheirWall)
{
    Building b = test::sampleBuilding();
    b.frame = {};
    const auto model = roundTrip(b, options());
    // Wall 10 runs along x from (0, 0): the door's hole from 1.0 to 2.01, 0.05 deeper than the wall on either side.
    expectBox(test::elementOf(model, "IfcOpeningElement", "Opening 30"), {1.0, -0.15, 0.0}, {2.01, 0.15, 2.13});
    // Wall 12 runs back along x at y = 6.
    expectBox(test::elementOf(model, "IfcOpeningElement", "Opening 32"), {2.2, 5.85, 0.0}, {4.0, 6.15, 2.2});
    const double gross = 10.2 * 0.2 * 2.8;
    EXPECT_NEAR(volumeOf(test::elementOf(model, "IfcWall", "Wall 10")), gross - 0.2 * (1.01 * 2.13 + 1.5 * 1.2),
                kExact_m);
    const auto closed = roundTrip(b, options(), {.subtractOpenings = false});
    EXPECT_NEAR(volumeOf(test::elementOf(closed, "IfcWall", "Wall 10")), gross, kExact_m);
}

TEST_P(WriterGeometry, DoorsAndWindowsFillTheirHoleWithinTheWall)
{
    Building b = test::sampleBuilding();
    b.frame = {};
    const auto model = roundTrip(b, options());
    expectBox(test::elementOf(model, "IfcDoor", "Door 30"), {1.0, -0.1, 0.0}, {2.01, 0.1, 2.13});
    expectBox(test::elementOf(model, "IfcDoor", "Door 31"), {4.95, 2.0, 0.0}, {5.05, 2.9, 2.1});
    expectBox(test::elementOf(model, "IfcDoor", "Door 33"), {9.9, 2.0, 0.02}, {10.1, 2.9, 2.12});
    expectBox(test::elementOf(model, "IfcWindow", "Window 34"), {6.0, -0.04, 0.9}, {7.5, 0.04, 2.1});
    EXPECT_EQ(test::elementOf(model, "IfcDoor", "Door 30").hostGuid, test::elementOf(model, "IfcWall", "Wall 10").guid);
    EXPECT_TRUE(test::elementOf(model, "IfcWindow", "Window 34").isTransparent);
    EXPECT_FALSE(test::elementOf(model, "IfcDoor", "Door 30").isTransparent);
}

TEST_P(WriterGeometry, OpenLeafIsFlushWithTheSideItOpensTo)
{
    Building b = test::oneWall();
    Opening door;
    door.id = {3};
    door.host = {2};
    door.kind = OpeningKind::Door;
    door.offset_m = 1.0;
    door.width.value_m = 1.0;
    door.height.value_m = 2.0;
    door.leaves = 1;
    door.leafState = LeafState::Open;
    for (const bool left : {true, false})
    {
        door.opensToLeft = left;
        b.openings = {door};
        const auto model = roundTrip(b, options());
        double mean = 0.0;
        const auto& mesh = test::elementOf(model, "IfcDoor", "Door 3");
        for (const auto& v : mesh.vertices)
            mean += v.y() / static_cast<double>(mesh.vertices.size());
        EXPECT_GT(left ? mean : -mean, 0.01);  // the leaf's eight corners are 0.06 to 0.1 to that side
    }
}

TEST_P(WriterGeometry, RemovedLeafLeavesTheFrame)
{
    Building b = test::sampleBuilding();
    const auto model = roundTrip(b, options());
    // U-shaped lining of 5 cm through the wall.
    EXPECT_NEAR(volumeOf(test::elementOf(model, "IfcDoor", "Door 33")), 0.2 * (0.9 * 2.1 - 0.8 * 2.05), kExact_m);
}

TEST_P(WriterGeometry, ArcWallsKeepTheirVolumeAndCircle)
{
    Building b = test::sampleBuilding();
    b.frame = {};
    const auto model = roundTrip(b, options());
    const auto& half = test::elementOf(model, "IfcWall", "Wall 17");
    const double volume = M_PI * 2.0 * 0.2 * 2.8;
    EXPECT_NEAR(volumeOf(half), volume, kCurve * volume);
    for (const Eigen::Vector3d& v : half.vertices)
    {
        const double radius = (v.head<2>() - Eigen::Vector2d(-2.0, 3.0)).norm();
        EXPECT_TRUE(std::abs(radius - 1.9) < kExact_m || std::abs(radius - 2.1) < kExact_m) << radius;
        EXPECT_LT(v.x(), -2.0 + kExact_m) << "clockwise from (-2, 1) to (-2, 5) bends to the left";
    }
}

TEST_P(WriterGeometry, SlopedTopsKeepTheirVolume)
{
    const Building b = test::sampleBuilding();
    const auto model = roundTrip(b, options());
    EXPECT_NEAR(volumeOf(test::elementOf(model, "IfcWall", "Wall 20")), 0.2 * (6.0 * 1.0 + 6.0 * 2.0 / 2.0 - 1.0),
                kExact_m);
    EXPECT_NEAR(volumeOf(test::elementOf(model, "IfcWall", "Wall 21")), 0.2 * 6.0 * 2.0 / 2.0, kExact_m);
    // Curved under (0, 5.1) (3, 6.1) (end, 4.1), base 3.1.
    const double end = b.wall({22})->axisLength_m();
    const double volume = 0.2 * (3.0 * 2.5 + (end - 3.0) * 2.0);
    EXPECT_NEAR(volumeOf(test::elementOf(model, "IfcWall", "Wall 22")), volume, kCurve * volume);
}

TEST_P(WriterGeometry, ProfilesStandWhereTheyAreAndAsTheyAreTurned)
{
    Building b = test::sampleBuilding();
    b.frame = {};
    const auto model = roundTrip(b, options());
    int compared = 0;
    for (const Column& column : b.columns)
        if (std::holds_alternative<ProfileSection>(column.section))
        {
            const auto& mesh = test::elementOf(model, "IfcColumn", "Column " + std::to_string(column.id.value));
            EXPECT_NEAR(volumeOf(mesh), areaOf(column.section) * column.height.value_m, kExact_m);
            for (const Eigen::Vector2d& corner : column.outline())
                for (const double z : {column.base_m, column.base_m + column.height.value_m})
                    EXPECT_TRUE(
                        std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const Eigen::Vector3d& v)
                                    { return (v - Eigen::Vector3d(corner.x(), corner.y(), z)).norm() < kExact_m; }))
                        << mesh.name << " has no corner at " << corner.transpose();
            ++compared;
        }
    EXPECT_EQ(compared, 4);
}

TEST_P(WriterGeometry, ColumnsSlabsAndSpaces)
{
    Building b = test::sampleBuilding();
    b.frame = {};
    const auto model = roundTrip(b, options());
    const auto& rectangle = test::elementOf(model, "IfcColumn", "Column 40");
    EXPECT_NEAR(volumeOf(rectangle), 0.4 * 0.3 * 2.8, kExact_m);
    const double halfWidth = 0.5 * (0.4 * std::cos(0.5) + 0.3 * std::sin(0.5));
    const double halfDepth = 0.5 * (0.4 * std::sin(0.5) + 0.3 * std::cos(0.5));
    expectBox(rectangle, {2.5 - halfWidth, 3.0 - halfDepth, 0.0}, {2.5 + halfWidth, 3.0 + halfDepth, 2.8});
    // A radius of 0.2 m gives chords of 1 mm sagitta: 1.3 % of the area.
    EXPECT_NEAR(volumeOf(test::elementOf(model, "IfcColumn", "Column 41")), M_PI * 0.04 * 2.8,
                0.015 * M_PI * 0.04 * 2.8);
    const auto& floor = test::elementOf(model, "IfcSlab", "Slab 50");
    EXPECT_NEAR(volumeOf(floor), (10.2 * 6.2 - 1.0 - 0.5) * 0.25, kExact_m);
    expectBox(floor, {-0.1, -0.1, -0.25}, {10.1, 6.1, 0.0});
    EXPECT_EQ(floor.predefinedType, "FLOOR");
    EXPECT_EQ(test::elementOf(model, "IfcSlab", "Slab 51").predefinedType, "ROOF");
    const auto& room = test::elementOf(model, "IfcSpace", "Room 2");
    EXPECT_NEAR(volumeOf(room), (4.85 * 5.8 - 0.16) * 2.8, kExact_m);
    EXPECT_EQ(room.storeyGuid, model.storeys[0].guid);
}

/// Every vertex of a far away building must be its near twin's, moved.
void expectMoved(const ifc::IfcModel& near, const ifc::IfcModel& far, const Frame& frame)
{
    ASSERT_EQ(near.elements.size(), far.elements.size());
    for (std::size_t i = 0; i < near.elements.size(); ++i)
    {
        ASSERT_EQ(near.elements[i].vertices.size(), far.elements[i].vertices.size()) << near.elements[i].name;
        for (std::size_t k = 0; k < near.elements[i].vertices.size(); ++k)
            ASSERT_LT((far.elements[i].vertices[k] - frame.toWorld(near.elements[i].vertices[k])).norm(), 1e-4)
                << near.elements[i].name;  // 0.1 mm
    }
}

TEST_P(WriterGeometry, PlacementsAreExactAtThirtyTwoMillionMetres)
{
    Building b = test::sampleBuilding();
    b.frame = {};
    const auto near = roundTrip(b, options());
    b.frame.origin = {32500100.12345, 5600300.54321, 120.98765};
    b.frame.yaw_rad = 0.7654321;
    const auto far = roundTrip(b, options());
    expectMoved(near, far, b.frame);
    EXPECT_NEAR(far.storeys[1].elevation_m, 124.08765, 1e-4);
}

TEST_P(WriterGeometry, MapConversionIsExactAtThirtyTwoMillionMetres)
{
    Building b = test::sampleBuilding();
    b.frame = {};
    const auto near = roundTrip(b, options());
    b.frame.origin = {32500100.12345, 5600300.54321, 120.98765};
    b.frame.yaw_rad = -2.5;
    ifc::WriteOptions georeferenced = options();
    georeferenced.epsg = 4647;
    const auto local = roundTrip(b, georeferenced);
    expectMoved(near, local, Frame{});
    const auto map = roundTrip(b, georeferenced, {.applyMapConversion = true});
    ASSERT_TRUE(map.mapConversion);
    EXPECT_EQ(map.mapConversion->crs, "EPSG:4647");
    expectMoved(near, map, b.frame);
}

}  // namespace
}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
// IFC files as a validation sees them.
#include "ifc/bim_reader.h"
#include "core/geometry/polygon.h"
#include "ifc/ifc_writer.h"
#include "tests/support/ifc_text.h"
#include "tests/validation/sample_bims.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace s2b
{
namespace
{

using namespace test;
using ::testing::HasSubstr;

constexpr double kExact = 1e-6;  // the geometry engine's own tolerance

s2b::Wall modelWall(std::uint32_t id, const Eigen::Vector2d& start, const Eigen::Vector2d& end)
{
    s2b::Wall w;
    w.id = {id};
    w.storey = {1};
    w.start = start;
    w.end = end;
    w.bodyEnd_m = (end - start).norm();
    w.height.value_m = 3.0;
    w.thickness.value_m = 0.2;
    return w;
}

/// A straight wall with a door, an arc, a rectangular and a round column, at 30 degrees far from the origin.
Building building()
{
    Building b;
    b.frame.origin = {2000.0, 3000.0, 100.0};
    b.frame.yaw_rad = std::numbers::pi / 6.0;
    Storey storey;
    storey.id = {1};
    storey.name = "Level 0";
    storey.height.value_m = 3.0;
    b.storeys = {storey};
    b.walls = {modelWall(10, {0, 0}, {6, 0}), modelWall(11, {0, 8}, {6, 8})};
    b.walls[1].bulge = 0.4;
    b.walls[1].bodyEnd_m = b.walls[1].axisLength_m();
    Opening door;
    door.id = {20};
    door.host = {10};
    door.kind = OpeningKind::Door;
    door.offset_m = 2.0;
    door.width.value_m = 1.0;
    door.height.value_m = 2.0;
    b.openings = {door};
    s2b::Column square;
    square.id = {30};
    square.storey = {1};
    square.center = {3, 3};
    square.height.value_m = 3.0;
    square.section = RectangleSection{0.4, 0.3};
    s2b::Column round = square;
    round.id = {31};
    round.center = {4, 3};
    round.section = CircleSection{0.2};
    b.columns = {square, round};
    return b;
}

const BimElement& one(const Bim& bim, ElementClass elementClass, std::size_t number = 0)
{
    for (const BimElement& e : bim.elements)
        if (e.elementClass == elementClass && number-- == 0)
            return e;
    throw std::runtime_error("there is none");
}

TEST(BimReader, TakesPlansHeightsAndMeshes)
{
    const Folder folder;
    ifc::writeIfc(building(), folder.file("a.ifc"), {});
    const Bim bim = ifc::readBim(folder.file("a.ifc"));
    EXPECT_EQ(bim.schema, "IFC4");
    ASSERT_EQ(bim.storeys.size(), 1U);
    EXPECT_NEAR(bim.storeys[0].elevation_m + bim.origin.z(), 100.0, kExact);

    const BimElement& straight = one(bim, ElementClass::Wall);
    EXPECT_NEAR(area(straight.plan), 6.0 * 0.2, kExact);
    ASSERT_TRUE(straight.axis.has_value());
    EXPECT_NEAR(straight.axis->thickness_m, 0.2, kExact);
    EXPECT_NEAR((straight.axis->end - straight.axis->start).norm(), 6.0, kExact);
    EXPECT_NEAR(straight.low_m + bim.origin.z(), 100.0, kExact);
    EXPECT_NEAR(straight.high_m - straight.low_m, 3.0, kExact);
    EXPECT_NEAR(volumeOf(straight.mesh), 0.2 * (6.0 * 3.0 - 2.0), kExact) << "with its hole";
    EXPECT_EQ(straight.storey, 0);
    EXPECT_TRUE(straight.footprint.empty()) << "its outline is its rectangle";

    const BimElement& door = one(bim, ElementClass::Door);
    EXPECT_EQ(&bim.elements[static_cast<std::size_t>(door.host)], &straight);
    EXPECT_NEAR(area(door.plan), 1.0 * 0.2, kExact) << "the opening, flush with its wall";
    EXPECT_NEAR(door.high_m - door.low_m, 2.0, kExact);
}

TEST(BimReader, ACurvedWallKeepsItsOutline)
{
    const Folder folder;
    ifc::writeIfc(building(), folder.file("a.ifc"), {});
    const Bim bim = ifc::readBim(folder.file("a.ifc"));
    const BimElement& curved = one(bim, ElementClass::Wall, 1);
    EXPECT_FALSE(curved.axis.has_value());
    // An arc's body is its length times its thickness; chords stay within 1 mm of 6.7 m.
    const double length = building().walls[1].axisLength_m();
    EXPECT_NEAR(area(curved.plan), length * 0.2, 0.002 * length);
    EXPECT_GT(curved.plan.outer.size(), 8U);
}

TEST(BimReader, OpeningsAreCutOutOfWallsOfAnyForm)
{
    Building b = building();
    Opening window = b.openings[0];
    window.id = {21};
    window.host = {11};  // the arc
    window.kind = OpeningKind::Window;
    window.sill.value_m = 0.8;
    window.height.value_m = 1.0;
    b.openings.push_back(window);
    b.walls.push_back(modelWall(12, {0, -4}, {6, -4}));  // a gable
    b.walls[2].topProfile = {{0, 3}, {3, 5}, {6, 3}};
    Opening high = window;
    high.id = {22};
    high.host = {12};
    b.openings.push_back(high);
    const Folder folder;
    ifc::writeIfc(b, folder.file("a.ifc"), {});
    const Bim bim = ifc::readBim(folder.file("a.ifc"));
    const double length = b.walls[1].axisLength_m();
    EXPECT_NEAR(std::abs(volumeOf(one(bim, ElementClass::Wall, 1).mesh)), 0.2 * (3.0 * length - 1.0),
                0.002 * length * 3.0 * 0.2)
        << "chords, and an opening that is straight";
    EXPECT_NEAR(std::abs(volumeOf(one(bim, ElementClass::Wall, 2).mesh)), 0.2 * (6.0 * 3.0 + 6.0 - 1.0), kExact);
}

TEST(BimReader, AProfileIsComparedByTheBoxAroundIt)
{
    const Folder folder;
    Building b = building();
    std::vector<ProfileSection> sections{{ProfileShape::I, 0.30, 0.28, 0.011, 0.019},
                                         {ProfileShape::L, 0.25, 0.20, 0.020, 0.020},
                                         {ProfileShape::L, 0.20, 0.20, 0.010, 0.010},
                                         {ProfileShape::U, 0.10, 0.30, 0.010, 0.016},
                                         {ProfileShape::T, 0.30, 0.15, 0.011, 0.019}};
    b.columns.resize(1);
    for (std::size_t i = 0; i < sections.size(); ++i)
    {
        s2b::Column column = b.columns[0];
        column.id = {static_cast<std::uint32_t>(40 + i)};
        column.center.x() += 1.0 + static_cast<double>(i);
        column.yaw_rad = 0.3;
        column.section = sections[i];
        b.columns.push_back(column);
    }
    ifc::writeIfc(b, folder.file("a.ifc"), {});
    const Bim bim = ifc::readBim(folder.file("a.ifc"));
    for (std::size_t i = 0; i < sections.size(); ++i)
    {
        const BimElement& e = one(bim, ElementClass::Column, i + 1);
        EXPECT_NEAR(area(e.plan), sections[i].width_m * sections[i].depth_m, kExact) << shapeName(sections[i].shape);
        const Eigen::Vector2d center =
            (b.frame.toWorld({b.columns[i + 1].center.x(), b.columns[i + 1].center.y(), 0.0}) - bim.origin).head<2>();
        EXPECT_LT((centroid(e.plan) - center).norm(), kExact);
        EXPECT_NEAR(volumeOf(e.mesh), areaOf(sections[i]) * 3.0, kExact) << "as built";
    }
}

TEST(BimReader, ARoundColumnIsRound)
{
    const Folder folder;
    ifc::writeIfc(building(), folder.file("a.ifc"), {});
    const Bim bim = ifc::readBim(folder.file("a.ifc"));
    EXPECT_NEAR(area(one(bim, ElementClass::Column, 0).plan), 0.12, kExact);
    EXPECT_NEAR(area(one(bim, ElementClass::Column, 1).plan), std::numbers::pi * 0.04, 0.001) << "chords";
}

TEST(BimReader, AMapConversionIsAppliedWhereItBringsTheModelsTogether)
{
    const Folder folder;
    ifc::WriteOptions options;
    options.epsg = 25832;
    Building far = building();
    far.frame.origin = {32500100.0, 5600300.0, 120.0};
    ifc::writeIfc(far, folder.file("a.ifc"), options);
    const Bim local = ifc::readBim(folder.file("a.ifc"), {.near = Eigen::Vector3d(1, 2, 3)});
    EXPECT_LT(local.origin.norm(), 100.0);
    const Bim map = ifc::readBim(folder.file("a.ifc"), {.near = Eigen::Vector3d(32500000, 5600000, 0)});
    const BimElement& wall = one(map, ElementClass::Wall);
    const Eigen::Vector2d start = wall.axis->start + (map.origin - far.frame.origin).head<2>();
    const Eigen::Vector2d end = wall.axis->end + (map.origin - far.frame.origin).head<2>();
    EXPECT_LT(std::min(start.norm(), end.norm()), 1e-4) << "0.1 mm, as the writer promises";
    EXPECT_NEAR(map.storeys[0].elevation_m + map.origin.z(), 120.0, kExact);
}

TEST(BimReader, ReadsIfc2x3InMillimetresAndCountsWindowsOfCurtainWalls)
{
    const Folder folder;
    const Bim bim = ifc::readBim(folder.write("a.ifc", stepFile("IFC2X3", kMillimetreModel)));
    EXPECT_EQ(bim.schema, "IFC2X3");
    ASSERT_EQ(bim.elements.size(), 2U) << "a curtain wall is no wall";
    const BimElement& wall = one(bim, ElementClass::Wall);
    EXPECT_EQ(wall.type, "IfcWallStandardCase");
    EXPECT_NEAR(area(wall.plan), 4.0 * 0.3, kExact);
    EXPECT_NEAR(wall.low_m + bim.origin.z(), 3.5, kExact);
    const BimElement& window = one(bim, ElementClass::Window);
    EXPECT_EQ(window.host, -1);
    EXPECT_EQ(window.storey, 0);
    EXPECT_NEAR(area(window.plan), 4.0 * 0.3, kExact) << "without an opening its own body counts";
}

TEST(BimReader, AWallOfPartsHasTheBodyOfItsParts)
{
    // The same file, but the body belongs to a part of the wall.
    std::string text = stepFile("IFC2X3", kMillimetreModel);
    const auto replace = [&](const std::string& from, const std::string& to)
    { text.replace(text.find(from), from.size(), to); };
    replace("#30=IFCWALLSTANDARDCASE('0000000000000000000003',#10,'W',$,$,#18,#29,$);",
            "#30=IFCWALL('0000000000000000000003',#10,'W',$,$,#18,$,$);\n"
            "#40=IFCBUILDINGELEMENTPART('0000000000000000000040',#10,'Layer',$,$,#18,#29,$);\n"
            "#41=IFCRELAGGREGATES('0000000000000000000041',#10,$,$,#30,(#40));");
    const Folder folder;
    const Bim bim = ifc::readBim(folder.write("a.ifc", text));
    const BimElement& wall = one(bim, ElementClass::Wall);
    EXPECT_EQ(wall.guid, "0000000000000000000003");
    EXPECT_EQ(wall.name, "W");
    EXPECT_EQ(wall.storey, 0);
    EXPECT_NEAR(area(wall.plan), 4.0 * 0.3, kExact);
    EXPECT_NEAR(std::abs(volumeOf(wall.mesh)), 4.0 * 0.3 * 2.5, kExact);
}

TEST(BimReader, WithoutMeshesThereAreNone)
{
    const Folder folder;
    ifc::writeIfc(building(), folder.file("a.ifc"), {});
    const Bim bim = ifc::readBim(folder.file("a.ifc"), {.withMeshes = false});
    EXPECT_TRUE(bim.elements.front().mesh.vertices.empty());
    EXPECT_NEAR(area(bim.elements.front().plan), 1.2, kExact);
}

TEST(BimReader, AFileWithoutWallsOrTheLikeIsRefused)
{
    const Folder folder;
    ifc::writeIfc(Building{}, folder.file("a.ifc"), {});
    EXPECT_THAT(errorOf(ErrorCode::BadFile, [&] { (void)ifc::readBim(folder.file("a.ifc")); }),
                HasSubstr("it holds no geometry"));
}

TEST(BimReader, AFileInTheWrongUnitIsRefused)
{
    const Folder folder;
    Building giant = building();
    for (s2b::Wall& w : giant.walls)
    {
        w.start *= 1000.0;
        w.end *= 1000.0;
        w.bodyEnd_m *= 1000.0;
        w.height.value_m *= 1000.0;
        w.thickness.value_m *= 1000.0;
    }
    giant.openings.clear();
    giant.columns.clear();
    ifc::writeIfc(giant, folder.file("a.ifc"), {});
    EXPECT_THAT(errorOf(ErrorCode::BadFile, [&] { (void)ifc::readBim(folder.file("a.ifc")); }),
                HasSubstr("length unit is wrong"));
}

}  // namespace
}  // namespace s2b

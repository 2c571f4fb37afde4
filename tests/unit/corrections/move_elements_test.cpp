// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/corrections/corrections.h"
#include "core/model/wall_axis.h"
#include "tests/unit/corrections/house.h"

#include <gmock/gmock.h>

#include <cmath>

namespace s2b
{
namespace
{

using namespace test;
using testing::HasSubstr;

constexpr double kExact_m = 1e-9;

Eigen::Affine3d shift(double x, double y, double z = 0)
{
    return Eigen::Affine3d(Eigen::Translation3d(x, y, z));
}

Eigen::Affine3d turnAbout(double x, double y, double angle)
{
    return shift(x, y) * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * shift(-x, -y);
}

Eigen::Affine3d scaling(double x, double y, double z)
{
    return Eigen::Affine3d(Eigen::Scaling(x, y, z));
}

Building moved(ElementId id, const Eigen::Affine3d& motion)
{
    return moveElements(house(), {{id, motion}});
}

/// Every junction's ends lie on each other, and every opening in its wall's body.
void expectConsistent(const Building& b)
{
    const auto placeOf = [](const Wall& w, JunctionEnd end)
    { return WallAxis(w).at(end == JunctionEnd::End ? w.axisLength_m() : 0.0); };
    for (const Junction& j : b.junctions)
    {
        const Wall *a = b.wall(j.wallA), *c = b.wall(j.wallB);
        ASSERT_TRUE(a && c);
        ASSERT_NE(j.endA, JunctionEnd::Path);  // in this house
        const Eigen::Vector2d p = placeOf(*a, j.endA);
        const bool isCorner = j.endB != JunctionEnd::Path;
        EXPECT_LT(isCorner ? (p - placeOf(*c, j.endB)).norm() : std::abs(WallAxis(*c).project(p).y()), kExact_m);
    }
    for (const Opening& o : b.openings)
    {
        const Wall* host = b.wall(o.host);
        ASSERT_TRUE(host);
        EXPECT_GE(o.offset_m, host->bodyStart_m - kExact_m);
        EXPECT_LE(o.offset_m + o.width.value_m, host->bodyEnd_m + kExact_m);
    }
}

TEST(MoveElements, DrawsTheNeighboursToAWall)
{
    const Building b = moved(kPartition, shift(0.4, 0));
    EXPECT_NEAR(b.wall(kPartition)->start.x(), 5.4, kExact_m);
    EXPECT_EQ(opening(b, kDoor).offset_m, 2.0);  // it goes with its wall
    EXPECT_EQ(b.junctions.size(), 6u);
    expectConsistent(b);

    const Building c = moved(kEast, shift(0.5, 0));  // the long walls follow
    EXPECT_NEAR(c.wall(kSouth)->end.x(), 8.5, kExact_m);
    EXPECT_NEAR(c.wall(kSouth)->bodyEnd_m, 8.65, kExact_m);
    EXPECT_NEAR(c.wall(kNorth)->start.x(), 8.5, kExact_m);
    EXPECT_NEAR(c.wall(kEast)->bodyStart_m, 0.15, kExact_m);
    EXPECT_EQ(c.junctions.size(), 6u);
    expectConsistent(c);
}

TEST(MoveElements, KeepsOpeningsInPlaceWhenAWallIsDrawnAtItsStart)
{
    const Building b = moved(kSouth, shift(0, -0.3));  // the partition starts there, and has a door
    EXPECT_NEAR(b.wall(kPartition)->start.y(), -0.3, kExact_m);
    EXPECT_NEAR(opening(b, kDoor).offset_m, 2.3, kExact_m);
    EXPECT_EQ(opening(b, kWindow).offset_m, 1.0);
    expectConsistent(b);
}

TEST(MoveElements, GivesUpAJunctionThatNoLongerMeets)
{
    const Building b = moved(kPartition, shift(6, 0));
    EXPECT_EQ(b.junctions.size(), 4u);
    ASSERT_EQ(b.diagnostics.size(), 2u);
    EXPECT_EQ(b.diagnostics[0].code, "JunctionOpened");
    EXPECT_EQ(b.diagnostics[0].element, kPartition);
    expectConsistent(b);
}

TEST(MoveElements, TurnsAWallAndCutsItAtTheFaces)
{
    const Building b = moved(kPartition, turnAbout(5, 2.5, 0.2));
    EXPECT_EQ(b.junctions.size(), 6u);
    expectConsistent(b);
    // A body that meets another at a slant ends with its first corner at the face (docs/conventions.md).
    EXPECT_NEAR(b.wall(kPartition)->bodyStart_m, (0.3 + std::sin(0.2) * 0.1) / 2 / std::cos(0.2), kExact_m);
}

TEST(MoveElements, ScalesWhatAScaleSays)
{
    const Building wide = moved(kPartition, shift(5, 0) * scaling(1.5, 1, 1) * shift(-5, 0));
    EXPECT_NEAR(wide.wall(kPartition)->thickness.value_m, 0.15, kExact_m);
    EXPECT_EQ(wide.wall(kPartition)->thickness.provenance, Provenance::Corrected);
    EXPECT_EQ(wide.wall(kPartition)->height.provenance, Provenance::Measured);
    const Building high = moved(kPartition, scaling(1, 1, 1.1));
    EXPECT_NEAR(high.wall(kPartition)->height.value_m, 2.86, kExact_m);
    EXPECT_NEAR(opening(high, kDoor).height.value_m, 2.31, kExact_m);
}

TEST(MoveElements, MovesAllTogetherWithoutLosingAJunction)
{
    std::vector<ElementMotion> all;
    for (const Wall& w : house().walls)
        all.push_back({w.id, shift(3, -2) * turnAbout(0, 0, 0.7)});
    const Building b = moveElements(house(), all);
    EXPECT_EQ(b.junctions.size(), 6u);
    EXPECT_TRUE(b.diagnostics.empty());
    expectConsistent(b);
    for (std::size_t i = 0; i < b.walls.size(); ++i)
    {
        EXPECT_NEAR(b.walls[i].axisLength_m(), house().walls[i].axisLength_m(), kExact_m);
        EXPECT_NEAR(b.walls[i].bodyEnd_m, house().walls[i].bodyEnd_m, kExact_m);
    }
}

TEST(MoveElements, MirrorsAnArc)
{
    Building b = house();
    Wall arc = straightWall(ElementId{20}, {1, 1}, {3, 1}, 0.2, 0, 0);
    arc.bulge = 0.5;
    b.walls.push_back(arc);
    const Eigen::Vector2d middle = WallAxis(arc).at(arc.axisLength_m() / 2);
    const Building m = moveElements(b, {{arc.id, scaling(1, -1, 1)}});
    const Wall& w = *m.wall(arc.id);
    EXPECT_NEAR(WallAxis(w).at(w.axisLength_m() / 2).y(), -middle.y(), kExact_m);
    EXPECT_THAT(refusal([&] { return moveElements(b, {{arc.id, scaling(2, 1, 1)}}); }), HasSubstr("curved"));
}

TEST(MoveElements, RefusesWhatAnElementCanNotTake)
{
    const Eigen::Affine3d tilt(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()));
    Eigen::Affine3d shear = Eigen::Affine3d::Identity();
    shear.linear()(0, 1) = 0.5;
    EXPECT_THAT(refusal([&] { return moved(kSouth, tilt); }), HasSubstr("Wall 2 was tilted by 5.7 degrees"));
    EXPECT_THAT(refusal([&] { return moved(kColumn, shear); }), HasSubstr("sheared"));
    EXPECT_THAT(refusal([] { return moved(kSouth, scaling(1, 1, 0)); }), HasSubstr("flattened"));
    EXPECT_THAT(refusal([] { return moved(kSouth, scaling(1, 1, -1)); }), HasSubstr("upside down"));
}

TEST(MoveElements, MovesColumnsSlabsAndSpaces)
{
    const Building b = moved(kColumn, shift(1, 0, 0.1) * turnAbout(2.5, 2.5, 0.3));
    EXPECT_NEAR(column(b, kColumn).center.x(), 3.5, kExact_m);
    EXPECT_NEAR(column(b, kColumn).yaw_rad, 0.3, kExact_m);
    EXPECT_NEAR(column(b, kColumn).base_m, 0.1, kExact_m);
    EXPECT_EQ(column(b, kColumn).sectionProvenance, Provenance::Measured);
    EXPECT_NEAR(moved(kFloor, shift(0, 0, -0.05)).slabs[0].top_m, -0.05, kExact_m);
    const Building scaled = moved(kRoomA, scaling(2, 1, 1));
    EXPECT_NEAR(scaled.spaces[0].area_m2, 2 * house().spaces[0].area_m2, kExact_m);
    EXPECT_NEAR(moved(kStorey, shift(0, 0, 0.1)).storeys[0].elevation_m, 0.1, kExact_m);
}

TEST(PlaceOpening, KeepsItInItsWall)
{
    const auto corners = [](double x, double y0, double y1, double z0, double z1)
    {
        return std::array<Eigen::Vector3d, 4>{Eigen::Vector3d(x, y0, z0), Eigen::Vector3d(x, y1, z0),
                                              Eigen::Vector3d(x, y1, z1), Eigen::Vector3d(x, y0, z1)};
    };
    const Building b = placeOpening(house(), kDoor, corners(5.0, 1.0, 2.0, 0.0, 2.1));
    EXPECT_NEAR(opening(b, kDoor).offset_m, 1.0, kExact_m);
    EXPECT_NEAR(opening(b, kDoor).width.value_m, 1.0, kExact_m);
    EXPECT_EQ(opening(b, kDoor).width.provenance, Provenance::Corrected);
    EXPECT_EQ(opening(b, kDoor).height.provenance, Provenance::Measured);
    EXPECT_THAT(refusal([&] { return placeOpening(house(), kDoor, corners(6, 1, 2, 0, 2.1)); }), HasSubstr("out of"));
    EXPECT_THAT(refusal([&] { return placeOpening(house(), kDoor, corners(5, 4.5, 5.4, 0, 2.1)); }), HasSubstr("edge"));
}

}  // namespace
}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spaces/spaces.h"

#include "tests/unit/spaces/plan_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace
{

using namespace s2b;
using namespace s2b::test;

/// Areas follow from the walls' faces alone; only the rounding of new corners to double is left.
constexpr double kExact_m2 = 1e-6;

SpaceResult spacesOf(const PlanScene& scene, const std::vector<Wall>& walls, const Level& level = levelAt(0.0, 2.6),
                     const SpaceParams& params = {})
{
    const RoomPlan plan = planRooms(scene.cells(), level, walls, params, Context{});
    std::uint32_t nextId = 100;
    return findSpaces(plan, ElementId{1}, 0, nextId, params);
}

std::vector<std::string> codesOf(const SpaceResult& result)
{
    std::vector<std::string> codes;
    for (const Diagnostic& d : result.diagnostics)
        codes.push_back(d.code);
    return codes;
}

/// A house of 8 m by 4 m inside, with a wall across at x = 4.9 to 5.1.
std::vector<Wall> twoRoomWalls()
{
    std::vector<Wall> walls = boxOf(2, {0, 0}, {8, 4});
    walls.push_back(wallFrom(6, {5, 0}, {5, 4}));
    return walls;
}

TEST(FindSpaces, MakesOneSpacePerRoomWithTheExactAreaBetweenTheFaces)
{
    PlanScene scene;
    scene.room({{0, 0}, {4.9, 4}});
    scene.room({{5.1, 0}, {8, 4}}, 0.0, 2.4);
    scene.level({{4.9, 1}, {5.1, 1.9}}, 0.0, Label::Floor);  // a door, through which the floor goes on
    const SpaceResult result = spacesOf(scene, twoRoomWalls());
    ASSERT_EQ(result.spaces.size(), 2U);
    EXPECT_TRUE(result.diagnostics.empty());
    EXPECT_NEAR(result.spaces[0].area_m2, 4.9 * 4, kExact_m2);
    EXPECT_NEAR(result.spaces[1].area_m2, 2.9 * 4, kExact_m2);
    EXPECT_EQ(result.spaces[0].outline.outer.size(), 4U);
    EXPECT_EQ(result.spaces[0].name, "0.01");
    EXPECT_EQ(result.spaces[1].name, "0.02");
    EXPECT_EQ(result.spaces[0].id, ElementId{100});
    EXPECT_EQ(result.spaces[0].boundedBy, (std::vector{ElementId{2}, ElementId{4}, ElementId{5}, ElementId{6}}));
    // The cells' heights are floats, without noise.
    EXPECT_NEAR(result.spaces[0].height.value_m, 2.6, 1e-6);
    EXPECT_NEAR(result.spaces[1].height.value_m, 2.4, 1e-6);
    EXPECT_EQ(result.spaces[1].height.provenance, Provenance::Measured);
}

TEST(FindSpaces, FollowsAnLShapedRoom)
{
    std::vector<Wall> walls{wallFrom(2, {-0.2, -0.1}, {6.2, -0.1}), wallFrom(3, {6.1, 0}, {6.1, 2}),
                            wallFrom(4, {6.2, 2.1}, {3, 2.1}),      wallFrom(5, {3.1, 2.2}, {3.1, 5}),
                            wallFrom(6, {3.2, 5.1}, {-0.2, 5.1}),   wallFrom(7, {-0.1, 5}, {-0.1, 0})};
    PlanScene scene;
    scene.room({{0, 0}, {6, 2}});
    scene.room({{0, 2}, {3, 5}});
    const SpaceResult result = spacesOf(scene, walls);
    ASSERT_EQ(result.spaces.size(), 1U);
    EXPECT_EQ(result.spaces[0].outline.outer.size(), 6U);
    EXPECT_NEAR(result.spaces[0].area_m2, 6 * 2 + 3 * 3, kExact_m2);
    EXPECT_EQ(result.spaces[0].boundedBy.size(), 6U);
}

TEST(FindSpaces, ClosesASmallGapBetweenWallsWithoutChangingTheArea)
{
    std::vector<Wall> walls = twoRoomWalls();
    walls.back().end.y() = 3.9;  // ends 10 cm before the wall that it should meet
    walls.back().bodyEnd_m = 3.9;
    PlanScene scene;
    scene.room({{0, 0}, {8, 4}});
    const SpaceResult result = spacesOf(scene, walls);
    ASSERT_EQ(result.spaces.size(), 2U);
    EXPECT_NEAR(result.spaces[0].area_m2, 4.9 * 4, kExact_m2);
    EXPECT_NEAR(result.spaces[1].area_m2, 2.9 * 4, kExact_m2);
}

TEST(FindSpaces, LeavesAWideGapBetweenWallsOpen)
{
    std::vector<Wall> walls = twoRoomWalls();
    walls.back().end.y() = walls.back().bodyEnd_m = 3.0;
    PlanScene scene;
    scene.room({{0, 0}, {8, 4}});
    const SpaceResult result = spacesOf(scene, walls);
    ASSERT_EQ(result.spaces.size(), 1U);
    EXPECT_NEAR(result.spaces[0].area_m2, 8 * 4 - 0.2 * 3, kExact_m2);
}

TEST(FindSpaces, CutsAFreeStandingWallOut)
{
    std::vector<Wall> walls = boxOf(2, {0, 0}, {8, 4});
    walls.push_back(wallFrom(6, {3, 2}, {5, 2}));
    PlanScene scene;
    scene.room({{0, 0}, {8, 4}});
    const SpaceResult result = spacesOf(scene, walls);
    ASSERT_EQ(result.spaces.size(), 1U);
    ASSERT_EQ(result.spaces[0].outline.holes.size(), 1U);
    EXPECT_NEAR(result.spaces[0].area_m2, 8 * 4 - 2 * 0.2, kExact_m2);
    EXPECT_EQ(result.spaces[0].boundedBy.size(), 5U);
}

TEST(FindSpaces, IsNotDividedByAParapet)
{
    std::vector<Wall> walls = twoRoomWalls();
    walls.back().height.value_m = 1.1;
    PlanScene scene;
    scene.room({{0, 0}, {8, 4}});
    const SpaceResult result = spacesOf(scene, walls);
    ASSERT_EQ(result.spaces.size(), 1U);
    EXPECT_NEAR(result.spaces[0].area_m2, 8 * 4, kExact_m2);
}

TEST(FindSpaces, FollowsACurvedWall)
{
    std::vector<Wall> walls = boxOf(2, {0, 0}, {4, 4});
    walls[1] = wallFrom(3, {4, -0.1}, {4, 4.1});  // a half circle instead of the straight wall
    walls[1].bulge = 1.0;
    walls[1].bodyEnd_m = walls[1].axisLength_m();
    walls[0].bodyEnd_m = walls[2].bodyEnd_m = 4.2;
    walls[2].start.x() = 4.0;
    PlanScene scene;
    scene.room({{0, 0}, {6, 4}});
    const SpaceResult result = spacesOf(scene, walls);
    ASSERT_EQ(result.spaces.size(), 1U);
    // The arc is sampled to 1 mm sagitta over 6.3 m of face.
    EXPECT_NEAR(result.spaces[0].area_m2, 4 * 4 + std::numbers::pi * 2 * 2 / 2, 0.01);
}

TEST(FindSpaces, ReportsWhatIsEnclosedButWasNotSeen)
{
    PlanScene scene;
    scene.room({{0, 0}, {4.9, 4}});
    const SpaceResult result = spacesOf(scene, twoRoomWalls());
    EXPECT_EQ(result.spaces.size(), 1U);
    EXPECT_EQ(codesOf(result), std::vector<std::string>{"EnclosedUnseen"});
}

TEST(FindSpaces, DoesNotTakeACourtyardForARoom)
{
    PlanScene scene;
    scene.room({{0, 0}, {4.9, 4}});
    scene.level({{5.1, 0}, {8, 4}}, 0.0, Label::Floor);
    const SpaceResult result = spacesOf(scene, twoRoomWalls());
    EXPECT_EQ(result.spaces.size(), 1U);
    EXPECT_EQ(codesOf(result), std::vector<std::string>{"EnclosedUncovered"});
}

TEST(FindSpaces, ClosesARoomByItsCeilingWhereAWallIsMissing)
{
    std::vector<Wall> walls = boxOf(2, {0, 0}, {8, 4});
    walls.erase(walls.begin() + 1);  // a glass front at x = 8
    PlanScene scene;
    scene.room({{0, 0}, {8, 4}});
    scene.level({{8, -3}, {15, 7}}, 0.0, Label::Floor);  // ground outside, at the same height
    const SpaceResult result = spacesOf(scene, walls);
    ASSERT_EQ(result.spaces.size(), 1U);
    EXPECT_EQ(result.spaces[0].outline.outer.size(), 4U);
    EXPECT_NEAR(result.spaces[0].area_m2, 8 * 4, 0.05 * 4);  // a pixel of 5 cm along the open side
    EXPECT_EQ(codesOf(result), std::vector<std::string>{"SpaceClosedByCeiling"});
    EXPECT_EQ(result.diagnostics[0].element, result.spaces[0].id);
}

TEST(FindSpaces, OnlyReportsARoomWithHardlyAnyWalls)
{
    PlanScene scene;
    scene.room({{0, 0}, {8, 4}});
    const SpaceResult result = spacesOf(scene, {wallFrom(2, {0, -0.1}, {8, -0.1})});
    EXPECT_TRUE(result.spaces.empty());
    EXPECT_EQ(codesOf(result), std::vector<std::string>{"RoomNotClosed"});
}

TEST(FindSpaces, TakesTheEavesOfAPitchedRoofForTheRoomsEnd)
{
    // Two gable walls along x; the roof meets the floor at x = 0 and x = 8.
    const std::vector<Wall> walls{wallFrom(2, {0, -0.1}, {8, -0.1}), wallFrom(3, {0, 4.1}, {8, 4.1})};
    PlanScene scene;
    scene.level({{0, 0}, {8, 4}}, 0.0, Label::Floor);
    scene.slope({{0, 0}, {4, 4}}, 0.0, 1.0, Label::Roof);
    scene.slope({{4, 0}, {8, 4}}, 4.0, -1.0, Label::Roof);
    const SpaceResult result = spacesOf(scene, walls, levelAt(0.0, 4.0, false));
    ASSERT_EQ(result.spaces.size(), 1U);
    EXPECT_TRUE(result.diagnostics.empty());
    // The roof counts from 0.2 m above the floor, on each side.
    EXPECT_NEAR(result.spaces[0].area_m2, 7.6 * 4, 0.1 * 4);
    EXPECT_EQ(result.spaces[0].height.provenance, Provenance::Assumed);
}

TEST(FindSpaces, FindsNothingInNothing)
{
    EXPECT_TRUE(spacesOf(PlanScene{}, {}).spaces.empty());
    EXPECT_TRUE(spacesOf(PlanScene{}, twoRoomWalls()).spaces.empty());
}

}  // namespace

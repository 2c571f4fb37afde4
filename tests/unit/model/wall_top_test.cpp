// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/wall_top.h"

#include <gtest/gtest.h>

namespace s2b
{
namespace
{

TEST(WallTop, IsLevelWithoutAProfile)
{
    Wall wall;
    wall.base_m = 0.5;
    wall.height.value_m = 2.5;
    EXPECT_DOUBLE_EQ(topAt(wall, -1.0), 3.0);
    EXPECT_DOUBLE_EQ(topAt(wall, 7.0), 3.0);
}

TEST(WallTop, FollowsAGable)
{
    Wall wall;
    wall.topProfile = {{0.0, 2.0}, {3.0, 5.0}, {6.0, 2.0}};
    EXPECT_DOUBLE_EQ(topAt(wall, 1.0), 3.0);
    EXPECT_DOUBLE_EQ(topAt(wall, 3.0), 5.0);
    EXPECT_DOUBLE_EQ(topAt(wall, 5.0), 3.0);
    EXPECT_DOUBLE_EQ(topAt(wall, -1.0), 2.0);
    EXPECT_DOUBLE_EQ(topAt(wall, 9.0), 2.0);
}

TEST(WallTop, TakesAStepAfterItsPlace)
{
    Wall wall;
    wall.topProfile = {{0.0, 2.0}, {1.0, 2.0}, {1.0, 3.0}, {2.0, 3.0}};
    EXPECT_DOUBLE_EQ(topAt(wall, 0.999), 2.0);
    EXPECT_DOUBLE_EQ(topAt(wall, 1.001), 3.0);
}

}  // namespace
}  // namespace s2b

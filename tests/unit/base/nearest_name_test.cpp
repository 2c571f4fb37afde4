// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/nearest_name.h"

#include <gtest/gtest.h>

#include <array>

namespace s2b
{
namespace
{

constexpr std::array<std::string_view, 3> kNames{"walls", "doors", "columns"};

TEST(NearestName, FindsTheOneThatWasMeant)
{
    EXPECT_EQ(nearestName("wals", kNames), "walls");
    EXPECT_EQ(nearestName("DOOR", kNames), "doors");
    EXPECT_EQ(nearestName("colums", kNames), "columns");
    EXPECT_EQ(nearestName("columns", kNames), "columns");
}

TEST(NearestName, TakesTheFirstOfEquallyNearOnes)
{
    constexpr std::array<std::string_view, 2> names{"ab", "ac"};
    EXPECT_EQ(nearestName("ad", names), "ab");
    EXPECT_EQ(nearestName("", names), "ab");
}

TEST(NearestName, IsEmptyWithoutCandidates)
{
    EXPECT_EQ(nearestName("walls", {}), "");
}

TEST(JoinNames, ListsThem)
{
    EXPECT_EQ(joinNames(kNames), "walls, doors, columns");
    EXPECT_EQ(joinNames({}), "");
}

}  // namespace
}  // namespace s2b

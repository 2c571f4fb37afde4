// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/sightlines.h"

#include "tests/support/hand_made_cloud.h"

#include <gtest/gtest.h>

#include <numbers>

namespace s2b
{
namespace
{

using test::HandMadeCloud;

constexpr double kBehind_m = 4.0;

/// A wall at y = 2 with a hole of 1 m by 2 m about x = 0, and what is seen through it at y = 4; the scanner at the
/// origin.
HandMadeCloud wallWithHole()
{
    HandMadeCloud cloud(0.02);
    cloud.standAt({0, 0, 1.5});
    cloud.wallFace({-2, 2}, {2, 2}, 0, 2.6, Label::Wall, {{1.5, 2.5, 0.0, 2.0}});
    cloud.wallFace({-0.9, kBehind_m}, {0.9, kBehind_m}, 0, 2.4);
    return cloud;
}

TEST(Sightlines, PassedWhereSomethingBehindWasSeen)
{
    const Sightlines lines(wallWithHole().view(), 0.0, {0, 0, 0}, Context{});
    const auto stations = lines.near({0, 2, 1.5}, 10.0);
    const auto passed = [&](double x, double z) { return lines.passed({x, 2, z}, {0, 1, 0}, 0.2, stations); };
    EXPECT_TRUE(passed(0.0, 1.0));
    EXPECT_TRUE(passed(0.3, 1.8));
    EXPECT_FALSE(passed(1.2, 1.0));  // the wall
    EXPECT_FALSE(passed(0.0, 2.3));
    EXPECT_FALSE(lines.passed({0, kBehind_m, 1.2}, {0, 1, 0}, 0.2, stations));  // what was seen is no way through
    EXPECT_FALSE(lines.passed({0, -3, 1.2}, {0, 1, 0}, 0.2, stations));         // nobody looked there
}

TEST(Sightlines, RaysAlongAPlateDoNotPassIt)
{
    const Sightlines lines(wallWithHole().view(), 0.0, {0, 0, 0}, Context{});
    EXPECT_FALSE(lines.passed({0, 2, 1.0}, {1, 0, 0}, 0.2, lines.near({0, 2, 1}, 10.0)));
}

TEST(Sightlines, FollowsTheBuildingFrame)
{
    HandMadeCloud cloud = wallWithHole();
    constexpr double yaw = 0.6;
    cloud.move(yaw, {0, 0, 7.0});
    const Sightlines lines(cloud.view(), yaw, {0, 0, -7.0}, Context{});
    const auto stations = lines.near({0, 2, 1.5}, 10.0);
    EXPECT_TRUE(lines.passed({0, 2, 1.0}, {0, 1, 0}, 0.2, stations));
    EXPECT_FALSE(lines.passed({1.2, 2, 1.0}, {0, 1, 0}, 0.2, stations));
}

TEST(Sightlines, LooksInEveryDirection)
{
    // A sphere of points: from its middle every place within was passed, none beyond.
    HandMadeCloud cloud;
    cloud.standAt({1, 2, 3});
    for (int i = 0; i < 200000; ++i)
    {
        const double z = 1 - 2 * randomShare(1, 1, static_cast<std::uint64_t>(i)),
                     angle = 2 * std::numbers::pi * randomShare(1, 2, static_cast<std::uint64_t>(i)),
                     r = std::sqrt(1 - z * z);
        cloud.point({1 + 5 * r * std::cos(angle), 2 + 5 * r * std::sin(angle), 3 + 5 * z}, Label::Unassigned);
    }
    const Sightlines lines(cloud.view(), 0.0, {0, 0, 0}, Context{});
    int inside = 0, beyond = 0;
    for (int i = 0; i < 2000; ++i)
    {
        const double z = 1 - 2 * randomShare(2, 1, static_cast<std::uint64_t>(i)),
                     angle = 2 * std::numbers::pi * randomShare(2, 2, static_cast<std::uint64_t>(i)),
                     r = std::sqrt(1 - z * z);
        const Eigen::Vector3d d(r * std::cos(angle), r * std::sin(angle), z), at(1, 2, 3);
        inside += lines.passed(at + 4 * d, d, 0.2, {0});
        beyond += lines.passed(at + 4.9 * d, d, 0.2, {0});
    }
    EXPECT_GT(inside, 700);  // most squares of the map got a point
    EXPECT_EQ(beyond, 0);
}

TEST(Sightlines, NearestStationsFirstAndNoneWithoutStations)
{
    HandMadeCloud cloud;
    cloud.standAt({9, 0, 0});
    cloud.standAt({1, 0, 0});
    cloud.standAt({30, 0, 0});
    cloud.point({0, 0, 0}, Label::Wall);
    EXPECT_EQ(Sightlines(cloud.view(), 0, {0, 0, 0}, Context{}).near({0, 0, 0}, 10.0),
              (std::vector<std::uint32_t>{1, 0}));
    cloud.forgetStations();
    EXPECT_TRUE(Sightlines(cloud.view(), 0, {0, 0, 0}, Context{}).empty());
    EXPECT_FALSE(Sightlines().passed({0, 0, 0}, {1, 0, 0}, 0.1, {}));
}

}  // namespace
}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/station_assignment.h"

#include "tests/support/hand_made_cloud.h"

#include <gtest/gtest.h>

namespace s2b
{
namespace
{

using test::HandMadeCloud;

/// Two rooms with a wall of 0.12 m between them, at y in [3, 3.12], each with its station.
HandMadeCloud twoRooms()
{
    HandMadeCloud cloud;
    cloud.standAt({2.0, 1.5, 1.5});
    cloud.room({0, 0}, {4, 3});
    cloud.standAt({2.0, 4.6, 1.5});
    cloud.room({0, 3.12}, {4, 6});
    cloud.forgetStationOfPoints();
    return cloud;
}

TEST(NearestVisibleStations, FindsTheRoomsOwnBehindAThinWall)
{
    const HandMadeCloud cloud = twoRooms();
    const CloudView view = cloud.view();
    const std::vector<std::uint16_t> found = nearestVisibleStations(view, Context{});
    std::size_t right = 0, wrong = 0;
    for (std::size_t i = 0; i < view.count; ++i)
        (found[i] == (view.xyz[3 * i + 1] < 3.06F ? 0 : 1) ? right : wrong) += found[i] != StationView::kUnknown;
    EXPECT_EQ(wrong, 0U);
    EXPECT_GT(right, 0.9 * static_cast<double>(view.count));
}

TEST(NearestVisibleStations, KnowsNoneOfWhatIsHidden)
{
    HandMadeCloud cloud;
    cloud.standAt({2.0, 1.5, 1.5});
    cloud.room({0, 0}, {4, 3});
    const std::size_t own = cloud.size();
    cloud.room({0, 3.2}, {4, 6});
    const std::vector<std::uint16_t> found = nearestVisibleStations(cloud.view(), Context{});
    for (std::size_t i = own; i < cloud.size(); ++i)
        ASSERT_EQ(found[i], StationView::kUnknown) << i;
}

TEST(NearestVisibleStations, DoesNotDependOnTheOrderOfThePointsOrTheThreads)
{
    HandMadeCloud cloud = twoRooms();
    const auto counted = [&](unsigned threads)
    {
        Context context;
        context.threads = threads;
        const std::vector<std::uint16_t> found = nearestVisibleStations(cloud.view(), context);
        return std::pair(std::count(found.begin(), found.end(), 0), std::count(found.begin(), found.end(), 1));
    };
    const auto before = counted(1);
    EXPECT_EQ(before, counted(2));
    cloud.shuffle(3);
    EXPECT_EQ(before, counted(2));
}

TEST(NearestVisibleStations, TakesPointsThatAreNoNumbersAndStationsOutsideTheCloud)
{
    HandMadeCloud cloud;
    cloud.standAt({-3.0, 1.0, 1.0});
    cloud.wallFace({0, 0}, {0, 2}, 0, 2);
    cloud.point({std::numeric_limits<double>::quiet_NaN(), 0, 0}, Label::Wall);
    const std::vector<std::uint16_t> found = nearestVisibleStations(cloud.view(), Context{});
    EXPECT_EQ(found.back(), StationView::kUnknown);
    EXPECT_EQ(found.front(), 0);
}

TEST(HiddenShare, TellsMixedUpIdsFromRightOnes)
{
    HandMadeCloud cloud;
    cloud.standAt({2.0, 1.5, 1.5});
    cloud.room({0, 0}, {4, 3});
    const std::size_t first = cloud.size();
    cloud.standAt({2.0, 4.6, 1.5});
    cloud.room({0, 3.12}, {4, 6});
    EXPECT_LT(hiddenShare(cloud.view(), Context{}), 0.15);
    std::vector<std::uint16_t> swapped(cloud.size(), 0);
    std::fill(swapped.begin(), swapped.begin() + static_cast<std::ptrdiff_t>(first), std::uint16_t{1});
    CloudView view = cloud.view();
    view.stations.ofPoint = swapped.data();
    // All but what lies within the reach of a slant ray's own surface (0.4 m): the partition's faces and strips beside
    // it.
    EXPECT_GT(hiddenShare(view, Context{}), 0.75);
    view.stations = {};
    EXPECT_EQ(hiddenShare(view, Context{}), 0.0);
}

}  // namespace
}  // namespace s2b

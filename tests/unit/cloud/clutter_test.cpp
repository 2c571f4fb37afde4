// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/clutter.h"
#include "tests/support/hand_made_cloud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace s2b
{
namespace
{

using test::HandMadeCloud;

HandMadeCloud building(double spacing = 0.03)
{
    HandMadeCloud cloud(spacing);
    cloud.room({0, 0}, {8, 5});
    return cloud;
}

/// Scattered points in a box of 4 m.
void scatter(HandMadeCloud& cloud, const Eigen::Vector3d& low, int count)
{
    for (int i = 0; i < count; ++i)
    {
        const auto n = static_cast<std::uint64_t>(i);
        cloud.point(low + 4.0 * Eigen::Vector3d(randomShare(5, 0, n), randomShare(5, 1, n), randomShare(5, 2, n)),
                    Label::Unassigned);
    }
}

std::size_t kept(const HandMadeCloud& cloud, const KeptRegion& region, std::size_t first = 0)
{
    std::size_t count = 0;
    const CloudView view = cloud.view();
    for (std::size_t i = first; i < view.count; ++i)
        count += region.contains({view.xyz[3 * i], view.xyz[3 * i + 1], view.xyz[3 * i + 2]});
    return count;
}

TEST(DenseRegion, KeepsAllOfACleanBuilding)
{
    const HandMadeCloud cloud = building();
    EXPECT_EQ(kept(cloud, findDenseRegion(cloud.view(), {}, {})), cloud.size());
}

TEST(DenseRegion, LeavesADistantBlobOut)
{
    HandMadeCloud cloud = building();
    const std::size_t own = cloud.size();
    scatter(cloud, {40, 3, 0}, 400);
    scatter(cloud, {2, 2, 30}, 400);  // above: a height is a limit as well
    const KeptRegion region = findDenseRegion(cloud.view(), {}, {});
    EXPECT_EQ(kept(cloud, region, own), 0u);
    EXPECT_EQ(kept(cloud, region), own);
}

TEST(DenseRegion, IsWhatItWasWithoutTheBlob)
{
    HandMadeCloud cloud = building();
    const KeptRegion before = findDenseRegion(cloud.view(), {}, {});
    scatter(cloud, {40.3, 3, 0.2}, 400);
    const KeptRegion after = findDenseRegion(cloud.view(), {}, {});
    // The voxel grid starts at the cloud's lowest corner, which the blob leaves where it was.
    EXPECT_EQ(before.center, after.center);
    EXPECT_EQ(before.half, after.half);
    EXPECT_EQ(before.zMax, after.zMax);
}

TEST(DenseRegion, KeepsSparseDetailInsideTheBuilding)
{
    HandMadeCloud cloud = building();
    const std::size_t own = cloud.size();
    for (int i = 0; i < 5; ++i)
        cloud.point({3.0 + 0.2 * i, 2.5, 1.2}, Label::Furniture);
    EXPECT_EQ(kept(cloud, findDenseRegion(cloud.view(), {}, {}), own), 5u);
}

TEST(DenseRegion, FollowsABuildingThatStandsAtAnAngle)
{
    HandMadeCloud cloud = building();
    cloud.move(std::numbers::pi / 6, {100, 50, 0});
    const KeptRegion region = findDenseRegion(cloud.view(), {}, {});
    EXPECT_EQ(kept(cloud, region), cloud.size());
    // The long side of 8 m with up to a voxel's diagonal and the margin at each end; its bounding square has 9.4 m.
    EXPECT_LT(4 * region.half.x() * region.half.y(), (8 + 2 * 1.42) * (5 + 2 * 1.42));
}

TEST(DenseRegion, NeedsNoTuningForTheDensity)
{
    for (const double spacing : {0.015, 0.03, 0.1})
    {
        HandMadeCloud cloud = building(spacing);
        const std::size_t own = cloud.size();
        scatter(cloud, {40, 3, 0}, static_cast<int>(own / 1000));
        const KeptRegion region = findDenseRegion(cloud.view(), {}, {});
        EXPECT_EQ(kept(cloud, region), own) << "spacing " << spacing;
    }
}

TEST(DenseRegion, TakesEqualPointsForTheBuilding)
{
    HandMadeCloud cloud;
    for (int i = 0; i < 100; ++i)
        cloud.point({5, 5, 5}, Label::Wall);
    EXPECT_EQ(kept(cloud, findDenseRegion(cloud.view(), {}, {})), 100u);
}

TEST(DenseRegion, HasNoLimitWhenSwitchedOff)
{
    HandMadeCloud cloud = building();
    scatter(cloud, {40, 3, 0}, 400);
    ClutterParams off;
    off.enabled = false;
    const KeptRegion region = findDenseRegion(cloud.view(), off, {});
    EXPECT_TRUE(region.everything);
    EXPECT_EQ(kept(cloud, region), cloud.size());
}

TEST(DenseRegion, SurvivesStrayReturnsHundredsOfKilometresAway)
{
    HandMadeCloud cloud = building();
    const std::size_t own = cloud.size();
    cloud.point({3e5, -2e5, 1e4}, Label::Unassigned);
    // The grid gets coarser, and the region with it; what matters is that nothing of the building is lost.
    EXPECT_EQ(kept(cloud, findDenseRegion(cloud.view(), {}, {})), own);
}

TEST(DenseRegion, DoesNotDependOnThePointsOrderOrTheThreads)
{
    HandMadeCloud cloud = building();
    scatter(cloud, {40, 3, 0}, 400);
    Context one, four;
    one.threads = 1;
    four.threads = 4;
    const KeptRegion a = findDenseRegion(cloud.view(), {}, one);
    cloud.shuffle(9);
    const KeptRegion b = findDenseRegion(cloud.view(), {}, four);
    EXPECT_EQ(a.center, b.center);
    EXPECT_EQ(a.axis, b.axis);
    EXPECT_EQ(a.half, b.half);
    EXPECT_EQ(a.zMin, b.zMin);
    EXPECT_EQ(a.zMax, b.zMax);
}

TEST(DenseRegion, LeavesPointsThatAreNotFiniteToTheCells)
{
    HandMadeCloud cloud = building();
    cloud.point({std::nan(""), 0, 0}, Label::Wall);
    EXPECT_EQ(kept(cloud, findDenseRegion(cloud.view(), {}, {})), cloud.size() - 1);
}

}  // namespace
}  // namespace s2b

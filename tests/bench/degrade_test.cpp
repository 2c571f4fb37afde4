// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/degrade.h"

#include "core/base/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace s2b
{
namespace
{

constexpr std::size_t kPoints = 400000;

/// A floor of 40 x 40 m and clutter and walls above it, each point a class of its own place.
PointCloud room()
{
    PointCloud cloud;
    for (std::size_t i = 0; i < kPoints; ++i)
    {
        const bool isFloor = i % 4 == 0;
        cloud.points.emplace_back(static_cast<float>(40.0 * randomShare(3, 1, i)),
                                  static_cast<float>(40.0 * randomShare(3, 2, i)),
                                  isFloor ? 0.0F : static_cast<float>(0.1 + 2.4 * randomShare(3, 3, i)));
        cloud.labels.push_back(isFloor ? Label::Floor : i % 4 == 1 ? Label::Unassigned : Label::Wall);
    }
    return cloud;
}

double shareOf(const PointCloud& cloud, Label label)
{
    return static_cast<double>(std::count(cloud.labels.begin(), cloud.labels.end(), label)) /
           static_cast<double>(cloud.size());
}

TEST(Degrade, ConfusesLabelsAsOftenAsItSays)
{
    PointCloud cloud = room();
    degrade(cloud, 7);
    // Walls: half of the points; 5 % less 1/8 that hit their own class by chance are flipped, then 10 % in patches
    // become furniture; half of the clutter joins them. Patches vary the shares by a few per cent of their value.
    EXPECT_NEAR(shareOf(cloud, Label::Furniture), 0.5 * 0.1 + 0.25 * 0.5 * 0.1, 0.01);
    EXPECT_NEAR(shareOf(cloud, Label::Unassigned), 0.25 * 0.5 + 0.25 * 0.1, 0.015);
    EXPECT_NEAR(shareOf(cloud, Label::Stair), 0.0, 1e-9) << "nothing is taken for a stair";
}

TEST(Degrade, HidesWhatIsInBoxesButNotTheFloor)
{
    const PointCloud before = room();
    PointCloud after = before;
    degrade(after, 7);
    const auto count = [](const PointCloud& cloud, float low, float high)
    {
        return std::count_if(cloud.points.begin(), cloud.points.end(),
                             [&](const Eigen::Vector3f& p) { return p.z() >= low && p.z() < high; });
    };
    EXPECT_EQ(count(after, -1.0F, 0.05F), count(before, -1.0F, 0.05F));
    EXPECT_EQ(count(after, 1.51F, 9.0F), count(before, 1.51F, 9.0F));
    // 25 boxes of 1.44 m2 on 1600 m2, a few over each other or the edge.
    const auto lost = static_cast<double>(count(before, 0.05F, 1.5F) - count(after, 0.05F, 1.5F)) /
                      static_cast<double>(count(before, 0.05F, 1.5F));
    EXPECT_GT(lost, 0.015);
    EXPECT_LT(lost, 0.0226);
}

TEST(Degrade, DependsOnTheSeedAlone)
{
    PointCloud a = room();
    PointCloud b = room();
    PointCloud c = room();
    degrade(a, 7);
    degrade(b, 7);
    degrade(c, 8);
    EXPECT_EQ(a.labels, b.labels);
    EXPECT_EQ(a.points, b.points);
    EXPECT_NE(a.labels, c.labels);
}

TEST(Degrade, LeavesAnEmptyCloudEmpty)
{
    PointCloud cloud;
    degrade(cloud, 7);
    EXPECT_EQ(cloud.size(), 0U);
}

}  // namespace
}  // namespace s2b

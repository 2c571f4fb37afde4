// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/wall_planes.h"

#include <gtest/gtest.h>

#include <cstring>

namespace s2b
{
namespace
{

constexpr float kSize = 0.03f;

/// A wall of 4 m by 2.7 m in the plane x = 0 with a door leaf of 0.9 m by 2 m that stands back by 8 cm.
CellSet wallWithDoor()
{
    CellSet set;
    set.size_m = static_cast<double>(kSize);
    set.floor_m = 0.0;
    set.ceiling_m = 2.7;
    for (float y = 0.0f; y < 4.0f; y += kSize)
        for (float z = 0.015f; z < 2.7f; z += kSize)
        {
            const bool isLeaf = y > 1.5f && y < 2.4f && z < 2.0f;
            SurfaceCell c;
            c.position = {isLeaf ? 0.09f : 0.01f, y, z};
            c.normal = {1, 0, 0};
            c.label = isLeaf ? Label::Door : Label::Wall;
            set.cells.push_back(c);
        }
    return set;
}

}  // namespace

TEST(WallPlanes, ALeafStandsBackFromTheWallAndEndsBelowTheCeiling)
{
    const CellSet set = wallWithDoor();
    const std::vector<WallPlane> planes = findWallPlanes(set, {});
    ASSERT_EQ(planes.size(), set.cells.size());
    for (std::size_t i = 0; i < planes.size(); ++i)
    {
        const SurfaceCell& c = set.cells[i];
        if (c.label == Label::Door)
        {
            EXPECT_NEAR(planes[i].upperOffset, 0.8f, 0.21f);  // in 0.1 m, strips are 2 cm
            EXPECT_NEAR(planes[i].top, 0.7f, 0.16f);          // bins are 15 cm
            EXPECT_LT(planes[i].runUp, 2.0f - c.position.z() + 0.16f);
        }
        else if (c.position.y() < 1.0f)
        {
            EXPECT_LT(planes[i].offset, 0.01f);
            EXPECT_LT(planes[i].upperOffset, 0.01f);
            EXPECT_NEAR(planes[i].top, 0.0f, 0.16f);
            EXPECT_NEAR(planes[i].runUp + planes[i].runDown, 2.7f, 0.31f);
        }
    }
}

TEST(WallPlanes, AWholeWallHasAStrengthOfAboutOne)
{
    const CellSet set = wallWithDoor();
    const std::vector<WallPlane> planes = findWallPlanes(set, {});
    for (std::size_t i = 0; i < planes.size(); ++i)
    {
        const float y = set.cells[i].position.y();
        if (y > 3.0f && y < 3.2f)
        {
            EXPECT_NEAR(planes[i].strength, 1.0f, 0.15f);
        }
    }
}

TEST(WallPlanes, LevelCellsAndThoseWithoutANormalHaveNone)
{
    CellSet set = wallWithDoor();
    set.cells[0].normal = {0, 0, 1};
    set.cells[1].normal = {0, 0, 0};
    const std::vector<WallPlane> planes = findWallPlanes(set, {});
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
    {
        EXPECT_EQ(planes[i].strength, 0.0f);
        EXPECT_EQ(planes[i].runUp, 0.0f);
    }
}

TEST(WallPlanes, AreTheSameForAnyNumberOfThreads)
{
    const CellSet set = wallWithDoor();
    Context one, many;
    one.threads = 1;
    many.threads = 4;
    const std::vector<WallPlane> a = findWallPlanes(set, one), b = findWallPlanes(set, many);
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(WallPlane)), 0);
}

}  // namespace s2b

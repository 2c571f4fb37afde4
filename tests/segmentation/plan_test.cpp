// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/plan.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace s2b
{
namespace
{

SurfaceCell cell(float x, float y, float z, const Eigen::Vector3f& normal)
{
    SurfaceCell c;
    c.position = {x, y, z};
    c.normal = normal;
    c.count = 1;
    return c;
}

PlanContract contract(std::vector<std::string> channels)
{
    PlanContract plan;
    plan.pixel_m = 0.2;
    plan.low_m = -0.3;
    plan.bin_m = 0.2;
    plan.bins = 24;
    plan.channels = std::move(channels);
    plan.multiple = 8;
    return plan;
}

/// A wall facing x at x = 1.07, a floor, and one slanted cell.
CellSet corner()
{
    CellSet set;
    set.size_m = 0.02;
    set.floor_m = 10.0;
    set.ceiling_m = 12.5;
    set.cells.push_back(cell(0.0f, 0.0f, 10.0f, {0, 0, 1}));
    for (int y = 0; y < 10; ++y)
        for (int z = 0; z < 10; ++z)
            set.cells.push_back(
                cell(1.07f, 0.41f + 0.02f * static_cast<float>(y), 10.71f + 0.02f * static_cast<float>(z), {-1, 0, 0}));
    set.cells.push_back(cell(0.5f, 0.5f, 11.0f, {0.8f, 0, 0.6f}));
    return set;
}

float value(const Tensor& plan, std::size_t layer, std::int64_t x, std::int64_t y)
{
    const auto pixels = static_cast<std::size_t>(plan.shape[2] * plan.shape[3]);
    return std::get<std::vector<float>>(plan.data)[layer * pixels + static_cast<std::size_t>(y * plan.shape[3] + x)];
}

}  // namespace

TEST(Plan, SidesAreAMultipleThatHoldsAllCells)
{
    const PlanContract plan = contract({"level"});
    const CellSet set = corner();
    const PlanGrid grid(plan, set);
    EXPECT_EQ(grid.width(), 8);
    EXPECT_EQ(grid.height(), 8);
    for (const SurfaceCell& c : set.cells)
    {
        const PlanPlace p = grid.place(c);
        EXPECT_LT(p.x, grid.width());
        EXPECT_LT(p.y, grid.height());
        EXPECT_LE(std::abs(p.dx), 0.5f);
        EXPECT_LE(std::abs(p.dy), 0.5f);
    }
}

TEST(Plan, AFullyCoveredBinHasTheAreaOfItsSection)
{
    const PlanContract plan = contract({"facing_x", "facing_y", "level", "rest", "facing_x_place", "facing_y_place"});
    const CellSet set = corner();
    const Tensor t = planTensor(PlanGrid(plan, set), plan, set);
    ASSERT_EQ(t.shape, (std::vector<std::int64_t>{1, 6 * 24, 8, 8}));
    // 0.7 m over the floor is in the sixth bin from 0.3 m below it; x = 1.07 in the sixth pixel, 3 cm before its
    // centre.
    EXPECT_NEAR(value(t, 5, 5, 2), 1.0f, 1e-4f);
    EXPECT_NEAR(value(t, 4 * 24 + 5, 5, 2), -0.15f, 1e-4f);
    EXPECT_EQ(value(t, 24 + 5, 5, 2), 0.0f);
    EXPECT_NEAR(value(t, 2 * 24 + 1, 0, 0), 0.01f, 1e-6f);
    EXPECT_GT(value(t, 3 * 24 + 6, 2, 2), 0.0f);
}

TEST(Plan, WhatIsBelowOrAboveCountsInTheOutermostBins)
{
    const PlanContract plan = contract({"level"});
    CellSet set = corner();
    set.cells.push_back(cell(0.0f, 0.0f, 3.0f, {0, 0, 1}));
    set.cells.push_back(cell(0.0f, 0.0f, 40.0f, {0, 0, 1}));
    const PlanGrid grid(plan, set);
    EXPECT_EQ(grid.place(set.cells[set.cells.size() - 2]).bin, 0);
    EXPECT_EQ(grid.place(set.cells.back()).bin, 23);
    EXPECT_EQ(grid.place(set.cells.back()).dz, 1.0f);
    const Tensor t = planTensor(grid, plan, set);
    EXPECT_GT(value(t, 0, 0, 0), 0.0f);
    EXPECT_GT(value(t, 23, 0, 0), 0.0f);
}

}  // namespace s2b

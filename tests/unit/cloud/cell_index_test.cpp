// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/cell_index.h"
#include "tests/support/stages.h"

#include <gtest/gtest.h>

#include <set>

namespace s2b
{
namespace
{

using test::cellsOf;
using test::HandMadeCloud;

TEST(CellIndex, VisitsEveryCellNearASegmentOnce)
{
    HandMadeCloud cloud(0.03);
    cloud.room({-2, -1}, {4, 3});
    const SurfaceCells cells = cellsOf(cloud);
    const double zMin = 0.5, zMax = 2.0, reach = 0.3;
    const CellIndex index(cells, zMin, zMax);
    const Eigen::Vector2d a(-1.5, -1.0), b(3.0, 2.5);
    std::set<const SurfaceCell*> visited;
    index.near(a, b, reach, [&](const SurfaceCell& c) { EXPECT_TRUE(visited.insert(&c).second) << "visited twice"; });
    std::size_t near = 0;
    for (const SurfaceCell& c : cells.cells)
    {
        const Eigen::Vector2d p = c.position.head<2>().cast<double>();
        const Eigen::Vector2d t = (b - a).normalized();
        const double s = std::clamp(t.dot(p - a), 0.0, (b - a).norm());
        const double z = static_cast<double>(c.position.z());
        if ((p - a - t * s).norm() <= reach && z > zMin && z < zMax)
        {
            ++near;
            EXPECT_TRUE(visited.contains(&c));
        }
    }
    EXPECT_GT(near, 100u);
    EXPECT_LT(visited.size(), cells.cells.size() / 2);
}

TEST(CellIndex, IsEmptyBetweenHeightsWithoutCells)
{
    HandMadeCloud cloud(0.03);
    cloud.room({0, 0}, {2, 2});
    const SurfaceCells cells = cellsOf(cloud);
    const CellIndex index(cells, 10, 20);
    index.near({0, 0}, {2, 2}, 1, [](const SurfaceCell&) { ADD_FAILURE() << "there is no cell at this height"; });
}

}  // namespace
}  // namespace s2b

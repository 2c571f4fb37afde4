// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/upper_storey.h"

#include <gtest/gtest.h>

namespace
{

using namespace s2b;

Wall wallOf(std::uint32_t id, double y, double base_m, double height_m)
{
    Wall w;
    w.id = ElementId{id};
    w.storey = ElementId{100};
    w.start = {0, y};
    w.end = {5, y};
    w.bodyEnd_m = 5;
    w.base_m = base_m;
    w.height = {height_m, Provenance::Measured, 0};
    w.thickness = {0.2, Provenance::Measured, 0};
    w.evidence.facesSeen = 2;
    return w;
}

/// A column of face cells on both faces of the wall, every 2 cm from bottom to top.
void addFaces(SurfaceCells& cells, const Wall& w, double bottom, double top)
{
    for (double x = 0.1; x < 4.9; x += 0.1)
        for (double z = bottom; z < top; z += 0.02)
            for (const double side : {-0.1, 0.1})
            {
                SurfaceCell c;
                c.position = Eigen::Vector3d(x, w.start.y() + side, z).cast<float>();
                c.normal = Eigen::Vector3f::UnitY();
                cells.cells.push_back(c);
            }
}

TEST(UpperStorey, IsWhereTheLowerWallsEndBesideAHangingOne)
{
    SurfaceCells cells;
    cells.size_m = 0.02;
    // The foot of the hanging wall is hidden by 0.2 m of roof; the lower wall ends at the storey.
    const std::vector<Wall> walls{wallOf(1, 0, 0, 5.2), wallOf(2, 4, 3.3, 1.9), wallOf(3, 8, 0, 3.1)};
    addFaces(cells, walls[1], 3.4, 5.2);
    addFaces(cells, walls[2], 0, 3.2);
    Level level;
    level.ceiling_m = 5.2;
    const auto base = upperStoreyBase(walls, level, CellIndex(cells, -0.2, 5.6), 1.9);
    ASSERT_TRUE(base.has_value());
    EXPECT_NEAR(*base, 3.2, 0.08);  // the 2 % quantile of the cells of 0.3 m around a row of 0.1 m
}

TEST(UpperStorey, IsNotFoundWhereAllWallsStandOnTheFloor)
{
    const std::vector<Wall> walls{wallOf(1, 0, 0, 5.2), wallOf(2, 4, 0.0, 3.0)};
    SurfaceCells cells;
    cells.size_m = 0.02;
    addFaces(cells, walls[0], 0, 5.2);
    Level level;
    level.ceiling_m = 5.2;
    EXPECT_FALSE(upperStoreyBase(walls, level, CellIndex(cells, -0.2, 5.6), 1.9).has_value());
}

TEST(UpperStorey, DividesTallWallsAndTakesHangingOnes)
{
    std::vector<Wall> walls{wallOf(1, 0, 0, 5.2), wallOf(2, 4, 3.3, 1.9), wallOf(3, 8, 0, 3.1)};
    std::vector<Junction> junctions{{ElementId{1}, ElementId{2}, JunctionEnd::End, JunctionEnd::Path},
                                    {ElementId{1}, ElementId{3}, JunctionEnd::Start, JunctionEnd::Start}};
    std::uint32_t nextId = 10;
    divideWalls(walls, junctions, 3.2, ElementId{101}, nextId);
    ASSERT_EQ(walls.size(), 4u);
    EXPECT_DOUBLE_EQ(walls[0].height.value_m, 3.2);
    EXPECT_EQ(walls[0].storey, ElementId{100});
    EXPECT_EQ(walls[1].storey, ElementId{101});
    EXPECT_DOUBLE_EQ(walls[1].base_m, 3.2);
    EXPECT_NEAR(walls[1].height.value_m, 2.0, 1e-12);
    EXPECT_EQ(walls[2].storey, ElementId{100});  // hardly reaches it
    EXPECT_EQ(walls[3].storey, ElementId{101});
    EXPECT_EQ(walls[3].id, ElementId{10});
    EXPECT_DOUBLE_EQ(walls[3].base_m, 3.2);
    // The hanging wall meets the upper part, not the lower one.
    EXPECT_EQ(junctions[0].wallA, ElementId{10});
    EXPECT_EQ(junctions[0].wallB, ElementId{2});
    EXPECT_EQ(junctions[1].wallA, ElementId{1});
}

}  // namespace

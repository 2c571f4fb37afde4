// SPDX-License-Identifier: GPL-3.0-or-later
/// Classes that a model got wrong and the building that they show puts right.
#include "core/segmentation/element_classes.h"

#include "tests/support/hand_made_cloud.h"

#include <gtest/gtest.h>

#include <functional>

namespace s2b
{
namespace
{

using test::Gap;
using test::HandMadeCloud;
using test::RoomGaps;

const Gap kWindow{1.5, 2.9, 0.9, 2.1}, kDoor{1.0, 1.9, -1.0, 2.05};

/// Two rooms beside each other with a wall of 24 cm between them: a door in it, a window in the south wall, a column.
HandMadeCloud twoRooms()
{
    HandMadeCloud cloud(0.02, 0.001);
    RoomGaps west, east;
    west.south = {kWindow};
    west.east = {kDoor};
    east.west = {kDoor};
    cloud.room({0, 0}, {5, 4}, 0.0, 2.6, west);
    cloud.room({5.24, 0}, {9, 4}, 0.0, 2.6, east);
    // The reveal of the window, its pane, and the outer face.
    for (const double x : {1.5, 2.9})
        cloud.wallFace({x, -0.24}, {x, 0}, 0.9, 2.1);
    for (const double z : {0.9, 2.1})
        cloud.horizontal({1.5, -0.24}, {2.9, 0}, z, Label::Wall);
    cloud.wallFace({1.5, -0.12}, {2.9, -0.12}, 0.9, 2.1, Label::Window);
    cloud.wallFace({-0.24, -0.24}, {9.24, -0.24}, 0.0, 2.6, Label::Wall, {{1.74, 3.14, 0.9, 2.1}});
    // The door is closed: its leaf stands in the middle of the wall.
    for (const double y : {1.0, 1.9})
        cloud.wallFace({5.0, y}, {5.24, y}, 0.0, 2.05);
    cloud.horizontal({5.0, 1.0}, {5.24, 1.9}, 2.05, Label::Wall);
    cloud.wallFace({5.12, 1.0}, {5.12, 1.9}, 0.0, 2.05, Label::Door);
    return cloud;
}

struct Settled
{
    SurfaceCells cells;
    std::vector<CellClass> classes;

    /// Share of the cells with the true class `from` that ended as `to`.
    [[nodiscard]] double share(Label from, Label to) const
    {
        double all = 0, some = 0;
        for (std::size_t i = 0; i < classes.size(); ++i)
            if (cells.cells[i].label == from)
                all += 1, some += classes[i].label == to;
        return some / all;
    }
};

/// @param guess  what the model says of a cell with its true class
Settled settled(const HandMadeCloud& cloud, const std::function<CellClass(const SurfaceCell&)>& guess)
{
    Settled s;
    CellParams params;
    params.size_m = 0.03;
    s.cells = buildSurfaceCells(cloud.view(), {}, params, {});
    for (const SurfaceCell& c : s.cells.cells)
        s.classes.push_back(guess(c));
    SurfaceCells unlabelled = s.cells;
    unlabelled.hasLabels = false;
    settleByElements(s.cells, findLevels(unlabelled, {}, {}).levels, s.classes, {});
    return s;
}

CellClass right(const SurfaceCell& c)
{
    return {c.label, 220};
}

TEST(ElementClasses, LeaveWhatIsRight)
{
    const Settled s = settled(twoRooms(), right);
    for (const Label label : {Label::Floor, Label::Ceiling, Label::Wall, Label::Window, Label::Door})
        EXPECT_GT(s.share(label, label), 0.97) << labelName(label);
}

TEST(ElementClasses, FindThePaneThatWasTakenForWall)
{
    const Settled s = settled(twoRooms(), [](const SurfaceCell& c)
                              { return c.label == Label::Window ? CellClass{Label::Wall, 150} : right(c); });
    EXPECT_GT(s.share(Label::Window, Label::Window), 0.9);
    EXPECT_GT(s.share(Label::Wall, Label::Wall), 0.97);
}

TEST(ElementClasses, FindTheWallThatWasTakenForSomethingElse)
{
    // Half of the cells of a metre of wall are furniture, a bit of it door.
    std::size_t k = 0;
    const Settled s =
        settled(twoRooms(),
                [&](const SurfaceCell& c)
                {
                    const bool isWrong = c.label == Label::Wall && c.position.x() < 1.2f && ++k % 2 == 0;
                    return isWrong ? CellClass{k % 8 == 0 ? Label::Door : Label::Furniture, 140} : right(c);
                });
    EXPECT_GT(s.share(Label::Wall, Label::Wall), 0.97);
}

TEST(ElementClasses, SayThatTheyAreNotTheModels)
{
    const Settled s = settled(twoRooms(), [](const SurfaceCell& c)
                              { return c.label == Label::Window ? CellClass{Label::Wall, 150} : right(c); });
    for (std::size_t i = 0; i < s.classes.size(); ++i)
        if (s.cells.cells[i].label == Label::Window && s.classes[i].label == Label::Window)
        {
            EXPECT_EQ(s.classes[i].confidence, 170);
        }
}

TEST(ElementClasses, LeaveACloudWithoutABuilding)
{
    HandMadeCloud cloud;
    cloud.horizontal({0, 0}, {0.4, 0.4}, 0.0, Label::Furniture);
    const Settled s = settled(cloud, right);
    EXPECT_EQ(s.share(Label::Furniture, Label::Furniture), 1.0);
}

}  // namespace
}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
/// Labels that a model guessed: they count as much as they are sure.
#include "core/pipeline/pipeline.h"
#include "tests/support/building_dump.h"
#include "tests/support/hand_made_cloud.h"

#include <gtest/gtest.h>

namespace s2b
{
namespace
{

using test::HandMadeCloud;

/// A room, and a wide board a metre from one of its walls that reaches from floor to ceiling.
HandMadeCloud roomWithBoard(Label boardLabel)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {6, 4});
    cloud.wallFace({1, 1}, {4, 1}, 0.0, 2.55, boardLabel);
    return cloud;
}

Building reconstructed(const HandMadeCloud& cloud, const std::vector<std::uint8_t>* confidence)
{
    CloudView view = cloud.view();
    view.confidence = confidence ? confidence->data() : nullptr;
    return reconstruct(view, {}, {});
}

TEST(GuessedLabels, ThatAreSureGiveTheWallsOfGivenOnes)
{
    const HandMadeCloud cloud = roomWithBoard(Label::Furniture);
    const std::vector<std::uint8_t> sure(cloud.size(), 255);
    const Building given = reconstructed(cloud, nullptr), guessed = reconstructed(cloud, &sure);
    ASSERT_EQ(given.walls.size(), 4u);
    ASSERT_EQ(guessed.walls.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
    {
        EXPECT_LT((given.walls[i].start - guessed.walls[i].start).norm(), 1e-3);
        EXPECT_LT((given.walls[i].end - guessed.walls[i].end).norm(), 1e-3);
    }
}

/// The walls' own labels are wrong, but the model says that it does not know: shape decides.
TEST(GuessedLabels, ThatAreNotSureLeaveItToTheGeometry)
{
    HandMadeCloud cloud = roomWithBoard(Label::Furniture);
    std::vector<std::uint8_t> confidence(cloud.size(), 255);
    for (std::size_t i = 0; i < cloud.size(); ++i)
        if (cloud.cloud().labels[i] == Label::Wall)
        {
            cloud.cloud().labels[i] = Label::Furniture;
            confidence[i] = 60;
        }
    EXPECT_EQ(reconstructed(cloud, &confidence).walls.size(), 4u);
    EXPECT_EQ(reconstructed(cloud, nullptr).walls.size(), 0u) << "the same labels, given, say that there is no wall";
}

/// Noise looks like panes to a model, but panes stand back from a face.
TEST(GuessedLabels, OfGlassInAFaceLeaveTheWall)
{
    HandMadeCloud cloud = roomWithBoard(Label::Furniture);
    for (std::size_t i = 0; i < cloud.size(); ++i)
        if (cloud.cloud().labels[i] == Label::Wall && cloud.cloud().points[i].x() > 5.9f)
            cloud.cloud().labels[i] = Label::Window;
    const std::vector<std::uint8_t> sure(cloud.size(), 230);
    EXPECT_EQ(reconstructed(cloud, &sure).walls.size(), 4u);
    EXPECT_EQ(reconstructed(cloud, nullptr).walls.size(), 3u) << "given labels are taken at their word";
}

/// A leaf that reaches the ceiling's height nearly, taken for wall in part.
TEST(GuessedLabels, OfALeafMakeNoWall)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {6, 4});
    cloud.wallFace({2, 1}, {2.8, 1.1}, 0.0, 2.1, Label::Wall);
    const std::vector<std::uint8_t> sure(cloud.size(), 230);
    EXPECT_EQ(reconstructed(cloud, &sure).walls.size(), 4u);
}

TEST(GuessedLabels, OfZeroConfidenceAreNone)
{
    HandMadeCloud cloud = roomWithBoard(Label::Wall);
    cloud.setLabels(Label::Furniture);
    const std::vector<std::uint8_t> none(cloud.size(), 0);
    EXPECT_GE(reconstructed(cloud, &none).walls.size(), 4u);
}

/// A closed door of 0.9 m whose frame a model takes for wall: the hole reaches to where the wall's faces end.
TEST(GuessedLabels, MakeAHoleAsWideAsTheFacesLeaveIt)
{
    HandMadeCloud cloud;
    test::RoomGaps west, east;
    west.east = east.west = {{1.0, 1.9, 0.0, 2.1}};
    cloud.room({0, 0}, {4, 3}, 0, 2.6, west);
    cloud.room({4.2, 0}, {8.2, 3}, 0, 2.6, east);
    cloud.wallFace({4.1, 1.0}, {4.1, 1.08}, 0.0, 2.1, Label::Wall);
    cloud.wallFace({4.1, 1.08}, {4.1, 1.82}, 0.0, 2.02, Label::Door);
    cloud.wallFace({4.1, 1.08}, {4.1, 1.82}, 2.02, 2.1, Label::Wall);
    cloud.wallFace({4.1, 1.82}, {4.1, 1.9}, 0.0, 2.1, Label::Wall);
    const std::vector<std::uint8_t> sure(cloud.size(), 255);
    const Building given = reconstructed(cloud, nullptr), guessed = reconstructed(cloud, &sure);
    ASSERT_EQ(given.openings.size(), 1u);
    ASSERT_EQ(guessed.openings.size(), 1u);
    constexpr double edge_m = 0.02;  // a cell
    EXPECT_NEAR(given.openings[0].width.value_m, 0.74, 2 * edge_m) << "given labels are taken at their word";
    EXPECT_NEAR(guessed.openings[0].width.value_m, 0.9, 2 * edge_m);
    EXPECT_NEAR(guessed.openings[0].height.value_m, 2.1, edge_m);
    EXPECT_EQ(guessed.openings[0].kind, OpeningKind::Door);
}

/// An open doorway with its reveals, of which a model calls one jamb and something beside it door.
TEST(GuessedLabels, LeaveADoorwayAsWideAsTheFacesShowIt)
{
    HandMadeCloud cloud;
    test::RoomGaps west, east;
    west.east = east.west = {{1.0, 1.9, 0.0, 2.1}};
    cloud.room({0, 0}, {4, 3}, 0, 2.6, west);
    cloud.room({4.2, 0}, {8.2, 3}, 0, 2.6, east);
    cloud.wallFace({4, 1.0}, {4.2, 1.0}, 0.0, 2.1, Label::Door);
    cloud.wallFace({4, 1.9}, {4.2, 1.9}, 0.0, 2.1, Label::Wall);
    cloud.wallFace({4.1, 1.0}, {4.1, 1.5}, 0.0, 2.0, Label::Door);
    cloud.horizontal({4, 1.0}, {4.2, 1.9}, 2.1, Label::Wall);
    cloud.horizontal({4, 1.0}, {4.2, 1.9}, 0.0, Label::Floor);
    const std::vector<std::uint8_t> sure(cloud.size(), 255);
    const Building guessed = reconstructed(cloud, &sure);
    ASSERT_EQ(guessed.openings.size(), 1u);
    constexpr double edge_m = 0.02;  // a cell
    EXPECT_EQ(guessed.openings[0].kind, OpeningKind::Door);
    EXPECT_NEAR(guessed.openings[0].width.value_m, 0.9, 2 * edge_m);
    EXPECT_NEAR(guessed.openings[0].height.value_m, 2.1, edge_m);
}

}  // namespace
}  // namespace s2b

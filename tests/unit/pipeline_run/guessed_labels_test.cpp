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

}  // namespace
}  // namespace s2b

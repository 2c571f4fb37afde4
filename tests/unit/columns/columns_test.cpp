// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/stages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace s2b
{
namespace
{

using test::HandMadeCloud;
using test::storeyOf;

// Faces are means of thousands of points; a cell's mean lies on the face to a fraction of a millimetre, corner cells
// pull it in by less than one.
constexpr double kSize_m = 0.004, kPlace_m = 0.002;

HandMadeCloud hall()
{
    HandMadeCloud cloud;
    cloud.room({1, 0.5}, {5, 4});
    return cloud;
}

/// The four faces of a box, in plan turned by yaw about its centre.
void addBox(HandMadeCloud& cloud, const Eigen::Vector2d& center, double width, double depth, double yaw = 0.0,
            double bottom = 0.0, double top = 2.6, int faces = 4)
{
    const Eigen::Rotation2Dd turn(yaw);
    const std::array<Eigen::Vector2d, 4> corners{
        center + turn * Eigen::Vector2d(-width / 2, -depth / 2), center + turn * Eigen::Vector2d(width / 2, -depth / 2),
        center + turn * Eigen::Vector2d(width / 2, depth / 2), center + turn * Eigen::Vector2d(-width / 2, depth / 2)};
    for (std::size_t i = 0; i < static_cast<std::size_t>(faces); ++i)
        cloud.wallFace(corners[i], corners[(i + 1) % 4], bottom, top, Label::Column);
}

Column only(const HandMadeCloud& cloud)
{
    const ColumnResult columns = storeyOf(cloud).columns;
    EXPECT_EQ(columns.columns.size(), 1u);
    return columns.columns.empty() ? Column{} : columns.columns[0];
}

void expectRectangle(const Column& c, const Eigen::Vector2d& center, double width, double depth, double yaw = 0.0)
{
    ASSERT_TRUE(std::holds_alternative<RectangleSection>(c.section));
    const auto& section = std::get<RectangleSection>(c.section);
    EXPECT_LT((c.center - center).norm(), kPlace_m) << c.center.transpose();
    // The same rectangle has two names a quarter turn apart.
    const double turn = std::remainder(c.yaw_rad - yaw, std::numbers::pi);
    const bool isSwapped = std::abs(turn) > std::numbers::pi / 4;
    EXPECT_NEAR(isSwapped ? section.depth_m : section.width_m, width, kSize_m);
    EXPECT_NEAR(isSwapped ? section.width_m : section.depth_m, depth, kSize_m);
    EXPECT_NEAR(std::remainder(c.yaw_rad - yaw, std::numbers::pi / 2), 0.0, 0.02);
}

TEST(Columns, FindASquareOne)
{
    HandMadeCloud cloud = hall();
    addBox(cloud, {3, 2}, 0.4, 0.4);
    const Column c = only(cloud);
    expectRectangle(c, {3, 2}, 0.4, 0.4);
    EXPECT_EQ(c.base_m, 0.0);
    EXPECT_NEAR(c.height.value_m, 2.6, 1e-9);
    EXPECT_EQ(c.storey.value, 1u);
    EXPECT_NE(c.id.value, 0u);
}

TEST(Columns, FindARectangularOne)
{
    HandMadeCloud cloud = hall();
    addBox(cloud, {3, 2}, 0.3, 0.7);
    expectRectangle(only(cloud), {3, 2}, 0.3, 0.7);
}

TEST(Columns, FindOneThatStandsAtAnAngle)
{
    HandMadeCloud cloud = hall();
    addBox(cloud, {3, 2}, 0.3, 0.6, 0.5);
    expectRectangle(only(cloud), {3, 2}, 0.3, 0.6, 0.5);
}

TEST(Columns, FindARoundOne)
{
    for (const double radius : {0.08, 0.2, 0.45})
    {
        HandMadeCloud cloud = hall();
        cloud.mantle({3, 2}, radius, 0, 2.6, Label::Column);
        const Column c = only(cloud);
        ASSERT_TRUE(std::holds_alternative<CircleSection>(c.section)) << radius;
        EXPECT_NEAR(std::get<CircleSection>(c.section).radius_m, radius, kSize_m);
        EXPECT_LT((c.center - Eigen::Vector2d(3, 2)).norm(), kPlace_m);
    }
}

TEST(Columns, FindARoundOneSeenFromOneSide)
{
    HandMadeCloud cloud = hall();
    cloud.mantle({3, 2}, 0.25, 0, 2.6, Label::Column, 0.3, 0.3 + 0.85 * std::numbers::pi);
    const Column c = only(cloud);
    ASSERT_TRUE(std::holds_alternative<CircleSection>(c.section));
    // What one station sees, 153 degrees: its sagitta is 0.19 m, so cells a millimetre off move radius and centre by
    // two.
    EXPECT_NEAR(std::get<CircleSection>(c.section).radius_m, 0.25, 0.006);
    EXPECT_LT((c.center - Eigen::Vector2d(3, 2)).norm(), 0.006);
}

TEST(Columns, FindARoundOneInNoise)
{
    HandMadeCloud cloud(0.02, 0.003);
    cloud.room({1, 0.5}, {5, 4});
    cloud.mantle({3, 2}, 0.2, 0, 2.6, Label::Column);
    const Column c = only(cloud);
    ASSERT_TRUE(std::holds_alternative<CircleSection>(c.section));
    EXPECT_NEAR(std::get<CircleSection>(c.section).radius_m, 0.2, kSize_m);
}

/// The faces of a section; only those that `isSeen` keeps, by their outward normal and middle in the section's
/// directions.
void addSection(HandMadeCloud& cloud, const Section& section, const Eigen::Vector2d& center, double yaw = 0.0,
                const std::function<bool(const Eigen::Vector2d&, const Eigen::Vector2d&)>& isSeen = {})
{
    const std::vector<Eigen::Vector2d> ring = outlineOf(section);
    const Eigen::Rotation2Dd turn(yaw);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const Eigen::Vector2d a = ring[i], b = ring[(i + 1) % ring.size()], d = (b - a).normalized();
        if (!isSeen || isSeen({d.y(), -d.x()}, (a + b) / 2))
            cloud.wallFace(center + turn * a, center + turn * b, 0, 2.6, Label::Column);
    }
}

void expectProfile(const Column& c, const ProfileSection& truth, const Eigen::Vector2d& center, double yaw)
{
    ASSERT_TRUE(std::holds_alternative<ProfileSection>(c.section));
    const auto& section = std::get<ProfileSection>(c.section);
    EXPECT_STREQ(shapeName(section.shape), shapeName(truth.shape));
    EXPECT_NEAR(section.width_m, truth.width_m, kPlace_m);
    EXPECT_NEAR(section.depth_m, truth.depth_m, kPlace_m);
    EXPECT_NEAR(section.web_m, truth.web_m, kPlace_m);
    EXPECT_NEAR(section.flange_m, truth.flange_m, kPlace_m);
    EXPECT_LT((c.center - center).norm(), kPlace_m);
    const double period = truth.shape == ProfileShape::I ? std::numbers::pi : 2 * std::numbers::pi;
    EXPECT_NEAR(std::remainder(c.yaw_rad - yaw, period), 0.0, 0.01);
    EXPECT_EQ(c.sectionProvenance, Provenance::Measured);
    EXPECT_LT(c.evidence.rms_m, 0.006);
}

constexpr ProfileSection kHe300{ProfileShape::I, 0.30, 0.30, 0.011, 0.019};
constexpr ProfileSection kAngle{ProfileShape::L, 0.60, 0.40, 0.18, 0.18};

TEST(Columns, FindSteelAndConcreteSectionsInNoise)
{
    for (const ProfileSection& section : {kHe300, kAngle, ProfileSection{ProfileShape::U, 0.10, 0.30, 0.010, 0.016},
                                          ProfileSection{ProfileShape::T, 0.30, 0.20, 0.012, 0.020}})
        for (const double yaw : {0.0, 0.5, std::numbers::pi / 2})
        {
            SCOPED_TRACE(shapeName(section.shape));
            HandMadeCloud cloud(0.02, 0.003);
            cloud.room({1, 0.5}, {5, 4});
            addSection(cloud, section, {3, 2}, yaw);
            expectProfile(only(cloud), section, {3, 2}, yaw);
        }
}

TEST(Columns, BoxASectionOfWhichTooLittleIsSeenAndSaySo)
{
    // From one side, an I may as well be a U.
    HandMadeCloud cloud = hall();
    addSection(cloud, kHe300, {3, 2}, 0.0, [](const Eigen::Vector2d& out, const Eigen::Vector2d& middle)
               { return out.x() > 0.5 || (middle.x() > -0.01 && out.x() > -0.5); });
    const ColumnResult result = storeyOf(cloud).columns;
    ASSERT_EQ(result.columns.size(), 1u);
    ASSERT_TRUE(std::holds_alternative<RectangleSection>(result.columns[0].section));
    const auto& box = std::get<RectangleSection>(result.columns[0].section);
    // Both faces of a flange of 19 mm fall into the same cells: its position is their mean, up to half of it further
    // in.
    EXPECT_NEAR(box.width_m, 0.3, 0.02);
    EXPECT_NEAR(box.depth_m, 0.3, 0.02);
    ASSERT_EQ(test::countCode(result.diagnostics, "SectionAsBox"), 1u);
}

TEST(Columns, LookForSectionsOnlyWhenAsked)
{
    HandMadeCloud cloud = hall();
    addSection(cloud, kHe300, {3, 2});
    ColumnParams params;
    params.profiles = false;
    std::uint32_t nextId = 1;
    Level level;
    level.ceiling_m = 2.6;
    const CloudView view = cloud.view();
    const ColumnResult result = findColumns(test::cellsOf(cloud), {&view, {}}, level, {}, {1}, nextId, params, {});
    ASSERT_EQ(result.columns.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<RectangleSection>(result.columns[0].section));
    EXPECT_TRUE(result.diagnostics.empty());
}

TEST(Columns, SayNothingOfSectionsWhereTheyAreRectanglesAndCircles)
{
    HandMadeCloud cloud(0.02, 0.003);
    cloud.room({0, 0}, {8, 4});
    addBox(cloud, {2, 2}, 0.3, 0.5, 0.5);
    addBox(cloud, {4, 2}, 0.4, 0.4);
    cloud.mantle({6, 2}, 0.2, 0, 2.6, Label::Column);
    const ColumnResult result = storeyOf(cloud).columns;
    EXPECT_EQ(result.columns.size(), 3u);
    EXPECT_EQ(test::countCode(result.diagnostics, "SectionAsBox"), 0u);
    for (const Column& c : result.columns)
        EXPECT_FALSE(std::holds_alternative<ProfileSection>(c.section));
}

TEST(Columns, TellDozensApart)
{
    HandMadeCloud cloud;
    cloud.room({0, 0}, {13, 9});
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 4; ++j)
            addBox(cloud, {1.5 + 2 * i, 1.5 + 2 * j}, 0.3, 0.3);
    EXPECT_EQ(storeyOf(cloud).columns.columns.size(), 24u);
}

TEST(Columns, CutOffWhatIsLabelledColumnAtFloorAndCeiling)
{
    // A capital and a foot of 0.8 m (D3.6, figure 12: over-segmentation).
    HandMadeCloud cloud = hall();
    addBox(cloud, {3, 2}, 0.4, 0.4);
    addBox(cloud, {3, 2}, 0.8, 0.8, 0.0, 0.0, 0.15);
    addBox(cloud, {3, 2}, 0.8, 0.8, 0.0, 2.45, 2.6);
    cloud.horizontal({2.5, 1.5}, {3.5, 2.5}, 2.6, Label::Column);
    expectRectangle(only(cloud), {3, 2}, 0.4, 0.4);
}

TEST(Columns, DropStrayLabels)
{
    // 5 % of the points have a wrong label, a tenth of these the column's.
    HandMadeCloud cloud = hall();
    addBox(cloud, {3, 2}, 0.4, 0.4);
    for (std::size_t i = 0; i < cloud.size(); ++i)
        if (cloud.cloud().labels[i] == Label::Wall && randomBits(1, 2, i) % 200 == 0)
            cloud.cloud().labels[i] = Label::Column;
    expectRectangle(only(cloud), {3, 2}, 0.4, 0.4);
}

TEST(Columns, ReportASizeOutOfRange)
{
    HandMadeCloud cloud = hall();
    addBox(cloud, {3, 2}, 2.5, 0.4);
    const ColumnResult r = storeyOf(cloud).columns;
    EXPECT_TRUE(r.columns.empty());
    EXPECT_EQ(test::countCode(r.diagnostics, "SizeOutOfRange"), 1u);
}

TEST(Columns, CompleteOneThatStandsInAWallAndSaySo)
{
    // Of a square of 0.4 m half stands in the wall of the hall's lower side, which is thicker than that.
    HandMadeCloud cloud = hall();
    cloud.wallFace({3.2, 0.5}, {3.2, 0.7}, 0.0, 2.6, Label::Column);
    cloud.wallFace({3.2, 0.7}, {2.8, 0.7}, 0.0, 2.6, Label::Column);
    cloud.wallFace({2.8, 0.7}, {2.8, 0.5}, 0.0, 2.6, Label::Column);
    const ColumnResult result = storeyOf(cloud).columns;
    ASSERT_EQ(result.columns.size(), 1u);
    const auto& section = std::get<RectangleSection>(result.columns[0].section);
    // The wall's own face hides how far the sides go on: a cell.
    constexpr double cell_m = 0.02;
    EXPECT_NEAR(section.width_m, 0.4, cell_m);
    EXPECT_NEAR(section.depth_m, 0.4, cell_m);
    EXPECT_NEAR(result.columns[0].center.y(), 0.5, cell_m);
    EXPECT_EQ(result.columns[0].sectionProvenance, Provenance::Assumed);
    EXPECT_EQ(test::countCode(result.diagnostics, "DepthAssumed"), 1u);
}

TEST(Columns, AreNotMadeOfAFewStrayLabels)
{
    // As many wrong labels as a column's cluster needs, spread over what would be a column of 0.3 m.
    HandMadeCloud cloud = hall();
    for (int i = 0; i < 60; ++i)
        cloud.point({3.0 + 0.3 * (i % 7) / 6.0, 2.0 + 0.3 * (i % 5) / 4.0, 0.3 + 2.0 * i / 60.0}, Label::Column);
    EXPECT_TRUE(storeyOf(cloud).columns.columns.empty());
}

TEST(Columns, AreNoneInAnEmptyHall)
{
    EXPECT_TRUE(storeyOf(hall()).columns.columns.empty());
}

}  // namespace
}  // namespace s2b

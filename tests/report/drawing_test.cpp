// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/canvas.h"
#include "core/report/color.h"
#include "core/report/plan_view.h"
#include "core/report/png.h"
#include "core/report/rasters.h"
#include "core/report/svg_sheet.h"
#include "core/report/text.h"
#include "tests/report/sample_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <numeric>
#include <regex>

namespace s2b::report::testing
{
namespace
{

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Text, ShowsNumbersAsPeopleReadThem)
{
    EXPECT_EQ(number(-1.25, 1), "\u22121.2");
    EXPECT_EQ(number(-0.04, 1), "0.0") << "no minus before nothing";
    EXPECT_EQ(number(std::nan(""), 1), kNone);
    EXPECT_EQ(counted(1234567), "1\u202F234\u202F567");
    EXPECT_EQ(counted(999), "999");
    EXPECT_EQ(millimetres(0.00412), "4.1");
    EXPECT_EQ(millimetres(0.00412, true), "+4.1");
    EXPECT_EQ(millimetres(-0.1534), "\u2212153");
    EXPECT_EQ(millimetres(0.00002, true), "0.0");
    EXPECT_EQ(roundMillimetres(0.015), "15");
    EXPECT_EQ(roundMillimetres(0.0075, true), "+7.5");
    EXPECT_EQ(roundMillimetres(-0.2, true), "\u2212200");
    EXPECT_EQ(roundMillimetres(0.0, true), "0");
    EXPECT_EQ(percent(0.934), "93\u202F%");
    EXPECT_EQ(plainNumber(-0.00001, 3), "0");
    EXPECT_EQ(plainNumber(1.500, 3), "1.5");
    EXPECT_EQ(plainNumber(100.0, 0), "100");
}

TEST(Text, EncodesAsRfc4648Does)
{
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xFF\xFE"), "//4=");
}

TEST(DivergingColor, IsSymmetricAboutAGreyMiddleAndEndsAtItsLimits)
{
    const Color middle = divergingColor(0.0);
    EXPECT_TRUE(middle.r == middle.g && middle.g == middle.b);
    EXPECT_EQ(divergingColor(5.0), divergingColor(1.0));
    EXPECT_EQ(divergingColor(-5.0), divergingColor(-1.0));
    EXPECT_GT(divergingColor(0.8).r, divergingColor(0.8).b) << "red in front";
    EXPECT_GT(divergingColor(-0.8).b, divergingColor(-0.8).r) << "blue inside";
    // The map keeps both sides equally light; 12 of 255 is what its steps in RGB leave.
    const auto lightness = [](Color c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; };
    for (const double value : {0.25, 0.5, 0.75})
        EXPECT_NEAR(lightness(divergingColor(value)), lightness(divergingColor(-value)), 14.0) << value;
}

TEST(Png, ComesBackAsItWas)
{
    Image image(3, 2, Color{10, 20, 30, 255});
    image.at(2, 1) = {200, 100, 50, 0};
    const std::string bytes = encodePng(image);
    png_image header = {};
    header.version = PNG_IMAGE_VERSION;
    ASSERT_TRUE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()));
    header.format = PNG_FORMAT_RGBA;
    Image back(static_cast<int>(header.width), static_cast<int>(header.height), Color{});
    ASSERT_TRUE(png_image_finish_read(&header, nullptr, back.pixels.data(), 0, nullptr));
    EXPECT_EQ(back.width, 3);
    EXPECT_EQ(back.pixels, image.pixels);
}

TEST(Sheet, IsDrawnAtTheLargestRoundScaleThatFits)
{
    const Eigen::AlignedBox2d box(Eigen::Vector2d(0, 0), Eigen::Vector2d(15, 10));
    const Sheet sheet(box, 182, 205, 7);
    EXPECT_EQ(sheet.scale(), 100) << "150 mm wide; at 1:75 it would be 200 mm";
    EXPECT_THAT(sheet.svg("x"), HasSubstr("width=\"164mm\" height=\"114mm\""));
    EXPECT_TRUE(sheet.place({0, 0}).isApprox(Eigen::Vector2d(7, 107))) << "north is up";
}

TEST(Sheet, ScaleBarStaysOnANarrowFace)
{
    Sheet sheet({Eigen::Vector2d(0, 0), Eigen::Vector2d(1.1, 2.7)}, 89, 60, 5);
    sheet.scaleBar();
    const std::string svg = sheet.svg("x");
    const std::size_t bar = svg.find("<rect x=\"") + 9;
    EXPECT_GE(std::stod(svg.substr(bar)), 5.0) << "the margin";
    EXPECT_THAT(svg, HasSubstr(">0.5 m<"));
}

TEST(Plan, MarksErrorsByPatternAndNumberAndNotByColourAlone)
{
    const SampleReport sample;
    const Scene scene = makeScene(sample.input());
    std::vector<WallFaces> none;
    const Drawing plan = drawPlan(scene, scene.levels[0], rasterize(sample.input(), scene, scene.levels[0], none, {}));
    for (const char* part : {"class=\"e missed wall\"", "class=\"e extra wall\"", "class=\"e out wall\"",
                             "class=\"truth\"", "class=\"badgetext\"", "data:image/png"})
        EXPECT_THAT(plan.svg, HasSubstr(part));
    EXPECT_THAT(plan.svg, HasSubstr("32\u202F500\u202F105")) << "world coordinates at the edge";
    EXPECT_THAT(plan.caption, HasSubstr("Scale 1:100 on A4"));
    EXPECT_THAT(sharedDefinitions(), HasSubstr("id=\"p-missed\""));
    EXPECT_THAT(sharedDefinitions(), HasSubstr("id=\"p-extra\""));
    EXPECT_THAT(sharedDefinitions(), HasSubstr("id=\"p-out\""));
}

TEST(Plan, CanBeDrawnWithoutPoints)
{
    SampleReport sample;
    sample.dropPoints();
    const Scene scene = makeScene(sample.input());
    std::vector<WallFaces> none;
    const StoreyRasters rasters = rasterize(sample.input(), scene, scene.levels[0], none, {});
    EXPECT_THAT(drawPlan(scene, scene.levels[0], rasters).svg, Not(HasSubstr("data:image")));
    EXPECT_TRUE(drawDeviations(scene, scene.levels[0], rasters, false).svg.empty());
}

TEST(Rasters, SortPointsToTheFaceTheyLieOn)
{
    const SampleReport sample;
    const Scene scene = makeScene(sample.input());
    const int row = scene.rowOfResult[2];
    std::vector<WallFaces> walls{wallFaces(scene, static_cast<std::size_t>(row))};
    ASSERT_EQ(walls[0].row, row);
    EXPECT_NEAR(walls[0].length_m, 12.0, 1e-9);
    EXPECT_NEAR(walls[0].high_m - walls[0].low_m, 2.6, 1e-9);
    const StoreyRasters rasters = rasterize(sample.input(), scene, scene.levels[0], walls, {});
    const auto count = [](const Raster& r) { return std::accumulate(r.count.begin(), r.count.end(), 0U); };
    EXPECT_EQ(count(walls[0].left), 6000u);
    EXPECT_EQ(count(walls[0].right), 6000u);
    // It bulges by 3 cm in its middle and by nothing at its ends; the noise of 4 mm is averaged in cells of some
    // points.
    const Raster& left = walls[0].left;
    const auto mean = [&](double x, double y)
    {
        double sum = 0.0;
        unsigned n = 0;
        for (double dx = -0.5; dx <= 0.5; dx += left.cell_m)
        {
            for (double dy = -0.2; dy <= 0.2; dy += left.cell_m)
            {
                const auto cell = static_cast<std::size_t>(left.find(x + dx, y + dy));
                sum += static_cast<double>(left.sum_m[cell]);
                n += left.count[cell];
            }
        }
        return sum / n;
    };
    EXPECT_NEAR(mean(6.0, 1.3), 0.029, 0.002);
    EXPECT_NEAR(mean(0.55, 0.25), 0.030 * std::sin(0.144) * std::sin(0.302), 0.002);
    EXPECT_GT(count(rasters.floor), 10000u);
    EXPECT_GT(count(rasters.slice), 100u);
}

TEST(Canvas, DrawsWithinItsWindow)
{
    const Color red{255, 0, 0, 255};
    Canvas canvas(40, 20, Color{255, 255, 255, 255});
    const Viewport view = Viewport::fit({Eigen::Vector2i(0, 0), Eigen::Vector2i(20, 20)},
                                        {Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 10)});
    canvas.polygon(view, {{{-5, 5}, {50, 5}, {50, 50}, {-5, 50}}, {}}, red);  // the upper half, and far beyond
    const Image image = canvas.image();
    EXPECT_EQ(image.at(10, 2), red);
    EXPECT_EQ(image.at(10, 15), (Color{255, 255, 255, 255}));
    EXPECT_EQ(image.at(30, 2), (Color{255, 255, 255, 255})) << "outside the window";
}

TEST(Canvas, WritesText)
{
    Canvas canvas(80, 20, Color{255, 255, 255, 255});
    canvas.text({2, 2}, "LOA 30", Color{0, 0, 0, 255});
    const Image image = canvas.image();
    const auto dark = std::count_if(image.pixels.begin(), image.pixels.end(), [](Color c) { return c.r < 128; });
    EXPECT_GT(dark, 200);
    EXPECT_LT(dark, 500);
    EXPECT_EQ(Canvas::textWidth("LOA 30"), 70);
}

}  // namespace
}  // namespace s2b::report::testing

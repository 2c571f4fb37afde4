// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/segment.h"

#include "core/base/error.h"
#include "core/segmentation/passes.h"
#include "tests/support/hand_made_cloud.h"

#include <gmock/gmock.h>

#include <set>

namespace s2b
{
namespace
{

using test::HandMadeCloud;

OnnxModel modelOf(const std::string& name, unsigned threads = 2)
{
    return OnnxModel::load(std::string(S2B_TEST_MODELS) + "/" + name + ".onnx", threads);
}

/// Two storeys, each a room with a table.
HandMadeCloud twoStoreys(double spacing_m = 0.02)
{
    HandMadeCloud cloud(spacing_m, 0.001);
    for (const double floor : {0.0, 2.9})
    {
        cloud.room({0, 0}, {5, 4}, floor, floor + 2.6);
        cloud.horizontal({2, 2}, {3, 3}, floor + 0.9, Label::Furniture);
    }
    return cloud;
}

/// Share of the points of a class that got it.
double shareRight(const HandMadeCloud& cloud, const Segmentation& result, Label label)
{
    const CloudView view = cloud.view();
    double right = 0, all = 0;
    for (std::size_t i = 0; i < view.count; ++i)
        if (view.labels[i] == static_cast<std::uint8_t>(label))
            all += 1, right += result.labels[i] == view.labels[i];
    return right / all;
}

TEST(Segment, LabelsThePointsOfEveryStorey)
{
    const HandMadeCloud cloud = twoStoreys();
    const Segmentation result = segment(cloud.view(), modelOf("rules"), {}, {});
    ASSERT_EQ(result.labels.size(), cloud.size());
    ASSERT_EQ(result.confidence.size(), cloud.size());
    // The rules look at one cell alone, so a cell in the corner of wall and floor may go either way.
    for (const Label label : {Label::Floor, Label::Ceiling, Label::Wall, Label::Furniture})
        EXPECT_GT(shareRight(cloud, result, label), 0.95) << labelName(label);
    std::size_t sum = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
        EXPECT_GT(result.confidence[i], 63) << "of four classes the best one has at least a quarter";
    for (const std::size_t n : result.counts)
        sum += n;
    EXPECT_EQ(sum, cloud.size());
}

TEST(Segment, LooksAtNoLabels)
{
    HandMadeCloud cloud = twoStoreys();
    const Segmentation without = segment(cloud.view(false), modelOf("rules"), {}, {});
    cloud.setLabels(Label::Window);
    EXPECT_EQ(segment(cloud.view(), modelOf("rules"), {}, {}).labels, without.labels);
}

TEST(Segment, TakesProbabilitiesAsWellAsLogits)
{
    const HandMadeCloud cloud = twoStoreys();
    const Segmentation logits = segment(cloud.view(), modelOf("rules"), {}, {});
    const Segmentation probabilities = segment(cloud.view(), modelOf("probabilities"), {}, {});
    EXPECT_EQ(logits.labels, probabilities.labels);
    for (std::size_t i = 0; i < cloud.size(); ++i)
        EXPECT_LE(std::abs(logits.confidence[i] - probabilities.confidence[i]), 1);  // each rounds its own way
}

TEST(Segment, GivesTheSameBytesForAnyNumberOfThreadsAndAnyOrderOfThePoints)
{
    HandMadeCloud cloud = twoStoreys();
    for (const std::string name : {"rules", "plan"})
    {
        Context one;
        one.threads = 1;
        const Segmentation a = segment(cloud.view(), modelOf(name, 1), {}, one);
        const Segmentation b = segment(cloud.view(), modelOf(name, 4), {}, {});
        EXPECT_EQ(a.labels, b.labels) << name;
        EXPECT_EQ(a.confidence, b.confidence) << name;
        HandMadeCloud shuffled = twoStoreys();
        shuffled.shuffle(3);
        EXPECT_EQ(segment(shuffled.view(), modelOf(name), {}, {}).counts, a.counts) << name;
    }
}

TEST(Segment, UsesColoursWhereThereAreAny)
{
    const HandMadeCloud cloud = twoStoreys();
    EXPECT_NO_THROW((void)segment(cloud.view(), modelOf("takes_colour"), {}, {}));
    EXPECT_THROW((void)segment(cloud.view(), modelOf("needs_colour"), {}, {}), Error);

    CloudView coloured = cloud.view();
    const std::vector<std::uint8_t> rgba(4 * cloud.size(), 90);
    coloured.rgb = rgba.data();
    coloured.rgbStride = 4;
    EXPECT_NO_THROW((void)segment(coloured, modelOf("needs_colour"), {}, {}));
}

TEST(Segment, LeavesWhatIsFarFromTheBuildingUnassigned)
{
    HandMadeCloud cloud = twoStoreys();
    cloud.point({60, 0, 0}, Label::Furniture);
    const Segmentation result = segment(cloud.view(), modelOf("rules"), {}, {});
    EXPECT_EQ(result.labels.back(), static_cast<std::uint8_t>(Label::Unassigned));
    EXPECT_EQ(result.confidence.back(), 0);
}

TEST(Segment, IsCancelledAtAnyStep)
{
    const HandMadeCloud cloud = twoStoreys(0.05);
    const OnnxModel model = modelOf("plan");
    std::vector<std::string> steps;
    Context watched;
    watched.progress = [&](std::string_view text, double) { steps.emplace_back(text); };
    (void)segment(cloud.view(), model, {}, watched);
    ASSERT_GT(steps.size(), 5u);
    for (std::size_t k = 0; k < steps.size(); ++k)
    {
        std::stop_source stop;
        Context context;
        context.cancel = stop.get_token();
        context.progress = [&, n = std::size_t{0}](std::string_view, double) mutable
        {
            if (n++ == k)
                stop.request_stop();
        };
        EXPECT_THROW((void)segment(cloud.view(), model, {}, context), Cancelled) << steps[k];
    }
}

TEST(Segment, ProgressNeverGoesBack)
{
    const HandMadeCloud cloud = twoStoreys(0.05);
    double last = 0;
    Context context;
    context.progress = [&](std::string_view text, double fraction)
    {
        EXPECT_GE(fraction, last) << text;
        EXPECT_LE(fraction, 1.0);
        last = fraction;
    };
    SegmentParams params;
    params.largestPass = 3000;
    params.overlap_m = 0.3;
    (void)segment(cloud.view(), modelOf("rules"), params, context);
    EXPECT_GT(last, 0.9);
}

TEST(Segment, RefusesAnEmptyCloud)
{
    EXPECT_THROW((void)segment({}, modelOf("rules"), {}, {}), Error);
}

SurfaceCells cellsOf(const HandMadeCloud& cloud)
{
    CellParams params;
    params.size_m = 0.03;
    return buildSurfaceCells(cloud.view(false), {}, params, {});
}

/// Every cell is inside one pass, whatever the size of the tiles; what is seen around a tile is near it.
TEST(Passes, CutLargeStoreysIntoTilesThatShareNoCell)
{
    const SurfaceCells cells = cellsOf(twoStoreys());
    SegmentParams params;
    params.overlap_m = 0.4;
    std::size_t tiles = 0;
    for (const std::size_t largest : {std::size_t{1000000}, std::size_t{20000}, std::size_t{5000}})
    {
        params.largestPass = largest;
        const std::vector<SegmentPass> passes = planPasses(cells, findLevels(cells, {}, {}).levels, params, {});
        std::set<std::uint32_t> seen;
        for (const SegmentPass& pass : passes)
        {
            EXPECT_EQ(std::set(pass.cells.begin(), pass.cells.end()).size(), pass.cells.size());
            Eigen::AlignedBox2f box;
            for (std::size_t i = 0; i < pass.inside; ++i)
            {
                EXPECT_TRUE(seen.insert(pass.cells[i]).second);
                box.extend(cells.cells[pass.cells[i]].position.head<2>());
            }
            for (std::size_t i = pass.inside; i < pass.cells.size(); ++i)
                EXPECT_LT(box.exteriorDistance(cells.cells[pass.cells[i]].position.head<2>().eval()), 0.57f);
        }
        EXPECT_EQ(seen.size(), cells.cells.size());
        EXPECT_GE(passes.size(), std::max<std::size_t>(2, tiles));
        tiles = passes.size();
    }
    EXPECT_GT(tiles, 4u);
}

TEST(Passes, KnowTheHeightsOfTheirStorey)
{
    const SurfaceCells cells = cellsOf(twoStoreys());
    const std::vector<SegmentPass> passes = planPasses(cells, findLevels(cells, {}, {}).levels, {}, {});
    ASSERT_EQ(passes.size(), 2u);
    EXPECT_NEAR(passes[0].floor_m, 0.0, 0.02);
    EXPECT_NEAR(passes[0].ceiling_m, 2.6, 0.02);
    EXPECT_NEAR(passes[1].floor_m, 2.9, 0.02);
    EXPECT_NEAR(passes[1].ceiling_m, 5.5, 0.02);
}

}  // namespace
}  // namespace s2b

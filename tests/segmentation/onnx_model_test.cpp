// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/onnx_model.h"

#include "core/base/error.h"
#include "core/segmentation/inputs.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <stop_token>

namespace s2b
{
namespace
{

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string pathOf(const std::string& name)
{
    return std::string(S2B_TEST_MODELS) + "/" + name + ".onnx";
}

/// What loading the file complains about.
std::string complaint(const std::string& path)
{
    try
    {
        (void)OnnxModel::load(path, 1);
    }
    catch (const Error& e)
    {
        EXPECT_EQ(e.code(), ErrorCode::BadFile) << e.what();
        return e.what();
    }
    return "none";
}

TEST(OnnxModel, ReadsTheContractFromTheMetadata)
{
    const OnnxModel model = OnnxModel::load(pathOf("rules"), 1);
    const ModelContract& c = model.contract();
    EXPECT_THAT(c.classes, testing::ElementsAre(Label::Floor, Label::Ceiling, Label::Wall, Label::Furniture));
    EXPECT_EQ(c.cell_m, 0.03);
    EXPECT_THAT(c.features, testing::ElementsAre("normal_z", "height", "depth"));
    EXPECT_EQ(c.scores, ScoreKind::Logits);
    EXPECT_EQ(c.colour, ColourUse::None);
    EXPECT_FALSE(c.plan.isUsed());
    EXPECT_THAT(model.inputNames(), testing::ElementsAre("cells"));

    const OnnxModel plan = OnnxModel::load(pathOf("plan"), 1);
    EXPECT_EQ(plan.contract().plan.pixel_m, 0.1);
    EXPECT_EQ(plan.contract().plan.bins, 2);
    EXPECT_EQ(plan.contract().plan.multiple, 8);
    EXPECT_THAT(plan.inputNames(), testing::ElementsAre("cells", "plan", "pixel"));
}

/// Each complaint is one sentence about the file and what is wrong.
TEST(OnnxModel, SaysWhatIsWrongWithAFile)
{
    const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
        {"text", {"no ONNX model"}},
        {"truncated", {"no ONNX model"}},
        {"empty", {"empty"}},
        {"no_metadata", {"s2b.contract"}},
        {"other_version", {"version 2", "version 1"}},
        {"unknown_key", {"s2b.cel_m", "s2b.cell_m"}},
        {"missing_key", {"s2b.cell_m"}},
        {"unknown_class", {"\"wal\"", "wall"}},
        {"unknown_feature", {"\"hight\"", "height"}},
        {"bad_number", {"3 cm", "no number"}},
        {"half_normalised", {"s2b.mean and s2b.scale"}},
        {"silent_colour", {"s2b.colour"}},
        {"wrong_width", {"cells", "[any, 3]", "[any, 4]"}},
        {"wrong_type", {"cells", "should be float [any, 3]"}},
        {"wrong_input", {"\"cell\"", "cells"}},
        {"wrong_classes", {"scores", "[any, 4]", "[any, 5]"}},
        {"no_scores", {"no output \"scores\""}},
        {"newer_ir", {"newer ONNX", "IR version 10"}},
        {"newer_opset", {"newer ONNX", "opset 17 to 21"}}};
    for (const auto& [name, parts] : cases)
    {
        const std::string text = complaint(pathOf(name));
        EXPECT_THAT(text, AllOf(HasSubstr(name + ".onnx: "), Not(HasSubstr("\n")))) << name;
        for (const std::string& part : parts)
            EXPECT_THAT(text, HasSubstr(part)) << name;
    }
    EXPECT_THAT(complaint(pathOf("not_there")), HasSubstr("can't be read"));
    EXPECT_THAT(complaint(S2B_TEST_MODELS), HasSubstr("is a folder"));
}

/// Debian's onnxruntime writes a thousand lines there as its first session is made.
TEST(OnnxModel, SaysNothingOnTheConsole)
{
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    (void)OnnxModel::load(pathOf("rules"), 2);
    (void)complaint(pathOf("text"));
    (void)complaint(pathOf("newer_ir"));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

CellSet someCells(std::size_t count)
{
    CellSet set;
    set.size_m = 0.03, set.ceiling_m = 2.5;
    for (std::size_t i = 0; i < count; ++i)
    {
        SurfaceCell c;
        c.position = {static_cast<float>(i % 317) * 0.031f, static_cast<float>(i / 317) * 0.029f,
                      static_cast<float>(i % 83) * 0.03f};
        c.normal = i % 3 ? Eigen::Vector3f(1, 0, 0) : Eigen::Vector3f(0, 0.1f, 0.99f);
        c.count = 1 + static_cast<std::uint32_t>(i % 5);
        set.cells.push_back(c);
    }
    return set;
}

std::vector<float> scoresOf(const std::string& name, const CellSet& set, unsigned threads)
{
    Context context;
    context.threads = threads;
    const OnnxModel model = OnnxModel::load(pathOf(name), threads);
    const std::vector<Tensor> inputs = makeInputs(model.contract(), model.inputNames(), set, context);
    return model.run(inputs, set.cells.size(), context);
}

TEST(OnnxModel, GivesTheScoresOfTheNetwork)
{
    CellSet set = someCells(3);
    set.cells[0].normal = {0, 0, 1}, set.cells[0].position.z() = 0.1f;
    const std::vector<float> scores = scoresOf("rules", set, 1);
    ASSERT_EQ(scores.size(), 12u);
    EXPECT_NEAR(scores[0], 8.0 - 8 * 0.1, 1e-5);          // floor
    EXPECT_NEAR(scores[1], 8.0 - 8 * (2.5 - 0.1), 1e-5);  // ceiling
    EXPECT_NEAR(scores[2], -8.0 + 6.0, 1e-5);             // wall
    EXPECT_NEAR(scores[3], 1.0, 1e-5);
}

TEST(OnnxModel, GivesTheSameBytesForAnyNumberOfThreads)
{
    const CellSet set = someCells(50021);
    for (const std::string name : {"rules", "probabilities", "plan"})
    {
        const std::vector<float> one = scoresOf(name, set, 1);
        EXPECT_EQ(one, scoresOf(name, set, 2)) << name;
        EXPECT_EQ(one, scoresOf(name, set, 5)) << name;
    }
}

TEST(OnnxModel, StopsWhenCancelled)
{
    const OnnxModel model = OnnxModel::load(pathOf("plan"), 2);
    const CellSet set = someCells(1000);
    const std::vector<Tensor> inputs = makeInputs(model.contract(), model.inputNames(), set, {});
    std::stop_source stop;
    Context context;
    context.cancel = stop.get_token();
    stop.request_stop();
    EXPECT_THROW((void)model.run(inputs, set.cells.size(), context), Cancelled);
}

}  // namespace
}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/labels/label.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <vector>

namespace
{

using namespace s2b;

template <class Call>
std::string failureOf(Call call)
{
    try
    {
        call();
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.code(), ErrorCode::BadLabels);
        return error.what();
    }
    return {};
}

class LabelMapFile : public testing::Test
{
protected:
    void SetUp() override
    {
        const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
        m_path = (std::filesystem::temp_directory_path() / ("s2b_labels_" + test + ".toml")).string();
    }
    void TearDown() override { std::filesystem::remove(m_path); }
    void write(const std::string& text) const { std::ofstream(m_path, std::ios::binary) << text; }

    std::string m_path;
};

TEST(LabelName, IsDifferentForEveryClass)
{
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < kLabelCount; ++i)
        names.insert(labelName(static_cast<Label>(i)));
    EXPECT_EQ(names.size(), kLabelCount);
    EXPECT_EQ(labelName(Label::Furniture), "furniture");
    EXPECT_EQ(labelName(static_cast<Label>(200)), "unknown");
}

TEST(BuiltInLabelMap, S2bCodesAreTheClasses)
{
    const LabelMap map = builtInLabelMap("s2b");
    ASSERT_EQ(map.classOfCode.size(), kLabelCount);
    for (const auto& [code, label] : map.classOfCode)
        EXPECT_EQ(static_cast<int>(label), code);
}

TEST(BuiltInLabelMap, PublishedMapsHaveTheirPublishedCodes)
{
    const LabelMap s3dis = builtInLabelMap("s3dis");
    EXPECT_EQ(s3dis.classOfCode.size(), 13u);
    EXPECT_EQ(s3dis.classOfCode.at(0), Label::Ceiling);
    EXPECT_EQ(s3dis.classOfCode.at(1), Label::Floor);
    EXPECT_EQ(s3dis.classOfCode.at(2), Label::Wall);
    EXPECT_EQ(s3dis.classOfCode.at(3), Label::Beam);
    EXPECT_EQ(s3dis.classOfCode.at(4), Label::Column);
    EXPECT_EQ(s3dis.classOfCode.at(5), Label::Window);
    EXPECT_EQ(s3dis.classOfCode.at(6), Label::Door);
    EXPECT_EQ(s3dis.classOfCode.at(12), Label::Furniture);

    const LabelMap scannet = builtInLabelMap("scannet");
    EXPECT_EQ(scannet.classOfCode.size(), 41u);
    EXPECT_EQ(scannet.classOfCode.at(0), Label::Unassigned);
    EXPECT_EQ(scannet.classOfCode.at(1), Label::Wall);
    EXPECT_EQ(scannet.classOfCode.at(2), Label::Floor);
    EXPECT_EQ(scannet.classOfCode.at(8), Label::Door);
    EXPECT_EQ(scannet.classOfCode.at(9), Label::Window);
    EXPECT_EQ(scannet.classOfCode.at(22), Label::Ceiling);
    EXPECT_EQ(scannet.classOfCode.at(5), Label::Furniture);

    const LabelMap asprs = builtInLabelMap("asprs");
    EXPECT_EQ(asprs.classOfCode.size(), 23u);  // LAS 1.4 R15 defines 0 to 22
    EXPECT_EQ(asprs.classOfCode.at(2), Label::Floor);
    EXPECT_EQ(asprs.classOfCode.at(5), Label::Furniture);
    EXPECT_EQ(asprs.classOfCode.at(6), Label::Unassigned);
}

TEST(BuiltInLabelMap, NamesTheKnownOnes)
{
    const std::string message = failureOf([] { (void)builtInLabelMap("s4dis"); });
    EXPECT_NE(message.find("s2b, s3dis, scannet, asprs"), std::string::npos) << message;
    EXPECT_FALSE(failureOf([] { (void)loadLabelMap(""); }).empty());
    EXPECT_FALSE(failureOf([] { (void)loadLabelMap("no_such_map.toml"); }).empty());
    EXPECT_FALSE(failureOf([] { (void)loadLabelMap(std::filesystem::temp_directory_path().string()); }).empty());
}

TEST_F(LabelMapFile, IsReadWithNegativeCodesAndComments)
{
    write("# our scanner's\n[labels]\n-1 = \"unassigned\"\n7 = \"wall\"  # bricks\n8 = \"wall\"\n100 = \"door\"\n");
    const LabelMap map = loadLabelMap(m_path);
    EXPECT_EQ(map.name, m_path);
    EXPECT_EQ(map.classOfCode,
              (std::map<int, Label>{{-1, Label::Unassigned}, {7, Label::Wall}, {8, Label::Wall}, {100, Label::Door}}));
}

TEST_F(LabelMapFile, MistakesAreNamedWithFileAndLine)
{
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"", "[labels]"},
        {"[labels]\n", "[labels]"},
        {"[label]\n1 = \"wall\"\n", "[labels]"},
        {"[labels]\n1 = \"wal\"\n", "line 2: there is no class \"wal\", the nearest known one is wall"},
        {"[labels]\n1 = 3\n", "line 2: code 1 needs a class name"},
        {"[labels]\nwall = \"wall\"\n", "line 2: \"wall\" is no label code"},
        {"[labels]\n1x = \"wall\"\n", "line 2: \"1x\" is no label code"},
        {"[labels]\n99999999999 = \"wall\"\n", "line 2: \"99999999999\" is no label code"},
        {"[labels]\n1 = \"wall\"\n01 = \"door\"\n", ": code 1 is given twice"},
        {"[labels]\n1 = \"wall\"\n1 = \"door\"\n", "line 3: not TOML"},
        {"[labels]\n1 = \"wall\"\n[more]\n", "line 3: \"more\" is not known"},
        {"[labels\n", "line 1: not TOML"},
    };
    for (const auto& [text, expected] : cases)
    {
        write(text);
        const std::string message = failureOf([&] { (void)loadLabelMap(m_path); });
        EXPECT_TRUE(message.starts_with(m_path)) << text << message;
        EXPECT_NE(message.find(expected), std::string::npos) << "expected: " << expected << "\nactual: " << message;
    }
}

}  // namespace

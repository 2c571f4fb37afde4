// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/parameters.h"

#include "core/base/error.h"

#include <gtest/gtest.h>
#include <boost/pfr.hpp>
#include <boost/pfr/core_name.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace s2b;

std::string readText(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A file that is gone at the end of the test.
class ScratchFile
{
public:
    explicit ScratchFile(const std::string& text)
    {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        m_path = std::filesystem::temp_directory_path() / (std::string("s2b_") + test->name() + ".toml");
        std::ofstream(m_path, std::ios::binary) << text;
    }
    ~ScratchFile() { std::filesystem::remove(m_path); }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    [[nodiscard]] std::string path() const { return m_path.string(); }

private:
    std::filesystem::path m_path;
};

/// The message of the BadParameter that the call throws; empty when it throws none.
template <class Call>
std::string failureOf(Call call)
{
    try
    {
        call();
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.code(), ErrorCode::BadParameter);
        return error.what();
    }
    return {};
}

const void* address(const ParameterInfo& info, Parameters& parameters)
{
    return std::visit([&](auto find) { return static_cast<const void*>(find(parameters)); }, info.member);
}

/// "maximumThickness_m" -> "maximumThickness".
std::string withoutUnit(std::string_view member)
{
    for (const std::string_view suffix : {"_m2", "_m", "_deg", "_rad", "_s"})
    {
        if (member.ends_with(suffix))
            return std::string(member.substr(0, member.size() - suffix.size()));
    }
    return std::string(member);
}

TEST(ParameterTable, HasOneRowOfTheRightNameForEveryMemberOfEveryStage)
{
    Parameters parameters;
    std::map<const void*, std::string> rows;
    for (const ParameterInfo& info : parameterTable())
        EXPECT_TRUE(rows.emplace(address(info, parameters), info.name).second) << info.name << " shares its member";

    constexpr auto kStages = boost::pfr::names_as_array<Parameters>();
    std::size_t members = 0;
    boost::pfr::for_each_field(parameters,
                               [&](auto& stage, std::size_t s)
                               {
                                   using Stage = std::remove_reference_t<decltype(stage)>;
                                   constexpr auto kNames = boost::pfr::names_as_array<Stage>();
                                   boost::pfr::for_each_field(
                                       stage,
                                       [&](auto& member, std::size_t m)
                                       {
                                           ++members;
                                           const std::string name =
                                               std::string(kStages[s]) + "." + withoutUnit(kNames[m]);
                                           const auto row = rows.find(static_cast<const void*>(&member));
                                           ASSERT_NE(row, rows.end()) << name << " has no row in parameter_table.cpp";
                                           EXPECT_EQ(row->second, name);
                                       });
                               });
    EXPECT_EQ(members, rows.size());
}

TEST(ParameterTable, DefaultsLieWithinTheirRangesAndEveryRowIsExplained)
{
    const Parameters defaults;
    for (const ParameterInfo& info : parameterTable())
    {
        EXPECT_LT(info.minimum, info.maximum) << info.name;
        EXPECT_GE(info.value(defaults), info.minimum) << info.name;
        EXPECT_LE(info.value(defaults), info.maximum) << info.name;
        EXPECT_TRUE(info.help.ends_with('.')) << info.name;
        EXPECT_FALSE(info.source.empty()) << info.name;
        EXPECT_EQ(info.isSwitch(), info.unit.empty()) << info.name;
    }
    EXPECT_NO_THROW(checkParameters(defaults));
}

TEST(ParameterTable, EndsOfEachRangeAreAllowedAndWhatLiesBeyondIsNot)
{
    for (const ParameterInfo& info : parameterTable())
    {
        Parameters parameters;
        info.set(parameters, info.minimum);
        EXPECT_EQ(info.value(parameters), info.minimum);
        info.set(parameters, info.maximum);
        EXPECT_EQ(info.value(parameters), info.maximum);
        const Parameters before = parameters;
        for (const double bad : {info.minimum - 1.0, info.maximum + 1.0, std::nan(""),
                                 std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()})
            EXPECT_THROW(info.set(parameters, bad), Error) << info.name << " = " << bad;
        EXPECT_EQ(parameters, before);
    }
}

TEST(FindParameter, NamesTheNearestKnownOne)
{
    EXPECT_NE(failureOf([] { (void)findParameter("walls.maximumThicknes"); }).find("walls.maximumThickness"),
              std::string::npos);
    EXPECT_NE(failureOf([] { (void)findParameter("MergeGap"); }).find("walls.mergeGap"), std::string::npos);
    EXPECT_NE(failureOf([] { (void)findParameter("walls.maximumThickness_m"); }).find("walls.maximumThickness"),
              std::string::npos);
    EXPECT_FALSE(failureOf([] { (void)findParameter(""); }).empty());
}

TEST(SetParameter, SetsNumbersWholeNumbersAndSwitches)
{
    Parameters parameters;
    setParameter(parameters, "walls.mergeGap=1.5");
    setParameter(parameters, " walls.closeGap =\t2e-1 ");
    setParameter(parameters, "columns.circleTrials=+7");
    setParameter(parameters, "clutter.enabled=off");
    EXPECT_EQ(parameters.walls.mergeGap_m, 1.5);
    EXPECT_EQ(parameters.walls.closeGap_m, 0.2);
    EXPECT_EQ(parameters.columns.circleTrials, 7);
    EXPECT_FALSE(parameters.clutter.enabled);
    for (const char* yes : {"clutter.enabled=true", "clutter.enabled=1", "clutter.enabled=on"})
    {
        parameters.clutter.enabled = false;
        setParameter(parameters, yes);
        EXPECT_TRUE(parameters.clutter.enabled) << yes;
    }
}

TEST(SetParameter, RefusesWhatIsNoValueOfTheParameterAndChangesNothing)
{
    Parameters parameters;
    for (const char* bad : {"",
                            "=",
                            "walls.mergeGap",
                            "walls.mergeGap=",
                            "walls.mergeGap=1,5",
                            "walls.mergeGap=1.5m",
                            "walls.mergeGap=nan",
                            "walls.mergeGap=inf",
                            "walls.mergeGap=-0.1",
                            "walls.mergeGap=99",
                            "walls.mergeGap=true",
                            "walls.mergeGap=1=2",
                            "columns.circleTrials=2.5",
                            "columns.circleTrials=1e30",
                            "clutter.enabled=2",
                            "clutter.enabled=0.5",
                            "clutter.enabled=yes!",
                            "walls.mergeGap=1e999",
                            "walls=1",
                            "1"})
        EXPECT_FALSE(failureOf([&] { setParameter(parameters, bad); }).empty()) << bad;
    EXPECT_EQ(parameters, Parameters{});
}

TEST(SetParameter, SaysTheAllowedRange)
{
    Parameters parameters;
    const std::string message = failureOf([&] { setParameter(parameters, "walls.mergeGap=99"); });
    EXPECT_EQ(message, "walls.mergeGap = 99 is out of range, use 0 to 5 m");
}

TEST(CheckParameters, FindsAMinimumAboveItsMaximum)
{
    Parameters parameters;
    setParameter(parameters, "openings.minimumDoorWidth=3");
    setParameter(parameters, "openings.maximumDoorWidth=2");
    const std::string message = failureOf([&] { checkParameters(parameters); });
    EXPECT_NE(message.find("openings.minimumDoorWidth = 3"), std::string::npos) << message;
    EXPECT_NE(message.find("openings.maximumDoorWidth = 2"), std::string::npos) << message;
}

TEST(CheckParameters, FindsAValueThatWasPutInByHand)
{
    Parameters parameters;
    parameters.walls.mergeGap_m = std::nan("");
    EXPECT_NE(failureOf([&] { checkParameters(parameters); }).find("walls.mergeGap"), std::string::npos);
}

TEST(LoadConfig, ReadsBackTheTextOfAnyParameters)
{
    // Every parameter away from its default, at values without a short decimal text.
    Parameters written;
    for (const ParameterInfo& info : parameterTable())
    {
        double value = info.minimum + (info.maximum - info.minimum) / 3.0;
        if (info.isSwitch())
            value = 1.0 - info.value(written);
        else if (info.isInteger())
            value = std::floor(value);
        info.set(written, value);
    }
    ASSERT_NO_THROW(checkParameters(written));
    const ScratchFile file(configText(written));
    Parameters read;
    loadConfig(read, file.path());
    EXPECT_EQ(read, written);
}

TEST(LoadConfig, TakesWholeNumbersForLengthsAndLeavesTheRest)
{
    const ScratchFile file("[walls]\nmergeGap = 1 # metre\n\n[clutter]\nenabled = false\n");
    Parameters expected;
    expected.walls.closeGap_m = 0.33;
    Parameters parameters = expected;
    expected.walls.mergeGap_m = 1.0;
    expected.clutter.enabled = false;
    loadConfig(parameters, file.path());
    EXPECT_EQ(parameters, expected);
}

TEST(LoadConfig, AnEmptyFileChangesNothing)
{
    const ScratchFile file("");
    Parameters parameters;
    loadConfig(parameters, file.path());
    EXPECT_EQ(parameters, Parameters{});
}

TEST(LoadConfig, NamesTheFileAndTheLineOfAMistakeAndChangesNothing)
{
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"[walls]\nmergeGap = 1\nmergGap = 1\n",
         "line 3: there is no parameter \"walls.mergGap\", the nearest known one is walls.mergeGap"},
        {"[walls]\nmergeGap = 99\n", "line 2: walls.mergeGap = 99 is out of range, use 0 to 5 m"},
        {"[walls]\n\nmergeGap = \"1\"\n", "line 3: walls.mergeGap has a value of another kind"},
        {"[walls]\nmergeGap = nan\n", "line 2: walls.mergeGap = nan is out of range"},
        {"[columns]\ncircleTrials = 2.5\n", "line 2: columns.circleTrials = 2.5 is not a whole number"},
        {"[clutter]\nenabled = 1\n", "line 2: clutter.enabled has a value of another kind, use true or false"},
        {"[wall]\nmergeGap = 1\n",
         "line 1: there is no parameter \"wall.mergeGap\", the nearest known one is walls.mergeGap"},
        {"[roofs]\n", "line 1: there is no parameter \"roofs\""},
        {"mergeGap = 1\n", "line 1: there is no parameter \"mergeGap\", the nearest known one is walls.mergeGap"},
        {"walls = 1\n", "line 1: \"walls\" is a table of parameters"},
        {"[walls\nmergeGap = 1\n", "line 1: not TOML"},
        {"[walls]\nmergeGap = 1\nmergeGap = 2\n", "line 3: not TOML"},
        {"[walls.deep]\nmergeGap = 1\n", "line 1: there is no parameter \"walls.deep\""},
        {"[walls]\nminimumThickness = 0.9\nmaximumThickness = 0.3\n",
         ": walls.minimumThickness = 0.9 is above walls.maximumThickness = 0.3"},
        {"[walls]\n\xff\xfe = 1\n", "not TOML"},
    };
    for (const auto& [text, expected] : cases)
    {
        const ScratchFile file("[walls]\ncloseGap = 0.1\n");
        std::ofstream(file.path(), std::ios::binary) << text;
        Parameters parameters;
        const std::string message = failureOf([&] { loadConfig(parameters, file.path()); });
        EXPECT_TRUE(message.starts_with(file.path())) << message;
        EXPECT_NE(message.find(expected), std::string::npos) << "expected: " << expected << "\nactual: " << message;
        EXPECT_EQ(parameters, Parameters{});
    }
}

TEST(LoadConfig, NamesAFileThatIsNotThere)
{
    Parameters parameters;
    const std::string path = (std::filesystem::temp_directory_path() / "s2b_no_such_file.toml").string();
    EXPECT_EQ(failureOf([&] { loadConfig(parameters, path); }), path + ": there is no such file");
    EXPECT_FALSE(failureOf([&] { loadConfig(parameters, std::filesystem::temp_directory_path().string()); }).empty());
}

TEST(ParameterDocumentation, IsTheFileInDocs)
{
    const std::filesystem::path path = std::filesystem::path(S2B_SOURCE_FOLDER) / "docs" / "parameters.md";
    if (std::getenv("S2B_UPDATE_DOCS"))
        std::ofstream(path, std::ios::binary) << parameterDocumentation();
    std::istringstream written(readText(path));
    std::istringstream expected(parameterDocumentation());
    std::string writtenLine;
    std::string expectedLine;
    while (std::getline(expected, expectedLine))
    {
        std::getline(written, writtenLine);
        ASSERT_EQ(writtenLine, expectedLine)
            << "docs/parameters.md is out of date; run this test with S2B_UPDATE_DOCS=1 "
               "in its environment to write it anew";
    }
    EXPECT_FALSE(std::getline(written, writtenLine)) << "docs/parameters.md has more lines than it should";
}

}  // namespace

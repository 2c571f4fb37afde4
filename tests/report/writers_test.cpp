// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/report/csv.h"
#include "core/report/json.h"
#include "core/report/scene.h"
#include "tests/report/json_schema.h"
#include "tests/report/sample_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <stop_token>

namespace s2b::report::testing
{
namespace
{

using nlohmann::json;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::vector<std::string> kFiles{"report.html", "report.json", "elements.csv", "issues.bcf"};

/// Without printing a whole page when it is not so.
bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// RFC 4180, read by the letter.
std::vector<std::vector<std::string>> readCsv(const std::string& text)
{
    std::vector<std::vector<std::string>> rows{{""}};
    bool isQuoted = false;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        std::string& field = rows.back().back();
        if (isQuoted && text[i] == '"' && i + 1 < text.size() && text[i + 1] == '"')
            field += text[i++];
        else if (text[i] == '"')
            isQuoted = !isQuoted;
        else if (!isQuoted && text[i] == ',')
            rows.back().emplace_back();
        else if (!isQuoted && text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n')
        {
            rows.push_back({""});
            ++i;
        }
        else
            field += text[i];
    }
    rows.pop_back();  // the last line ends too
    return rows;
}

std::vector<std::string> allGuids(const SampleReport& sample)
{
    std::vector<std::string> guids;
    for (const validation::BimElement& element : sample.result.elements)
        guids.push_back(element.guid);
    for (const validation::ElementResult& pair : sample.validation.elements)
    {
        if (pair.result < 0)
            guids.push_back(sample.truth.elements[static_cast<std::size_t>(pair.truth)].guid);
    }
    return guids;
}

TEST(ReportJson, FitsItsSchemaWithPointsWithoutThemAndWithoutATruth)
{
    const json schema = json::parse(readFile(std::string(S2B_SOURCE_FOLDER) + "/docs/validation_report.schema.json"));
    SampleReport sample;
    EXPECT_THAT(faults(json::parse(makeJson(sample.input(), makeScene(sample.input()))), schema), IsEmpty());

    ReportInput points = sample.input();
    points.truth = nullptr;
    points.building = nullptr;
    EXPECT_THAT(faults(json::parse(makeJson(points, makeScene(points))), schema), IsEmpty());

    sample.dropPoints();
    const json files = json::parse(makeJson(sample.input(), makeScene(sample.input())));
    EXPECT_THAT(faults(files, schema), IsEmpty());
    EXPECT_THAT(faults(json{{"format", "other"}}, schema), Not(IsEmpty())) << "the schema refuses something";
}

TEST(ReportJson, HasTheFiguresAndEveryElementOnce)
{
    const SampleReport sample;
    const json report = json::parse(makeJson(sample.input(), makeScene(sample.input())));
    EXPECT_EQ(report["classes"]["wall"]["cornersAt"]["10"]["precision"], 1.0);
    EXPECT_EQ(report["classes"]["wall"]["at50"]["f1"], 12.0 / 13.0);
    EXPECT_EQ(report["cloudToResult"]["wallMeanAbsolute_m"], 0.0028);
    EXPECT_EQ(report["cloudToResult"]["histogram"]["counts"].size(), 64u);
    EXPECT_EQ(report["storeys"][1]["truthElevation_m"], 123.0) << "world height";
    EXPECT_EQ(report["diagnostics"][0]["place"][0], 32500105.0);
    EXPECT_EQ(report["parameters"]["walls.defaultThickness"], "0.15");

    std::multiset<std::string> guids;
    for (const json& element : report["elements"])
        guids.insert(element[element["result"].is_null() ? "truth" : "result"]["guid"]);
    const auto expected = allGuids(sample);
    EXPECT_EQ(guids, std::multiset<std::string>(expected.begin(), expected.end()));
    EXPECT_EQ(report["elements"].back()["outcome"], "not seen");
    int sum = 0;
    for (const auto& [verdict, count] : report["summary"]["verdicts"].items())
        sum += count.get<int>();
    EXPECT_EQ(sum, static_cast<int>(expected.size()));
}

TEST(ReportCsv, HasARowPerElementAndKeepsNamesWithCommasAndQuotes)
{
    const SampleReport sample;
    const auto rows = readCsv(makeCsv(makeScene(sample.input())));
    ASSERT_EQ(rows.size(), allGuids(sample).size() + 1);
    for (const auto& row : rows)
        EXPECT_EQ(row.size(), rows.front().size());
    const auto column = static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), "name") - rows[0].begin());
    std::vector<std::string> names;
    for (const auto& row : rows)
        names.push_back(row[column]);
    EXPECT_THAT(names, Contains(sample.result.elements[0].name));
}

TEST(ReportPage, ShowsEveryElementAndNeedsNothingFromOutside)
{
    const SampleReport sample;
    const TestFolder folder;
    writeReport(sample.input(), folder.path("r"), {});
    const std::string page = readFile(folder.path("r/report.html"));
    for (const std::string& guid : allGuids(sample))
        EXPECT_TRUE(has(page, guid)) << guid;
    for (const char* attribute : {"src=\"", "href=\"", "url("})
    {
        for (std::size_t at = page.find(attribute); at != std::string::npos; at = page.find(attribute, at + 1))
        {
            const std::string_view target = std::string_view(page).substr(at + std::string_view(attribute).size(), 22);
            EXPECT_TRUE(target.starts_with("data:image/png;base64,") || target.starts_with("#")) << target;
        }
    }
    EXPECT_FALSE(has(page, "<script"));
    EXPECT_FALSE(has(page, "<Wand>")) << "names are text, not markup";
    EXPECT_THAT(page, HasSubstr("&lt;Wand&gt; &amp; &quot;S\xC3\xBC"
                                "d&quot;"));
    EXPECT_FALSE(has(page, "{{")) << "the template is filled";
    for (const char* part :
         {"Plan of Ground floor", "Plan of Upper floor", "Deviations of Ground floor", "left face",
          "histogram of signed distances", "walls.defaultThickness", "the thickness of wall 7 is assumed"})
        EXPECT_TRUE(has(page, part)) << part;
    EXPECT_TRUE(has(page, "14 of 17 judged elements")) << "15 pairs less one that bulges; one missed, one extra";
}

TEST(ReportPage, SaysThatThereIsNothingToJudge)
{
    SampleReport sample;
    sample.dropPoints();
    sample.validation = {};
    sample.truth.elements.clear();
    sample.result.elements.clear();
    const TestFolder folder;
    writeReport(sample.input(), folder.path("r"), {});
    EXPECT_TRUE(has(readFile(folder.path("r/report.html")), "No element could be judged"));
}

TEST(Report, IsTheSameBytesForEveryNumberOfThreads)
{
    const TestFolder folder;
    for (const unsigned threads : {1U, 4U})
    {
        const SampleReport sample;
        Context context;
        context.threads = threads;
        writeReport(sample.input(), folder.path(std::to_string(threads)), context);
    }
    for (const std::string& name : kFiles)
        EXPECT_EQ(readFile(folder.path("1/" + name)), readFile(folder.path("4/" + name))) << name;
}

TEST(Report, NamesFilesWithoutTheFoldersOfTheMachine)
{
    const SampleReport sample;
    const TestFolder folder;
    writeReport(sample.input(), folder.path("r"), {});
    for (const std::string& name : kFiles)
    {
        std::string content = readFile(folder.path("r/" + name));
        if (name == "issues.bcf")
        {
            content.clear();
            for (const auto& [path, file] : readZip(folder.path("r/" + name)))
                content += file;
        }
        EXPECT_FALSE(has(content, "/survey/house")) << name;
        EXPECT_FALSE(has(content, "/somewhere/else")) << name;
    }
}

TEST(Report, ReplacesAnOldOneAndLeavesNothingBeside)
{
    const SampleReport sample;
    const TestFolder folder;
    writeReport(sample.input(), folder.path("r"), {});
    const std::string first = readFile(folder.path("r/report.json"));
    writeReport(sample.input(), folder.path("r"), {});
    EXPECT_EQ(readFile(folder.path("r/report.json")), first);
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path("r")))
        names.insert(entry.path().filename().string());
    EXPECT_EQ(names, std::set<std::string>(kFiles.begin(), kFiles.end()));
}

TEST(Report, FailsWithTheFilesNameAndLeavesTheOldReportAlone)
{
    const SampleReport sample;
    const TestFolder folder;
    writeReport(sample.input(), folder.path("r"), {});
    const std::string page = readFile(folder.path("r/report.html"));
    std::filesystem::remove(folder.path("r/issues.bcf"));
    std::filesystem::create_directory(folder.path("r/issues.bcf"));  // the last one can't be written
    SampleReport other;
    other.result.file = "other.ifc";
    try
    {
        writeReport(other.input(), folder.path("r"), {});
        FAIL() << "it was written";
    }
    catch (const Error& e)
    {
        EXPECT_EQ(e.code(), ErrorCode::CannotWrite);
        EXPECT_THAT(e.what(), HasSubstr("issues.bcf"));
    }
    EXPECT_EQ(readFile(folder.path("r/report.html")), page);
    for (const auto& entry : std::filesystem::directory_iterator(folder.path("r")))
        EXPECT_EQ(entry.path().string().find(".partial"), std::string::npos) << entry.path();
}

TEST(Report, LeavesNoFolderWhenItCanNotBeWritten)
{
    const SampleReport sample;
    const TestFolder folder;
    std::ofstream(folder.path("taken")) << "precious";
    EXPECT_THROW(writeReport(sample.input(), folder.path("taken"), {}), Error);
    EXPECT_THROW(writeReport(sample.input(), folder.path("taken/r"), {}), Error);
    EXPECT_EQ(readFile(folder.path("taken")), "precious");
    EXPECT_THROW(writeReport(sample.input(), "/proc/self/report", {}), Error);  // nobody can make a file there
}

TEST(Report, LeavesNothingWhenItIsCancelled)
{
    const SampleReport sample;
    const TestFolder folder;
    std::stop_source stop;
    Context context;
    context.cancel = stop.get_token();
    context.progress = [&](std::string_view, double fraction)
    {
        if (fraction > 0.4)
            stop.request_stop();
    };
    EXPECT_THROW(writeReport(sample.input(), folder.path("a/b"), context), Cancelled);
    EXPECT_FALSE(std::filesystem::exists(folder.path("a")));
}

TEST(Report, TakesNamesThatAreNotUtf8)
{
    SampleReport sample;
    sample.result.elements[0].name = "bad \xFF\xC3(\x01 name";
    sample.truth.storeys[0].name = "\xED\xA0\x80";
    const TestFolder folder;
    writeReport(sample.input(), folder.path("r"), {});
    EXPECT_TRUE(json::accept(readFile(folder.path("r/report.json"))));
    EXPECT_TRUE(has(readFile(folder.path("r/report.html")), "bad \xEF\xBF\xBD\xEF\xBF\xBD(  name"));
}

}  // namespace
}  // namespace s2b::report::testing

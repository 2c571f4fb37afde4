// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/bcf.h"
#include "core/report/scene.h"
#include "tests/report/sample_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <regex>
#include <set>

namespace s2b::report::testing
{
namespace
{

using ::testing::HasSubstr;

std::map<std::string, std::string> issuesOf(const SampleReport& sample)
{
    const TestFolder folder;
    writeReport(sample.input(), folder.path("r"), {});
    const auto files = readZip(folder.path("r/issues.bcf"));
    std::map<std::string, std::string> byName(files.begin(), files.end());
    EXPECT_EQ(byName.size(), files.size()) << "each name once";
    return byName;
}

double numberIn(const std::string& xml, const std::string& parent, const std::string& tag)
{
    const std::string part = xml.substr(xml.find("<" + parent + ">"));
    const std::size_t at = part.find("<" + tag + ">") + tag.size() + 2;
    return std::stod(part.substr(at));
}

Eigen::Vector3d vectorIn(const std::string& xml, const std::string& name)
{
    return {numberIn(xml, name, "X"), numberIn(xml, name, "Y"), numberIn(xml, name, "Z")};
}

TEST(Bcf, HasATopicForEachElementOutOfTolerance)
{
    const SampleReport sample;
    const auto files = issuesOf(sample);
    EXPECT_THAT(files.at("bcf.version"), HasSubstr("VersionId=\"2.1\""));
    const std::regex uuid("[0-9a-f]{8}-[0-9a-f]{4}-5[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}");  // version 5
    std::map<std::string, std::set<std::string>> topics;
    for (const auto& [name, content] : files)
    {
        if (name == "bcf.version")
            continue;
        const std::string topic = name.substr(0, name.find('/'));
        EXPECT_TRUE(std::regex_match(topic, uuid)) << topic;
        topics[topic].insert(name.substr(name.find('/') + 1));
    }
    ASSERT_EQ(topics.size(), 3u) << "one missed, one without counterpart, one that bulges";
    std::set<std::string> types;
    for (const auto& [topic, names] : topics)
    {
        EXPECT_EQ(names, (std::set<std::string>{"markup.bcf", "viewpoint.bcfv", "snapshot.png"}));
        const std::string markup = files.at(topic + "/markup.bcf");
        EXPECT_THAT(markup, HasSubstr("<Topic Guid=\"" + topic + "\""));
        EXPECT_THAT(markup, HasSubstr("<Filename>model.ifc</Filename>"));
        EXPECT_THAT(markup, HasSubstr("<CreationDate>1970-01-01T00:00:00Z</CreationDate>"));
        EXPECT_EQ(files.at(topic + "/snapshot.png").substr(1, 3), "PNG");
        std::smatch type;
        ASSERT_TRUE(std::regex_search(markup, type, std::regex("TopicType=\"([^\"]*)\"")));
        types.insert(type[1]);
    }
    EXPECT_EQ(types, (std::set<std::string>{"Deviation", "Missing element", "Element without a counterpart"}));
}

TEST(Bcf, ViewpointSelectsTheElementAndSeesAllOfIt)
{
    const SampleReport sample;
    const auto files = issuesOf(sample);
    int checked = 0;
    for (const auto& [name, view] : files)
    {
        if (!name.ends_with("viewpoint.bcfv"))
            continue;
        for (const validation::Bim* bim : {&sample.truth, &sample.result})
        {
            for (const validation::BimElement& element : bim->elements)
            {
                if (view.find("IfcGuid=\"" + element.guid + "\"") == std::string::npos)
                    continue;
                ++checked;
                const Eigen::Vector3d eye = vectorIn(view, "CameraViewPoint");
                const Eigen::Vector3d direction = vectorIn(view, "CameraDirection");
                const Eigen::Vector3d up = vectorIn(view, "CameraUpVector");
                EXPECT_NEAR(direction.norm(), 1.0, 1e-5);
                EXPECT_NEAR(up.norm(), 1.0, 1e-5);
                EXPECT_NEAR(direction.dot(up), 0.0, 1e-5);
                EXPECT_LT(direction.z(), 0.0) << "from above";
                const double half = numberIn(view, "PerspectiveCamera", "FieldOfView") / 2.0 * std::numbers::pi / 180.0;
                for (const Eigen::Vector2d& p : element.plan.outer)
                {
                    for (const double z : {element.low_m, element.high_m})
                    {
                        const Eigen::Vector3d d = Eigen::Vector3d(p.x(), p.y(), z) + bim->origin - eye;
                        EXPECT_LT(std::acos(d.normalized().dot(direction)), half) << "within the picture";
                    }
                }
            }
        }
    }
    EXPECT_EQ(checked, 4) << "the missed wall, the extra one, and the bulging one in both models";
}

TEST(Bcf, TopicsKeepTheirGuidWhenOtherElementsChange)
{
    SampleReport sample;
    std::set<std::string> before;
    for (const auto& [name, content] : issuesOf(sample))
        before.insert(name);
    sample.validation.elements.erase(sample.validation.elements.begin());  // one that is within tolerance
    sample.params.deviationRange_m = 0.1;
    std::set<std::string> after;
    for (const auto& [name, content] : issuesOf(sample))
        after.insert(name);
    EXPECT_EQ(before, after);
}

TEST(Bcf, ElementsOfTheSameGuidAreTopicsOfTheirOwn)
{
    SampleReport sample;
    validation::Deviation bad = sample.validation.cloudToResult->elements[2];
    for (const std::size_t i : {0U, 1U})
    {
        sample.result.elements[i].guid = sample.result.elements[2].guid;
        sample.validation.cloudToResult->elements[i] = bad;
    }
    std::size_t topics = 0;
    for (const auto& [name, content] : issuesOf(sample))
        topics += name.ends_with("/markup.bcf") ? 1 : 0;
    EXPECT_EQ(topics, 5u);
}

TEST(Bcf, AnElementWithoutAGuidIsShownWithoutASelection)
{
    SampleReport sample;
    for (validation::BimElement& element : sample.truth.elements)
        element.guid.clear();
    for (const auto& [name, content] : issuesOf(sample))
    {
        if (name.ends_with("viewpoint.bcfv") && content.find("<Selection>") == std::string::npos)
            return SUCCEED();
    }
    FAIL() << "the missed wall has no GUID to select";
}

TEST(NameUuid, IsVersionFiveOfItsName)
{
    EXPECT_EQ(nameUuid("a"), nameUuid("a"));
    EXPECT_NE(nameUuid("a"), nameUuid("b"));
    EXPECT_EQ(nameUuid("a").at(14), '5');
}

}  // namespace
}  // namespace s2b::report::testing

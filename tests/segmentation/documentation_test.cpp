// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/inputs.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace s2b
{
namespace
{

/// Who makes a model reads there what a feature is: the page has to have all of them, with unit and meaning.
TEST(SegmentationPage, DescribesEveryFeatureAndChannel)
{
    std::ifstream file(std::string(S2B_SOURCE_FOLDER) + "/docs/segmentation.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    ASSERT_FALSE(page.empty());
    for (const auto& infos : {knownFeatures(), knownPlanChannels()})
        for (const FeatureInfo& info : infos)
        {
            std::string help(info.help);
            for (std::size_t at = help.find('|'); at != std::string::npos; at = help.find('|', at + 2))
                help.insert(at, "\\");  // a table's cell
            EXPECT_NE(page.find("| `" + std::string(info.name) + "` | " + std::string(info.unit) + " | " + help + " |"),
                      std::string::npos)
                << info.name;
        }
}

}  // namespace
}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/presets.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

#include <set>

namespace s2b
{
namespace
{

std::string failureOf(std::string_view list)
{
    Parameters parameters;
    try
    {
        applyPresets(parameters, list);
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.code(), ErrorCode::BadParameter);
        EXPECT_EQ(parameters, Parameters{}) << "a list that fails changes nothing";
        return error.what();
    }
    return {};
}

TEST(PresetTable, SaysWhatDiffersFromTheDefaultsAndWhy)
{
    std::set<std::string> names;
    for (const Preset& preset : presetTable())
    {
        EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
        EXPECT_FALSE(preset.title.empty() || preset.help.empty()) << preset.name;
        std::set<std::string> rows;
        for (const PresetValue& value : preset.values)
        {
            EXPECT_TRUE(rows.insert(value.parameter).second) << value.parameter << " is set twice by " << preset.name;
            EXPECT_NE(findParameter(value.parameter).value(Parameters{}), value.value)
                << preset.name << " sets " << value.parameter << " to its default";
            EXPECT_GT(value.reason.size(), 10U) << preset.name << ", " << value.parameter;
        }
    }
}

TEST(PresetTable, EveryCombinationCanBeRun)
{
    for (const Preset& preset : presetTable())
    {
        Parameters alone;
        applyPresets(alone, preset.name);
        for (const PresetValue& value : preset.values)
            EXPECT_EQ(findParameter(value.parameter).value(alone), value.value) << value.parameter;
        for (const Preset& other : presetTable())
        {
            if (other.kind == preset.kind)
                continue;
            Parameters both;
            EXPECT_NO_THROW(applyPresets(both, preset.name + "," + other.name));
        }
    }
}

TEST(ApplyPresets, KeepsWhatThePresetDoesNotSay)
{
    Parameters parameters;
    parameters.walls.mergeGap_m = 1.25;
    applyPresets(parameters, "Mobile Mapping");  // as people write it
    EXPECT_EQ(parameters.walls.mergeGap_m, 1.25);
    EXPECT_NE(parameters.walls.planeDistance_m, Parameters{}.walls.planeDistance_m);
}

TEST(ApplyPresets, NamesTheKnownOnes)
{
    EXPECT_NE(failureOf("castle").find("residential, office, hall, mobile-mapping"), std::string::npos);
    EXPECT_FALSE(failureOf("").empty());
    EXPECT_FALSE(failureOf("office,").empty());
}

TEST(ApplyPresets, TakesOneOfEachKind)
{
    EXPECT_NE(failureOf("office,hall").find("same kind"), std::string::npos);
    EXPECT_EQ(failureOf("office, mobile-mapping"), "");
}

}  // namespace
}  // namespace s2b

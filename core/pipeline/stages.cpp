// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/pipeline/pipeline.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace s2b
{

namespace
{

struct StageInfo
{
    Stage stage;
    std::string_view name;
    std::vector<Stage> needs;  ///< directly; always earlier in the list
};

const std::vector<StageInfo>& stageInfos()
{
    static const std::vector<StageInfo> kInfos = {
        {Stage::Levels, "levels", {}},
        {Stage::Walls, "walls", {Stage::Levels}},
        {Stage::Doors, "doors", {Stage::Walls}},
        {Stage::Windows, "windows", {Stage::Walls}},
        {Stage::Openings, "openings", {Stage::Walls}},
        {Stage::Columns, "columns", {Stage::Levels}},
        {Stage::Slabs, "slabs", {Stage::Levels}},
        {Stage::Spaces, "spaces", {Stage::Walls}},
    };
    return kInfos;
}

void addWithNeeds(std::set<Stage>& stages, const StageInfo& info)
{
    stages.insert(info.stage);
    for (const Stage needed : info.needs)
        addWithNeeds(stages, *std::ranges::find(stageInfos(), needed, &StageInfo::stage));
}

std::string normalised(std::string_view text)
{
    std::string name;
    for (const char c : text)
    {
        if (c != ' ' && c != '\t')
            name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return name;
}

}  // namespace

std::set<Stage> parseStages(std::string_view list)
{
    std::vector<std::string_view> known;
    for (const StageInfo& info : stageInfos())
        known.push_back(info.name);

    std::set<Stage> stages;
    while (true)
    {
        const std::size_t comma = list.find(',');
        const std::string name = normalised(list.substr(0, comma));
        if (name == "all")
            stages = allStages();
        else if (const auto found = std::ranges::find(stageInfos(), name, &StageInfo::name);
                 found != stageInfos().end())
            addWithNeeds(stages, *found);
        else
            throw Error(ErrorCode::BadParameter,
                        "there is no stage \"" + name + "\", use a list of " + joinNames(known) + " or all");
        if (comma == std::string_view::npos)
            return stages;
        list.remove_prefix(comma + 1);
    }
}

std::set<Stage> allStages()
{
    std::set<Stage> stages;
    for (const StageInfo& info : stageInfos())
        stages.insert(info.stage);
    return stages;
}

}  // namespace s2b

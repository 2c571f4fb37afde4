// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/pipeline/pipeline.h"

#include <gtest/gtest.h>

namespace
{

using namespace s2b;
using Stages = std::set<Stage>;

TEST(ParseStages, BringsWhatAStageNeeds)
{
    EXPECT_EQ(parseStages("levels"), (Stages{Stage::Levels}));
    EXPECT_EQ(parseStages("walls"), (Stages{Stage::Levels, Stage::Walls}));
    EXPECT_EQ(parseStages("doors"), (Stages{Stage::Levels, Stage::Walls, Stage::Doors}));
    EXPECT_EQ(parseStages("columns"), (Stages{Stage::Levels, Stage::Columns}));
}

TEST(ParseStages, TakesAListInAnyOrderCaseAndSpacing)
{
    const Stages expected{Stage::Levels, Stage::Walls, Stage::Windows, Stage::Columns};
    EXPECT_EQ(parseStages("windows,columns"), expected);
    EXPECT_EQ(parseStages(" Columns , WINDOWS,columns"), expected);
}

TEST(ParseStages, AllMeansEveryOne)
{
    EXPECT_EQ(parseStages("all"), allStages());
    EXPECT_EQ(parseStages("levels,walls,doors,windows,openings,columns,slabs,spaces"), allStages());
    EXPECT_EQ(allStages().size(), 8u);
}

TEST(ParseStages, NamesTheKnownOnes)
{
    for (const char* bad : {"", ",", "walls,", "roofs", "walls;doors"})
    {
        try
        {
            (void)parseStages(bad);
            ADD_FAILURE() << bad;
        }
        catch (const Error& error)
        {
            EXPECT_EQ(error.code(), ErrorCode::BadParameter);
            EXPECT_NE(std::string(error.what()).find("levels, walls, doors"), std::string::npos) << error.what();
        }
    }
}

}  // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/validation_parameters.h"
#include "tests/validation/sample_bims.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace s2b
{
namespace
{

using namespace test;
using ::testing::HasSubstr;

std::string said(const std::string& assignment)
{
    return errorOf(ErrorCode::BadParameter,
                   [&]
                   {
                       ValidationParams params;
                       setParameter(params, assignment);
                   });
}

TEST(ValidationParameters, AreSetByName)
{
    ValidationParams params;
    setParameter(params, "validation.tolerance=20");
    setParameter(params, "Validation.DeviationRange = 0.3");
    setParameter(params, "validation.loa40=0.004");
    EXPECT_EQ(params.tolerance, 20);
    EXPECT_DOUBLE_EQ(params.deviationRange_m, 0.3);
    EXPECT_DOUBLE_EQ(params.loaLimit_m[3], 0.004);
}

TEST(ValidationParameters, BadOnesAreNamedWithWhatWouldDo)
{
    EXPECT_THAT(said("validation.tolerence=20"), HasSubstr("nearest known one is validation.tolerance"));
    EXPECT_THAT(said("validation.tolerance=25"), HasSubstr("use 10, 20, 30, 40 or 50"));
    EXPECT_THAT(said("validation.minimumMatch=2"), HasSubstr("0.01 to 1"));
    EXPECT_THAT(said("validation.loa10=wide"), HasSubstr("is no number"));
    EXPECT_THAT(said("validation.tolerance"), HasSubstr("write name=value"));
}

TEST(ValidationParameters, LimitsHaveToFall)
{
    ValidationParams params;
    EXPECT_NO_THROW(checkParams(params));
    params.loaLimit_m[2] = 0.06;
    EXPECT_THAT(errorOf(ErrorCode::BadParameter, [&] { checkParams(params); }), HasSubstr("validation.loa30"));
}

TEST(ValidationParameters, TheDefaultsAreInTheirRanges)
{
    EXPECT_NO_THROW(checkParams({}));
}

TEST(ValidationParameters, StandInTheDocumentation)
{
    std::ifstream in(std::string(S2B_SOURCE_FOLDER) + "/docs/validation.md");
    std::stringstream text;
    text << in.rdbuf();
    EXPECT_THAT(text.str(), HasSubstr(parameterTableText())) << "copy this table there:\n" << parameterTableText();
}

}  // namespace
}  // namespace s2b

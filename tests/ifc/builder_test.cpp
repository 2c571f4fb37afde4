// SPDX-License-Identifier: GPL-3.0-or-later
// Instances as lines of the file, and what the schema does not take.
#include "ifc/builder.h"

#include "core/base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace s2b::ifc
{
namespace
{

using ::testing::HasSubstr;

std::string textOf(const Builder& builder)
{
    return builder.text({"name", "1970-01-01T00:00:00", "system"});
}

std::string errorOf(const std::function<void(Builder&)>& run)
{
    Builder builder("IFC4");
    try
    {
        run(builder);
    }
    catch (const Error& e)
    {
        return e.code() == ErrorCode::Internal ? e.what() : std::string("another code: ") + e.what();
    }
    return "no error";
}

TEST(Builder, WritesNumbersWithAPointAndFifteenDigits)
{
    Builder builder("IFC4");
    const std::vector<double> coordinates = {1.0, -2.5e-7, 32500100.1234567};
    builder.add("IfcCartesianPoint", {{"Coordinates", coordinates}});
    builder.add("IfcDirection", {{"DirectionRatios", std::vector<double>{0.1, 1e22, -0.0}}});
    const std::string text = textOf(builder);
    EXPECT_THAT(text, HasSubstr("\n#1=IFCCARTESIANPOINT((1.,-2.5E-07,32500100.1234567));\n"));
    EXPECT_THAT(text, HasSubstr("\n#2=IFCDIRECTION((0.1,1.E+22,-0.));\n"));
    EXPECT_THAT(text, HasSubstr("\nENDSEC;\nEND-ISO-10303-21;\n"));
}

TEST(Builder, WritesWhatIsUnsetAndWhatIsDerived)
{
    Builder builder("IFC4");
    const Instance metre = builder.add(
        "IfcSIUnit", {{"Name", Enumeration{"METRE"}}, {"UnitType", Enumeration{"LENGTHUNIT"}}, {"Prefix", {}}});
    builder.add("IfcUnitAssignment", {{"Units", InstanceList{metre, metre}}});
    const std::string text = textOf(builder);
    EXPECT_THAT(text, HasSubstr("#1=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);\n"));
    EXPECT_THAT(text, HasSubstr("#2=IFCUNITASSIGNMENT((#1,#1));\n"));
}

TEST(Builder, WritesTextSoThatEveryLetterComesBack)
{
    Builder builder("IFC4");
    for (const char* name : {"plain", "it's", "back\\slash", "Größe", "日本"})
        builder.add("IfcPropertySingleValue",
                    {{"Name", name}, {"NominalValue", TypedValue{"IfcLabel", std::string(name)}}});
    const std::string text = textOf(builder);
    EXPECT_THAT(text, HasSubstr("('plain',$,IFCLABEL('plain'),$);"));
    EXPECT_THAT(text, HasSubstr("('it''s',"));
    EXPECT_THAT(text, HasSubstr("('back\\\\slash',"));
    for (const char c : text)
        EXPECT_TRUE(c == '\n' || (c >= ' ' && c <= '~'));
}

TEST(Builder, TakesOnlyWhatTheSchemaKnows)
{
    const std::vector<double> zero = {0.0, 0.0};
    EXPECT_THAT(errorOf([](Builder& b) { b.add("IfcWal", {}); }), HasSubstr("IFC4 has no IfcWal"));
    EXPECT_THAT(errorOf([](Builder& b) { b.add("IfcProduct", {}); }), HasSubstr("IfcProduct is no entity"));
    EXPECT_THAT(errorOf([&](Builder& b) { b.add("IfcCartesianPoint", {{"Points", zero}}); }),
                HasSubstr("IFCCARTESIANPOINT has no attribute Points"));
    EXPECT_THAT(errorOf([](Builder& b) { b.add("IfcCartesianPoint", {}); }),
                HasSubstr("IFCCARTESIANPOINT lacks its Coordinates"));
    EXPECT_THAT(errorOf([](Builder& b) { b.add("IfcCartesianPoint", {{"Coordinates", std::vector<double>{}}}); }),
                HasSubstr("empty list"));
    EXPECT_THAT(errorOf([](Builder& b) { b.add("IfcCartesianPoint", {{"Coordinates", std::vector<double>{NAN}}}); }),
                HasSubstr("not finite"));
    EXPECT_THAT(errorOf([](Builder& b) { b.add("IfcCartesianPoint", {{"Coordinates", std::vector<int>{1, 2}}}); }),
                HasSubstr("no value of this kind"));
    EXPECT_THAT(
        errorOf([](Builder& b)
                { b.add("IfcSIUnit", {{"Name", Enumeration{"FOOT"}}, {"UnitType", Enumeration{"LENGTHUNIT"}}}); }),
        HasSubstr("no item FOOT"));
    EXPECT_THAT(errorOf(
                    [](Builder& b)
                    {
                        b.add("IfcPropertySingleValue",
                              {{"Name", "length"}, {"NominalValue", TypedValue{"IfcLengthMeasure", 2}}});
                    }),
                HasSubstr("IfcLengthMeasure takes no value of this kind"));
}

}  // namespace
}  // namespace s2b::ifc

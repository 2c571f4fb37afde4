// SPDX-License-Identifier: GPL-3.0-or-later
// Files of other programs: schemas, units, mapped items, parts of parts, and files that are none.
#include "core/base/error.h"
#include "sample_building.h"
#include "test_files.h"
#include "tests/support/ifc_text.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace s2b
{
namespace
{

using test::kMillimetreModel;
using test::stepFile;
using test::TestFolder;

TEST(Reader, MillimetresMappedItemsAndIfc2x3)
{
    const TestFolder folder;
    test::writeText(folder.file("a.ifc"), stepFile("IFC2X3", kMillimetreModel));
    const auto model = ifc::readIfc(folder.file("a.ifc"));
    EXPECT_EQ(model.schema, "IFC2X3");
    ASSERT_EQ(model.storeys.size(), 1U);
    EXPECT_NEAR(model.storeys[0].elevation_m, 3.0, 1e-9);
    const auto& wall = test::elementOf(model, "IfcWallStandardCase", "W");
    EXPECT_NEAR(test::volumeOf(wall), 4.0 * 0.3 * 2.5, 1e-6);
    EXPECT_LT((test::boxOf(wall).low - Eigen::Vector3d(1.0, 2.0, 3.5)).norm(), 1e-6);
    EXPECT_EQ(wall.storeyGuid, model.storeys[0].guid);
}

TEST(Reader, PartsAreOnTheStoreyOfTheirWholeAndKnowIt)
{
    const TestFolder folder;
    test::writeText(folder.file("a.ifc"), stepFile("IFC2X3", kMillimetreModel));
    const auto model = ifc::readIfc(folder.file("a.ifc"));
    const auto& pane = test::elementOf(model, "IfcWindow", "Pane");
    EXPECT_EQ(pane.storeyGuid, model.storeys[0].guid);
    EXPECT_EQ(pane.hostGuid, "0000000000000000000004");
    EXPECT_EQ(test::elementOf(model, "IfcFurnishingElement", "Chair").storeyGuid, model.storeys[0].guid);
}

TEST(Reader, ReadsTheSameTwice)
{
    const TestFolder folder;
    ifc::writeIfc(test::sampleBuilding(), folder.file("a.ifc"), {});
    const auto a = ifc::readIfc(folder.file("a.ifc"));
    const auto b = ifc::readIfc(folder.file("a.ifc"));
    EXPECT_TRUE(a.withoutMesh.empty());
    ASSERT_EQ(a.elements.size(), b.elements.size());
    for (std::size_t i = 0; i < a.elements.size(); ++i)
    {
        EXPECT_EQ(a.elements[i].guid, b.elements[i].guid);
        EXPECT_EQ(a.elements[i].vertices, b.elements[i].vertices);
        EXPECT_EQ(a.elements[i].triangles, b.elements[i].triangles);
    }
}

TEST(Reader, TellsGlassFromFrame)
{
    const auto model = test::roundTrip(test::sampleBuilding());
    const auto& window = test::elementOf(model, "IfcWindow", "Window 34");
    ASSERT_EQ(window.triangleIsTransparent.size(), window.triangles.size());
    const auto glass = std::count(window.triangleIsTransparent.begin(), window.triangleIsTransparent.end(), true);
    EXPECT_EQ(glass, 12) << "the pane is a box";
    EXPECT_GT(static_cast<std::ptrdiff_t>(window.triangles.size()), glass);
}

std::string errorOf(const std::string& path)
{
    try
    {
        (void)ifc::readIfc(path);
    }
    catch (const Error& e)
    {
        EXPECT_EQ(e.code(), ErrorCode::BadFile);
        EXPECT_NE(std::string(e.what()).find(path), std::string::npos) << e.what();
        return e.what();
    }
    ADD_FAILURE() << "no error for " << path;
    return {};
}

TEST(Reader, BadFilesGetOneSentence)
{
    const TestFolder folder;
    const auto file = [&](const char* name, const std::string& text)
    {
        test::writeText(folder.file(name), text);
        return folder.file(name);
    };
    ifc::writeIfc(test::sampleBuilding(), folder.file("whole.ifc"), {});
    const std::string whole = test::readText(folder.file("whole.ifc"));
    const auto expect = [&](const std::string& path, const char* reason)
    { EXPECT_NE(errorOf(path).find(reason), std::string::npos) << path; };
    expect(folder.file("missing.ifc"), "does not exist");
    expect(folder.file(""), "does not exist");
    expect(file("empty.ifc", ""), "empty");
    expect(file("text.ifc", "hello, this is no IFC file\n"), "not an IFC");
    expect(file("half.ifc", whole.substr(0, whole.size() / 2)), "truncated");
    expect(file("nothing.ifc", stepFile("IFC4", "")), "no geometry");
    expect(file("other.ifc", stepFile("AP214", "#1=CARTESIAN_POINT('',(0.,0.,0.));\n")), "schema");
    // Cut and closed again: shapes and places are gone. Who made what is nobody's business here.
    const std::size_t solid = whole.find("=IFCEXTRUDEDAREASOLID(");
    const std::size_t line = whole.rfind('\n', solid) + 1;
    const std::string number = whole.substr(line, solid - line);
    std::string holed = whole;
    holed.erase(line, whole.find('\n', line) + 1 - line);
    expect(file("holed.ifc", holed), ("it is damaged: " + number + ", which").c_str());
    std::string anonymous = whole;
    anonymous.replace(anonymous.find(",$,", anonymous.find("=IFCWALL(")), 3, ",#999999,");
    EXPECT_FALSE(ifc::readIfc(file("anonymous.ifc", anonymous)).elements.empty());
    Building bare;
    ifc::writeIfc(bare, folder.file("bare.ifc"), {});
    expect(folder.file("bare.ifc"), "no geometry");
}

}  // namespace
}  // namespace s2b

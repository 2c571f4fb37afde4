// SPDX-License-Identifier: GPL-3.0-or-later
// Truth files of all kinds, and files that are none.
#include "core/geometry/polygon.h"
#include "core/validation/cv4aec_json.h"
#include "core/validation/survey_truth.h"
#include "ifc/bim_reader.h"
#include "tests/validation/sample_bims.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace s2b
{
namespace
{

using namespace test;
using ::testing::HasSubstr;

constexpr double kExact = 1e-9;

const char* const kWalls = R"([{"start_pt": [10.0, 5.0, 0.5], "end_pt": [14.0, 5.0, 0.5], "width": 0.2, "height": 3.0},
  {"start_pt": [10.0, 5.0, 0.5], "end_pt": [10.0, 9.0, 0.5], "width": 0.3, "height": 3.0}])";
const char* const kDoors =
    R"([{"loc": [12.0, 5.05, 0.5], "width": 1.0, "depth": 0.1, "height": 2.1, "rotation": 180.0}])";
const char* const kColumns = R"([{"loc": [12.0, 7.0, 0.5], "width": 0.4, "depth": 0.2, "height": 3.0, "rotation": 90},
  {"loc": [13.0, 7.0, 0.5], "width": 0.4, "height": 3.0}])";

std::string badFile(const std::string& path)
{
    return errorOf(ErrorCode::BadFile, [&] { (void)ifc::readTruth(path); });
}

TEST(Cv4aec, WallsDoorsAndColumnsAreReadFromTheFilesOfAModel)
{
    const Folder folder;
    const std::string walls = folder.write("Office_F1_walls.json", kWalls);
    (void)folder.write("Office_F1_doors.json", kDoors);
    (void)folder.write("Office_F1_columns.json", kColumns);
    (void)folder.write("Other_F1_walls.json", kWalls);
    const Bim bim = ifc::readTruth(walls);
    EXPECT_EQ(bim.schema, "CV4AEC");
    ASSERT_EQ(bim.elements.size(), 5U) << "the other model stays out";
    ASSERT_EQ(bim.storeys.size(), 1U);
    EXPECT_EQ(bim.storeys[0].name, "F1");
    EXPECT_NEAR(bim.storeys[0].elevation_m + bim.origin.z(), 0.5, kExact);

    const BimElement* door = nullptr;
    std::vector<const BimElement*> columns;
    const BimElement* wall = nullptr;
    for (const BimElement& e : bim.elements)
    {
        if (e.elementClass == ElementClass::Door)
            door = &e;
        else if (e.elementClass == ElementClass::Column)
            columns.push_back(&e);
        else if (wall == nullptr)
            wall = &e;
    }
    ASSERT_TRUE(wall != nullptr && door != nullptr && columns.size() == 2);
    EXPECT_NEAR(area(wall->plan), 4.0 * 0.2, kExact);
    EXPECT_NEAR(wall->high_m - wall->low_m, 3.0, kExact);
    EXPECT_NEAR(wall->low_m + bim.origin.z(), 0.5, kExact);
    EXPECT_LT((wall->axis->start + bim.origin.head<2>() - Eigen::Vector2d(10, 5)).norm(), kExact);
    EXPECT_NEAR(area(door->plan), 1.0 * 0.2, kExact) << "flush with its wall";
    EXPECT_LT((centroid(door->plan) + bim.origin.head<2>() - Eigen::Vector2d(12, 5)).norm(), kExact);
    EXPECT_GE(door->host, 0);
    EXPECT_NEAR(area(columns[0]->plan), 0.4 * 0.2, kExact);
    EXPECT_TRUE(contains(columns[0]->plan, Eigen::Vector2d(12.0, 7.19) - bim.origin.head<2>()))
        << "turned by 90 degrees";
    EXPECT_GT(area(columns[1]->plan), 0.0) << "a missing depth is a sheet";
}

TEST(Cv4aec, FloorsAreStoreysInAscendingOrder)
{
    const Folder folder;
    (void)folder.write("M_F2_walls.json",
                       R"([{"start_pt": [0,0,3.2], "end_pt": [4,0,3.2], "width": 0.2, "height": 3}])");
    (void)folder.write("M_F1_walls.json", R"([{"start_pt": [0,0,0], "end_pt": [4,0,0], "width": 0.2, "height": 3}])");
    const Bim bim = ifc::readTruth(folder.path());
    ASSERT_EQ(bim.storeys.size(), 2U);
    EXPECT_EQ(bim.storeys[0].name, "F1");
    EXPECT_EQ(bim.storeys[1].name, "F2");
    for (const BimElement& e : bim.elements)
        EXPECT_NEAR(e.low_m, bim.storeys[static_cast<std::size_t>(e.storey)].elevation_m, kExact);
}

TEST(Cv4aec, ListsAndObjectsWithoutTellingNamesAreTaken)
{
    const Folder folder;
    EXPECT_EQ(ifc::readTruth(folder.write("a.json", kWalls)).elements.size(), 2U);
    const std::string all = std::string("{\"walls\": ") + kWalls + ", \"doors\": " + kDoors + "}";
    EXPECT_EQ(ifc::readTruth(folder.write("b.json", all)).elements.size(), 3U);
}

TEST(Cv4aec, MeshesHaveTheirDoorsCutOut)
{
    const Folder folder;
    const std::string all = std::string("{\"walls\": ") + kWalls + ", \"doors\": " + kDoors + "}";
    const Bim bim = ifc::readTruth(folder.write("b.json", all));
    double volume = 0.0;
    for (const auto& t : bim.elements[0].mesh.triangles)
    {
        const auto& v = bim.elements[0].mesh.vertices;
        volume += v[t[0]].dot(v[t[1]].cross(v[t[2]])) / 6.0;
    }
    EXPECT_NEAR(volume, 0.2 * (4.0 * 3.0 - 1.0 * 2.1), kExact);
}

TEST(Cv4aec, ADoorInACornerBelongsToTheWallAlongIt)
{
    // Its middle lies in the wall along y, but it is as wide as a door along x.
    const Folder folder;
    const std::string all = R"({"walls": [
      {"start_pt": [0,-2,0], "end_pt": [0,2,0], "width": 0.3, "height": 3},
      {"start_pt": [-0.6,0,0], "end_pt": [4,0,0], "width": 0.1, "height": 3},
      {"start_pt": [0.1,0,0], "end_pt": [0.1,0,0], "width": 0.3, "height": 3}],
      "doors": [{"loc": [0.1, 0.06, 0], "width": 1.0, "depth": 0.1, "height": 2}]})";
    const Bim bim = ifc::readTruth(folder.write("a.json", all));
    ASSERT_EQ(bim.elements.size(), 4U);
    const BimElement& door = bim.elements.back();
    ASSERT_EQ(door.elementClass, ElementClass::Door);
    EXPECT_EQ(door.host, 1);
    EXPECT_NEAR(area(door.plan), 1.0 * 0.1, kExact);
    EXPECT_FALSE(bim.elements[2].axis.has_value()) << "a wall without a length has no direction";
}

TEST(Cv4aec, FilesThatAreNoneAreRefusedInOneSentence)
{
    const Folder folder;
    EXPECT_THAT(badFile(folder.write("a_b_walls.json", R"({"start_pt": [0,0,0]})")), HasSubstr("not a list"));
    EXPECT_THAT(badFile(folder.write("list.json", R"([{"loc": [0,0,0]}])")), HasSubstr("no CV4AEC model"));
    EXPECT_THAT(badFile(folder.write("x.json", R"({"name": "something"})")), HasSubstr("neither a CV4AEC model"));
    const Folder other;
    EXPECT_THAT(badFile(other.write("a_b_walls.json", R"([{"width": 0.2}])")), HasSubstr("no start_pt"));
    const Folder third;
    EXPECT_THAT(badFile(third.write("a_b_walls.json", R"([{"start_pt": "here", "end_pt": [1, 0, 0]}])")),
                HasSubstr("not a CV4AEC model"));
    const Folder empty;
    EXPECT_THAT(badFile(empty.path()), HasSubstr("holds no CV4AEC files"));
    (void)empty.write("A_F1_walls.json", kWalls);
    (void)empty.write("B_F1_walls.json", kWalls);
    EXPECT_THAT(badFile(empty.path()), HasSubstr("several CV4AEC models"));
}

TEST(TruthFiles, WhatIsNoneIsNamedForWhatItIs)
{
    const Folder folder;
    EXPECT_THAT(badFile(folder.file("nothing.ifc")), HasSubstr("does not exist"));
    EXPECT_THAT(badFile(folder.write("empty.ifc", "")), HasSubstr("is empty"));
    EXPECT_THAT(badFile(folder.write("text.ifc", "Dear surveyor,")), HasSubstr("neither an IFC file"));
    EXPECT_THAT(badFile(folder.write("zip.ifc", "PK\003\004")), HasSubstr("unpack"));
    EXPECT_THAT(badFile(folder.write("xml.ifc", "<?xml version=\"1.0\"?>")), HasSubstr("XML"));
    EXPECT_THAT(badFile(folder.write("cut.json", R"({"elements": [{"type")")), HasSubstr("truncated"));
    EXPECT_THAT(badFile(folder.write("cut.ifc", "ISO-10303-21;\nHEADER;\n")), HasSubstr("truncated"));
}

TEST(TruthFiles, LengthsAThousandTimesTooLargeAreRefused)
{
    const Folder folder;
    const std::string millimetres = R"([{"start_pt": [0,0,0], "end_pt": [4000,0,0], "width": 200, "height": 3000}])";
    const std::string said = badFile(folder.write("walls.json", millimetres));
    EXPECT_THAT(said, HasSubstr("3e+03 m high"));
    EXPECT_THAT(said, HasSubstr("length unit is wrong"));
    const std::string kilometres =
        R"([{"start_pt": [0,0,0], "end_pt": [0.004,0,0], "width": 0.0002, "height": 0.003}])";
    EXPECT_THAT(badFile(folder.write("walls.json", kilometres)), HasSubstr("length unit is wrong"));
}

TEST(TruthFiles, ASurveysTruthIsToldByItsParts)
{
    const Folder folder;
    const std::string path = folder.write("gt.json", R"({"elements": [], "storeys": []})");
    EXPECT_TRUE(isSurveyTruth(path));
    EXPECT_THAT(badFile(path), HasSubstr("holds no walls"));
    EXPECT_THAT(badFile(folder.write("bad.json", R"({"elements": [{"type": "IfcWall", "obb": 3}], "storeys": []})")),
                HasSubstr("not the truth of a simulated survey"));
}

}  // namespace
}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloud/station_file.h"

#include "core/base/error.h"
#include "core/cloud/point_cloud.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace s2b
{
namespace
{

class StationFile : public testing::Test
{
protected:
    std::string write(const std::string& text)
    {
        const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
        m_path = (std::filesystem::temp_directory_path() /
                  (std::string("s2b_") + test->test_suite_name() + test->name() + ".txt"))
                     .string();
        std::ofstream(m_path, std::ios::binary) << text;
        return m_path;
    }
    std::string errorOf(const std::string& text)
    {
        try
        {
            (void)readStations(write(text));
        }
        catch (const Error& e)
        {
            EXPECT_EQ(e.code(), ErrorCode::BadFile);
            return e.what();
        }
        return {};
    }
    void TearDown() override { std::filesystem::remove(m_path); }

    std::string m_path;
};

TEST_F(StationFile, ReadsIdsAndPlacesWithAnySeparatorTitlesAndRemarks)
{
    const auto stations =
        readStations(write("id;x;y;z\r\n7; 1.5;2;3\r\n# a remark\n\n12,4,-5,6e2 # the roof\n3\t7 8 9"));
    ASSERT_EQ(stations.size(), 3U);
    EXPECT_EQ(stations[0].id, 7);
    EXPECT_EQ(stations[0].position, Eigen::Vector3d(1.5, 2, 3));
    EXPECT_EQ(stations[1].id, 12);
    EXPECT_EQ(stations[1].position, Eigen::Vector3d(4, -5, 600));
    EXPECT_EQ(stations[2].position, Eigen::Vector3d(7, 8, 9));
}

TEST_F(StationFile, KeepsWorldCoordinatesToTheMillimetre)
{
    EXPECT_EQ(readStations(write("32500100.123 5600300.456 120.789")).front().position,
              Eigen::Vector3d(32500100.123, 5600300.456, 120.789));
}

TEST_F(StationFile, ReadsASimulatedSurveysTruth)
{
    const auto stations = readStations(write(R"({"elements": [], "stations": [[1, 2, 3, 0], [4, 5, 6, -1]]})"));
    ASSERT_EQ(stations.size(), 2U);
    EXPECT_FALSE(stations[0].id);
    EXPECT_EQ(stations[1].position, Eigen::Vector3d(4, 5, 6));
}

TEST_F(StationFile, ReadsObjects)
{
    const auto stations =
        readStations(write(R"([{"id": 4, "x": 1, "y": 2, "z": 3}, {"id": 5, "position": [6, 7, 8]}])"));
    ASSERT_EQ(stations.size(), 2U);
    EXPECT_EQ(stations[0].id, 4);
    EXPECT_EQ(stations[1].position, Eigen::Vector3d(6, 7, 8));
}

TEST_F(StationFile, SaysWhatIsWrongAndWhere)
{
    using testing::HasSubstr;
    EXPECT_THAT(errorOf("1 2 3\n4 5\n"), HasSubstr("line 2"));
    EXPECT_THAT(errorOf("1 2 3 4 5\n"), HasSubstr("line 1"));
    EXPECT_THAT(errorOf("1 2 three\n"), HasSubstr("line 1"));
    EXPECT_THAT(errorOf("1 2 3 inf\n"), HasSubstr("line 1"));
    EXPECT_THAT(errorOf("1.5 1 2 3\n"), HasSubstr("whole number"));
    EXPECT_THAT(errorOf("70000 1 2 3\n"), HasSubstr("whole number"));
    EXPECT_THAT(errorOf("1 1 2 3\n1 4 5 6\n"), HasSubstr("given twice"));
    EXPECT_THAT(errorOf("1 1 2 3\n4 5 6\n"), HasSubstr("some have none"));
    EXPECT_THAT(errorOf("# nothing\n"), HasSubstr("no station"));
    EXPECT_THAT(errorOf("{\"stations\": [[1, 2]]}"), HasSubstr("station 1"));
    EXPECT_THAT(errorOf("{\"stations\": [{\"id\": 1, \"x\": 2}]}"), HasSubstr("station 1"));
    EXPECT_THAT(errorOf("{\"station\": []}"), HasSubstr("'stations'"));
    EXPECT_THAT(errorOf("{"), HasSubstr("not JSON"));
    EXPECT_THROW((void)readStations("no/such/file"), Error);
}

TEST(StationIds, FollowsTheFilesIds)
{
    const StationIds ids({{12, {}}, {3, {}}}, 3);
    EXPECT_EQ(ids.indexOf(12), 0);
    EXPECT_EQ(ids.indexOf(3), 1);
    for (const int unknown : {-1, 0, 4, 13, 1000000})
        EXPECT_EQ(ids.indexOf(unknown), StationView::kUnknown);
}

TEST(StationIds, CountsFromOneOrFromZeroWithoutIds)
{
    const std::vector<KnownStation> two(2);
    EXPECT_EQ(StationIds(two, 1).indexOf(1), 0);
    EXPECT_EQ(StationIds(two, 2).indexOf(2), 1);  // of the first one no point is left
    EXPECT_EQ(StationIds(two, 0).indexOf(0), 0);
    EXPECT_EQ(StationIds(two, 1).indexOf(0), StationView::kUnknown);
}

}  // namespace
}  // namespace s2b

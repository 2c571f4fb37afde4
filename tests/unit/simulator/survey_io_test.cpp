// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/survey_io.h"
#include "core/base/error.h"
#include "tests/simulator/truth_json.h"

#include <gtest/gtest.h>
#include <laszip/laszip_api.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace s2b::sim
{
namespace
{

class SurveyFile : public testing::Test
{
protected:
    void SetUp() override
    {
        m_folder = std::filesystem::path(testing::TempDir()) /
                   ("s2b_survey_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::remove_all(m_folder);
        std::filesystem::create_directories(m_folder);
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }
    [[nodiscard]] std::string path(const std::string& name) const { return (m_folder / name).string(); }
    static std::string bytes(const std::string& path)
    {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    }
    static Survey georeferenced(unsigned threads = 0)
    {
        BuildingSpec spec = twoRoomsWithDoor();
        spec.origin = {32500100.25, 5600300.5, 120.125};
        spec.yaw_deg = 23.0;
        const SimulatedBuilding building = makeBuilding(spec);
        const Scene scene = makeScene(building);
        ScanSettings settings;
        settings.step_deg = 1.0;
        settings.threads = threads;
        return scan(scene, chooseStations(building, scene, false), settings);
    }
    std::filesystem::path m_folder;
};

struct LasPoint
{
    Eigen::Vector3d at;
    int label;
    int station;
    std::array<int, 3> rgb;
};

std::vector<LasPoint> readLas(const std::string& path)
{
    laszip_POINTER reader = nullptr;
    EXPECT_EQ(laszip_create(&reader), 0);
    laszip_BOOL isCompressed = 0;
    EXPECT_EQ(laszip_open_reader(reader, path.c_str(), &isCompressed), 0);
    laszip_header_struct* header = nullptr;
    EXPECT_EQ(laszip_get_header_pointer(reader, &header), 0);
    EXPECT_EQ(isCompressed != 0, path.ends_with(".laz"));
    EXPECT_EQ(header->version_minor, 4);
    EXPECT_EQ(header->point_data_format, 7);
    EXPECT_EQ(header->x_scale_factor, 0.001);
    laszip_point_struct* point = nullptr;
    EXPECT_EQ(laszip_get_point_pointer(reader, &point), 0);
    std::vector<LasPoint> result;
    for (laszip_U64 i = 0; i < header->extended_number_of_point_records; ++i)
    {
        EXPECT_EQ(laszip_read_point(reader), 0);
        std::array<laszip_F64, 3> at{};
        laszip_get_coordinates(reader, at.data());
        result.push_back({{at[0], at[1], at[2]},
                          point->extended_classification,
                          point->point_source_ID,
                          {point->rgb[0], point->rgb[1], point->rgb[2]}});
        // 1e-6: the header's box is of rounded coordinates, in doubles at 3e7 m.
        EXPECT_LE(at[0], header->max_x + 1e-6);
        EXPECT_GE(at[0], header->min_x - 1e-6);
    }
    laszip_close_reader(reader);
    laszip_destroy(reader);
    return result;
}

TEST_F(SurveyFile, LasAndLazKeepMillimetresLabelsAndColours)
{
    const Survey survey = georeferenced();
    for (const char* name : {"a.laz", "a.las"})
    {
        writeSurvey(survey, path(name));
        const std::vector<LasPoint> read = readLas(path(name));
        ASSERT_EQ(read.size(), survey.size());
        for (std::size_t i = 0; i < read.size(); ++i)
        {
            const Eigen::Vector3d world = survey.origin + survey.points[i].cast<double>();
            ASSERT_LT((read[i].at - world).cwiseAbs().maxCoeff(),
                      0.00051);  // half a millimetre and a double's spacing at 3e7
            ASSERT_EQ(read[i].label, static_cast<int>(survey.labels[i]));
            ASSERT_EQ(read[i].station, survey.stations[i] + 1);
            ASSERT_EQ(read[i].rgb[0], survey.colours[i][0] * 257);
        }
    }
    EXPECT_LT(std::filesystem::file_size(path("a.laz")), std::filesystem::file_size(path("a.las")) / 2);
}

TEST_F(SurveyFile, BytesAreTheSameForAnyNumberOfThreads)
{
    writeSurvey(georeferenced(1), path("one.laz"));
    writeSurvey(georeferenced(2), path("two.laz"));
    EXPECT_GT(bytes(path("one.laz")).size(), 10000U);
    EXPECT_EQ(bytes(path("one.laz")), bytes(path("two.laz")));
}

TEST_F(SurveyFile, PlyHasDoublesWhenFarFromTheOrigin)
{
    const Survey survey = georeferenced();
    writeSurvey(survey, path("a.ply"));
    const std::string all = bytes(path("a.ply"));
    const std::size_t data = all.find("end_header\n") + 11;
    EXPECT_NE(all.find("property double x"), std::string::npos);
    EXPECT_NE(all.find("property float scalar_Classification"), std::string::npos);
    constexpr std::size_t kRow = 3 * 8 + 3 + 4;
    ASSERT_EQ(all.size(), data + survey.size() * kRow);
    const std::size_t last = survey.size() - 1;
    double x = 0.0;
    float label = 0.0F;
    std::memcpy(&x, all.data() + data + last * kRow, 8);
    std::memcpy(&label, all.data() + data + last * kRow + 27, 4);
    EXPECT_EQ(x, survey.origin.x() + static_cast<double>(survey.points[last].x()));
    EXPECT_EQ(label, static_cast<float>(survey.labels[last]));
}

TEST_F(SurveyFile, XyzIsOneLineAPoint)
{
    const Survey survey = georeferenced();
    writeSurvey(survey, path("a.xyz"));
    std::ifstream in(path("a.xyz"));
    std::size_t lines = 0;
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    int label = 0;
    while (in >> x >> y >> z >> label)
    {
        ASSERT_NEAR(x, survey.origin.x() + static_cast<double>(survey.points[lines].x()), 0.0000501);  // 4 decimals
        ASSERT_EQ(label, static_cast<int>(survey.labels[lines]));
        ++lines;
    }
    EXPECT_EQ(lines, survey.size());
}

TEST_F(SurveyFile, ErrorsNameTheFileAndLeaveNothing)
{
    const Survey survey = georeferenced();
    for (const std::string& name :
         {std::string("no/such/folder/a.laz"), std::string("a.e57"), std::string("noextension")})
    {
        try
        {
            writeSurvey(survey, path(name));
            FAIL() << name;
        }
        catch (const Error& e)
        {
            EXPECT_NE(std::string(e.what()).find(name), std::string::npos);
        }
    }
    EXPECT_TRUE(std::filesystem::is_empty(m_folder));
}

TEST_F(SurveyFile, TruthTellsWhatWasSeen)
{
    const SimulatedBuilding building = makeBuilding(twoRoomsWithDoor());
    const Scene scene = makeScene(building);
    ScanSettings settings;
    settings.step_deg = 0.5;
    const std::vector<Station> stations = chooseStations(building, scene, false);
    writeTruth(scene, scan(scene, stations, settings), stations, &building, path("gt.json"));
    const auto truth = nlohmann::json::parse(bytes(path("gt.json")));
    ASSERT_EQ(truth["storeys"].size(), 1U);
    EXPECT_TRUE(truth["storeys"][0]["scanned"]);
    // The median of thousands of points with 2 mm of noise.
    EXPECT_NEAR(truth["storeys"][0]["floor_z"], 0.0, 0.001);
    EXPECT_NEAR(truth["storeys"][0]["ceiling_z"], 2.7, 0.001);
    std::size_t walls = 0;
    for (const auto& e : truth["elements"])
    {
        if (e["type"] == "IfcWall")
        {
            ++walls;
            const double pos = e["visible_side_pos"];
            const double neg = e["visible_side_neg"];
            const bool isPartition = e["thickness"] == 0.15;
            // Inner faces are seen nearly whole, outer ones (from inside) not at all; the rest of 1 is the door, and
            // grazing rays.
            EXPECT_GT(std::max(pos, neg), 0.7);
            if (isPartition)
                EXPECT_GT(std::min(pos, neg), 0.7);
            else
                EXPECT_EQ(std::min(pos, neg), 0.0);
        }
        if (e["type"] == "IfcDoor")
        {
            EXPECT_GT(e["host_points_near"], 200);
            EXPECT_NEAR(e["opening"]["half"][0], 0.4425, 1e-9);
        }
    }
    EXPECT_EQ(walls, 5U);
}

}  // namespace
}  // namespace s2b::sim

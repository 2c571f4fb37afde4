// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "ifc/ifc_writer.h"
#include "tests/simulator/scanner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace s2b::sim
{
namespace
{

class IfcScene : public testing::Test
{
protected:
    void SetUp() override
    {
        m_path = (std::filesystem::path(testing::TempDir()) /
                  (std::string("s2b_") + testing::UnitTest::GetInstance()->current_test_info()->name() + ".ifc"))
                     .string();
    }
    void TearDown() override { std::filesystem::remove(m_path); }
    std::string m_path;
};

TEST_F(IfcScene, ScansLikeTheBuildingThatItWasWrittenFrom)
{
    BuildingSpec spec = oneRoom();
    spec.yaw_deg = 23.0;
    spec.origin = {32500100.25, 5600300.5, 120.125};
    const SimulatedBuilding building = makeBuilding(spec);
    ifc::writeIfc(building.truth, m_path, {});
    const Scene own = makeScene(building);
    const Scene read = readScene(m_path);

    ScanSettings settings;
    settings.step_deg = 1.0;
    settings.noise_m = 0.0;
    settings.mixedPixels = 0.0;
    settings.dropOut = false;
    const Station station = chooseStations(building, own, false).front();
    const Survey a = scan(own, {station}, settings);
    const Survey b = scan(read, {{station.position + own.origin - read.origin, 0}}, settings);
    ASSERT_EQ(a.size(), b.size());
    std::size_t otherLabels = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        const Eigen::Vector3d d = a.points[i].cast<double>() - b.points[i].cast<double>() + own.origin - read.origin;
        ASSERT_LT(d.norm(), 2e-4);  // float directions and ranges; a double's spacing at 3e7
        otherLabels += a.labels[i] != b.labels[i] ? 1U : 0U;
    }
    EXPECT_LT(otherLabels, a.size() / 1000);  // rays into the very corners
}

TEST_F(IfcScene, ChoosesStationsInEveryRoom)
{
    BuildingSpec spec;
    spec.furniture = false;
    const SimulatedBuilding building = makeBuilding(spec);
    ifc::writeIfc(building.truth, m_path, {});
    const Scene scene = readScene(m_path);
    const std::vector<Station> stations = chooseStations(scene, true);
    ScanSettings settings;
    settings.step_deg = 1.0;
    const Survey survey = scan(scene, stations, settings);
    for (const char* type : {"IfcWall", "IfcSlab", "IfcDoor", "IfcWindow", "IfcColumn", "ground"})
        EXPECT_TRUE(
            std::any_of(survey.triangles.begin(), survey.triangles.end(), [&](std::uint32_t t)
                        { return t != Survey::kNoTriangle && scene.elements[scene.surfaces[t].element].type == type; }))
            << type;
    for (const int storey : {-1, 0, 1})
        EXPECT_TRUE(std::any_of(stations.begin(), stations.end(), [&](const Station& s) { return s.storey == storey; }))
            << storey;
}

TEST_F(IfcScene, RefusesAFileThatIsNotThere)
{
    EXPECT_THROW((void)readScene(m_path), Error);
}

}  // namespace
}  // namespace s2b::sim

// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated survey's truth, through all readers: the building against itself is perfect, whatever file it comes from.
#include "core/validation/survey_truth.h"
#include "ifc/bim_reader.h"
#include "ifc/ifc_writer.h"
#include "tests/property/simulated_survey.h"
#include "tests/simulator/truth_json.h"
#include "tests/validation/sample_bims.h"

#include <gtest/gtest.h>

namespace s2b
{
namespace
{

using namespace test;

struct Simulated
{
    Folder folder;
    std::string json = folder.file("gt.json");
    std::string ifc = folder.file("truth.ifc");
    PointCloud cloud;

    Simulated()
    {
        sim::BuildingSpec spec;
        spec.storeys = 2;
        spec.roomsPerSide = 2;
        spec.trees = false;
        spec.yaw_deg = 20.0;
        spec.origin = {1000.0, 2000.0, 30.0};
        const sim::SimulatedBuilding building = sim::makeBuilding(spec);
        const sim::Scene scene = sim::makeScene(building, spec.seed);
        const std::vector<sim::Station> stations = sim::chooseStations(building, scene, false, spec.seed);
        sim::ScanSettings settings = quickScan();
        settings.step_deg = 1.4;  // 5 cm at 2 m: enough for cells of 10 cm
        const sim::Survey survey = sim::scan(scene, stations, settings);
        cloud = survey.toPointCloud();
        sim::writeTruth(scene, survey, stations, &building, json);
        ifc::writeIfc(building.truth, ifc, {});
    }
    [[nodiscard]] CloudView view() const
    {
        return {cloud.points.front().data(), cloud.size(), cloud.origin,
                reinterpret_cast<const std::uint8_t*>(cloud.labels.data())};
    }
};

const Simulated& simulated()
{
    static const Simulated kOne;
    return kOne;
}

TEST(Agreement, TheTruthInItsOwnIfcIsPerfect)
{
    const Bim truth = ifc::readTruth(simulated().json);
    const Bim result = ifc::readTruth(simulated().ifc);
    const Validation v = validate(truth, result, nullptr, {}, {});
    for (const ElementClass elementClass : {ElementClass::Wall, ElementClass::Door, ElementClass::Window})
    {
        SCOPED_TRACE(className(elementClass));
        const ClassScore& s = v.scores.at(elementClass);
        EXPECT_GE(s.truthCount, 3);
        // The truth is written in tenths of a millimetre, arcs in chords within 1 mm: of 0.1 m thick walls 1 % at
        // worst.
        EXPECT_GT(*s.iou, 0.99);
        EXPECT_DOUBLE_EQ(s.at50.recall, 1.0);
        EXPECT_DOUBLE_EQ(s.at50.precision, 1.0) << "what was not seen is excused";
        EXPECT_LT(*s.centroid_m, 0.002);
        EXPECT_LT(*s.heightError_m, 0.0003);
    }
    const ClassScore& walls = v.scores.at(ElementClass::Wall);
    EXPECT_GT(*walls.volumetricIou, 0.99);
    EXPECT_LT(*walls.thicknessError_m, 0.0003);
    EXPECT_DOUBLE_EQ(walls.cornersAt.at(5).f1, 1.0);
    ASSERT_EQ(v.storeys.size(), 2U);
    for (const StoreyError& e : v.storeys)
        EXPECT_LT(e.error_m, 0.005) << "seen floors are as noisy as the scan";
    EXPECT_EQ(v.extraStoreys, 0);
}

TEST(Agreement, ThePointsLieOnTheTruth)
{
    const CloudDeviation d = measureDeviation(ifc::readBim(simulated().ifc), simulated().view(), {}, false, {});
    // The scan's noise is 3 mm (1 sigma): a mean distance of 2.4 mm; mixed pixels at edges add a little.
    EXPECT_GT(d.wallMeanAbsolute_m, 0.0015);
    EXPECT_LT(d.wallMeanAbsolute_m, 0.004);
}

TEST(Agreement, ThePointsTellMuchTheSameOfWhatWasSeen)
{
    const Bim known = ifc::readTruth(simulated().json);
    const Bim unknown = ifc::readTruth(simulated().ifc);
    const CloudView view = simulated().view();
    const Bim result = ifc::readBim(simulated().ifc);
    const Validation a = validate(known, result, &view, {}, {});
    const Validation b = validate(unknown, result, &view, {}, {});
    for (const ElementClass elementClass : {ElementClass::Wall, ElementClass::Door, ElementClass::Window})
    {
        SCOPED_TRACE(className(elementClass));
        // Elements at the border of being seen may fall to either side: one in ten.
        const int known_ = a.scores.at(elementClass).truthCount;
        EXPECT_NEAR(b.scores.at(elementClass).truthCount, known_, 1 + known_ / 10);
        EXPECT_DOUBLE_EQ(b.scores.at(elementClass).at50.f1, 1.0);
    }
    EXPECT_EQ(a.storeys.size(), b.storeys.size());
}

}  // namespace
}  // namespace s2b

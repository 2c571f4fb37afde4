// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/scene.h"
#include "tests/report/sample_report.h"

#include <gtest/gtest.h>

namespace s2b::report::testing
{
namespace
{

using namespace validation;

const Row& rowOf(const Scene& scene, const std::string& guid)
{
    for (const Row& row : scene.rows)
    {
        if ((row.result && row.result->guid == guid) || (row.truth && row.truth->guid == guid))
            return row;
    }
    throw std::runtime_error("no row of " + guid);
}

TEST(Scene, PutsTheWorstFirstAndNumbersThem)
{
    const SampleReport sample;
    const Scene scene = makeScene(sample.input());
    int group = 0;
    for (std::size_t i = 0; i < scene.rows.size(); ++i)
    {
        const Row& row = scene.rows[i];
        EXPECT_EQ(row.number, static_cast<int>(i) + 1);
        const int now = row.verdict == Verdict::OutOfTolerance ? 0
                        : row.verdict == Verdict::Within       ? 1
                        : row.pair.outcome == Outcome::NotSeen ? 3
                                                               : 2;
        EXPECT_GE(now, group);
        group = now;
    }
    EXPECT_EQ(scene.rows[0].pair.outcome, Outcome::Missed);
    EXPECT_EQ(scene.rows[1].pair.outcome, Outcome::FalsePositive);
    EXPECT_EQ(scene.rows[2].result, &sample.result.elements[2]);
    EXPECT_EQ(scene.rows.back().pair.outcome, Outcome::NotSeen);
}

TEST(Scene, JudgesByThePointsWhereThereAreAny)
{
    const SampleReport sample;
    const Scene scene = makeScene(sample.input());
    const Row& bulging = rowOf(scene, sample.result.elements[2].guid);
    EXPECT_EQ(bulging.verdict, Verdict::OutOfTolerance);
    EXPECT_EQ(bulging.band, LoaBand::Loa20);
    EXPECT_EQ(bulging.error_m, 0.0282);
    EXPECT_EQ(rowOf(scene, sample.result.elements[0].guid).verdict, Verdict::Within);
    EXPECT_EQ(scene.toleranceLimit_m, 0.015);
    EXPECT_EQ(scene.colorRange_m, 0.030) << "twice the tolerance";
}

TEST(Scene, JudgesDoorsByTheirPlaceWhateverThePointsSayOfTheLeaf)
{
    SampleReport sample;
    const int door = sample.validation.elements.back().result - 1;
    ASSERT_EQ(sample.result.elements[static_cast<std::size_t>(door)].elementClass, ElementClass::Door);
    Deviation& deviation = sample.validation.cloudToResult->elements[static_cast<std::size_t>(door)];
    deviation.points = 1000;
    deviation.p95_m = 0.18;
    deviation.verdict = Verdict::OutOfTolerance;
    const std::string guid = sample.result.elements[static_cast<std::size_t>(door)].guid;
    EXPECT_EQ(rowOf(makeScene(sample.input()), guid).verdict, Verdict::Within);
    for (ElementResult& pair : sample.validation.elements)
    {
        if (pair.result == door)
            pair.centroid_m = 0.02;
    }
    EXPECT_EQ(rowOf(makeScene(sample.input()), guid).verdict, Verdict::OutOfTolerance);
}

TEST(Scene, JudgesByPlaceAndSizeWithoutPoints)
{
    SampleReport sample;
    sample.dropPoints();
    const Scene scene = makeScene(sample.input());
    const Row& thick = rowOf(scene, sample.result.elements[2].guid);
    EXPECT_EQ(thick.error_m, 0.031) << "its thickness is the largest error";
    EXPECT_EQ(thick.verdict, Verdict::OutOfTolerance);
    EXPECT_EQ(thick.band, LoaBand::Loa20);
    const Row& good = rowOf(scene, sample.result.elements[0].guid);
    EXPECT_EQ(good.verdict, Verdict::Within);
    EXPECT_EQ(good.band, LoaBand::Loa30) << "6 mm";
}

TEST(Scene, GivesEachElementTheStoreyOfItsTruth)
{
    const SampleReport sample;
    const Scene scene = makeScene(sample.input());
    ASSERT_EQ(scene.levels.size(), 2u) << "the result's storeys go with the truth's";
    EXPECT_EQ(rowOf(scene, sample.result.elements[9].guid).storey, "Upper floor");
    EXPECT_EQ(rowOf(scene, sample.result.elements.back().guid).storey, "Ground floor") << "by its own storey's partner";
    EXPECT_EQ(scene.levels[0].rows.size() + scene.levels[1].rows.size(), scene.rows.size());
}

TEST(Scene, PutsModelsOfDifferentOriginsInOneFrame)
{
    SampleReport sample;
    sample.result.origin += Eigen::Vector3d(10, -20, 5);
    const Scene scene = makeScene(sample.input());
    EXPECT_EQ(scene.base, sample.truth.origin);
    EXPECT_TRUE(scene.resultShift.isApprox(Eigen::Vector3d(10, -20, 5)));
}

TEST(Scene, MeasuresOneModelAgainstThePointsAlone)
{
    const SampleReport sample;
    ReportInput input = sample.input();
    input.truth = nullptr;
    const Scene scene = makeScene(input);
    EXPECT_EQ(scene.rows.size(), sample.result.elements.size());
    EXPECT_EQ(scene.rows[0].result, &sample.result.elements[2]);
    EXPECT_EQ(scene.rows[0].verdict, Verdict::OutOfTolerance);
    EXPECT_EQ(scene.rows[1].verdict, Verdict::Within) << "nothing is a false positive without a truth";
}

TEST(BandOf, IsTheBestBandWhoseLimitIsKept)
{
    const ValidationParams params;
    EXPECT_EQ(bandOf(0.0009, params), LoaBand::Loa50);
    EXPECT_EQ(bandOf(0.001, params), LoaBand::Loa50);
    EXPECT_EQ(bandOf(0.0011, params), LoaBand::Loa40);
    EXPECT_EQ(bandOf(0.015, params), LoaBand::Loa30);
    EXPECT_EQ(bandOf(0.14, params), LoaBand::Loa10);
    EXPECT_EQ(bandOf(0.16, params), LoaBand::Beyond);
}

}  // namespace
}  // namespace s2b::report::testing

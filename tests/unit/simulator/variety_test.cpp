// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/variety.h"

#include <gtest/gtest.h>

#include <set>

namespace s2b::sim
{
namespace
{

constexpr std::uint64_t kSeeds = 40;

Scene sceneOf(std::uint64_t seed)
{
    const Variety variety = drawVariety(seed);
    return makeScene(makeBuilding(variety.spec), seed);
}

}  // namespace

TEST(Variety, EverySeedGivesABuildingThatCanBeScanned)
{
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
    {
        SCOPED_TRACE(seed);
        const Scene scene = sceneOf(seed);
        ASSERT_GT(scene.triangles.size(), 200u);
        for (const Eigen::Vector3d& v : scene.vertices)
            ASSERT_TRUE(v.allFinite() && v.norm() < 200.0);
        const SimulatedBuilding building = makeBuilding(drawVariety(seed).spec);
        EXPECT_FALSE(chooseStations(building, scene, false, seed).empty());
    }
}

TEST(Variety, AllClassesOccur)
{
    std::set<Label> labels;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
        for (const Surface& surface : sceneOf(seed).surfaces)
            labels.insert(surface.label);
    EXPECT_EQ(labels.size(), kLabelCount);
}

TEST(Variety, TheSameSeedGivesTheSameScene)
{
    const Scene a = sceneOf(7), b = sceneOf(7);
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    for (std::size_t i = 0; i < a.vertices.size(); ++i)
        ASSERT_EQ(a.vertices[i], b.vertices[i]);
}

TEST(Variety, OpeningsStayWithinTheirWalls)
{
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
    {
        SCOPED_TRACE(seed);
        const SimulatedBuilding building = makeBuilding(drawVariety(seed).spec);
        for (const Opening& opening : building.truth.openings)
        {
            const Wall* host = building.truth.wall(opening.host);
            ASSERT_NE(host, nullptr);
            EXPECT_GE(opening.offset_m, 0.0);
            EXPECT_LE(opening.offset_m + opening.width.value_m, host->axisLength_m());
            EXPECT_LE(opening.sill.value_m + opening.height.value_m, host->height.value_m + 1e-9);
        }
    }
}

}  // namespace s2b::sim

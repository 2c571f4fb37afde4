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

TEST(Variety, AFifthOfTheScannersAreLineLasersFromAFewSetUps)
{
    int lines = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        const Variety variety = drawVariety(seed);
        if (variety.scan.lineStep_deg == 0.0)
            continue;
        ++lines;
        EXPECT_GE(variety.scan.mostStations, 1U);
        EXPECT_LE(variety.scan.mostStations, 4U);
        EXPECT_FALSE(variety.outside);
    }
    EXPECT_GT(lines, 25);
    EXPECT_LT(lines, 65);
}

TEST(Variety, SomeGlazedFrontsHaveADoorAndSomeDoorsAreGlazed)
{
    std::size_t fronts = 0, glazedDoors = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
    {
        const Scene scene = sceneOf(seed);
        std::set<std::uint32_t> doors, glazed, windows;
        for (const Surface& surface : scene.surfaces)
        {
            if (surface.label == Label::Door)
                (surface.material == Material::Glass ? glazed : doors).insert(surface.element);
            if (surface.label == Label::Window)
                windows.insert(surface.element);
        }
        for (const std::uint32_t element : glazed)
        {
            EXPECT_TRUE(doors.contains(element) || scene.elements[element].type == "IfcDoor");
            ++(windows.contains(element) ? fronts : glazedDoors);
        }
    }
    EXPECT_GT(fronts, 5U);
    EXPECT_GT(glazedDoors, 20U);
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

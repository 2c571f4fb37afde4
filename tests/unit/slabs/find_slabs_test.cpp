// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/slabs/slabs.h"

#include "core/geometry/polygon.h"
#include "tests/unit/spaces/plan_scene.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

using namespace s2b;
using namespace s2b::test;

/// Outlines on walls follow from their faces alone; only the rounding of new corners to double is left.
constexpr double kExact_m2 = 1e-6;

/// A house of 8 m by 5 m inside, walls 0.3 m; its storeys are 2.6 m high and 2.85 m apart.
class House
{
public:
    void addStorey(const std::vector<Patch>& floorHoles = {}, const std::vector<Patch>& ceilingHoles = {},
                   double ceiling = 2.6)
    {
        const double z = 2.85 * static_cast<double>(m_levels.size());
        m_scene.level(kPlan, z, Label::Floor, floorHoles);
        m_scene.level(kPlan, z + ceiling, Label::Ceiling, ceilingHoles);
        m_levels.push_back(levelAt(z, z + ceiling));
        m_walls.push_back(boxOf(static_cast<std::uint32_t>(10 * m_levels.size()), kPlan.low, kPlan.high, 0.3, z));
    }
    [[nodiscard]] SlabResult slabs(const SlabParams& params = {}) const
    {
        const PlanCells cells = m_scene.cells();
        std::vector<RoomPlan> plans;
        std::vector<ElementId> storeys;
        for (std::size_t i = 0; i < m_levels.size(); ++i)
        {
            plans.push_back(planRooms(cells, m_levels[i], m_walls[i], SpaceParams{}, Context{}));
            storeys.push_back(ElementId{static_cast<std::uint32_t>(i + 1)});
        }
        std::uint32_t nextId = 100;
        return findSlabs(cells, plans, storeys, nextId, params, Context{});
    }
    PlanScene& scene() { return m_scene; }
    std::vector<Wall>& walls(std::size_t storey) { return m_walls[storey]; }
    Level& level(std::size_t storey) { return m_levels[storey]; }

    static inline const Patch kPlan{{0, 0}, {8, 5}};
    static constexpr double kOuter_m2 = 8.6 * 5.6;

private:
    PlanScene m_scene;
    std::vector<Level> m_levels;
    std::vector<std::vector<Wall>> m_walls;
};

std::vector<const Slab*> ofKind(const SlabResult& result, SlabKind kind)
{
    std::vector<const Slab*> found;
    for (const Slab& s : result.slabs)
        if (s.kind == kind)
            found.push_back(&s);
    return found;
}

int countOf(const SlabResult& result, const std::string& code, ElementId element)
{
    int n = 0;
    for (const Diagnostic& d : result.diagnostics)
        n += d.code == code && d.element == element;
    return n;
}

TEST(FindSlabs, PutsTheOutlineOnTheOuterFaces)
{
    House house;
    house.addStorey();
    const SlabResult result = house.slabs();
    const auto floors = ofKind(result, SlabKind::Floor);
    ASSERT_EQ(floors.size(), 1U);
    EXPECT_EQ(floors[0]->outline.outer.size(), 4U);
    EXPECT_NEAR(area(floors[0]->outline), House::kOuter_m2, kExact_m2);
    EXPECT_DOUBLE_EQ(floors[0]->top_m, 0.0);
    EXPECT_EQ(floors[0]->thickness.provenance, Provenance::Assumed);
    EXPECT_DOUBLE_EQ(floors[0]->thickness.value_m, SlabParams{}.defaultThickness_m);
    EXPECT_EQ(countOf(result, "ThicknessAssumed", floors[0]->id), 1);
    EXPECT_EQ(floors[0]->evidence.facesSeen, 1);
    EXPECT_EQ(floors[0]->evidence.points, 2U * 320U * 200U);                        // two a cell of 2.5 cm
    EXPECT_NEAR(floors[0]->evidence.faceCoverage[0], 40 / House::kOuter_m2, 0.01);  // pixels of 5 cm along 26 m
    EXPECT_DOUBLE_EQ(floors[0]->evidence.labelShare, 1.0);
}

TEST(FindSlabs, MeasuresTheThicknessBetweenCeilingAndFloor)
{
    House house;
    house.addStorey();
    house.addStorey();
    const SlabResult result = house.slabs();
    const auto floors = ofKind(result, SlabKind::Floor);
    ASSERT_EQ(floors.size(), 2U);
    EXPECT_EQ(floors[1]->storey, ElementId{2});
    EXPECT_EQ(floors[1]->thickness.provenance, Provenance::Measured);
    EXPECT_NEAR(floors[1]->thickness.value_m, 0.25, 1e-6);  // heights are floats, without noise
    EXPECT_EQ(countOf(result, "ThicknessAssumed", floors[1]->id), 0);
    EXPECT_EQ(floors[1]->evidence.facesSeen, 2);
    EXPECT_TRUE(floors[1]->outline.holes.empty());
}

TEST(FindSlabs, DoesNotTakeASuspendedCeilingForTheUnderside)
{
    House house;
    house.addStorey({}, {}, 2.1);
    house.addStorey();
    const SlabResult result = house.slabs();
    const auto floors = ofKind(result, SlabKind::Floor);
    ASSERT_EQ(floors.size(), 2U);
    EXPECT_EQ(floors[1]->thickness.provenance, Provenance::Assumed);
    EXPECT_EQ(countOf(result, "UndersideImplausible", floors[1]->id), 1);
}

TEST(FindSlabs, LeavesAHoleWhereOneSeesThrough)
{
    const Patch stair{{6, 0}, {8, 3}};
    House house;
    house.addStorey({}, {stair});
    house.addStorey({stair});
    const SlabResult result = house.slabs();
    const auto floors = ofKind(result, SlabKind::Floor);
    ASSERT_EQ(floors.size(), 2U);
    ASSERT_EQ(floors[1]->outline.holes.size(), 1U);
    EXPECT_EQ(floors[1]->outline.holes[0].size(), 4U);
    EXPECT_NEAR(-signedArea(floors[1]->outline.holes[0]), 6, 0.05 * 5);  // a pixel along the two free sides
    for (const Eigen::Vector2d& p : floors[1]->outline.holes[0])
    {
        // The sides at the walls lie on their faces.
        EXPECT_LT(p.x(), 8 + 1e-9);
        EXPECT_GT(p.y(), -1e-9);
    }
    EXPECT_TRUE(floors[0]->outline.holes.empty());
}

TEST(FindSlabs, MakesNoHoleOfAFurnitureShadow)
{
    const Patch cupboard{{6, 0}, {8, 3}};
    House house;
    house.addStorey();
    house.addStorey({cupboard});
    const SlabResult result = house.slabs();
    EXPECT_TRUE(ofKind(result, SlabKind::Floor)[1]->outline.holes.empty());
}

TEST(FindSlabs, MakesNoHoleWhereNothingWasSeenAtAll)
{
    const Patch unseen{{6, 0}, {8, 3}};
    House house;
    house.addStorey({unseen}, {unseen});
    house.addStorey({unseen}, {unseen});
    EXPECT_TRUE(ofKind(house.slabs(), SlabKind::Floor)[1]->outline.holes.empty());
}

TEST(FindSlabs, PutsARoofOnALevelCeiling)
{
    House house;
    house.addStorey();
    house.addStorey();
    const SlabResult result = house.slabs();
    const auto roofs = ofKind(result, SlabKind::Roof);
    ASSERT_EQ(roofs.size(), 1U);
    EXPECT_EQ(roofs[0]->storey, ElementId{2});
    EXPECT_NEAR(area(roofs[0]->outline), House::kOuter_m2, kExact_m2);
    EXPECT_NEAR(roofs[0]->top_m - roofs[0]->thickness.value_m, 2.85 + 2.6, 1e-9);
    EXPECT_EQ(countOf(result, "ThicknessAssumed", roofs[0]->id), 1);
}

TEST(FindSlabs, PutsNoRoofOnASlopedCeiling)
{
    House house;
    house.addStorey();
    house.level(0).ceilingSeen = false;
    const SlabResult result = house.slabs();
    EXPECT_TRUE(ofKind(result, SlabKind::Roof).empty());
    EXPECT_EQ(countOf(result, "RoofNotLevel", ElementId{}), 1);
}

TEST(FindSlabs, LeavesWallsOutsideThatStickOut)
{
    House house;
    house.addStorey();
    house.walls(0).push_back(wallFrom(30, {8.3, 2.5}, {12.3, 2.5}));
    const auto result = house.slabs();
    ASSERT_EQ(ofKind(result, SlabKind::Floor).size(), 1U);
    EXPECT_NEAR(area(ofKind(result, SlabKind::Floor)[0]->outline), House::kOuter_m2, kExact_m2);
}

TEST(FindSlabs, FollowsTheSeenFloorWithoutAnyWalls)
{
    House house;
    house.addStorey();
    house.walls(0).clear();
    const auto result = house.slabs();
    ASSERT_EQ(ofKind(result, SlabKind::Floor).size(), 1U);
    EXPECT_EQ(ofKind(result, SlabKind::Floor)[0]->outline.outer.size(), 4U);
    EXPECT_NEAR(area(ofKind(result, SlabKind::Floor)[0]->outline), 8 * 5, 0.05 * 26);  // a pixel of 5 cm along 26 m
}

TEST(FindSlabs, SaysSoWhenAStoreyHasNone)
{
    PlanScene scene;
    const RoomPlan plan = planRooms(scene.cells(), levelAt(0.0, 2.6), {}, SpaceParams{}, Context{});
    std::uint32_t nextId = 100;
    const SlabResult result = findSlabs(scene.cells(), {plan}, {ElementId{1}}, nextId, SlabParams{}, Context{});
    EXPECT_TRUE(result.slabs.empty());
    EXPECT_EQ(countOf(result, "NoFloorSlab", ElementId{}), 1);
}

}  // namespace

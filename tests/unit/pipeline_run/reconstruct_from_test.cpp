// SPDX-License-Identifier: GPL-3.0-or-later
/// Single stages on a cloud, with what earlier runs and people left.
#include "core/pipeline/reconstruct_from.h"

#include "core/corrections/corrections.h"
#include "core/corrections/same.h"
#include "tests/support/building_dump.h"
#include "tests/support/plan_geometry.h"
#include "tests/support/stages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace s2b
{
namespace
{

using test::dump;
using test::HandMadeCloud;

constexpr double kCells_m = 0.01;  // half a cell: what one run may differ from another with other neighbours

/// Two storeys with a partition, a door and a column each.
const HandMadeCloud& house()
{
    static const HandMadeCloud kHouse = []
    {
        HandMadeCloud cloud(0.025);
        for (const double floor : {0.0, 2.9})
        {
            test::RoomGaps west, east;
            west.east = east.west = {{1.0, 1.9, 0.0, 2.1}};
            cloud.room({0, 0}, {4, 3}, floor, floor + 2.6, west);
            cloud.room({4.2, 0}, {8, 3}, floor, floor + 2.6, east);
            cloud.wallFace({4.1, 1.0}, {4.1, 1.9}, floor, floor + 2.1, Label::Door);
            cloud.mantle({6, 1.5}, 0.2, floor, floor + 2.6, Label::Column);
        }
        return cloud;
    }();
    return kHouse;
}

PipelineOptions only(std::set<Stage> stages)
{
    PipelineOptions options;
    options.stages = std::move(stages);
    return options;
}

Model whole()
{
    static const Building kFound = reconstruct(house().view(), {}, {});
    return {kFound, kFound, {}};
}

Model run(const Model& earlier, std::set<Stage> stages, std::optional<ElementId> storey = {})
{
    return reconstructFrom(house().view(), only(std::move(stages)), earlier, storey, {});
}

/// The partition of a storey: the wall with the door.
const Wall& partition(const Building& b, std::size_t storey)
{
    for (const Opening& o : b.openings)
        if (b.wall(o.host)->storey == b.storeys[storey].id && o.kind == OpeningKind::Door)
            return *b.wall(o.host);
    throw std::runtime_error("no door");
}

Building moved(Building b, ElementId id, double x)
{
    return moveElements(std::move(b), {{id, Eigen::Affine3d(Eigen::Translation3d(x, 0, 0))}});
}

std::size_t doorsIn(const Building& b, ElementId wall)
{
    return static_cast<std::size_t>(
        std::count_if(b.openings.begin(), b.openings.end(), [&](const Opening& o) { return o.host == wall; }));
}

TEST(ReconstructFrom, StageByStageGivesTheWhole)
{
    const Building levels = reconstruct(house().view(), only({Stage::Levels}), {});
    Model m{levels, levels, {}};
    m = run(m, {Stage::Walls});
    m = run(m, {Stage::Doors, Stage::Windows, Stage::Openings});
    m = run(m, {Stage::Columns});
    m = run(m, {Stage::Slabs, Stage::Spaces});
    const Building all = whole().found;
    ASSERT_EQ(m.corrected.walls.size(), all.walls.size());
    EXPECT_EQ(m.corrected.openings.size(), all.openings.size());
    EXPECT_EQ(m.corrected.columns.size(), all.columns.size());
    EXPECT_EQ(m.corrected.slabs.size(), all.slabs.size());
    EXPECT_EQ(m.corrected.spaces.size(), all.spaces.size());
    EXPECT_EQ(m.corrected.junctions.size(), all.junctions.size());
    EXPECT_EQ(m.corrected.diagnostics.size(), all.diagnostics.size());
    for (std::size_t i = 0; i < all.walls.size(); ++i)
    {
        EXPECT_LT((m.corrected.walls[i].start - all.walls[i].start).norm(), 1e-6);
        EXPECT_LT((m.corrected.walls[i].end - all.walls[i].end).norm(), 1e-6);
    }
    EXPECT_TRUE(correctedElements(m.found, m.corrected).empty());
}

TEST(ReconstructFrom, KeepsTheIdsOfWhatIsFoundAgain)
{
    const Model before = whole();
    const Model after = run(before, allStages());
    ASSERT_EQ(after.corrected.walls.size(), before.corrected.walls.size());
    for (const Wall& w : before.corrected.walls)
    {
        ASSERT_TRUE(after.corrected.wall(w.id)) << w.id.value;
        EXPECT_LT((after.corrected.wall(w.id)->start - w.start).norm(), kCells_m);
    }
    for (const Storey& s : before.corrected.storeys)
        EXPECT_TRUE(after.corrected.storey(s.id));
    EXPECT_EQ(after.corrected.junctions.size(), before.corrected.junctions.size());
    EXPECT_EQ(after.corrected.openings.size(), before.corrected.openings.size());
}

TEST(ReconstructFrom, KeepsCorrectionsOfTheStageThatRuns)
{
    Model m = whole();
    const ElementId shifted = partition(m.found, 0).id, removed = partition(m.found, 1).id;
    m.corrected = removeElement(moved(m.corrected, shifted, 0.5), removed);
    const Model after = run(m, {Stage::Walls});
    EXPECT_TRUE(isSame(*after.corrected.wall(shifted), *m.corrected.wall(shifted)));
    EXPECT_FALSE(after.corrected.wall(removed));
    EXPECT_TRUE(after.found.wall(removed));  // it can be brought back
    EXPECT_EQ(after.corrected.walls.size(), m.corrected.walls.size());
    EXPECT_EQ(doorsIn(after.corrected, shifted), 1u);
    EXPECT_THAT(correctedElements(after.found, after.corrected), testing::IsSupersetOf({shifted, removed}));
    const Building reset = resetElement(after.corrected, after.found, shifted);
    EXPECT_LT((reset.wall(shifted)->start - partition(whole().found, 0).start).norm(), kCells_m);
}

TEST(ReconstructFrom, GivenLevelsGiveOtherWalls)
{
    Model m = whole();
    const ElementId upper = m.corrected.storeys[1].id;
    m.corrected = moveLevel(m.corrected, upper, m.corrected.storeys[1].elevation_m + 0.4);
    const Model after = run(m, {Stage::Walls});
    EXPECT_NEAR(after.corrected.storey(upper)->elevation_m, 3.3, kCells_m);
    int onUpper = 0;
    for (const Wall& w : after.corrected.walls)
        if (w.storey == upper)
        {
            ++onUpper;
            EXPECT_NEAR(w.base_m, 3.3, kCells_m);
        }
    EXPECT_EQ(onUpper, 5);

    m = whole();
    m.corrected = removeElement(m.corrected, upper);
    EXPECT_EQ(run(m, {Stage::Walls}).corrected.walls.size(), 5u);
}

TEST(ReconstructFrom, LevelsStayAsPeopleLeftThem)
{
    Model m = whole();
    const ElementId lower = m.corrected.storeys[0].id, upper = m.corrected.storeys[1].id;
    m.corrected = moveLevel(m.corrected, upper, 3.0);
    m = renameElement(m, upper, "Attic");
    m.corrected = addLevel(m.corrected, -2.8);
    const Model after = run(m, {Stage::Levels});
    ASSERT_EQ(after.corrected.storeys.size(), 3u);
    EXPECT_NEAR(after.corrected.storeys[0].elevation_m, -2.8, 1e-9);
    EXPECT_EQ(after.corrected.storeys[1].id, lower);
    EXPECT_EQ(after.corrected.storeys[2].name, "Attic");
    EXPECT_EQ(after.corrected.storeys[2].elevation_m, 3.0);
    EXPECT_EQ(after.corrected.walls.size(), m.corrected.walls.size());

    m = whole();
    m.corrected = removeElement(m.corrected, upper);
    EXPECT_EQ(run(m, {Stage::Levels}).corrected.storeys.size(), 1u);  // what was taken out is not found again
}

TEST(ReconstructFrom, TakesLevelsThatAreGivenForFoundOnes)
{
    const Model earlier = whole();
    PipelineOptions options = only({Stage::Levels, Stage::Walls});
    options.levels = {{0.3, 2.6}, {2.9, 5.3, false}};
    const Model after = reconstructFrom(house().view(), options, earlier, std::nullopt, {});
    ASSERT_EQ(after.corrected.storeys.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i)
    {
        const Storey& s = after.corrected.storeys[i];
        EXPECT_EQ(s.id, earlier.corrected.storeys[i].id);
        // World heights, in a frame whose zero is the lowest floor that was found.
        EXPECT_NEAR(after.corrected.frame.origin.z() + s.elevation_m, options.levels[i].floor_m, 1e-9);
        EXPECT_NEAR(s.height.value_m, options.levels[i].ceiling_m - options.levels[i].floor_m, 1e-9);
    }
    EXPECT_EQ(after.corrected.storeys[0].height.provenance, Provenance::Corrected);
    EXPECT_EQ(after.corrected.storeys[1].height.provenance, Provenance::Assumed);  // nobody says that it was seen
    for (const Wall& w : after.corrected.walls)
        if (w.storey == after.corrected.storeys[0].id)
        {
            EXPECT_NEAR(w.base_m, after.corrected.storeys[0].elevation_m, kCells_m);
        }

    // Other stages stand on the model's own, and an order that is none is refused.
    options.stages = {Stage::Walls};
    const Model walls = reconstructFrom(house().view(), options, earlier, std::nullopt, {});
    EXPECT_EQ(walls.corrected.storeys[0].elevation_m, earlier.corrected.storeys[0].elevation_m);
    options.stages = {Stage::Levels};
    options.levels = {{2.9, 5.5}, {0.0, 2.6}};
    EXPECT_THROW((void)reconstructFrom(house().view(), options, earlier, std::nullopt, {}), Error);
}

TEST(ReconstructFrom, GivenWallsGiveOtherDoors)
{
    Model m = whole();
    const Wall wall = partition(m.found, 0);
    m.corrected = removeElement(m.corrected, wall.id);
    EXPECT_EQ(run(m, {Stage::Doors}).corrected.openings.size(), 1u);  // of the other storey
    m.corrected = addWall(m.corrected, {wall.storey, wall.start, wall.end, wall.thickness});
    const ElementId added = m.corrected.walls.back().id;
    const Model after = run(m, {Stage::Doors});
    EXPECT_EQ(doorsIn(after.corrected, added), 1u);
    EXPECT_TRUE(after.corrected.wall(added));
}

TEST(ReconstructFrom, RenewsOnlyTheStoreyThatIsAskedFor)
{
    const Model m = whole();
    const ElementId lower = m.found.storeys[0].id;
    PipelineOptions options = only({Stage::Walls});
    options.parameters.walls.minimumLength_m = 3.5;  // leaves the long walls alone
    options.parameters.walls.minimumFreeLength_m = 3.5;
    const Model after = reconstructFrom(house().view(), options, m, lower, {});
    const auto count = [&](const Model& model, ElementId storey)
    { return std::ranges::count(model.corrected.walls, storey, &Wall::storey); };
    EXPECT_LT(count(after, lower), 5);
    EXPECT_EQ(count(after, m.found.storeys[1].id), 5);
    for (const Wall& w : m.corrected.walls)
        EXPECT_TRUE(w.storey == lower || isSame(w, *after.corrected.wall(w.id)));
    for (const Opening& o : after.corrected.openings)
        EXPECT_TRUE(after.corrected.wall(o.host));
    for (const Junction& j : after.corrected.junctions)
        EXPECT_TRUE(after.corrected.wall(j.wallA) && after.corrected.wall(j.wallB));
}

TEST(ReconstructFrom, GivesNewElementsIdsOfTheirOwn)
{
    Model m = whole();
    m.corrected = addWall(m.corrected, {m.corrected.storeys[0].id, {1, 1}, {3, 1}, {0.1, Provenance::Assumed, 0}});
    m = run(m, allStages());
    std::set<std::uint32_t> ids;
    std::size_t elements = 0;
    const auto take = [&](const auto& list)
    {
        for (const auto& e : list)
            ids.insert(e.id.value), ++elements;
    };
    const Building& b = m.corrected;
    take(b.storeys), take(b.walls), take(b.openings), take(b.columns), take(b.slabs), take(b.spaces);
    EXPECT_EQ(ids.size(), elements);
}

TEST(ReconstructFrom, DoesNotDependOnTheThreads)
{
    Model m = whole();
    m.corrected = moved(m.corrected, partition(m.found, 0).id, 0.3);
    Context one, three;
    one.threads = 1;
    three.threads = 3;
    const PipelineOptions options = only({Stage::Walls, Stage::Doors, Stage::Columns, Stage::Slabs, Stage::Spaces});
    const Model a = reconstructFrom(house().view(), options, m, {}, one);
    const Model b = reconstructFrom(house().view(), options, m, {}, three);
    EXPECT_EQ(dump(a.corrected), dump(b.corrected));
    EXPECT_EQ(dump(a.found), dump(b.found));
}

TEST(ReconstructFrom, RefusesWhatItCanNotDo)
{
    EXPECT_THROW(run(whole(), {Stage::Walls}, ElementId{9999}), Error);
    EXPECT_THROW(run(Model{}, {Stage::Walls}), Error);
}

}  // namespace
}  // namespace s2b

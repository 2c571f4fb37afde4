// SPDX-License-Identifier: GPL-3.0-or-later
/// The whole run on hand-made clouds: what it refuses, how it stops, and what it never changes.
#include "core/pipeline/pipeline.h"
#include "tests/support/building_dump.h"
#include "tests/support/plan_geometry.h"
#include "tests/support/stages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace s2b
{
namespace
{

using test::dump;
using test::HandMadeCloud;

/// Two storeys with a partition, a door and a column each.
HandMadeCloud building(double spacing = 0.025)
{
    HandMadeCloud cloud(spacing);
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
}

ErrorCode codeOf(const CloudView& view)
{
    try
    {
        (void)reconstruct(view, {}, {});
    }
    catch (const Error& e)
    {
        EXPECT_FALSE(std::string(e.what()).empty());
        return e.code();
    }
    return ErrorCode::Internal;
}

TEST(Reconstruct, FindsWhatStandsThere)
{
    const Building b = reconstruct(building().view(), {}, {});
    EXPECT_EQ(b.storeys.size(), 2u);
    EXPECT_EQ(b.walls.size(), 10u);  // two long and two short outer ones and the partition, on each storey
    EXPECT_EQ(b.columns.size(), 2u);
    EXPECT_EQ(std::count_if(b.openings.begin(), b.openings.end(),
                            [](const Opening& o) { return o.kind == OpeningKind::Door; }),
              2);
    EXPECT_EQ(b.openings.size(), 2u);
}

TEST(Reconstruct, GivesEveryElementItsOwnId)
{
    const Building b = reconstruct(building().view(), {}, {});
    std::set<std::uint32_t> ids;
    std::size_t elements = 0;
    const auto take = [&](const auto& list)
    {
        for (const auto& e : list)
        {
            EXPECT_NE(e.id.value, 0u);
            ids.insert(e.id.value);
            ++elements;
        }
    };
    take(b.storeys), take(b.walls), take(b.openings), take(b.columns), take(b.slabs), take(b.spaces);
    EXPECT_EQ(ids.size(), elements);
    for (const Opening& o : b.openings)
        EXPECT_NE(b.wall(o.host), nullptr);
    for (const Wall& w : b.walls)
        EXPECT_NE(b.storey(w.storey), nullptr);
    for (const Junction& j : b.junctions)
        EXPECT_TRUE(b.wall(j.wallA) && b.wall(j.wallB));
}

TEST(Reconstruct, RefusesAnEmptyCloud)
{
    EXPECT_EQ(codeOf({}), ErrorCode::EmptyCloud);
    const float one[3] = {0, 0, 0};
    EXPECT_EQ(codeOf({one, 0, Eigen::Vector3d::Zero(), nullptr}), ErrorCode::EmptyCloud);
}

TEST(Reconstruct, NamesAPointThatIsNotFinite)
{
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
    {
        HandMadeCloud cloud = building();
        cloud.cloud().points[1234].z() = bad;
        try
        {
            (void)reconstruct(cloud.view(), {}, {});
            FAIL();
        }
        catch (const Error& e)
        {
            EXPECT_EQ(e.code(), ErrorCode::BadCoordinates);
            EXPECT_THAT(e.what(), testing::HasSubstr("1234"));
        }
    }
    const float nothingFinite[3] = {NAN, NAN, NAN};
    EXPECT_EQ(codeOf({nothingFinite, 1, Eigen::Vector3d::Zero(), nullptr}), ErrorCode::BadCoordinates);
}

TEST(Reconstruct, ExplainsAnEmptyResult)
{
    HandMadeCloud point;
    point.point({1, 2, 3}, Label::Wall);
    HandMadeCloud upright;
    upright.wallFace({0, 0}, {3, 0}, 0, 2.6);
    HandMadeCloud equal;
    for (int i = 0; i < 1000; ++i)
        equal.point({1, 2, 3}, Label::Floor);
    for (const HandMadeCloud* cloud : {&point, &upright, &equal})
        for (const bool geometryOnly : {false, true})
        {
            PipelineOptions options;
            options.geometryOnly = geometryOnly;
            const Building b = reconstruct(cloud->view(), options, {});
            EXPECT_TRUE(b.walls.empty());
            EXPECT_FALSE(b.diagnostics.empty());
        }
}

TEST(Reconstruct, ReportsProgressThatNeverDecreases)
{
    Context context;
    double last = 0;
    int reports = 0;
    context.progress = [&](std::string_view text, double fraction)
    {
        EXPECT_FALSE(text.empty());
        EXPECT_GE(fraction, last);
        EXPECT_LE(fraction, 1.0);
        last = fraction;
        ++reports;
    };
    (void)reconstruct(building().view(), {}, context);
    EXPECT_GE(reports, 8);
    EXPECT_GT(last, 0.7);
}

TEST(Reconstruct, StopsAtEveryStepItReports)
{
    const HandMadeCloud cloud = building(0.05);
    int steps = 0;
    Context counting;
    counting.progress = [&](std::string_view, double) { ++steps; };
    const std::string before = dump(reconstruct(cloud.view(), {}, counting));
    for (int stopAt = 1; stopAt <= steps; ++stopAt)
    {
        std::stop_source stop;
        Context context;
        context.cancel = stop.get_token();
        int step = 0;
        std::string where;
        context.progress = [&](std::string_view text, double)
        {
            if (++step == stopAt)
            {
                where = text;
                stop.request_stop();
            }
            EXPECT_LE(step, stopAt) << "went on after " << where;
        };
        EXPECT_THROW((void)reconstruct(cloud.view(), {}, context), Cancelled) << "at " << where;
    }
    // Nothing is left behind: the next run gives what the first one gave. (Leaks show in the sanitizer builds.)
    EXPECT_EQ(dump(reconstruct(cloud.view(), {}, {})), before);
}

TEST(Reconstruct, LeavesTheCloudAlone)
{
    HandMadeCloud cloud = building();
    const PointCloud before = cloud.cloud();
    (void)reconstruct(cloud.view(), {}, {});
    EXPECT_EQ(cloud.cloud().points, before.points);
    EXPECT_EQ(cloud.cloud().labels, before.labels);
}

TEST(Reconstruct, IsTheSameForAnyOrderAndAnyNumberOfThreads)
{
    HandMadeCloud cloud = building();
    Context one, two, many;
    one.threads = 1, two.threads = 2, many.threads = 5;
    const std::string expected = dump(reconstruct(cloud.view(), {}, one));
    EXPECT_EQ(dump(reconstruct(cloud.view(), {}, two)), expected);
    EXPECT_EQ(dump(reconstruct(cloud.view(), {}, many)), expected);
    cloud.shuffle(4);
    EXPECT_EQ(dump(reconstruct(cloud.view(), {}, two)), expected);
}

TEST(Reconstruct, KeepsTheOriginInDoubles)
{
    HandMadeCloud cloud = building();
    const Building near = reconstruct(cloud.view(), {}, {});
    cloud.cloud().origin = {2600000.125, 1200000.0625, 431.5};
    const Building far = reconstruct(cloud.view(), {}, {});
    ASSERT_EQ(near.walls.size(), far.walls.size());
    for (std::size_t i = 0; i < near.walls.size(); ++i)
    {
        const auto world = [&](const Building& b)
        { return b.frame.toWorld({b.walls[i].start.x(), b.walls[i].start.y(), b.walls[i].base_m}); };
        // A double's spacing at 2.6e6 m is 5e-10 m.
        EXPECT_LT((world(far) - world(near) - cloud.cloud().origin).norm(), 1e-8);
    }
}

TEST(Reconstruct, RunsTheStagesAskedForOnly)
{
    const HandMadeCloud cloud = building();
    const auto with = [&](std::string_view stages)
    {
        PipelineOptions options;
        options.stages = parseStages(stages);
        return reconstruct(cloud.view(), options, {});
    };
    const Building levels = with("levels");
    EXPECT_EQ(levels.storeys.size(), 2u);
    EXPECT_TRUE(levels.walls.empty() && levels.openings.empty() && levels.columns.empty());
    const Building walls = with("walls");
    EXPECT_EQ(walls.walls.size(), 10u);
    EXPECT_TRUE(walls.openings.empty() && walls.columns.empty());
    EXPECT_EQ(with("columns").columns.size(), 2u);
    EXPECT_TRUE(with("columns").walls.empty());
    EXPECT_TRUE(with("windows").openings.empty());
    EXPECT_EQ(with("doors").openings.size(), 2u);
}

TEST(Reconstruct, GeometryOnlyDoesNotReadTheLabels)
{
    HandMadeCloud cloud = building();
    PipelineOptions options;
    options.geometryOnly = true;
    const std::string expected = dump(reconstruct(cloud.view(false), {}, {}));
    EXPECT_EQ(dump(reconstruct(cloud.view(), options, {})), expected);
    cloud.setLabels(Label::Furniture);
    EXPECT_EQ(dump(reconstruct(cloud.view(), options, {})), expected);
}

}  // namespace
}  // namespace s2b

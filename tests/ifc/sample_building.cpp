// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample_building.h"

#include <cmath>

namespace s2b::test
{
namespace
{

Dimension measured(double value)
{
    return {value, Provenance::Measured, 0.004};
}

Wall wall(unsigned id, unsigned storey, Eigen::Vector2d start, Eigen::Vector2d end, double base)
{
    Wall w;
    w.id = {id};
    w.storey = {storey};
    w.start = start;
    w.end = end;
    w.bodyEnd_m = (end - start).norm();
    w.base_m = base;
    w.height = measured(2.8);
    w.thickness = measured(0.2);
    w.evidence = {12345, {0.9, 0.75}, 2, 0.004, 0.97};
    return w;
}

Opening opening(unsigned id, unsigned host, OpeningKind kind, double offset, double width, double height, double sill)
{
    Opening o;
    o.id = {id};
    o.host = {host};
    o.kind = kind;
    o.offset_m = offset;
    o.width = measured(width);
    o.height = measured(height);
    o.sill = {sill, Provenance::Assumed, 0.0};
    o.evidence = {321, {0.5, 0.0}, 1, 0.008, 0.6};
    return o;
}

}  // namespace

Building sampleBuilding()
{
    Building b;
    b.frame.origin = {100.0, 200.0, 30.0};
    b.frame.yaw_rad = 0.3;
    b.storeys = {{{1}, "Level 0", 0.0, measured(2.8)}, {{2}, "Étage 1 – 日本", 3.1, {2.6, Provenance::Assumed, 0.0}}};

    // Ground floor: 10 m x 6 m, with its corners mitred by body extents; a partition; an oblique wall; an arc.
    b.walls.push_back(wall(10, 1, {0, 0}, {10, 0}, 0.0));
    b.walls.push_back(wall(11, 1, {10, 0}, {10, 6}, 0.0));
    b.walls.push_back(wall(12, 1, {10, 6}, {0, 6}, 0.0));
    b.walls.push_back(wall(13, 1, {0, 6}, {0, 0}, 0.0));
    for (int i = 0; i < 4; ++i)
    {
        Wall& w = b.walls[static_cast<std::size_t>(i)];
        const double overlap =
            i % 2 == 0 ? 0.1 : -0.1;  // the long walls run through, the short ones end at their faces
        w.bodyStart_m -= overlap;
        w.bodyEnd_m += overlap;
        w.isExternal = true;
        w.isExternalKnown = true;
    }
    b.walls.push_back(wall(14, 1, {5, 0}, {5, 6}, 0.0));
    b.walls.back().bodyStart_m = 0.1;
    b.walls.back().bodyEnd_m -= 0.1;
    b.walls.back().thickness = {0.1, Provenance::Assumed, 0.0};
    b.walls.back().isExternalKnown = true;
    b.walls.push_back(wall(15, 1, {12, 1}, {15, 3}, 0.0));
    b.walls.push_back(wall(16, 1, {15, 3}, {12, 6}, 0.0));
    b.walls.back().bulge = 0.4;
    b.walls.back().bodyEnd_m = b.walls.back().axisLength_m();
    b.walls.push_back(wall(17, 1, {-2, 1}, {-2, 5}, 0.0));
    b.walls.back().bulge = -1.0;  // a half circle, clockwise
    b.walls.back().bodyEnd_m = b.walls.back().axisLength_m();

    // Upper floor: a gable, a shed wall that ends at its base, a curved wall under a sloped top.
    b.walls.push_back(wall(20, 2, {0, 0}, {0, 6}, 3.1));
    b.walls.back().topProfile = {{0.0, 4.1}, {3.0, 6.1}, {6.0, 4.1}};
    b.walls.push_back(wall(21, 2, {0, 0}, {6, 0}, 3.1));
    b.walls.back().topProfile = {{0.0, 3.1}, {6.0, 5.1}};
    b.walls.push_back(wall(22, 2, {6, 0}, {6, 6}, 3.1));
    b.walls.back().bulge = 0.3;
    b.walls.back().bodyEnd_m = b.walls.back().axisLength_m();
    b.walls.back().topProfile = {{0.0, 5.1}, {3.0, 6.1}, {b.walls.back().bodyEnd_m, 4.1}};

    b.openings.push_back(opening(30, 10, OpeningKind::Door, 1.0, 1.01, 2.13, 0.0));
    b.openings.back().leaves = 1;
    b.openings.back().leafState = LeafState::Open;
    b.openings.back().hingeAtStart = true;
    b.openings.back().opensToLeft = true;
    b.openings.push_back(opening(31, 14, OpeningKind::Door, 2.0, 0.9, 2.1, 0.0));
    b.openings.back().leaves = 1;
    b.openings.back().leafState = LeafState::Open;
    b.openings.back().hingeAtStart = true;
    b.openings.push_back(opening(32, 12, OpeningKind::Door, 6.0, 1.8, 2.2, 0.0));
    b.openings.back().leaves = 2;
    b.openings.back().leafState = LeafState::Open;
    b.openings.back().opensToLeft = true;
    b.openings.push_back(opening(33, 11, OpeningKind::Door, 2.0, 0.9, 2.1, 0.02));
    b.openings.back().leafState = LeafState::Removed;
    b.openings.push_back(opening(34, 10, OpeningKind::Window, 6.0, 1.5, 1.2, 0.9));
    b.openings.push_back(opening(35, 13, OpeningKind::Plain, 2.0, 1.2, 2.0, 0.0));
    b.openings.push_back(opening(36, 16, OpeningKind::Window, 1.5, 1.0, 1.0, 1.0));
    b.openings.push_back(opening(37, 20, OpeningKind::Window, 2.5, 1.0, 1.0, 0.8));
    b.openings.push_back(opening(38, 15, OpeningKind::Door, 1.0, 0.8, 2.0, 0.0));
    b.openings.back().leafState = LeafState::Closed;

    Column rectangle;
    rectangle.id = {40};
    rectangle.storey = {1};
    rectangle.center = {2.5, 3.0};
    rectangle.yaw_rad = 0.5;
    rectangle.height = measured(2.8);
    rectangle.section = RectangleSection{0.4, 0.3};
    rectangle.evidence = {99, {0.5, 0.5}, 2, 0.002, 1.0};
    b.columns.push_back(rectangle);
    Column circle = rectangle;
    circle.id = {41};
    circle.center = {7.5, 3.0};
    circle.section = CircleSection{0.2};
    b.columns.push_back(circle);
    unsigned id = 42;
    for (const ProfileSection& section : {ProfileSection{ProfileShape::I, 0.30, 0.28, 0.011, 0.019},
                                          ProfileSection{ProfileShape::L, 0.25, 0.20, 0.020, 0.020},
                                          ProfileSection{ProfileShape::U, 0.10, 0.30, 0.010, 0.016},
                                          ProfileSection{ProfileShape::T, 0.30, 0.15, 0.011, 0.019}})
    {
        Column column = rectangle;
        column.id = {id};
        column.center = {1.0 + 0.9 * (id - 42), 4.5};
        column.yaw_rad = 0.4 * (id - 41);
        column.section = section;
        b.columns.push_back(column);
        ++id;
    }

    Slab floor;
    floor.id = {50};
    floor.storey = {1};
    floor.outline.outer = {{-0.1, -0.1}, {10.1, -0.1}, {10.1, 6.1}, {-0.1, 6.1}};
    floor.outline.holes = {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}, {{8, 4}, {8, 5}, {9, 5}}};
    floor.thickness = {0.25, Provenance::Assumed, 0.0};
    b.slabs.push_back(floor);
    Slab roof = floor;
    roof.id = {51};
    roof.storey = {2};
    roof.kind = SlabKind::Roof;
    roof.outline.holes.clear();
    roof.top_m = 6.4;
    b.slabs.push_back(roof);

    Space room;
    room.id = {60};
    room.storey = {1};
    room.name = "Büro";
    room.outline.outer = {{0.1, 0.1}, {4.95, 0.1}, {4.95, 5.9}, {0.1, 5.9}};
    room.height = measured(2.8);
    room.boundedBy = {{10}, {12}, {13}, {14}};
    b.spaces.push_back(room);
    room.id = {61};
    room.name = "Room 2";
    room.outline.outer = {{5.05, 0.1}, {9.9, 0.1}, {9.9, 5.9}, {5.05, 5.9}};
    room.outline.holes = {{{7.3, 2.8}, {7.3, 3.2}, {7.7, 3.2}, {7.7, 2.8}}};
    room.boundedBy = {{11}, {14}};
    b.spaces.push_back(room);

    b.junctions = {{{10}, {11}, JunctionEnd::End, JunctionEnd::Start},
                   {{11}, {12}, JunctionEnd::End, JunctionEnd::Start},
                   {{14}, {10}, JunctionEnd::Start, JunctionEnd::Path},
                   {{15}, {16}, JunctionEnd::End, JunctionEnd::Start}};
    b.diagnostics = {
        {Severity::Warning, "walls", "ThicknessAssumed", "Only one face was seen; \"0.1 m\" isn't measured", {14}, {}}};
    return b;
}

Building manyWalls(int count)
{
    Building b;
    b.storeys = {{{1}, "Level 0", 0.0, measured(2.8)}};
    const int perRow = static_cast<int>(std::ceil(std::sqrt(count)));
    for (int i = 0; i < count; ++i)
    {
        const Eigen::Vector2d start(5.0 * (i % perRow), 3.0 * (i / perRow));
        // Every wall and door differs a little, as measured ones do.
        Wall w = wall(static_cast<unsigned>(2 + 2 * i), 1, start,
                      start + Eigen::Vector2d(4.0 + 1e-4 * i, 0.01 * (i % 7)), 0.0);
        w.thickness.value_m = 0.1 + 1e-5 * i;
        w.evidence.rms_m = 1e-6 * i;
        b.walls.push_back(w);
        b.openings.push_back(
            opening(static_cast<unsigned>(3 + 2 * i), w.id.value, OpeningKind::Door, 1.0, 0.9 + 1e-5 * i, 2.1, 0.0));
        b.openings.back().evidence.rms_m = 1e-6 * i;
    }
    return b;
}

Building oneWall()
{
    Building b;
    b.storeys = {{{1}, "Level 0", 0.0, measured(2.8)}};
    b.walls.push_back(wall(2, 1, {0, 0}, {6, 0}, 0.0));
    return b;
}

}  // namespace s2b::test

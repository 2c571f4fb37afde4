// SPDX-License-Identifier: GPL-3.0-or-later
/// A house of one storey to correct: 8 x 5 m, a partition with a door, a window, a column, a floor and two spaces.
#pragma once

#include "core/base/error.h"
#include "core/corrections/corrections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace s2b::test
{

inline constexpr ElementId kStorey{1}, kSouth{2}, kEast{3}, kNorth{4}, kWest{5}, kPartition{6}, kDoor{7}, kWindow{8},
    kColumn{9}, kFloor{10}, kRoomA{11}, kRoomB{12};

inline Wall straightWall(ElementId id, Eigen::Vector2d start, Eigen::Vector2d end, double thickness, double before,
                         double beyond)
{
    Wall w;
    w.id = id;
    w.storey = kStorey;
    w.start = start;
    w.end = end;
    w.bodyStart_m = -before;
    w.bodyEnd_m = (end - start).norm() + beyond;
    w.height = {2.6, Provenance::Measured, 0.001};
    w.thickness = {thickness, Provenance::Measured, 0.002};
    w.evidence.points = 1000;
    w.evidence.facesSeen = 2;
    w.evidence.faceCoverage = {0.9, 0.8};
    return w;
}

inline Space room(ElementId id, double x0, double x1, ElementId end)
{
    Space s;
    s.id = id;
    s.storey = kStorey;
    s.name = id == kRoomA ? "0.01" : "0.02";
    s.outline.outer = {{x0, 0.15}, {x1, 0.15}, {x1, 4.85}, {x0, 4.85}};
    s.height = {2.6, Provenance::Measured, 0.0};
    s.area_m2 = (x1 - x0) * 4.7;
    s.boundedBy = {kSouth, kNorth, kPartition, end};
    return s;
}

inline Building house()
{
    Building b;
    b.storeys.push_back({kStorey, "Level 0", 0.0, {2.6, Provenance::Measured, 0.0}});
    // The long walls run through at the corners, the short ones and the partition end at their faces.
    b.walls = {
        straightWall(kSouth, {0, 0}, {8, 0}, 0.3, 0.15, 0.15), straightWall(kEast, {8, 0}, {8, 5}, 0.3, -0.15, -0.15),
        straightWall(kNorth, {8, 5}, {0, 5}, 0.3, 0.15, 0.15), straightWall(kWest, {0, 5}, {0, 0}, 0.3, -0.15, -0.15),
        straightWall(kPartition, {5, 0}, {5, 5}, 0.1, -0.15, -0.15)};
    b.junctions = {{kSouth, kEast, JunctionEnd::End, JunctionEnd::Start},
                   {kEast, kNorth, JunctionEnd::End, JunctionEnd::Start},
                   {kNorth, kWest, JunctionEnd::End, JunctionEnd::Start},
                   {kWest, kSouth, JunctionEnd::End, JunctionEnd::Start},
                   {kPartition, kSouth, JunctionEnd::Start, JunctionEnd::Path},
                   {kPartition, kNorth, JunctionEnd::End, JunctionEnd::Path}};
    Opening door;
    door.id = kDoor;
    door.host = kPartition;
    door.kind = OpeningKind::Door;
    door.offset_m = 2.0;
    door.width = {0.9, Provenance::Measured, 0.0};
    door.height = {2.1, Provenance::Measured, 0.0};
    door.sill = {0.0, Provenance::Measured, 0.0};
    Opening window = door;
    window.id = kWindow;
    window.host = kSouth;
    window.kind = OpeningKind::Window;
    window.offset_m = 1.0;
    window.width.value_m = 1.2;
    window.height.value_m = 1.3;
    window.sill.value_m = 0.9;
    b.openings = {door, window};
    Column column;
    column.id = kColumn;
    column.storey = kStorey;
    column.center = {2.5, 2.5};
    column.height = {2.6, Provenance::Measured, 0.0};
    column.section = RectangleSection{0.3, 0.4};
    b.columns = {column};
    Slab floor;
    floor.id = kFloor;
    floor.storey = kStorey;
    floor.outline.outer = {{-0.15, -0.15}, {8.15, -0.15}, {8.15, 5.15}, {-0.15, 5.15}};
    floor.thickness = {0.2, Provenance::Assumed, 0.0};
    b.slabs = {floor};
    b.spaces = {room(kRoomA, 0.15, 4.95, kWest), room(kRoomB, 5.05, 7.85, kEast)};
    return b;
}

inline const Opening& opening(const Building& b, ElementId id)
{
    return *std::find_if(b.openings.begin(), b.openings.end(), [&](const Opening& o) { return o.id == id; });
}

inline const Column& column(const Building& b, ElementId id)
{
    return *std::find_if(b.columns.begin(), b.columns.end(), [&](const Column& c) { return c.id == id; });
}

/// What the refusal says.
template <typename Function>
std::string refusal(const Function& function)
{
    try
    {
        (void)function();
    }
    catch (const Error& e)
    {
        EXPECT_EQ(e.code(), ErrorCode::BadParameter);
        return e.what();
    }
    return "nothing was refused";
}

}  // namespace s2b::test

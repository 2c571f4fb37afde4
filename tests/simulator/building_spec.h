// SPDX-License-Identifier: GPL-3.0-or-later
/// Parametric buildings: what to ask for, and what comes out of it.
#pragma once

#include "core/labels/label.h"
#include "core/model/building.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace s2b::sim
{

/// A closed interval that a length is drawn from [m].
struct Range
{
    double min_m = 0.0;
    double max_m = 0.0;
};

enum class Layout
{
    OneRoom,   ///< four exterior walls
    TwoRooms,  ///< four exterior walls and one partition
    Corridor   ///< rooms on both sides of a corridor
};

/// What to build. Everything that is not fixed is drawn from the seed; switching one feature off leaves the others as
/// they are.
struct BuildingSpec
{
    std::uint64_t seed = 1;
    Layout layout = Layout::Corridor;
    int storeys = 2;       ///< 1 to 50
    int roomsPerSide = 4;  ///< of the corridor, 2 to 100

    double yaw_deg = 0.0;  ///< of the building in the world
    Eigen::Vector3d origin =
        Eigen::Vector3d::Zero();  ///< world coordinates of the building's corner at the lowest floor [m]

    Range roomWidth_m{3.2, 5.6};      ///< along the corridor, between axes
    Range roomDepth_m{4.4, 5.6};      ///< across the corridor, between axes
    Range corridorWidth_m{1.9, 2.5};  ///< between axes
    Range clearHeight_m{2.6, 3.0};    ///< floor to the slab above, one draw for the building
    Range slabThickness_m{0.24, 0.32};
    std::vector<double> exteriorThickness_m{0.30, 0.365, 0.42, 0.45};
    std::vector<double> partitionThickness_m{0.10, 0.125, 0.15, 0.175, 0.24};
    double cubicleThickness_m = 0.08;

    bool doors = true;
    double openDoors = 0.45;     ///< [0, 1] share of doors with an open leaf
    double removedDoors = 0.12;  ///< [0, 1] share of doors with the frame only
    bool doubleDoors = true;
    bool windows = true;
    bool plainOpenings = true;
    bool cubicles = true;            ///< a room per storey with WC cubicles
    bool rectangularColumns = true;  ///< free-standing
    bool roundColumns = true;        ///< free-standing
    bool profileColumns = false;     ///< instead of some of the rectangular ones: I, L, U and T sections
    bool engagedColumns = true;      ///< rectangular, standing out of a wall
    bool obliqueWalls = true;        ///< partitions at 4 and 30 degrees to the others
    bool curvedWalls = true;         ///< an arc as a partition
    double facadeAngle_deg = 0.0;    ///< the end facade out of square by this, at most 20
    bool curvedFacade = false;       ///< the end facade as an arc; excludes facadeAngle_deg
    bool furniture = true;
    bool suspendedCeilings = false;  ///< in the corridor and some rooms, 0.25 to 0.4 m below the slab
    bool stairs = false;             ///< a flight of stairs and the hole above it
    bool trees = true;               ///< exterior clutter: ground and trees
    double groundLevel_m = -0.15;    ///< of the ground outside, above the lowest floor
    bool varied = false;       ///< doors, windows, furniture and structure of many makes (variety.h), as training data
    bool pitchedRoof = false;  ///< instead of the flat one, where the facades are square
};

/// One room of exactly this clear size and nothing else in it: no door, window, column, furniture. Walls 0.30 m.
[[nodiscard]] BuildingSpec oneRoom(double width_m = 5.0, double depth_m = 4.0, double height_m = 2.7);

/// Two rooms with one partition and a door in it, nothing else. The door's state comes from openDoors, removedDoors.
[[nodiscard]] BuildingSpec twoRoomsWithDoor();

/// A box of a prop: centre and half sizes [m], turned about z.
struct PropBox
{
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    Eigen::Vector3d half = Eigen::Vector3d::Zero();
    double yaw_rad = 0.0;
};

/// Something that is in the scene and not in the Building: furniture, a flight of stairs, ground, a tree.
struct Prop
{
    std::string kind;  ///< "table", "chair", "shelf", "cupboard", "box", "stair", "ground", "tree"
    Label label = Label::Furniture;
    int storey = 0;  ///< index, -1 outside
    std::array<std::uint8_t, 3> colour{120, 105, 140};
    std::vector<PropBox> boxes;                             ///< building frame
    std::vector<std::array<Eigen::Vector3d, 3>> triangles;  ///< building frame, besides the boxes
};

/// A building, its exact truth, and what stands in it.
///
/// The truth: axes of joined walls meet exactly, bodies touch without overlapping (a wall that ends on another one's
/// path ends where its first corner touches the other's face), heights reach from floor to slab, openings name their
/// host, spaces are the outlines between wall faces (columns are not cut out). A space lower than its storey has a
/// suspended ceiling.
struct SimulatedBuilding
{
    Building truth;
    std::vector<Prop> props;
    bool hasVariedFittings = false;  ///< doors and windows of many makes
};

/// Builds what the spec says. The same spec gives the same building.
/// @throws Error{BadParameter} that names the value out of range.
[[nodiscard]] SimulatedBuilding makeBuilding(const BuildingSpec& spec);

}  // namespace s2b::sim

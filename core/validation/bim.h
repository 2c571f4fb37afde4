// SPDX-License-Identifier: GPL-3.0-or-later
/// A BIM as a validation sees it: elements with a mesh, a plan and a height, from whatever file they came.
#pragma once

#include "core/model/building.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace s2b::validation
{

enum class ElementClass
{
    Wall,
    Door,
    Window,
    Column,
    Slab,
    Space,
};

/// "wall", "door" ...: as reports and options name it.
[[nodiscard]] const char* className(ElementClass elementClass);

/// Triangles relative to Bim::origin [m].
struct Mesh
{
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The centre line of a straight wall, relative to Bim::origin.
struct WallAxis
{
    Eigen::Vector2d start = Eigen::Vector2d::Zero();
    Eigen::Vector2d end = Eigen::Vector2d::Zero();
    double thickness_m = 0.0;
};

/// What a survey saw of an element, where the truth file knows it (a simulated survey's own truth does); otherwise the
/// points tell it.
struct Visibility
{
    bool counts = true;               ///< false: seen too little to be asked for
    bool isBothSidesSeen = false;     ///< of a wall
    std::optional<double> bandLow_m;  ///< floor and ceiling of the storey: a survey knows nothing above and below
    std::optional<double> bandHigh_m;
};

struct BimElement
{
    ElementClass elementClass = ElementClass::Wall;
    std::string guid;
    std::string name;
    std::string type;  ///< "IfcWallStandardCase" ...
    int storey = -1;   ///< index into Bim::storeys, -1 for none
    int host = -1;     ///< of a door or window: index of its wall in Bim::elements, -1 for none
    Mesh mesh;         ///< as built: walls with their openings
    Polygon plan;      ///< what is compared: the oriented rectangle, a curved wall's outline, a round column's circle;
                       ///< of a door or window the opening flush with its wall
    std::vector<Polygon> footprint;  ///< real outline in plan where it differs from `plan`; empty: it does not
    double low_m = 0.0;
    double high_m = 0.0;
    std::optional<WallAxis> axis;          ///< of a straight wall
    std::optional<Visibility> visibility;  ///< known only to a simulated survey's truth
};

struct BimStorey
{
    std::string guid;
    std::string name;
    double elevation_m = 0.0;  ///< relative to Bim::origin
    bool isSurveyed = true;    ///< false: no station stood there, nothing of it is asked for
    bool isChosen = true;      ///< false: left out by choice, nothing that a result has there counts
};

struct Bim
{
    std::string file;
    std::string schema;                                ///< "IFC4", "CV4AEC" ...
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< world coordinates of the elements' zero
    std::vector<BimStorey> storeys;                    ///< ascending elevation
    std::vector<BimElement> elements;
};

/// Middle of the box around all walls, columns and slabs (of all elements when there are none), world coordinates.
[[nodiscard]] Eigen::Vector3d centerOf(const Bim& bim);

/// Restricts a truth to some storeys: of the others nothing is asked for, and nothing that a result has there counts.
///
/// @param names  each a storey's name or GUID; none: nothing changes.
/// @throws Error{BadParameter} for a name that no storey has; it lists the storeys.
void selectStoreys(Bim& bim, std::span<const std::string> names);

/// The storey at a height: the highest one that begins at or below it, the lowest one below all; -1 without storeys.
[[nodiscard]] int storeyAt(const Bim& bim, double z_m);

/// @throws Error{BadFile} when walls, columns and doors are typically lower than 5 cm or higher than 100 m: a file
/// whose length unit is wrong by 1000.
void checkSizes(const Bim& bim);

}  // namespace s2b::validation

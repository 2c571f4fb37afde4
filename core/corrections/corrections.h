// SPDX-License-Identifier: GPL-3.0-or-later
/// What a person changes in a reconstructed building: plain functions from a building to the corrected one.
///
/// Guarantees of all of them:
/// - The building that is given stays as it is; the result differs from it only in what the correction says and in what
///   follows from it: openings go with their wall, neighbours are drawn to a wall that was moved.
/// - A dimension that was set is Provenance::Corrected.
/// - Ids stay; a new element gets the first free one.
/// - A correction that makes no sense throws Error{BadParameter} with one sentence that names the element and says why.
/// Lengths in metres, building frame. Cost: O(elements).
#pragma once

#include "core/model/building.h"

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace s2b
{

/// The first id above all that are used.
[[nodiscard]] ElementId freeId(const Building& building);

/// "Wall 12", "Door 7", or the name of a storey or a space; empty for an unknown id.
[[nodiscard]] std::string nameOf(const Building& building, ElementId id);

/// The storey of an element (of an opening its wall's), a storey's own id, or 0.
[[nodiscard]] ElementId storeyOf(const Building& building, ElementId id);

/// Takes the element out. With a wall go its openings and junctions, with a storey all that it holds.
[[nodiscard]] Building removeElement(Building building, ElementId id);

enum class Measure
{
    Thickness,  ///< wall, slab
    Height,     ///< wall, opening, column, storey (floor to ceiling), space
    Width,      ///< opening, rectangular column, diameter of a round one
    Depth,      ///< rectangular column
    Sill        ///< opening, above its host's base
};

/// The measure of an element, nothing where it has none.
[[nodiscard]] std::optional<Dimension> measureOf(const Building& building, ElementId id, Measure measure);

/// Sets it. A wall of which one face was seen keeps that face in its place; an opening keeps its middle.
[[nodiscard]] Building setMeasure(Building building, ElementId id, Measure measure, double value_m);

/// What an element can be made into.
enum class ElementKind
{
    Wall,
    Column,
    Door,
    Window,
    Opening
};
[[nodiscard]] std::optional<ElementKind> kindOf(const Building& building, ElementId id);

/// A door, window or plain opening becomes another of these; a short straight wall a rectangular column, and back.
[[nodiscard]] Building setKind(Building building, ElementId id, ElementKind kind);

/// Moves, turns, scales or mirrors elements, all by transformations of the building frame; the openings of a wall go
/// with it. What they can't take is refused: a wall stays upright, an opening in its wall, a column's section a
/// rectangle or a circle.
/// Neighbours are drawn to the walls that were moved where they still meet within 1.5 m; where they don't, the junction
/// is given up with a Diagnostic "JunctionOpened".
struct ElementMotion
{
    ElementId id;
    Eigen::Affine3d motion = Eigen::Affine3d::Identity();
};
[[nodiscard]] Building moveElements(Building building, const std::vector<ElementMotion>& motions);

/// Puts an opening where these corners of its hole lie: lower begin, lower end, upper end, upper begin along its host.
[[nodiscard]] Building placeOpening(Building building, ElementId id, const std::array<Eigen::Vector3d, 4>& corners);

/// Splits a wall at arc length s of its axis. The part from the start keeps the id.
[[nodiscard]] Building splitWall(Building building, ElementId id, double s_m);

/// Makes one of two straight walls of one storey in one line (2 degrees, half a thickness); the gap between them is
/// filled. The first keeps its id; of two thicknesses the better known one counts.
[[nodiscard]] Building mergeWalls(Building building, ElementId first, ElementId second);

struct NewWall
{
    ElementId storey;
    Eigen::Vector2d start = Eigen::Vector2d::Zero();  ///< of its axis
    Eigen::Vector2d end = Eigen::Vector2d::Zero();
    Dimension thickness;
};
/// Adds a straight wall from the storey's floor to its ceiling and joins its ends to the walls within 0.6 m.
[[nodiscard]] Building addWall(Building building, const NewWall& wall);

/// The wall whose one face runs through two points; its other face through the third, or, without a third, `thickness`
/// to the left of the way from the first to the second.
/// @throws Error{BadParameter} where the points are nearer than 0.1 m, or the third gives no thickness in (0, 2] m
[[nodiscard]] NewWall wallThrough(ElementId storey, const Eigen::Vector2d& first, const Eigen::Vector2d& second,
                                  const std::optional<Eigen::Vector2d>& third, double thickness_m);

/// Moves a storey's floor. What stands on it follows: the walls' and columns' tops, the ceiling and the windows stay.
[[nodiscard]] Building moveLevel(Building building, ElementId storey, double elevation_m);

/// Adds a storey. Its height reaches to the next one's floor less 0.2 m, or is the storey's below; Assumed.
[[nodiscard]] Building addLevel(Building building, double elevation_m);

/// The element as it was reconstructed, with the openings that a wall had. An element that was removed comes back.
[[nodiscard]] Building resetElement(Building building, const Building& found, ElementId id);

/// Whether an element differs between two states of a building, or is only in one of them.
[[nodiscard]] bool differs(const Building& found, const Building& corrected, ElementId id);

/// The ids of all storeys and elements that differ, ascending.
[[nodiscard]] std::vector<ElementId> correctedElements(const Building& found, const Building& corrected);

}  // namespace s2b

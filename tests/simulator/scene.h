// SPDX-License-Identifier: GPL-3.0-or-later
/// What the scanner sees: triangles with a label, a material and an element each.
#pragma once

#include "core/labels/label.h"
#include "core/model/building.h"
#include "tests/simulator/building_spec.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace s2b::sim
{

enum class Material : std::uint8_t
{
    Opaque,
    Glass
};

/// What a triangle belongs to.
struct Surface
{
    std::uint32_t element = 0;  ///< index into Scene::elements
    Label label = Label::Unassigned;
    Material material = Material::Opaque;
};

struct SceneElement
{
    std::string type;  ///< "IfcWall", "IfcDoor" ...; a prop's kind for what is not part of the building
    std::string guid;  ///< unique; of the IFC file, or made from the ElementId
    std::string name;
    ElementId id;         ///< in the Building; 0 for props and for IFC files
    int storey = -1;      ///< index, -1 none
    std::string host;     ///< guid of the wall that a door, window or opening is in
    bool isProp = false;  ///< not part of the building: furniture, ground, trees
    std::array<std::uint8_t, 3> colour{128, 128, 128};
};

struct SceneStorey
{
    std::string guid;
    std::string name;
    double elevation_m = 0.0;  ///< local z of the floor
};

/// Triangles in a local frame: world = origin + local (no rotation). Normals by the right-hand rule point out of the
/// solid.
struct Scene
{
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Surface> surfaces;  ///< one a triangle
    std::vector<SceneElement> elements;
    std::vector<SceneStorey> storeys;  ///< ascending

    std::uint32_t addElement(SceneElement element);
    void addTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                     const Surface& surface);
    /// Corners counter-clockwise seen from outside.
    void addQuad(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d,
                 const Surface& surface);
    void addBox(const PropBox& box, const Surface& surface);
    [[nodiscard]] Eigen::Vector3d normal(std::size_t triangle) const;
};

/// The base colour of a class, as a scanner's camera would see it.
[[nodiscard]] std::array<std::uint8_t, 3> labelColour(Label label);

/// The meshes of a building: walls with their openings, reveals, door frames and leaves, window frames, sills and
/// glass, columns, slabs, suspended ceilings (spaces lower than their storey), props. Any Building will do, also one
/// made by hand: joints of walls are closed where `junctions` says that they meet.
///
/// Opening angles of leaves and colours are drawn from `seed`. Elements get the guid "wall-<id>" and so on.
[[nodiscard]] Scene makeScene(const SimulatedBuilding& building, std::uint64_t seed = 1);

/// The meshes of any IFC file, labelled by type; slabs' upper faces are floor, lower ones ceiling; with ground and
/// trees round it.
/// @throws Error{BadFile} as ifc::readIfc.
[[nodiscard]] Scene readScene(const std::string& ifcPath);

}  // namespace s2b::sim

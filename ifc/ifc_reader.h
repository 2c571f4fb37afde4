// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace s2b::ifc
{

/// A product by name.
struct ProductName
{
    std::string guid;
    std::string type;
    std::string name;
};

/// One product of an IFC file, tessellated in world coordinates [m].
struct MeshElement
{
    std::string guid;
    std::string type;  ///< "IfcWall", "IfcDoor" ... (IfcWallStandardCase as written in the file)
    std::string name;
    std::string predefinedType;
    std::string storeyGuid;      ///< of the containing storey, empty when there is none
    std::string hostGuid;        ///< of the wall that a door, window or opening sits in, empty when there is none
    std::string openingGuid;     ///< of the opening that a door or window fills, empty when there is none
    ProductName whole;           ///< the element that it is a part of; empty when there is none
    bool isTransparent = false;  ///< a part of it is, by its surface style (a window's glass)
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<bool> triangleIsTransparent;  ///< of each triangle
};

struct StoreyInfo
{
    std::string guid;
    std::string name;
    double elevation_m = 0.0;  ///< world z of its placement
};

/// IfcMapConversion, in metres: map = origin + scale * Rz(yaw) * model.
struct MapConversion
{
    std::string crs;  ///< name of the projected coordinate system, "EPSG:25832"
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    double yaw_rad = 0.0;
    double scale = 1.0;

    [[nodiscard]] Eigen::Vector3d toMap(const Eigen::Vector3d& p) const;
};

struct IfcModel
{
    std::string schema;
    std::optional<MapConversion> mapConversion;  ///< what the file says, whether it was applied or not
    std::vector<StoreyInfo> storeys;             ///< ascending elevation
    std::vector<MeshElement> elements;           ///< in ascending instance number; openings and spaces too
    std::vector<std::string> withoutMesh;  ///< "IfcDoor 2xHCQ..." of products whose geometry could not be converted
};

struct ReadOptions
{
    bool subtractOpenings = true;  ///< walls with their holes
    bool applyMapConversion =
        false;  ///< map coordinates instead of the model's own, where the file has an IfcMapConversion
    std::vector<std::string> types = {};  ///< only products of these entities ("IfcWall") and their subtypes; none: all
    std::set<std::string> guids = {};     ///< only these products; none: all
};

/// Reads any IFC2X3, IFC4 or IFC4X3 file's product geometry through IfcGeom with OpenCASCADE, in metres.
///
/// Meshes are made in each product's own frame and moved to the world in double precision, so that a site placement at
/// 3.2e7 m costs nothing. Curves become chords within 1 mm. One thread: the same file gives the same result.
/// IfcOpenShell's log is process-wide, so only one thread may read at a time. Cost: some 500 products a second;
/// openings that are subtracted take most of it.
/// @throws Error{BadFile} for a missing or truncated file, one that is not IFC, or one without geometry.
[[nodiscard]] IfcModel readIfc(const std::string& path, const ReadOptions& options = {});

}  // namespace s2b::ifc

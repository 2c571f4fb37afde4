// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace s2b::ifc
{

/// One product of an IFC file, tessellated in world coordinates [m].
struct MeshElement
{
    std::string guid;
    std::string type;        ///< "IfcWall", "IfcDoor" ... (IfcWallStandardCase as written in the file)
    std::string name;
    std::string predefinedType;
    std::string storeyGuid;  ///< of the containing storey, empty when there is none
    std::string hostGuid;    ///< of the wall that a door or window sits in, empty when there is none
    bool isTransparent = false;                   ///< its surface style says so (glass)
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct StoreyInfo
{
    std::string guid;
    std::string name;
    double elevation_m = 0.0;  ///< world z of its placement
};

struct IfcModel
{
    std::string schema;
    std::vector<StoreyInfo> storeys;    ///< ascending elevation
    std::vector<MeshElement> elements;  ///< in the file's order
};

struct ReadOptions
{
    bool subtractOpenings = true;   ///< walls with their holes
};

/// Reads any IFC2X3, IFC4 or IFC4X3 file's product geometry through IfcGeom with OpenCASCADE, in metres.
/// @throws Error{BadFile} for a missing or truncated file, one that is not IFC, or one without geometry.
[[nodiscard]] IfcModel readIfc(const std::string& path, const ReadOptions& options = {});

}  // namespace s2b::ifc

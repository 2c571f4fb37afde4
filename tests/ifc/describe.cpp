// SPDX-License-Identifier: GPL-3.0-or-later
// What IfcGeom sees in a file, as JSON, for other readers to be compared with: describe FILE.ifc FILE.json
// {"elements": {GUID: {"type", "name", "volume_m3", "low": [x, y, z], "high": [x, y, z]}}}, holes subtracted.
#include "ifc/ifc_reader.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <exception>
#include <fstream>

namespace
{

nlohmann::json describe(const s2b::ifc::MeshElement& element)
{
    Eigen::Vector3d low = element.vertices.front();
    Eigen::Vector3d high = low;
    for (const Eigen::Vector3d& v : element.vertices)
    {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
    }
    // The tetrahedra from one corner to the triangles of a closed mesh.
    double six = 0.0;
    for (const auto& t : element.triangles)
        six += (element.vertices[t[0]] - low).dot((element.vertices[t[1]] - low).cross(element.vertices[t[2]] - low));
    return {{"type", element.type},
            {"name", element.name},
            {"volume_m3", six / 6.0},
            {"low", {low.x(), low.y(), low.z()}},
            {"high", {high.x(), high.y(), high.z()}}};
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 3)
    {
        std::fprintf(stderr, "usage: describe FILE.ifc FILE.json\n");
        return 2;
    }
    try
    {
        nlohmann::json elements;
        for (const s2b::ifc::MeshElement& element : s2b::ifc::readIfc(argv[1]).elements)
            elements[element.guid] = describe(element);
        std::ofstream file(argv[2]);
        file << nlohmann::json{{"elements", elements}}.dump(1) << '\n';
        file.close();
        return file ? 0 : 1;
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
}

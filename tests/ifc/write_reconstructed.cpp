// SPDX-License-Identifier: GPL-3.0-or-later
// Simulates the survey of a small building, reconstructs it and writes the result: write_reconstructed IFC4_FILE
// IFC4X3_FILE [profiles]
// With "profiles", of a hall with steel columns, scanned finely enough to measure their webs and flanges.
#include "core/pipeline/pipeline.h"
#include "ifc/ifc_writer.h"
#include "tests/simulator/building_spec.h"
#include "tests/simulator/scanner.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string_view>
#include <variant>

namespace
{

struct Task
{
    s2b::sim::BuildingSpec spec;
    s2b::sim::ScanSettings settings;
};

Task smallBuilding()
{
    Task task;
    task.spec.seed = 3;
    task.spec.storeys = 2;
    task.spec.roomsPerSide = 2;
    task.settings.step_deg = 0.7;
    task.settings.noise_m = 0.003;
    return task;
}

Task steelColumns()
{
    Task task;
    task.spec.seed = 4;
    task.spec.storeys = 1;
    task.spec.roomsPerSide = 4;
    task.spec.profileColumns = true;
    for (bool* clutter : {&task.spec.furniture, &task.spec.trees, &task.spec.cubicles, &task.spec.curvedWalls})
        *clutter = false;
    task.settings.seed = task.spec.seed;
    task.settings.step_deg = 0.4;
    task.settings.voxel_m = 0.005;
    return task;
}

}  // namespace

int main(int argc, char** argv)
{
    const bool isProfiles = argc == 4 && std::string_view(argv[3]) == "profiles";
    if (argc != 3 && !isProfiles)
    {
        std::fprintf(stderr, "usage: write_reconstructed IFC4_FILE IFC4X3_FILE [profiles]\n");
        return 2;
    }
    try
    {
        auto [spec, settings] = isProfiles ? steelColumns() : smallBuilding();
        spec.origin = {32500100.12, 5600300.54, 120.98};
        spec.yaw_deg = 17.0;
        const s2b::sim::SimulatedBuilding building = s2b::sim::makeBuilding(spec);
        const s2b::sim::Scene scene = s2b::sim::makeScene(building, spec.seed);
        const auto stations = s2b::sim::chooseStations(building, scene, false, spec.seed);
        const s2b::PointCloud cloud = s2b::sim::scan(scene, stations, settings).toPointCloud();
        const s2b::CloudView view{cloud.points.front().data(), cloud.size(), cloud.origin,
                                  reinterpret_cast<const std::uint8_t*>(cloud.labels.data())};
        const s2b::Building result = s2b::reconstruct(view, {}, {});
        s2b::ifc::WriteOptions options;
        options.projectName = "Survey";
        for (const char* schema : {"IFC4", "IFC4X3_ADD2"})
        {
            options.schema = schema;
            s2b::ifc::writeIfc(result, argv[options.schema == "IFC4" ? 1 : 2], options);
        }
        const auto profiles = std::count_if(result.columns.begin(), result.columns.end(), [](const s2b::Column& column)
                                            { return std::holds_alternative<s2b::ProfileSection>(column.section); });
        std::printf("%zu points: %zu walls, %zu openings, %zu columns (%td profiles), %zu spaces\n", cloud.size(),
                    result.walls.size(), result.openings.size(), result.columns.size(), profiles, result.spaces.size());
        if (isProfiles && profiles == 0)
        {
            std::fprintf(stderr, "no section was measured, so that none is checked\n");
            return 1;
        }
        return 0;
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
}

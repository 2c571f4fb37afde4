// SPDX-License-Identifier: GPL-3.0-or-later
// Simulates the survey of a small building, reconstructs it and writes the result: write_reconstructed IFC4_FILE
// IFC4X3_FILE
#include "core/pipeline/pipeline.h"
#include "ifc/ifc_writer.h"
#include "tests/simulator/building_spec.h"
#include "tests/simulator/scanner.h"

#include <cstdio>
#include <exception>

int main(int argc, char** argv)
{
    if (argc != 3)
    {
        std::fprintf(stderr, "usage: write_reconstructed IFC4_FILE IFC4X3_FILE\n");
        return 2;
    }
    try
    {
        s2b::sim::BuildingSpec spec;
        spec.seed = 3;
        spec.storeys = 2;
        spec.roomsPerSide = 2;
        spec.origin = {32500100.12, 5600300.54, 120.98};
        spec.yaw_deg = 17.0;
        s2b::sim::ScanSettings settings;
        settings.step_deg = 0.7;
        settings.noise_m = 0.003;
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
        std::printf("%zu points: %zu walls, %zu openings, %zu columns, %zu spaces\n", cloud.size(), result.walls.size(),
                    result.openings.size(), result.columns.size(), result.spaces.size());
        return 0;
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
}

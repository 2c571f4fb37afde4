// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the sample building: write_sample SCHEMA FILE [EPSG|many|empty]
#include "ifc/ifc_writer.h"
#include "sample_building.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

int main(int argc, char** argv)
{
    if (argc < 3)
    {
        std::fprintf(stderr, "usage: write_sample SCHEMA FILE [EPSG|many|empty]\n");
        return 2;
    }
    try
    {
        s2b::ifc::WriteOptions options;
        options.schema = argv[1];
        options.projectName = "Sample – Beispiel";
        options.parameters = {{"walls.maxThickness", "0.6"}, {"note", std::string(300, 'x')}};
        const std::string mode = argc > 3 ? argv[3] : "";
        s2b::Building building;
        if (mode == "many")
            building = s2b::test::manyWalls(4000);
        else if (mode != "empty")
            building = s2b::test::sampleBuilding();
        if (!mode.empty() && mode != "many" && mode != "empty")
            options.epsg = std::atoi(mode.c_str());
        const auto start = std::chrono::steady_clock::now();
        s2b::ifc::writeIfc(building, argv[2], options);
        std::printf("%.3f s\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        return 0;
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
}

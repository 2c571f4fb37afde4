// SPDX-License-Identifier: GPL-3.0-or-later
/// s2b_reconstruct IN.laz [--ifc OUT.ifc] [--json OUT.json] [--geometry-only] [--set name=value]: the pipeline alone,
/// timed.
#include "core/pipeline/pipeline.h"
#include "ifc/ifc_writer.h"
#include "tests/bench/building_json.h"
#include "tests/bench/laz_reader.h"
#include "tests/bench/survey_stations.h"

#include <CLI/CLI.hpp>

#include <sys/resource.h>

#include <chrono>
#include <fstream>
#include <iostream>

namespace
{

double seconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

long peakMegabytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("Reconstructs a building from a LAZ file and prints the seconds of each step.");
    std::string in, ifcPath, jsonPath, stationsPath;
    bool geometryOnly = false, quiet = false, noIds = false;
    unsigned threads = 0;
    std::vector<std::string> assignments;
    app.add_option("cloud", in, "LAS or LAZ file")->required();
    app.add_option("--ifc", ifcPath, "IFC file to write");
    app.add_option("--json", jsonPath, "plan as JSON to write");
    app.add_flag("--geometry-only", geometryOnly, "use no labels");
    app.add_flag("--quiet", quiet, "no step times");
    app.add_option("--stations", stationsPath, "where the scanner stood: a survey's truth, or a file of -STATIONS");
    app.add_flag("--no-ids", noIds, "don't read which station a point is of");
    app.add_option("--threads", threads, "0 = all");
    app.add_option("--set", assignments, "parameter, name=value");
    CLI11_PARSE(app, argc, argv);
    try
    {
        const double t0 = seconds();
        std::vector<std::uint16_t> sources;
        const s2b::PointCloud cloud = s2b::readLaz(in, nullptr, stationsPath.empty() || noIds ? nullptr : &sources);
        s2b::SurveyStations stations;
        if (!stationsPath.empty())
            stations = s2b::surveyStations(stationsPath, cloud.origin, sources);
        const double loaded = seconds();
        const long loadedMegabytes = peakMegabytes();
        s2b::PipelineOptions options;
        options.geometryOnly = geometryOnly;
        for (const std::string& a : assignments)
            s2b::setParameter(options.parameters, a);
        s2b::Context context;
        context.threads = threads;
        double last = loaded;
        std::string step;
        context.progress = [&](std::string_view text, double)
        {
            const double now = seconds();
            if (!step.empty() && !quiet)
                std::cout << "  " << step << ": " << now - last << " s\n";
            step = text;
            last = now;
        };
        s2b::CloudView view{cloud.points.front().data(), cloud.size(), cloud.origin,
                            reinterpret_cast<const std::uint8_t*>(cloud.labels.data())};
        view.stations = stations.view();
        const s2b::Building building = s2b::reconstruct(view, options, context);
        context.progress("", 1.0);
        const double done = seconds();
        if (!ifcPath.empty())
            s2b::ifc::writeIfc(building, ifcPath, {});
        if (!jsonPath.empty())
            std::ofstream(jsonPath) << s2b::buildingJson(building);
        std::cout << in << ": " << cloud.size() << " points, " << building.storeys.size() << " storeys, "
                  << building.walls.size() << " walls, " << building.openings.size() << " openings, "
                  << building.columns.size() << " columns; load " << loaded - t0 << " s, reconstruct " << done - loaded
                  << " s, write " << seconds() - done << " s, peak " << peakMegabytes() << " MB (" << loadedMegabytes
                  << " loaded)\n";
    }
    catch (const std::exception& e)
    {
        std::cerr << "s2b_reconstruct: " << e.what() << "\n";
        return 1;
    }
    return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
/// s2b_make_clouds FOLDER --points 1,10,30 [--from SURVEY.laz]: one survey (simulated, unless a file is given), drawn
/// down to as many million points as asked for: FOLDER/1M.laz ... What is there already stays.
#include "core/base/error.h"
#include "core/base/random.h"
#include "tests/bench/laz_reader.h"
#include "tests/simulator/building_spec.h"
#include "tests/simulator/scanner.h"
#include "tests/simulator/survey_io.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <format>
#include <iostream>
#include <numeric>

namespace
{

using namespace s2b;
using namespace s2b::sim;

constexpr double kMillion = 1.0e6;
constexpr double kRaysPerPoint = 2.0;  // some find nothing, and of some only one point a voxel is kept
constexpr double kVoxel_m = 0.003;
constexpr double kElevations_deg = 150.0;  // of a station, see ScanSettings

/// Evenly drawn over the survey, in its order: a cloud of the same place, thinner everywhere.
Survey drawDown(const Survey& survey, std::size_t count)
{
    std::vector<std::uint32_t> index(survey.size());
    std::iota(index.begin(), index.end(), 0U);
    const auto rank = [](std::uint32_t i) { return randomBits(1, 1, i); };
    std::nth_element(index.begin(), index.begin() + static_cast<std::ptrdiff_t>(count), index.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return rank(a) < rank(b); });
    index.resize(count);
    std::sort(index.begin(), index.end());
    Survey out;
    out.origin = survey.origin;
    for (const std::uint32_t i : index)
    {
        out.points.push_back(survey.points[i]);
        out.labels.push_back(survey.labels[i]);
        out.colours.push_back(survey.colours[i]);
        out.stations.push_back(survey.stations[i]);
        out.triangles.push_back(survey.triangles[i]);
    }
    return out;
}

/// A building of three storeys, scanned so finely that `millions` of points remain.
Survey simulate(double millions)
{
    BuildingSpec spec;
    spec.seed = 7;
    spec.storeys = 3;
    spec.roomsPerSide = 5;
    spec.yaw_deg = 23.0;
    const SimulatedBuilding building = makeBuilding(spec);
    const Scene scene = makeScene(building, spec.seed);
    const std::vector<Station> stations = chooseStations(building, scene, false, spec.seed);
    ScanSettings settings;
    settings.seed = spec.seed;
    settings.voxel_m = kVoxel_m;
    settings.step_deg = std::sqrt(static_cast<double>(stations.size()) * 360.0 * kElevations_deg /
                                  (kRaysPerPoint * millions * kMillion));
    std::cerr << std::format("scanning from {} stations, every {:.3f} degrees\n", stations.size(), settings.step_deg);
    return scan(scene, stations, settings);
}

Survey readSurvey(const std::string& path)
{
    Survey survey;
    PointCloud cloud = readLaz(path, &survey.colours);
    survey.origin = cloud.origin;
    survey.points = std::move(cloud.points);
    survey.labels = std::move(cloud.labels);
    survey.stations.resize(survey.size());
    survey.triangles.resize(survey.size());
    return survey;
}

void make(const std::string& folder, const std::string& from, const std::vector<double>& millions)
{
    const auto pathOf = [&](double m) { return (std::filesystem::path(folder) / std::format("{}M.laz", m)).string(); };
    double largest = 0.0;
    for (const double m : millions)
    {
        if (!std::filesystem::exists(pathOf(m)))
            largest = std::max(largest, m);
    }
    if (largest == 0.0)
        return;
    std::filesystem::create_directories(folder);
    const Survey survey = from.empty() ? simulate(largest) : readSurvey(from);
    std::cerr << survey.size() << " points\n";
    for (const double m : millions)
    {
        const auto count = static_cast<std::size_t>(std::llround(m * kMillion));
        if (std::filesystem::exists(pathOf(m)))
            continue;
        if (survey.size() < count)
            throw Error(ErrorCode::BadParameter,
                        std::format("the survey has {} points, fewer than {} million", survey.size(), m));
        writeLas(survey.size() == count ? survey : drawDown(survey, count), pathOf(m));
        std::cerr << pathOf(m) << "\n";
    }
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("Makes clouds of the same building with different numbers of points.");
    std::string folder, from;
    std::vector<double> millions{1, 10, 30};
    app.add_option("folder", folder, "where FOLDER/1M.laz ... are kept")->required();
    app.add_option("--points", millions, "millions of points")->delimiter(',')->check(CLI::Range(0.01, 200.0));
    app.add_option("--from", from, "LAZ file of at least as many points, instead of a simulated building");
    CLI11_PARSE(app, argc, argv);
    try
    {
        make(folder, from, millions);
    }
    catch (const std::exception& e)
    {
        std::cerr << "s2b_make_clouds: " << e.what() << "\n";
        return 1;
    }
    return 0;
}

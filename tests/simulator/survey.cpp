// SPDX-License-Identifier: GPL-3.0-or-later
/// s2b_survey: what a scan of a building would give. docs/simulator.md.
#include "core/base/error.h"
#include "ifc/ifc_writer.h"
#include "tests/simulator/building_spec.h"
#include "tests/simulator/scanner.h"
#include "tests/simulator/survey_io.h"
#include "tests/simulator/truth_json.h"
#include "tests/simulator/variety.h"

#include <CLI/CLI.hpp>

#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace
{

using namespace s2b;
using namespace s2b::sim;

constexpr const char* kBuilding = "Building";  ///< options about the building, in --help

struct Options
{
    std::string output;
    std::string ifcIn;
    std::string truth;
    std::string truthIfc;
    std::optional<std::array<double, 3>> origin;
    std::vector<std::string> without;
    bool outside = false;
    bool variety = false;
    BuildingSpec spec;
    ScanSettings scan;

    Options() { scan.voxel_m = 0.01; }  // what people thin a registered survey to
};

/// Features that can be left out, by the name that --without takes.
const std::map<std::string, bool BuildingSpec::*>& features()
{
    static const std::map<std::string, bool BuildingSpec::*> kFeatures{
        {"doors", &BuildingSpec::doors},
        {"double-doors", &BuildingSpec::doubleDoors},
        {"windows", &BuildingSpec::windows},
        {"plain-openings", &BuildingSpec::plainOpenings},
        {"cubicles", &BuildingSpec::cubicles},
        {"rectangular-columns", &BuildingSpec::rectangularColumns},
        {"round-columns", &BuildingSpec::roundColumns},
        {"engaged-columns", &BuildingSpec::engagedColumns},
        {"oblique-walls", &BuildingSpec::obliqueWalls},
        {"curved-walls", &BuildingSpec::curvedWalls},
        {"furniture", &BuildingSpec::furniture},
        {"trees", &BuildingSpec::trees},
    };
    return kFeatures;
}

Layout layoutOf(const std::string& name)
{
    static const std::map<std::string, Layout> kLayouts{
        {"corridor", Layout::Corridor}, {"one-room", Layout::OneRoom}, {"two-rooms", Layout::TwoRooms}};
    const auto it = kLayouts.find(name);
    if (it == kLayouts.end())
        throw Error(ErrorCode::BadParameter,
                    "--layout does not know '" + name + "': use corridor, one-room or two-rooms");
    return it->second;
}

void addOptions(CLI::App& app, Options& o)
{
    app.add_option("OUT", o.output, "the survey: .laz, .las, .ply, .xyz")->required();
    app.add_option("--ifc-in", o.ifcIn, "scan this IFC file instead of a building made from the seed");
    app.add_option("--truth", o.truth, "write the ground truth and what the survey saw of it as JSON");
    app.add_option("--truth-ifc", o.truthIfc, "write the ground truth as IFC");
    app.add_option("--seed", o.scan.seed, "of every random draw")->capture_default_str();
    app.add_option("--threads", o.scan.threads, "0 = all; the output does not depend on it");

    app.add_option_function<std::string>(
           "--layout", [&o](const std::string& name) { o.spec.layout = layoutOf(name); },
           "corridor, one-room or two-rooms [corridor]")
        ->group(kBuilding);
    app.add_option("--storeys", o.spec.storeys)->capture_default_str()->group(kBuilding);
    app.add_option("--rooms", o.spec.roomsPerSide, "on each side of the corridor")
        ->capture_default_str()
        ->group(kBuilding);
    app.add_option("--yaw-deg", o.spec.yaw_deg, "of the building in the world")->group(kBuilding);
    app.add_option("--origin", o.origin, "E N H: world coordinates of the building's corner at the lowest floor")
        ->group(kBuilding);
    app.add_option("--open-doors", o.spec.openDoors, "share of doors with an open leaf")
        ->capture_default_str()
        ->group(kBuilding);
    app.add_option("--removed-doors", o.spec.removedDoors, "share of doors with the frame only")
        ->capture_default_str()
        ->group(kBuilding);
    app.add_option("--facade-angle-deg", o.spec.facadeAngle_deg, "the end facade out of square by this")
        ->group(kBuilding);
    app.add_flag("--curved-facade", o.spec.curvedFacade, "the end facade as an arc")->group(kBuilding);
    app.add_flag("--suspended-ceilings", o.spec.suspendedCeilings)->group(kBuilding);
    app.add_flag("--stairs", o.spec.stairs)->group(kBuilding);
    app.add_flag("--variety", o.variety,
                 "draw the kind of building, its fittings, furniture and structure, the scanner and its stations from "
                 "the seed: training data. Other options override what is drawn")
        ->group(kBuilding);
    app.add_flag("--profile-columns", o.spec.profileColumns, "I, L, U and T sections instead of the rectangular ones")
        ->group(kBuilding);
    std::string names;
    for (const auto& [name, member] : features())
        names += (names.empty() ? "" : ", ") + name;
    app.add_option("--without", o.without, "leave out (comma separated): " + names)->delimiter(',')->group(kBuilding);

    const char* scanner = "Scanner";
    app.add_option("--step-deg", o.scan.step_deg, "angle between rays")->capture_default_str()->group(scanner);
    app.add_option("--line-step-deg", o.scan.lineStep_deg,
                   "a line laser that is turned: angle between its upright lines, of which none ends below the zenith")
        ->group(scanner);
    app.add_option("--stations", o.scan.mostStations, "at most so many, near each other; 0 = all")->group(scanner);
    app.add_option_function<double>(
           "--noise-mm", [&o](double mm) { o.scan.noise_m = mm / 1000.0; }, "sigma of the range at 5 m [2]")
        ->group(scanner);
    app.add_option("--mixed-pixels", o.scan.mixedPixels, "share of rays at an edge that return something in between")
        ->capture_default_str()
        ->group(scanner);
    app.add_option("--range-max", o.scan.rangeMax_m, "metres")->capture_default_str()->group(scanner);
    app.add_option("--label-errors", o.scan.labelErrors, "share of points with a wrong label")
        ->capture_default_str()
        ->group(scanner);
    app.add_option("--voxel", o.scan.voxel_m, "keep one point a voxel of this size in metres, 0 = all")
        ->capture_default_str()
        ->group(scanner);
    app.add_flag("--outside", o.outside, "stations round the building too")->group(scanner);
}

/// An IFC file is scanned as it is.
void refuseBuildingOptions(const CLI::App& app, const Options& o)
{
    if (o.ifcIn.empty())
        return;
    for (const CLI::Option* option : app.get_options())
        if (option->get_group() == kBuilding && option->count() > 0)
            throw Error(ErrorCode::BadParameter,
                        option->get_name() + " is for buildings made from the seed: leave it out with --ifc-in");
}

int run(Options& o)
{
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    o.spec.seed = o.scan.seed;
    if (o.origin)
        o.spec.origin = Eigen::Vector3d((*o.origin)[0], (*o.origin)[1], (*o.origin)[2]);
    for (const std::string& name : o.without)
    {
        const auto it = features().find(name);
        if (it == features().end())
            throw Error(ErrorCode::BadParameter,
                        "--without does not know '" + name + "': s2b_survey --help lists the features");
        o.spec.*(it->second) = false;
    }

    checkWritable(o.output, true);
    for (const std::string& path : {o.truth, o.truthIfc})
        if (!path.empty())
            checkWritable(path, false);

    std::optional<SimulatedBuilding> building;
    Scene scene;
    std::vector<Station> stations;
    if (o.ifcIn.empty())
    {
        building = makeBuilding(o.spec);
        scene = makeScene(*building, o.spec.seed);
        stations = chooseStations(*building, scene, o.outside, o.spec.seed);
    }
    else
    {
        if (!o.truthIfc.empty())
            throw Error(ErrorCode::BadParameter,
                        "--truth-ifc is for buildings made from the seed: with --ifc-in the truth is that file");
        scene = readScene(o.ifcIn);
        stations = chooseStations(scene, o.outside, o.scan.seed);
    }
    stations = fewStations(stations, o.scan.mostStations, o.scan.seed);
    std::printf("%zu triangles, %zu stations (%.1f s)\n", scene.triangles.size(), stations.size(), seconds());
    std::fflush(stdout);
    const Survey survey = scan(scene, stations, o.scan);
    std::printf("%zu points (%.1f s)\n", survey.size(), seconds());
    std::fflush(stdout);
    writeSurvey(survey, o.output);
    if (!o.truth.empty())
        writeTruth(scene, survey, stations, building ? &*building : nullptr, o.truth);
    if (!o.truthIfc.empty())
        ifc::writeIfc(building->truth, o.truthIfc, {});
    std::printf("written to %s (%.1f s)\n", o.output.c_str(), seconds());
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("What a laser scan of a building would give: of a building made from a seed, or of an IFC file.",
                 "s2b_survey");
    Options options;
    addOptions(app, options);
    try
    {
        app.parse(argc, argv);
        if (options.variety)
        {
            // Drawn first; what is given on the command line then overrides the draw.
            const Variety variety = drawVariety(options.scan.seed);
            options.spec = variety.spec;
            options.scan = variety.scan;
            options.outside = variety.outside;
            app.clear();
            app.parse(argc, argv);
        }
        refuseBuildingOptions(app, options);
        return run(options);
    }
    catch (const CLI::ParseError& e)
    {
        if (e.get_exit_code() == 0)
            return app.exit(e);
        std::cerr << "s2b_survey: " << e.what() << '\n';
    }
    catch (const std::exception& e)
    {
        std::cerr << "s2b_survey: " << e.what() << '\n';
    }
    return 1;
}

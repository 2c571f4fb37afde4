// SPDX-License-Identifier: GPL-3.0-or-later
/// s2b_validate TRUTH RESULT.ifc [--cloud SCAN.laz] [--json OUT.json]: a result measured against a truth, timed.
#include "core/validation/validation.h"
#include "ifc/bim_reader.h"
#include "tests/bench/laz_reader.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>

namespace
{

using Json = nlohmann::ordered_json;
using namespace s2b::validation;

double seconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Json number(std::optional<double> value)
{
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json json(const Rates& r)
{
    return {{"precision", r.precision}, {"recall", r.recall}, {"f1", r.f1}};
}

Json json(const ClassScore& s)
{
    Json result{{"truth", s.truthCount},
                {"result", s.resultCount},
                {"notSeen", s.notSeenCount},
                {"iou", number(s.iou)},
                {"iouMatched", s.iouMatched},
                {"iouFull", number(s.iouFull)},
                {"iouNearest", number(s.iouNearest)},
                {"iouBothSides", number(s.iouBothSides)},
                {"bothSides", s.bothSidesCount},
                {"at25", json(s.at25)},
                {"at50", json(s.at50)},
                {"vIoU", number(s.volumetricIou)},
                {"centroid_m", number(s.centroid_m)},
                {"thicknessError_m", number(s.thicknessError_m)},
                {"heightError_m", number(s.heightError_m)},
                {"axisEnd_m", number(s.axisEnd_m)}};
    for (const auto& [distance, rates] : s.cornersAt)
        result["corners"][std::to_string(distance) + " cm"] = json(rates);
    return result;
}

Json json(const CloudDeviation& d, const Bim& bim)
{
    Json result{{"wallMeanAbsolute_m", d.wallMeanAbsolute_m}};
    for (const auto& [elementClass, mean] : d.meanAbsolute_m)
        result["meanAbsolute_m"][className(elementClass)] = mean;
    std::map<std::string, int> bands;
    for (const Deviation& e : d.elements)
    {
        const BimElement& element = bim.elements[static_cast<std::size_t>(e.element)];
        if (element.elementClass != ElementClass::Space)
            ++bands[loaName(e.band)];
        result["elements"].push_back({{"class", className(element.elementClass)},
                                      {"guid", element.guid},
                                      {"points", e.points},
                                      {"meanAbsolute_m", e.meanAbsolute_m},
                                      {"meanSigned_m", e.meanSigned_m},
                                      {"median_m", e.median_m},
                                      {"rms_m", e.rms_m},
                                      {"p95_m", e.p95_m},
                                      {"coverage", e.coverage},
                                      {"band", loaName(e.band)}});
    }
    result["bands"] = bands;
    return result;
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("Measures a result against a ground truth, and both against a cloud.");
    std::string truthPath, resultPath, cloudPath, jsonPath;
    unsigned threads = 0;
    bool dropVisibility = false;
    app.add_option("truth", truthPath, "IFC, CV4AEC JSON or a simulated survey's truth")->required();
    app.add_option("result", resultPath, "IFC file")->required();
    app.add_option("--cloud", cloudPath, "LAS or LAZ file");
    app.add_option("--json", jsonPath, "everything, as JSON");
    app.add_option("--threads", threads, "0 = all");
    app.add_flag("--no-visibility", dropVisibility, "let the points tell what was seen, whatever the truth says");
    CLI11_PARSE(app, argc, argv);
    try
    {
        const double t0 = seconds();
        s2b::PointCloud cloud;
        s2b::CloudView view;
        s2b::ifc::BimReadOptions options;
        options.withMeshes = !cloudPath.empty();
        if (!cloudPath.empty())
        {
            cloud = s2b::readLaz(cloudPath);
            view = {cloud.points.front().data(), cloud.size(), cloud.origin,
                    reinterpret_cast<const std::uint8_t*>(cloud.labels.data())};
            options.near = cloud.origin + cloud.points[cloud.size() / 2].cast<double>();
        }
        const double t1 = seconds();
        Bim truth = s2b::ifc::readTruth(truthPath, options);
        if (dropVisibility)
            for (BimElement& e : truth.elements)
                e.visibility.reset();
        const double t2 = seconds();
        options.near = centerOf(truth);
        const Bim result = s2b::ifc::readBim(resultPath, options);
        const double t3 = seconds();
        s2b::Context context;
        context.threads = threads;
        const Validation v = validate(truth, result, cloudPath.empty() ? nullptr : &view, {}, context);
        const double t4 = seconds();

        Json out;
        for (const auto& [elementClass, score] : v.scores)
            out[className(elementClass)] = json(score);
        out["meanIou"] = number(v.meanIou);
        for (const StoreyError& e : v.storeys)
            out["storeys"]["errors_m"].push_back(number(e.error_m));
        out["storeys"]["extra"] = v.extraStoreys;
        if (v.cloudToTruth)
            out["cloudToTruth"] = json(*v.cloudToTruth, truth);
        if (v.cloudToResult)
            out["cloudToResult"] = json(*v.cloudToResult, result);
        out["seconds"] = {{"cloud", t1 - t0}, {"truth", t2 - t1}, {"result", t3 - t2}, {"validate", t4 - t3}};
        if (!jsonPath.empty())
            std::ofstream(jsonPath) << out.dump(1) << '\n';
        for (const char* key : {"cloudToTruth", "cloudToResult"})
            if (out.contains(key))
                out[key].erase("elements");
        std::cout << out.dump(1) << '\n';
    }
    catch (const std::exception& e)
    {
        std::cerr << "s2b_validate: " << e.what() << "\n";
        return 1;
    }
    return 0;
}

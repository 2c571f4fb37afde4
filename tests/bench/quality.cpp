// SPDX-License-Identifier: GPL-3.0-or-later
/// s2b_quality SCAN.laz TRUTH --mode given|degraded|geometry|segmented --ifc OUT.ifc --json OUT.json: one survey in one
/// mode, as scripts/bench quality runs it: reconstructed, written, read back, scored, and drawn storey by storey.
#include "core/pipeline/pipeline.h"
#include "core/report/html.h"
#include "core/report/plan_view.h"
#include "core/report/rasters.h"
#include "core/segmentation/segment.h"
#include "core/segmentation/shipped_model.h"
#include "core/validation/validation.h"
#include "ifc/bim_reader.h"
#include "ifc/ifc_writer.h"
#include "tests/bench/degrade.h"
#include "tests/bench/laz_reader.h"
#include "tests/bench/process_memory.h"
#include "tests/bench/survey_stations.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>

namespace
{

using Json = nlohmann::ordered_json;
using namespace s2b;
using namespace s2b::validation;

struct Options
{
    std::string cloud, truth, stations, mode = "given", model, ifc, json;
    std::vector<std::string> assignments;
    unsigned threads = 0;
    std::uint64_t seed = 7;
};

double seconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Json number(std::optional<double> value)
{
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

OnnxModel openModel(const Options& o)
{
    if (!o.model.empty())
        return OnnxModel::load(o.model, o.threads);
    if (shippedModel().empty())
        throw Error(ErrorCode::BadFile, "there is no shipped model, give one with --model");
    return OnnxModel::fromBytes(shippedModel(), kShippedModelName, o.threads);
}

/// Intersection over union of each class's points; null for a class that neither has. Points that the truth leaves
/// unassigned say nothing. The mean is over the classes that the truth has, of those that make a building.
Json labelsJson(const CloudView& truth, const Segmentation& result, double seconds)
{
    std::array<double, kLabelCount> both{}, either{}, there{};
    std::array<std::array<std::size_t, kLabelCount>, kLabelCount> confusion{};
    for (std::size_t i = 0; i < truth.count; ++i)
    {
        const std::size_t a = truth.labels[i], b = result.labels[i];
        ++confusion[a][b];
        if (a == static_cast<std::size_t>(Label::Unassigned))
            continue;
        ++there[a];
        ++either[a];
        if (a == b)
            ++both[a];
        else
            ++either[b];
    }
    Json out{{"seconds", seconds}, {"millions_per_second", 1e-6 * static_cast<double>(truth.count) / seconds}};
    double sum = 0, classes = 0;
    for (std::size_t k = 1; k < kLabelCount; ++k)
    {
        const auto label = static_cast<Label>(k);
        const double iou = either[k] > 0 ? both[k] / either[k] : 0.0;
        out[std::string(labelName(label))] = either[k] > 0 ? Json(iou) : Json(nullptr);
        if (there[k] > 0 && label <= Label::Window)
            sum += iou, classes += 1;
    }
    out["mean"] = classes > 0 ? Json(sum / classes) : Json(nullptr);
    out["confusion"] = confusion;  // points, by the truth's class and the result's
    return out;
}

/// A class that neither truth nor result has says nothing: null.
Json scoreJson(const ClassScore& s)
{
    return {{"truth", s.truthCount},
            {"result", s.resultCount},
            {"iou", number(s.iou)},
            {"f1", s.truthCount + s.resultCount > 0 ? Json(s.at50.f1) : Json(nullptr)},
            {"both_sides_iou", number(s.iouBothSides)},
            {"thickness_m", number(s.thicknessError_m)}};
}

Json storeysJson(const Validation& v)
{
    std::optional<double> worst;
    int missed = 0;
    for (const StoreyError& e : v.storeys)
    {
        if (e.result >= 0)
            worst = std::max(worst.value_or(0.0), e.error_m);
        else
            ++missed;
    }
    return {{"error_m", number(worst)}, {"missed", missed}, {"extra", v.extraStoreys}};
}

/// Plans of all storeys that were seen, with what is wrong in each. An element is found from an IoU of 0.5, as F1 in
/// the table counts it, and out of tolerance where its place, length or thickness is off by 5 cm (LOA20).
Json plansJson(const Bim& truth, const Bim& result, const CloudView& view, const Context& context)
{
    ValidationParams params;
    params.minimumMatch = 0.5;
    params.tolerance = 20;
    Validation v = validate(truth, result, nullptr, params, context);
    for (ElementResult& pair : v.elements)
    {
        // Scores compare these between floor and ceiling: how far a wall reaches into a slab is the modeller's habit.
        if (pair.elementClass == ElementClass::Wall || pair.elementClass == ElementClass::Column)
            pair.heightError_m.reset();
    }
    report::ReportInput input;
    input.truth = &truth;
    input.result = &result;
    input.validation = &v;
    input.params = &params;
    input.cloud = &view;
    const report::Scene scene = report::makeScene(input);
    Json plans = Json::array();
    for (const report::Level& level : scene.levels)
    {
        Json wrong = Json::array();
        bool isSeen = false;
        for (const std::size_t i : level.rows)
        {
            const report::Row& row = scene.rows[i];
            isSeen = isSeen || row.style != report::Style::NotSeen;
            if (row.verdict == Verdict::OutOfTolerance && row.pair.elementClass != ElementClass::Space)
                wrong.push_back(
                    {{"number", row.number},
                     {"class", className(row.pair.elementClass)},
                     {"outcome", row.pair.outcome == Outcome::Matched ? "out of tolerance"
                                                                      : report::outcomeName(row.pair.outcome)},
                     {"iou", row.pair.iou},
                     {"error_m", number(row.error_m)},
                     {"id", row.id}});
        }
        if (!isSeen)
            continue;
        std::vector<report::WallFaces> none;
        const report::StoreyRasters rasters = report::rasterize(input, scene, level, none, context);
        const report::Drawing drawing = report::drawPlan(scene, level, rasters);
        plans.push_back({{"level", level.name},
                         {"elevation_m", level.elevation_m + scene.base.z()},
                         {"is_of_truth", level.truth >= 0},
                         {"svg", drawing.svg},
                         {"caption", drawing.caption},
                         {"wrong", wrong}});
    }
    return {{"style", report::pageStyle()},
            {"definitions", report::sharedDefinitions()},
            {"legend", report::planLegend(scene)},
            {"storeys", plans}};
}

Json run(const Options& o)
{
    std::vector<std::array<std::uint8_t, 3>> colours;
    std::vector<std::uint16_t> sources;
    PointCloud cloud =
        readLaz(o.cloud, o.mode == "segmented" ? &colours : nullptr, o.stations.empty() ? nullptr : &sources);
    if (cloud.points.empty())
        throw Error(ErrorCode::EmptyCloud, o.cloud + " has no points");
    if (o.mode == "degraded")
        degrade(cloud, o.seed, sources.empty() ? nullptr : &sources);
    CloudView view{cloud.points.front().data(), cloud.size(), cloud.origin,
                   reinterpret_cast<const std::uint8_t*>(cloud.labels.data())};
    SurveyStations stations;
    if (!o.stations.empty())
        stations = surveyStations(o.stations, cloud.origin, sources);
    view.stations = stations.view();
    PipelineOptions pipeline;
    pipeline.geometryOnly = o.mode == "geometry";
    for (const std::string& a : o.assignments)
        setParameter(pipeline.parameters, a);
    Context context;
    context.threads = o.threads;
    const bench::MemoryMeter memory;
    Json labels;
    Segmentation segmentation;
    if (o.mode == "segmented")
    {
        if (!colours.empty())
            view.rgb = colours.front().data();
        const OnnxModel model = openModel(o);
        const double start = seconds();
        segmentation = segment(view, model, {}, context);
        labels = labelsJson(view, segmentation, seconds() - start);
        view.labels = segmentation.labels.data();
        view.confidence = segmentation.confidence.data();
    }
    const double start = seconds();
    const Building building = reconstruct(view, pipeline, context);
    const double took = seconds() - start;
    const double peak_b = memory.peak_b();
    ifc::writeIfc(building, o.ifc, {});

    ifc::BimReadOptions reading;
    reading.withMeshes = false;
    const Bim truth = ifc::readTruth(o.truth, reading);
    reading.near = centerOf(truth);
    Bim result;
    if (building.walls.empty() && building.columns.empty() && building.slabs.empty() && building.spaces.empty())
    {
        result.file = o.ifc;  // a model without elements can't be read, but it can be scored
        result.origin = truth.origin;
    }
    else
        result = ifc::readBim(o.ifc, reading);
    const Validation v = validate(truth, result, nullptr, {}, context);

    Json out{{"points", cloud.size()},
             {"seconds", took},
             {"peak_b", peak_b},
             {"loaded_b", memory.before_b()},
             {"storeys", storeysJson(v)}};
    for (const ElementClass c :
         {ElementClass::Wall, ElementClass::Door, ElementClass::Window, ElementClass::Column, ElementClass::Slab})
    {
        const auto score = v.scores.find(c);
        out[className(c)] = scoreJson(score == v.scores.end() ? ClassScore{} : score->second);
    }
    if (!labels.is_null())
        out["labels"] = labels;
    out["plans"] = plansJson(truth, result, view, context);
    return out;
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("Reconstructs a survey in one mode, scores the model against the truth, and draws both.");
    Options o;
    app.add_option("cloud", o.cloud, "LAS or LAZ file")->required();
    app.add_option("truth", o.truth, "what a simulated survey wrote beside it, IFC, or CV4AEC JSON")->required();
    app.add_option("--mode", o.mode, "given, degraded (wrong labels, occlusion), geometry (no labels) or segmented")
        ->check(CLI::IsMember({"given", "degraded", "geometry", "segmented"}));
    app.add_option("--model", o.model, "ONNX file for segmented (default: the shipped one)");
    app.add_option("--stations", o.stations,
                   "where the scanner stood, by the points' source ids: the truth, or a file");
    app.add_option("--ifc", o.ifc, "the model to write")->required();
    app.add_option("--json", o.json, "scores and plans to write")->required();
    app.add_option("--set", o.assignments, "parameter, name=value");
    app.add_option("--threads", o.threads, "0 = all");
    app.add_option("--seed", o.seed, "of the degradation");
    CLI11_PARSE(app, argc, argv);
    try
    {
        const Json out = run(o);
        std::ofstream file(o.json);
        file << out.dump() << '\n';
        if (!file.flush())
            throw Error(ErrorCode::CannotWrite, o.json + " can't be written");
    }
    catch (const std::exception& e)
    {
        std::cerr << "s2b_quality: " << e.what() << "\n";
        return 1;
    }
    return 0;
}

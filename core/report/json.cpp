// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/json.h"

#include "core/report/text.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace s2b::report
{
using namespace validation;
using Json = nlohmann::ordered_json;
namespace
{

Json optional(const std::optional<double>& value)
{
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json real(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json bimJson(const Bim* bim)
{
    if (!bim)
        return nullptr;
    return {{"name", fileName(bim->file)},
            {"schema", cleanText(bim->schema)},
            {"elements", bim->elements.size()},
            {"storeys", bim->storeys.size()}};
}

Json ratesJson(const Rates& rates)
{
    return {{"precision", real(rates.precision)}, {"recall", real(rates.recall)}, {"f1", real(rates.f1)}};
}

Json scoreJson(const ClassScore& score)
{
    Json corners = Json::object();
    for (const auto& [distance_cm, rates] : score.cornersAt)
        corners[std::to_string(distance_cm)] = ratesJson(rates);
    return {{"truthCount", score.truthCount},
            {"resultCount", score.resultCount},
            {"notSeenCount", score.notSeenCount},
            {"iou", optional(score.iou)},
            {"iouMatched", real(score.iouMatched)},
            {"iouFullHeight", optional(score.iouFull)},
            {"iouNearest", optional(score.iouNearest)},
            {"iouBothSides", optional(score.iouBothSides)},
            {"bothSidesCount", score.bothSidesCount},
            {"at25", ratesJson(score.at25)},
            {"at50", ratesJson(score.at50)},
            {"volumetricIou", optional(score.volumetricIou)},
            {"centroid_m", optional(score.centroid_m)},
            {"thicknessError_m", optional(score.thicknessError_m)},
            {"heightError_m", optional(score.heightError_m)},
            {"axisEnd_m", optional(score.axisEnd_m)},
            {"cornersAt", corners}};
}

Json deviationJson(const Deviation* deviation)
{
    if (!deviation)
        return nullptr;
    return {{"points", deviation->points},
            {"meanAbsolute_m", real(deviation->meanAbsolute_m)},
            {"meanSigned_m", real(deviation->meanSigned_m)},
            {"median_m", real(deviation->median_m)},
            {"rms_m", real(deviation->rms_m)},
            {"p95_m", real(deviation->p95_m)},
            {"coverage", real(deviation->coverage)},
            {"loa", loaName(deviation->band)},
            {"verdict", verdictName(deviation->verdict)}};
}

Json cloudJson(const std::optional<CloudDeviation>& deviation, const ValidationParams& params)
{
    if (!deviation)
        return nullptr;
    Json byClass = Json::object();
    for (const auto& [elementClass, mean_m] : deviation->meanAbsolute_m)
        byClass[className(elementClass)] = real(mean_m);
    return {
        {"wallMeanAbsolute_m", real(deviation->wallMeanAbsolute_m)},
        {"meanAbsolute_m", byClass},
        {"histogram",
         {{"low_m", -params.deviationRange_m}, {"high_m", params.deviationRange_m}, {"counts", deviation->histogram}}}};
}

Json sideJson(const BimElement* element, int index)
{
    if (!element)
        return nullptr;
    return {{"guid", cleanText(element->guid)},
            {"name", cleanText(element->name)},
            {"type", cleanText(element->type)},
            {"index", index}};
}

Json rowJson(const Row& row, bool hasTruth)
{
    return {{"number", row.number},
            {"class", className(row.pair.elementClass)},
            {"outcome", hasTruth ? Json(outcomeName(row.pair.outcome)) : Json(nullptr)},
            {"verdict", verdictName(row.verdict)},
            {"reason", row.reason},
            {"loa", loaName(row.band)},
            {"storey", row.storey},
            {"result", sideJson(row.result, row.pair.result)},
            {"truth", sideJson(row.truth, row.pair.truth)},
            {"iou", row.truth && row.result ? real(row.pair.iou) : Json(nullptr)},
            {"centroid_m", optional(row.pair.centroid_m)},
            {"thicknessError_m", optional(row.pair.thicknessError_m)},
            {"heightError_m", optional(row.pair.heightError_m)},
            {"axisEnd_m", optional(row.pair.axisEnd_m)},
            {"cloudToResult", deviationJson(row.toResult)},
            {"cloudToTruth", deviationJson(row.toTruth)}};
}

Json storeysJson(const ReportInput& input, const Scene& scene)
{
    Json storeys = Json::array();
    if (!input.truth)
        return storeys;
    for (const StoreyError& error : input.validation->storeys)
    {
        const auto name = [](const Bim& bim, int index)
        { return index < 0 ? Json(nullptr) : Json(cleanText(bim.storeys[static_cast<std::size_t>(index)].name)); };
        const auto elevation = [](const Bim& bim, int index, double base)
        { return index < 0 ? Json(nullptr) : Json(bim.storeys[static_cast<std::size_t>(index)].elevation_m + base); };
        storeys.push_back(
            {{"truth", name(*input.truth, error.truth)},
             {"truthElevation_m", elevation(*input.truth, error.truth, scene.truthShift.z() + scene.base.z())},
             {"result", name(*input.result, error.result)},
             {"resultElevation_m", elevation(*input.result, error.result, scene.resultShift.z() + scene.base.z())},
             {"error_m", error.result < 0 ? Json(nullptr) : real(error.error_m)}});
    }
    return storeys;
}

Json diagnosticsJson(const Building* building)
{
    static constexpr std::array<const char*, 3> kSeverity{"info", "warning", "error"};
    Json list = Json::array();
    if (!building)
        return list;
    for (const Diagnostic& diagnostic : building->diagnostics)
    {
        const Eigen::Vector3d place = building->frame.toWorld(diagnostic.location);
        list.push_back(
            {{"severity", kSeverity[static_cast<std::size_t>(diagnostic.severity)]},
             {"stage", cleanText(diagnostic.stage)},
             {"code", cleanText(diagnostic.code)},
             {"text", cleanText(diagnostic.text)},
             {"place", diagnostic.location.isZero() ? Json(nullptr) : Json{place.x(), place.y(), place.z()}}});
    }
    return list;
}

}  // namespace

std::string makeJson(const ReportInput& input, const Scene& scene)
{
    const ValidationParams& params = *input.params;
    Json json;
    json["format"] = {{"name", "scan-to-bim validation report"}, {"version", 1}};
    json["software"] = cleanText(input.softwareVersion);
    json["timestamp"] = cleanText(input.timestamp);
    json["files"] = {{"result", bimJson(input.result)}, {"truth", bimJson(input.truth)}};
    json["files"]["cloud"] =
        input.cloud ? Json{{"name", cleanText(input.cloudName)}, {"points", input.cloud->count}} : Json(nullptr);
    json["validationParameters"] = {{"deviationRange_m", params.deviationRange_m},
                                    {"minimumCoverage", params.minimumCoverage},
                                    {"minimumMatch", params.minimumMatch},
                                    {"tolerance", params.tolerance},
                                    {"loaLimit_m", params.loaLimit_m}};
    json["parameters"] = Json::object();
    for (const auto& [name, value] : input.parameters)
        json["parameters"][cleanText(name)] = cleanText(value);

    Json verdicts = {{"within tolerance", 0}, {"out of tolerance", 0}, {"no data", 0}};
    for (const Row& row : scene.rows)
        verdicts[verdictName(row.verdict)] = verdicts[verdictName(row.verdict)].get<int>() + 1;
    json["summary"] = {{"toleranceLimit_m", scene.toleranceLimit_m},
                       {"verdicts", verdicts},
                       {"meanIou", optional(input.validation->meanIou)},
                       {"extraStoreys", input.validation->extraStoreys}};
    json["classes"] = Json::object();
    for (const auto& [elementClass, score] : input.validation->scores)
        json["classes"][className(elementClass)] = scoreJson(score);
    json["storeys"] = storeysJson(input, scene);
    json["cloudToResult"] = cloudJson(input.validation->cloudToResult, params);
    json["cloudToTruth"] = cloudJson(input.validation->cloudToTruth, params);
    json["elements"] = Json::array();
    for (const Row& row : scene.rows)
        json["elements"].push_back(rowJson(row, scene.hasTruth));
    json["diagnostics"] = diagnosticsJson(input.building);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace s2b::report

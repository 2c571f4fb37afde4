// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/html.h"

#include "core/base/error.h"
#include "core/report/charts.h"
#include "core/report/template.h"
#include "core/report/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace s2b::report
{
using namespace validation;
namespace
{

struct Counts
{
    int judged = 0;
    int within = 0;
    int out = 0;
    int noData = 0;
    int notSeen = 0;
    std::map<LoaBand, int> bands;
};

Counts countRows(const Scene& scene, std::optional<ElementClass> elementClass)
{
    Counts counts;
    for (const Row& row : scene.rows)
    {
        if (elementClass && row.pair.elementClass != *elementClass)
            continue;
        counts.within += row.verdict == Verdict::Within ? 1 : 0;
        counts.out += row.verdict == Verdict::OutOfTolerance ? 1 : 0;
        counts.notSeen += row.pair.outcome == Outcome::NotSeen ? 1 : 0;
        counts.noData += row.verdict == Verdict::NoData && row.pair.outcome != Outcome::NotSeen ? 1 : 0;
        if (row.result)
            ++counts.bands[row.band];
    }
    counts.judged = counts.within + counts.out;
    return counts;
}

const char* cssOf(Style style)
{
    static constexpr std::array<const char*, 6> kCss{"within", "out", "missed", "extra", "nodata", "notseen"};
    return kCss[static_cast<std::size_t>(style)];
}

void addTile(Fields& page, const std::string& value, const std::string& unit, const std::string& label)
{
    Fields& tile = page.add("TILE");
    tile.set("VALUE", value);
    tile.set("UNIT", unit);
    tile.set("LABEL", label);
}

void addHead(Fields& page, const ReportInput& input, const Scene& scene)
{
    const Counts all = countRows(scene, std::nullopt);
    const std::string result = fileName(input.result->file);
    page.set("TITLE", result + (input.truth ? " against " + fileName(input.truth->file) : " against the points"));
    page.set("RESULT", result);
    page.set("TOLERANCE", "LOA" + std::to_string(input.params->tolerance));
    page.set("LIMIT", roundMillimetres(scene.toleranceLimit_m));
    if (all.judged > 0)
    {
        Fields& verdict = page.add("VERDICT");
        verdict.set("CLASS", all.out == 0 ? "good" : "bad");
        verdict.set("MARK", all.out == 0 ? "\u2713" : "!");
        verdict.set("TEXT", std::to_string(all.within) + " of " + std::to_string(all.judged) +
                                " judged elements are within tolerance.");
        std::string rest;
        if (all.noData > 0)
            rest +=
                std::to_string(all.noData) + (all.noData == 1 ? " has" : " have") + " too few points to be judged. ";
        if (all.notSeen > 0)
            rest += std::to_string(all.notSeen) + " of the truth " + (all.notSeen == 1 ? "was" : "were") +
                    " not seen by the survey and not asked for.";
        verdict.set("REST", rest);
    }
    else
        page.add("UNDECIDED");

    const auto& scores = input.validation->scores;
    if (const auto walls = scores.find(ElementClass::Wall); input.truth && walls != scores.end())
    {
        addTile(page, number(walls->second.at50.f1, 2), "", "F1 of walls at IoU 0.5");
        addTile(page, number(walls->second.iou, 2), "", "mean IoU of walls");
        if (walls->second.axisEnd_m)
            addTile(page, millimetres(walls->second.axisEnd_m), "mm", "axis ends of walls, median");
    }
    if (input.validation->cloudToResult)
        addTile(page, millimetres(input.validation->cloudToResult->wallMeanAbsolute_m), "mm",
                "points to walls of the result, mean absolute");
    if (input.validation->cloudToTruth)
        addTile(page, millimetres(input.validation->cloudToTruth->wallMeanAbsolute_m), "mm",
                "points to walls of the truth, mean absolute");
    addTile(page, std::to_string(all.out), "", "elements out of tolerance");
}

void addFiles(Fields& page, const ReportInput& input)
{
    const auto add = [&](const std::string& role, const std::string& name, const std::string& about)
    {
        Fields& file = page.add("FILE");
        file.set("ROLE", role);
        file.set("NAME", name);
        file.set("ABOUT", about);
    };
    const auto about = [](const Bim& bim)
    {
        return cleanText(bim.schema) + ", " + counted(bim.elements.size()) + " elements, " +
               counted(bim.storeys.size()) + (bim.storeys.size() == 1 ? " storey" : " storeys");
    };
    add(input.truth ? "Result" : "Model", fileName(input.result->file), about(*input.result));
    if (input.truth)
        add("Ground truth", fileName(input.truth->file), about(*input.truth));
    if (input.cloud)
        add("Point cloud", cleanText(input.cloudName), counted(input.cloud->count) + " points");
    else
        add("Point cloud", "none", "deviations from points are not part of this report");
    add("Software", cleanText(input.softwareVersion), "");
    if (input.timestamp != ReportInput{}.timestamp)
        add("Date", cleanText(input.timestamp), "");
}

void addClasses(Fields& page, const ReportInput& input, const Scene& scene)
{
    for (const auto& [elementClass, score] : input.validation->scores)
    {
        const Counts counts = countRows(scene, elementClass);
        if (!input.truth ||
            (score.truthCount == 0 && score.resultCount == 0 && counts.judged == 0 && score.notSeenCount == 0))
            continue;
        Fields& row = page.add("CLASS_FOUND");
        row.set("CLASS", pluralName(elementClass));
        row.set("TRUTH", counted(static_cast<std::uint64_t>(score.truthCount)));
        row.set("RESULT", counted(static_cast<std::uint64_t>(score.resultCount)));
        row.set("NOT_SEEN", counted(static_cast<std::uint64_t>(score.notSeenCount)));
        row.set("IOU", number(score.iou, 3));
        row.set("IOU_MATCHED", score.truthCount > 0 ? number(score.iouMatched, 3) : kNone);
        row.set("VOLUMETRIC", number(score.volumetricIou, 3));
        const auto rates = [&](const std::string& at, const Rates& r)
        {
            row.set("P" + at, number(r.precision, 2));
            row.set("R" + at, number(r.recall, 2));
            row.set("F" + at, number(r.f1, 2));
        };
        rates("25", score.at25);
        rates("50", score.at50);

        Fields& size = page.add("CLASS_SIZE");
        size.set("CLASS", pluralName(elementClass));
        size.set("CENTROID", millimetres(score.centroid_m));
        size.set("AXIS", millimetres(score.axisEnd_m));
        size.set("THICKNESS", millimetres(score.thicknessError_m));
        size.set("HEIGHT", millimetres(score.heightError_m));
        for (const int distance_cm : {5, 10, 20})
        {
            const auto corner = score.cornersAt.find(distance_cm);
            size.set("C" + std::to_string(distance_cm),
                     corner == score.cornersAt.end() ? std::string(kNone) : number(corner->second.f1, 2));
        }
    }
    for (const ElementClass elementClass : {ElementClass::Wall, ElementClass::Door, ElementClass::Window,
                                            ElementClass::Column, ElementClass::Slab, ElementClass::Space})
    {
        const Counts counts = countRows(scene, elementClass);
        if (counts.judged + counts.noData == 0)
            continue;
        const auto mean = [&](const std::optional<CloudDeviation>& deviation)
        {
            if (!deviation)
                return std::string(kNone);
            const auto found = deviation->meanAbsolute_m.find(elementClass);
            return found == deviation->meanAbsolute_m.end() ? std::string(kNone) : millimetres(found->second);
        };
        Fields& row = page.add("CLASS_TOLERANCE");
        row.set("CLASS", pluralName(elementClass));
        row.set("TO_RESULT", mean(input.validation->cloudToResult));
        row.set("TO_TRUTH", mean(input.validation->cloudToTruth));
        row.set("WITHIN", std::to_string(counts.within));
        row.set("OUT", std::to_string(counts.out));
        row.set("NO_DATA", std::to_string(counts.noData));
        row.set("BANDS", bandBar(counts.bands));
    }
    page.set("BAND_LEGEND", bandLegend(*input.params));
}

void addStoreys(Fields& page, const ReportInput& input, const Scene& scene)
{
    if (!input.truth || input.validation->storeys.empty())
        return;
    Fields& table = page.add("STOREYS");
    for (const StoreyError& error : input.validation->storeys)
    {
        if (error.truth < 0)
            continue;
        const BimStorey& truth = input.truth->storeys[static_cast<std::size_t>(error.truth)];
        Fields& row = table.add("STOREY");
        row.set("NAME", cleanText(truth.name));
        row.set("TRUTH", number(truth.elevation_m + scene.truthShift.z() + scene.base.z(), 3));
        if (error.result >= 0)
        {
            const BimStorey& result = input.result->storeys[static_cast<std::size_t>(error.result)];
            row.set("RESULT", number(result.elevation_m + scene.resultShift.z() + scene.base.z(), 3));
            row.set("ERROR", millimetres(error.error_m));
            row.set("REMARK", "");
        }
        else
        {
            row.set("RESULT", kNone);
            row.set("ERROR", kNone);
            row.set("REMARK", truth.isSurveyed ? "missed" : "not surveyed");
        }
    }
    if (input.validation->extraStoreys > 0)
        table.add("EXTRA").set("COUNT", std::to_string(input.validation->extraStoreys));
}

void addElements(Fields& page, const Scene& scene)
{
    for (const Row& row : scene.rows)
    {
        Fields& fields = page.add("ELEMENT");
        fields.set("NUMBER", std::to_string(row.number));
        fields.set("STYLE", cssOf(row.style));
        fields.set("CLASS", className(row.pair.elementClass));
        fields.set("ID", row.id);
        fields.set("NAME", row.name);
        fields.set("STOREY", row.storey);
        const bool isPair = row.truth && row.result;
        fields.set("IOU", isPair ? number(row.pair.iou, 2) : kNone);
        fields.set("PLACE", millimetres(row.pair.axisEnd_m ? row.pair.axisEnd_m : row.pair.centroid_m));
        fields.set("THICKNESS", millimetres(row.pair.thicknessError_m, true));
        fields.set("HEIGHT", millimetres(row.pair.heightError_m, true));
        const bool hasPoints = row.toResult && row.toResult->points > 0;
        fields.set("MEAN", hasPoints ? millimetres(row.toResult->meanSigned_m, true) : kNone);
        fields.set("P95", hasPoints ? millimetres(row.toResult->p95_m) : kNone);
        fields.set("COVERAGE", row.toResult ? percent(row.toResult->coverage) : kNone);
        fields.set("LOA", row.band == LoaBand::NoData ? kNone : loaName(row.band));
        const bool isOrdinary = row.pair.outcome == Outcome::Matched;
        fields.set("VERDICT", isOrdinary ? verdictName(row.verdict) : outcomeName(row.pair.outcome));
        fields.set("REASON", row.reason);
    }
}

void addDrawings(Fields& page, const std::string& section, const std::vector<Drawing>& drawings,
                 const std::string& legend)
{
    Fields shown;
    for (const Drawing& drawing : drawings)
    {
        if (drawing.svg.empty())
            continue;
        // The first one stays on a page with the heading and the legend.
        Fields& figure = shown.add(shown.sections.empty() ? "FIRST" : "FIGURE");
        figure.set("SVG", drawing.svg);
        figure.set("CAPTION", drawing.caption);
    }
    if (shown.sections.empty())
        return;
    shown.set("LEGEND", legend);
    page.add(section) = shown;
}

void addHistogram(Fields& page, const ReportInput& input, const Scene& scene)
{
    const auto& deviation = input.validation->cloudToResult;
    if (!deviation)
        return;
    const std::string svg = histogram(scene, *deviation, *input.params);
    if (svg.empty())
        return;
    std::uint64_t points = 0;
    for (const std::uint64_t count : deviation->histogram)
        points += count;
    Fields& figure = page.add("HISTOGRAM");
    figure.set("SVG", svg);
    figure.set("CAPTION", counted(points) + " points within " + roundMillimetres(input.params->deviationRange_m) +
                              " mm of an element; points farther away are not of the building.");
}

void addParameters(Fields& page, const ReportInput& input)
{
    const auto add = [&](const std::string& section, const std::string& name, const std::string& value)
    {
        Fields& row = page.add(section);
        row.set("NAME", name);
        row.set("VALUE", value);
    };
    const ValidationParams& params = *input.params;
    add("VALIDATION", "Tolerance", "LOA" + std::to_string(params.tolerance));
    std::string limits;
    for (std::size_t i = 0; i < params.loaLimit_m.size(); ++i)
        limits += (i ? ", " : "") + std::string("LOA") + std::to_string(10 * (i + 1)) + " " +
                  roundMillimetres(params.loaLimit_m[i]) + " mm";
    add("VALIDATION", "Limits of the accuracy bands (95 %)", limits);
    add("VALIDATION", "Points count up to this distance", roundMillimetres(params.deviationRange_m) + " mm");
    add("VALIDATION", "An element counts as seen from a coverage of", percent(params.minimumCoverage));
    add("VALIDATION", "A pair is a match from an IoU of", number(params.minimumMatch, 2));
    if (input.parameters.empty())
        return;
    Fields& table = page.add("PARAMETERS");
    for (const auto& [name, value] : input.parameters)
    {
        Fields& row = table.add("PARAMETER");
        row.set("NAME", cleanText(name));
        row.set("VALUE", cleanText(value));
    }
}

void addDiagnostics(Fields& page, const ReportInput& input)
{
    static constexpr std::array<const char*, 3> kSeverity{"info", "warning", "error"};
    if (!input.building || input.building->diagnostics.empty())
        return;
    Fields& table = page.add("DIAGNOSTICS");
    for (int severity = 2; severity >= 0; --severity)
    {
        for (const Diagnostic& diagnostic : input.building->diagnostics)
        {
            if (static_cast<int>(diagnostic.severity) != severity)
                continue;
            Fields& row = table.add("DIAGNOSTIC");
            row.set("SEVERITY", kSeverity[static_cast<std::size_t>(severity)]);
            row.set("STAGE", cleanText(diagnostic.stage));
            row.set("TEXT", cleanText(diagnostic.text));
            const Eigen::Vector3d p = input.building->frame.toWorld(diagnostic.location);
            row.set("PLACE", diagnostic.location.isZero()
                                 ? std::string(kNone)
                                 : number(p.x(), 2) + ", " + number(p.y(), 2) + ", " + number(p.z(), 2));
        }
    }
}

}  // namespace

std::string makeHtml(const ReportInput& input, const Scene& scene, const Drawings& drawings)
{
    Fields page;
    addHead(page, input, scene);
    addFiles(page, input);
    addClasses(page, input, scene);
    addStoreys(page, input, scene);
    page.set("DEFINITIONS", sharedDefinitions());
    addDrawings(page, "PLANS", drawings.plans, planLegend(scene));
    if (!drawings.unseen.empty())
    {
        std::string names;
        for (const std::string& name : drawings.unseen)
            names += (names.empty() ? "" : ", ") + name;
        page.add("UNSEEN").set("NAMES", names);
    }
    addElements(page, scene);
    const std::string bar = colorBar(scene);
    addDrawings(page, "DEVIATIONS", drawings.deviations, bar);
    addDrawings(page, "WALLS", drawings.walls, bar);
    addHistogram(page, input, scene);
    addParameters(page, input);
    addDiagnostics(page, input);

    // Sections of the same name stand within their table: the template repeats the rows.
    Fields top = page;
    top.sections.clear();
    Fields found;
    Fields size;
    for (auto& [name, fields] : page.sections)
    {
        if (name == "CLASS_FOUND")
            found.add("CLASS_ROW") = fields;
        else if (name == "CLASS_SIZE")
            size.add("CLASS_ROW") = fields;
        else
            top.sections.emplace_back(name, fields);
    }
    if (!found.sections.empty())
    {
        top.add("FOUND") = found;
        top.add("SIZE") = size;
    }
    return fillTemplate(kReportTemplate, top);
}

std::string pageStyle()
{
    constexpr std::string_view kOpen = "<style>";
    const std::size_t begin = kReportTemplate.find(kOpen);
    const std::size_t end = kReportTemplate.find("</style>");
    if (begin == std::string_view::npos || end == std::string_view::npos)
        throw Error(ErrorCode::Internal, "the template of the report has no style sheet");
    return std::string(kReportTemplate.substr(begin + kOpen.size(), end - begin - kOpen.size()));
}

}  // namespace s2b::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/csv.h"

#include "core/report/text.h"

#include <cmath>
#include <string_view>
#include <vector>

namespace s2b::report
{
using namespace validation;
namespace
{

constexpr int kDecimals = 5;  // of metres and shares: finer than any scanner

std::string quoted(std::string_view text)
{
    if (text.find_first_of(",\"\r\n") == std::string_view::npos)
        return std::string(text);
    std::string field = "\"";
    for (const char c : text)
        field += c == '"' ? std::string("\"\"") : std::string(1, c);
    return field + "\"";
}

std::string value(const std::optional<double>& number)
{
    return number && std::isfinite(*number) ? plainNumber(*number, kDecimals) : std::string();
}

void addDeviation(std::vector<std::string>& fields, const Deviation* deviation)
{
    if (!deviation)
    {
        fields.insert(fields.end(), 7, "");
        return;
    }
    fields.push_back(std::to_string(deviation->points));
    for (const double number : {deviation->meanAbsolute_m, deviation->meanSigned_m, deviation->median_m,
                                deviation->rms_m, deviation->p95_m, deviation->coverage})
        fields.push_back(value(number));
}

void addLine(std::string& csv, const std::vector<std::string>& fields)
{
    for (std::size_t i = 0; i < fields.size(); ++i)
        csv += (i ? "," : "") + quoted(fields[i]);
    csv += "\r\n";
}

}  // namespace

std::string makeCsv(const Scene& scene)
{
    std::string csv;
    addLine(csv, {"number",
                  "class",
                  "outcome",
                  "verdict",
                  "loa",
                  "storey",
                  "name",
                  "result_guid",
                  "truth_guid",
                  "iou",
                  "centroid_m",
                  "thickness_error_m",
                  "height_error_m",
                  "axis_end_m",
                  "points",
                  "mean_absolute_m",
                  "mean_signed_m",
                  "median_m",
                  "rms_m",
                  "p95_m",
                  "coverage",
                  "truth_points",
                  "truth_mean_absolute_m",
                  "truth_mean_signed_m",
                  "truth_median_m",
                  "truth_rms_m",
                  "truth_p95_m",
                  "truth_coverage",
                  "reason"});
    for (const Row& row : scene.rows)
    {
        const ElementResult& pair = row.pair;
        std::vector<std::string> fields{std::to_string(row.number),
                                        className(pair.elementClass),
                                        scene.hasTruth ? outcomeName(pair.outcome) : "",
                                        verdictName(row.verdict),
                                        loaName(row.band),
                                        row.storey,
                                        row.name,
                                        row.result ? cleanText(row.result->guid) : "",
                                        row.truth ? cleanText(row.truth->guid) : "",
                                        row.truth && row.result ? value(pair.iou) : "",
                                        value(pair.centroid_m),
                                        value(pair.thicknessError_m),
                                        value(pair.heightError_m),
                                        value(pair.axisEnd_m)};
        addDeviation(fields, row.toResult);
        addDeviation(fields, row.toTruth);
        fields.push_back(row.reason);
        addLine(csv, fields);
    }
    return csv;
}

}  // namespace s2b::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/validation_parameters.h"

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/pipeline/parameter_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace s2b::validation
{

namespace
{

[[noreturn]] void fail(const std::string& message)
{
    throw Error(ErrorCode::BadParameter, message);
}

template <auto kMember>
ParameterRow row(const char* name, const char* unit, double minimum, double maximum, const char* help,
                 const char* source)
{
    return {name, unit, minimum, maximum, help, source, +[](ValidationParams& p) { return &(p.*kMember); }};
}

template <std::size_t kBand>
ParameterRow limit(const char* name, const char* help, const char* source)
{
    return {name, "m", 0.0001, 1.0, help, source, +[](ValidationParams& p) { return &p.loaLimit_m[kBand]; }};
}

double valueOf(const ParameterRow& row, const ValidationParams& params)
{
    ValidationParams copy = params;  // one accessor serves reading and writing
    return std::visit([&](auto find) { return static_cast<double>(*find(copy)); }, row.member);
}

std::string range(const ParameterRow& row)
{
    return numberText(row.minimum) + " to " + numberText(row.maximum) +
           (row.unit.empty() || row.unit == "1" ? "" : " " + row.unit);
}

void check(const ParameterRow& row, double value)
{
    if (!(value >= row.minimum && value <= row.maximum))  // NaN as well
        fail(row.name + " = " + numberText(value) + " is out of range, use " + range(row));
    if (row.name == "validation.tolerance" && std::fmod(value, 10.0) != 0.0)
        fail(row.name + " = " + numberText(value) + " is no level of accuracy, use 10, 20, 30, 40 or 50");
}

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool isSameName(std::string_view a, std::string_view b)
{
    return std::ranges::equal(
        a, b, [](char x, char y)
        { return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y)); });
}

}  // namespace

// clang-format off
const std::vector<ParameterRow>& parameterRows()
{
    using P = ValidationParams;
    static const std::vector<ParameterRow> kRows = {
        row<&P::deviationRange_m>("validation.deviationRange", "m", 0.005, 2, "Points farther from every element are not of the building.", "D3.6, 6.3"),
        row<&P::minimumCoverage>("validation.minimumCoverage", "1", 0, 1, "Share of an element's visible surface with points from which it counts as seen.", "practice: the tenth from which a person recognises it"),
        row<&P::minimumMatch>("validation.minimumMatch", "1", 0.01, 1, "IoU from which a pair is one element, in deviations of position and size.", "CV4AEC challenge, lowest IoU threshold"),
        row<&P::tolerance>("validation.tolerance", "1", 10, 50, "Level of accuracy that an element has to keep: 10, 20, 30, 40 or 50.", "practice: the level that scans of buildings are commonly modelled to"),
        limit<0>("validation.loa10", "Deviation that 95 % of an element's points keep in LOA10.", "USIBD C120, levels of accuracy"),
        limit<1>("validation.loa20", "The same in LOA20.", "USIBD C120, levels of accuracy"),
        limit<2>("validation.loa30", "The same in LOA30.", "USIBD C120, levels of accuracy"),
        limit<3>("validation.loa40", "The same in LOA40.", "USIBD C120, levels of accuracy"),
        limit<4>("validation.loa50", "The same in LOA50.", "USIBD C120, levels of accuracy"),
    };
    return kRows;
}
// clang-format on

void setParameter(ValidationParams& params, std::string_view assignment)
{
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos)
        fail("\"" + std::string(assignment) +
             "\" is no assignment, write name=value, for example validation.tolerance=20");
    const std::string_view name = trimmed(assignment.substr(0, equals));
    const auto& rows = parameterRows();
    const auto found = std::ranges::find_if(rows, [&](const ParameterRow& r) { return isSameName(r.name, name); });
    if (found == rows.end())
    {
        std::vector<std::string_view> known;
        for (const ParameterRow& r : rows)
            known.emplace_back(r.name);
        fail("there is no parameter \"" + std::string(name) + "\", the nearest known one is " +
             std::string(nearestName(name, known)));
    }
    const std::string_view text = trimmed(assignment.substr(equals + 1));
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        fail(found->name + " = \"" + std::string(text) + "\" is no number, use " + range(*found));
    check(*found, value);
    std::visit(
        [&](auto find)
        {
            auto& target = *find(params);
            target = static_cast<std::remove_reference_t<decltype(target)>>(value);
        },
        found->member);
}

void checkParams(const ValidationParams& params)
{
    for (const ParameterRow& r : parameterRows())
        check(r, valueOf(r, params));
    for (std::size_t i = 1; i < params.loaLimit_m.size(); ++i)
        if (params.loaLimit_m[i] >= params.loaLimit_m[i - 1])
            fail("validation.loa" + std::to_string(10 * (i + 1)) + " = " + numberText(params.loaLimit_m[i]) +
                 " is not below validation.loa" + std::to_string(10 * i) + " = " +
                 numberText(params.loaLimit_m[i - 1]) + ", lower the one or raise the other");
}

std::string parameterTableText()
{
    const ValidationParams defaults;
    std::string text =
        "| name | default | range | meaning | source of the default |\n| --- | --- | --- | --- | --- |\n";
    for (const ParameterRow& r : parameterRows())
        text += "| " + r.name + " | " + numberText(valueOf(r, defaults)) + (r.unit == "1" ? "" : " " + r.unit) + " | " +
                range(r) + " | " + r.help + " | " + r.source + " |\n";
    return text;
}

}  // namespace s2b::validation

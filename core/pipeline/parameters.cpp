// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/parameters.h"

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/pipeline/parameter_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <type_traits>

namespace s2b
{

namespace
{

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// A number in C notation, whatever the locale; for a switch also true, false, on and off.
std::optional<double> parseValue(const ParameterInfo& info, std::string_view text)
{
    if (info.isSwitch())
    {
        if (text == "true" || text == "on")
            return 1.0;
        if (text == "false" || text == "off")
            return 0.0;
    }
    if (text.starts_with('+'))
        text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

[[noreturn]] void fail(const std::string& message)
{
    throw Error(ErrorCode::BadParameter, message);
}

}  // namespace

std::string numberText(double value)
{
    // 100000 rather than 1e+05; a plain one has at most 9 digits before the point and 21 after.
    char buffer[40];
    const bool isPlain = std::abs(value) >= 1e-4 && std::abs(value) < 1e9;
    const auto result = isPlain ? std::to_chars(std::begin(buffer), std::end(buffer), value, std::chars_format::fixed)
                                : std::to_chars(std::begin(buffer), std::end(buffer), value);
    return {buffer, result.ptr};
}

std::string rangeText(const ParameterInfo& info)
{
    if (info.isSwitch())
        return "true or false";
    return numberText(info.minimum) + " to " + numberText(info.maximum);
}

double ParameterInfo::value(const Parameters& parameters) const
{
    // One accessor serves reading and writing; nothing is written here.
    Parameters& unchanged = const_cast<Parameters&>(parameters);
    return std::visit([&](auto find) { return static_cast<double>(*find(unchanged)); }, member);
}

void ParameterInfo::set(Parameters& parameters, double value) const
{
    if (!(value >= minimum && value <= maximum))  // NaN as well
        fail(name + " = " + numberText(value) + " is out of range, use " + rangeText(*this) +
             (unit.empty() || unit == "1" ? "" : " " + unit));
    if (!std::holds_alternative<double* (*)(Parameters&)>(member) && value != std::floor(value))
        fail(name + " = " + numberText(value) + " is not a whole number, use " + rangeText(*this));
    std::visit(
        [&](auto find)
        {
            auto& target = *find(parameters);
            target = static_cast<std::remove_reference_t<decltype(target)>>(value);
        },
        member);
}

const ParameterInfo& findParameter(std::string_view name)
{
    const std::vector<ParameterInfo>& table = parameterTable();
    const auto found = std::ranges::find(table, name, &ParameterInfo::name);
    if (found != table.end())
        return *found;

    // Without a dot it is likely the part after it: compare like with like.
    std::vector<std::string_view> known;
    for (const ParameterInfo& info : table)
    {
        const std::string_view full = info.name;
        known.push_back(name.find('.') == std::string_view::npos ? full.substr(full.find('.') + 1) : full);
    }
    const std::string_view nearest = nearestName(name, known);
    const auto row = std::ranges::find(known, nearest) - known.begin();
    fail("there is no parameter \"" + std::string(name) + "\", the nearest known one is " +
         table[static_cast<std::size_t>(row)].name);
}

void setParameter(Parameters& parameters, std::string_view assignment)
{
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos)
        fail("\"" + std::string(assignment) + "\" is no assignment, write name=value, for example walls.mergeGap=0.5");
    const ParameterInfo& info = findParameter(trimmed(assignment.substr(0, equals)));
    const std::string_view text = trimmed(assignment.substr(equals + 1));
    const std::optional<double> value = parseValue(info, text);
    if (!value)
        fail(info.name + " = \"" + std::string(text) + "\" is no number, use " + rangeText(info));
    info.set(parameters, *value);
}

void checkParameters(const Parameters& parameters)
{
    Parameters scratch;
    for (const ParameterInfo& info : parameterTable())
        info.set(scratch, info.value(parameters));

    constexpr std::string_view kMinimum = ".minimum";
    for (const ParameterInfo& lower : parameterTable())
    {
        const std::size_t at = lower.name.find(kMinimum);
        if (at == std::string::npos)
            continue;
        std::string upperName = lower.name;
        upperName.replace(at, kMinimum.size(), ".maximum");
        const auto upper = std::ranges::find(parameterTable(), upperName, &ParameterInfo::name);
        if (upper != parameterTable().end() && lower.value(parameters) > upper->value(parameters))
            fail(lower.name + " = " + numberText(lower.value(parameters)) + " is above " + upperName + " = " +
                 numberText(upper->value(parameters)) + ", lower the one or raise the other");
    }
}

}  // namespace s2b

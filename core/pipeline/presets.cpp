// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/presets.h"

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/pipeline/parameter_text.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

namespace s2b
{

namespace
{

/// "Mobile mapping", "mobile_mapping" and "mobile-mapping" are one name.
std::string normalised(std::string_view text)
{
    std::string name;
    for (const char c : text)
    {
        if (std::isalnum(static_cast<unsigned char>(c)))
            name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    while (name.ends_with('-'))
        name.pop_back();
    return name;
}

}  // namespace

const Preset& findPreset(std::string_view name)
{
    const std::vector<Preset>& table = presetTable();
    const auto found = std::ranges::find(table, normalised(name), &Preset::name);
    if (found != table.end())
        return *found;
    std::vector<std::string_view> known;
    for (const Preset& preset : table)
        known.push_back(preset.name);
    throw Error(ErrorCode::BadParameter, "there is no preset \"" + std::string(name) + "\", use one of " +
                                             joinNames(known) + ", or one of each kind separated by a comma");
}

void applyPreset(Parameters& parameters, const Preset& preset)
{
    for (const PresetValue& value : preset.values)
        findParameter(value.parameter).set(parameters, value.value);
}

void applyPresets(Parameters& parameters, std::string_view list)
{
    Parameters changed = parameters;
    std::set<PresetKind> kinds;
    while (true)
    {
        const std::size_t comma = list.find(',');
        const Preset& preset = findPreset(list.substr(0, comma));
        if (!kinds.insert(preset.kind).second)
            throw Error(ErrorCode::BadParameter,
                        "the preset \"" + preset.name + "\" and the one before it are of the same kind, a kind of " +
                            (preset.kind == PresetKind::Building ? "building" : "survey") + ": use one of them");
        applyPreset(changed, preset);
        if (comma == std::string_view::npos)
            break;
        list.remove_prefix(comma + 1);
    }
    checkParameters(changed);
    parameters = changed;
}

std::string presetDocumentation()
{
    std::ostringstream text;
    text << "\n# Presets\n\n"
            "`-PRESET NAME`, or the two choices at the top of the dialog: what one kind of building, or one kind of\n"
            "survey, commonly needs. One of each kind can be combined, `-PRESET office,mobile-mapping`. `-CONFIG` and\n"
            "`-SET` come after it and win. The rows are those of `core/pipeline/preset_table.cpp`.\n";
    const Parameters defaults;
    for (const Preset& preset : presetTable())
    {
        text << "\n## " << preset.name << "\n\n"
             << preset.help << "\n\n| parameter | value | default | reason |\n| --- | --- | --- | --- |\n";
        for (const PresetValue& value : preset.values)
        {
            const ParameterInfo& info = findParameter(value.parameter);
            const std::string unit = info.unit.empty() || info.unit == "1" ? "" : " " + info.unit;
            text << "| " << info.name << " | " << numberText(value.value) << unit << " | "
                 << numberText(info.value(defaults)) << unit << " | " << value.reason << " |\n";
        }
    }
    return text.str();
}

}  // namespace s2b

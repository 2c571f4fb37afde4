// SPDX-License-Identifier: GPL-3.0-or-later
/// Presets: the parameters that one kind of building, or one kind of survey, commonly needs, each with its reason.
///
/// The command line (-PRESET), the dialog and docs/parameters.md all come from presetTable().
#pragma once

#include "core/pipeline/parameters.h"

#include <string>
#include <string_view>
#include <vector>

namespace s2b
{

/// What a preset describes. One of each kind can be combined: an office, surveyed by a mobile mapping system.
enum class PresetKind
{
    Building,
    Survey
};

struct PresetValue
{
    std::string parameter;  ///< of parameterTable()
    double value = 0;
    std::string reason;  ///< one sentence
};

struct Preset
{
    std::string name;   ///< "mobile-mapping"
    std::string title;  ///< "Mobile mapping"
    std::string help;   ///< one sentence
    PresetKind kind = PresetKind::Building;
    std::vector<PresetValue> values;
};

/// The table, buildings first.
[[nodiscard]] const std::vector<Preset>& presetTable();

/// @throws Error{BadParameter} that names the known presets.
[[nodiscard]] const Preset& findPreset(std::string_view name);

/// Sets what the preset says and leaves everything else.
void applyPreset(Parameters& parameters, const Preset& preset);

/// "office,mobile-mapping": applied from left to right. All or nothing.
/// @throws Error{BadParameter} for an unknown name, and for two presets of one kind.
void applyPresets(Parameters& parameters, std::string_view list);

/// The table as the chapter of docs/parameters.md.
[[nodiscard]] std::string presetDocumentation();

}  // namespace s2b

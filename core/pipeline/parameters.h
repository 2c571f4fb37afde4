// SPDX-License-Identifier: GPL-3.0-or-later
/// All parameters of the reconstruction, in one table: name, unit, range, default with its source, help.
///
/// The command line (-SET, -CONFIG), the dialog, the parameter record in the IFC and docs/parameters.md all come from
/// parameterTable().
#pragma once

#include "core/cloud/clutter.h"
#include "core/cloud/frame.h"
#include "core/cloud/surface_cells.h"
#include "core/columns/columns.h"
#include "core/levels/levels.h"
#include "core/openings/openings.h"
#include "core/slabs/slabs.h"
#include "core/spaces/spaces.h"
#include "core/walls/walls.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace s2b
{

struct Parameters
{
    ClutterParams clutter;
    CellParams cells;
    FrameParams frame;
    LevelParams levels;
    WallParams walls;
    OpeningParams openings;
    ColumnParams columns;
    SlabParams slabs;
    SpaceParams spaces;
    bool operator==(const Parameters&) const = default;
};

/// One row of the table. `member` finds the value within a Parameters.
struct ParameterInfo
{
    std::string name;    ///< "walls.maxThickness"
    std::string unit;    ///< "m", "deg", "1", "" for a switch
    double minimum = 0;  ///< inclusive
    double maximum = 0;  ///< inclusive
    std::string help;    ///< one sentence
    std::string source;  ///< where the default comes from: a section of D3.6, a paper, or a measurement
    std::variant<double* (*)(Parameters&), int* (*)(Parameters&), bool* (*)(Parameters&)> member;

    [[nodiscard]] double value(const Parameters& parameters) const;
    /// @throws Error{BadParameter} outside [minimum, maximum], NaN, or a fraction for a whole number.
    void set(Parameters& parameters, double value) const;
    [[nodiscard]] bool isSwitch() const { return std::holds_alternative<bool* (*)(Parameters&)>(member); }
    [[nodiscard]] bool isInteger() const { return std::holds_alternative<int* (*)(Parameters&)>(member); }
};

/// The table, in stage order.
[[nodiscard]] const std::vector<ParameterInfo>& parameterTable();

/// @throws Error{BadParameter} that names the nearest known parameter.
[[nodiscard]] const ParameterInfo& findParameter(std::string_view name);

/// "name=value". @throws Error{BadParameter} for an unknown name, text that is no number, a value out of range.
void setParameter(Parameters& parameters, std::string_view assignment);

/// Checks every value against its range, and every stage.minimumX against its stage.maximumX: a set of parameters that
/// was changed one by one, or filled by hand, before it is used.
/// @throws Error{BadParameter} that names the first offending parameter.
void checkParameters(const Parameters& parameters);

/// Reads a TOML file: tables are the part before the dot, keys the part after it. All or nothing.
/// @throws Error{BadParameter} that names the file, and the line or the parameter.
void loadConfig(Parameters& parameters, const std::string& path);

/// The TOML text that loadConfig reads back to the same parameters, with unit, range and help as comments.
[[nodiscard]] std::string configText(const Parameters& parameters);

/// The table, and that of the presets, as the Markdown of docs/parameters.md.
[[nodiscard]] std::string parameterDocumentation();

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace s2b
{

/// The classes that the reconstruction works with. The values are the codes of the `s2b` label map.
enum class Label : std::uint8_t
{
    Unassigned = 0,
    Floor = 1,
    Ceiling = 2,
    Wall = 3,
    Column = 4,
    Door = 5,
    Window = 6,
    Beam = 7,
    Stair = 8,
    Roof = 9,
    Furniture = 10
};
inline constexpr std::size_t kLabelCount = 11;

[[nodiscard]] std::string_view labelName(Label label);

/// Which code of a label field means which class. Codes that are not in the map have no class: an error for the user to
/// settle, never a silent guess.
struct LabelMap
{
    std::string name;                  ///< built-in name or the file it came from
    std::map<int, Label> classOfCode;  ///< sorted, so that everything listed from it is in a stable order
};

/// One of the built-in maps: s2b, s3dis, scannet, asprs. @throws Error{BadLabels} naming the known ones.
[[nodiscard]] LabelMap builtInLabelMap(std::string_view name);

/// A built-in name, or a TOML file with a table [labels] of `code = "class name"` pairs.
/// @throws Error{BadLabels} for an unknown name, an unreadable file, or an unknown class name (naming the nearest).
[[nodiscard]] LabelMap loadLabelMap(const std::string& nameOrFile);

}  // namespace s2b

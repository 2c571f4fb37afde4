// SPDX-License-Identifier: GPL-3.0-or-later
/// Numbers and words as a report shows them. Independent of the process' locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace s2b::report
{

/// What stands where there is no value.
inline constexpr const char* kNone = "\u2013";

/// Valid UTF-8 without control characters: names come from files that others wrote.
[[nodiscard]] std::string cleanText(std::string_view text);

/// For text and attributes of XML, SVG and HTML.
[[nodiscard]] std::string escapeXml(std::string_view text);

/// "-0.125" as a program reads it: no trailing zeros, no "-0".
[[nodiscard]] std::string plainNumber(double value, int decimals);

/// As people read it: a true minus sign, fixed decimals; kNone when it is not finite.
[[nodiscard]] std::string number(double value, int decimals);
[[nodiscard]] std::string number(const std::optional<double>& value, int decimals);

/// "12 345 678", in groups of three with narrow spaces that don't break.
[[nodiscard]] std::string counted(std::uint64_t count);

/// Metres given as millimetres, one decimal below 100 mm: "4.1", without the unit. `sign` puts a plus before gains.
[[nodiscard]] std::string millimetres(double length_m, bool sign = false);
[[nodiscard]] std::string millimetres(const std::optional<double>& length_m, bool sign = false);

/// As few decimals as a limit or a place on a scale needs: "15", "+7.5".
[[nodiscard]] std::string roundMillimetres(double length_m, bool sign = false);

/// [0, 1] as "93 %".
[[nodiscard]] std::string percent(double share);

/// The last part of a path: a report names files, not the folders of the machine it was made on.
[[nodiscard]] std::string fileName(std::string_view path);

[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace s2b::report

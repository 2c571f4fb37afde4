// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace s2b::report
{

struct Color
{
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    std::uint8_t a = 255;
    bool operator==(const Color&) const = default;
};

/// "#3f7fbf"
[[nodiscard]] std::string hex(Color color);

/// Signed values in [-1, 1]: blue, light grey, red, even in lightness on both sides of 0 and told apart by the colour
/// blind (Moreland 2009, "Diverging color maps for scientific visualization", the map "cool to warm"). Beyond: the end.
[[nodiscard]] Color divergingColor(double value);

}  // namespace s2b::report

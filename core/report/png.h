// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/color.h"

#include <string>
#include <vector>

namespace s2b::report
{

/// Rows from the top, pixels from the left.
struct Image
{
    int width = 0;
    int height = 0;
    std::vector<Color> pixels;

    Image() = default;
    Image(int w, int h, Color fill)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill)
    {
    }
    [[nodiscard]] Color& at(int x, int y)
    {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    [[nodiscard]] const Color& at(int x, int y) const
    {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

/// The image as a PNG file's bytes: RGBA, no time stamp.
/// @throws Error{Internal}
[[nodiscard]] std::string encodePng(const Image& image);

/// "data:image/png;base64,..."
[[nodiscard]] std::string dataUri(const Image& image);

}  // namespace s2b::report

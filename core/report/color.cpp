// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <format>

namespace s2b::report
{

std::string hex(Color color)
{
    return std::format("#{:02x}{:02x}{:02x}", color.r, color.g, color.b);
}

Color divergingColor(double value)
{
    // Moreland's map in nine equal steps; linear between them differs from his by less than 2 of 255.
    static constexpr std::array<std::array<double, 3>, 9> kSteps{{{59, 76, 192},
                                                                  {98, 130, 234},
                                                                  {141, 176, 254},
                                                                  {184, 208, 249},
                                                                  {221, 221, 221},
                                                                  {245, 196, 173},
                                                                  {244, 154, 123},
                                                                  {222, 96, 77},
                                                                  {180, 4, 38}}};
    if (!std::isfinite(value))
        value = 0.0;
    const double place = (std::clamp(value, -1.0, 1.0) + 1.0) / 2.0 * (kSteps.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(place), kSteps.size() - 2);
    const double share = place - static_cast<double>(low);
    const auto mix = [&](std::size_t channel)
    {
        const double mixed = kSteps[low][channel] * (1.0 - share) + kSteps[low + 1][channel] * share;
        return static_cast<std::uint8_t>(std::lround(mixed));
    };
    return {mix(0), mix(1), mix(2), 255};
}

}  // namespace s2b::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/cell_colours.h"

#include "core/cloud/surface_cells.h"

namespace s2b
{
namespace
{

constexpr std::size_t kChunk = 1u << 16;

}  // namespace

std::vector<std::array<std::uint8_t, 3>> cellColours(const CloudView& cloud,
                                                     const std::vector<std::uint32_t>& cellOfPoint,
                                                     std::size_t cellCount, const Context& context)
{
    struct Sum
    {
        std::array<std::uint32_t, 3> rgb{};  // of up to 16 million points
        std::uint32_t count = 0;
    };
    std::vector<Sum> sums(cellCount);
    for (std::size_t i = 0; i < cloud.count; ++i)
    {
        if (i % kChunk == 0)
            context.checkCancelled();
        if (cellOfPoint[i] == kNoCell || sums[cellOfPoint[i]].count == (1u << 24))
            continue;
        Sum& sum = sums[cellOfPoint[i]];
        ++sum.count;
        for (std::size_t k = 0; k < 3; ++k)
            sum.rgb[k] += cloud.rgb[cloud.rgbStride * i + k];
    }
    std::vector<std::array<std::uint8_t, 3>> colours(cellCount);
    for (std::size_t c = 0; c < cellCount; ++c)
        for (std::size_t k = 0; k < 3 && sums[c].count > 0; ++k)
            colours[c][k] = static_cast<std::uint8_t>((sums[c].rgb[k] + sums[c].count / 2) / sums[c].count);
    return colours;
}

}  // namespace s2b

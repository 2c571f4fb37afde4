// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/segmentation/cell_set.h"
#include "core/segmentation/contract.h"
#include "core/segmentation/inputs.h"
#include "core/segmentation/tensor.h"

#include <cstdint>
#include <span>

namespace s2b
{

/// Where a cell is in a plan.
struct PlanPlace
{
    std::int64_t x = 0, y = 0, bin = 0;
    float dx = 0, dy = 0;  ///< within the pixel, from its centre [pixels]
    float dz = 0;          ///< within the bin, from its middle [bins]; limited to 1 in the outermost
};

/// The plan's pixels and height bins: the cells' box, filled up to a multiple of the contract's.
class PlanGrid
{
public:
    PlanGrid(const PlanContract& plan, const CellSet& set);

    [[nodiscard]] std::int64_t width() const { return m_width; }
    [[nodiscard]] std::int64_t height() const { return m_height; }
    [[nodiscard]] PlanPlace place(const SurfaceCell& cell) const;

private:
    double m_lowX, m_lowY, m_lowZ, m_pixel, m_bin;
    std::int64_t m_bins, m_width, m_height;
};

/// All channels that a plan may have, in a fixed order. What is told of each bin, by area where it says so: the cells'
/// area relative to the section of the bin that such a surface can fill.
[[nodiscard]] std::span<const FeatureInfo> knownPlanChannels();

/// [1][channels * bins][height][width].  Cost: O(cells + size).
[[nodiscard]] Tensor planTensor(const PlanGrid& grid, const PlanContract& plan, const CellSet& set);

}  // namespace s2b

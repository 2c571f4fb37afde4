// SPDX-License-Identifier: GPL-3.0-or-later
/// The points of a cloud by cubes of a metre: what is done block by block stays in the processor's cache.
#pragma once

#include "core/base/context.h"
#include "core/base/floor_to_int.h"
#include "core/cloud/clutter.h"
#include "core/cloud/point_cloud.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace s2b
{

inline constexpr double kBlock_m = 1.0;

[[nodiscard]] inline Eigen::Vector3f pointAt(const CloudView& cloud, std::size_t i)
{
    return {cloud.xyz[3 * i], cloud.xyz[3 * i + 1], cloud.xyz[3 * i + 2]};
}

/// Points sorted by block: the only per-point memory.
struct Blocks
{
    Eigen::Array3i low = Eigen::Array3i::Zero();  ///< block coordinate of the grid's first block
    Eigen::Array3i size = Eigen::Array3i::Zero();
    std::vector<std::uint32_t> start;     ///< per block of the grid, and one more
    std::vector<PointIndex> order;        ///< point indices, block after block
    std::vector<std::uint32_t> occupied;  ///< grid indices of blocks with points, ascending
};

/// Those within the region. The order within a block depends on the threads.
/// @throws Error{BadCoordinates} at the first point that is not finite, and when the blocks would be too many;
/// Error{EmptyCloud} when no point is within.  Cost: three passes over the points.
[[nodiscard]] Blocks sortIntoBlocks(const CloudView& cloud, const KeptRegion& region, const Context& context);

/// Typical distance between neighbouring points on a surface: from the points per occupied 8 cm cell of dense blocks.
[[nodiscard]] double estimateSpacing(const CloudView& cloud, const Blocks& blocks);

}  // namespace s2b

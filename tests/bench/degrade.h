// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/point_cloud.h"

#include <cstdint>
#include <vector>

namespace s2b
{

/// Makes a survey worse, the ways real ones are: 5 % of the points get a random class, half of the unassigned clutter
/// is called wall (in 1 m patches), 10 % of all 0.5 m patches get a class that a segmentation takes them for, and 25
/// boxes of 1.2 m that stand on the floor hide what is in them, up to 1.5 m above it.
///
/// A function of the points and the seed alone. @pre cloud.hasLabels().
/// @param sources  where not null: the stations' ids of the points, which lose the hidden ones too
void degrade(PointCloud& cloud, std::uint64_t seed, std::vector<std::uint16_t>* sources = nullptr);

}  // namespace s2b

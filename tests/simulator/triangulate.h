// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace s2b::sim
{

/// Triangles of a simple polygon with holes, counter-clockwise (ear clipping). Cost: O(n^3) at worst; n is small here.
[[nodiscard]] std::vector<std::array<Eigen::Vector2d, 3>> triangulate(const Polygon& polygon);

}  // namespace s2b::sim

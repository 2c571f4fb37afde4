// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"

#include <optional>
#include <vector>

namespace s2b::validation
{

struct Body
{
    std::vector<Polygon> plan;
    double low_m = 0.0;
    double high_m = 0.0;
};

/// Volume that all of `truth` and all of `result` share, over the volume that they cover together: the vIoU of the
/// vector bodies, which takes no harm from another way of dividing walls. Exact but for heights rounded to 1 mm.
/// @return nothing without truth; 0 without a result.
/// Cost: O(h n log n) with h different heights and n corners.
[[nodiscard]] std::optional<double> unionIou(const std::vector<Body>& truth, const std::vector<Body>& result);

}  // namespace s2b::validation

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/point_cloud.h"

#include <cstdint>
#include <vector>

namespace s2b
{

/// For a cloud whose stations are known, but not which point was measured from which: the nearest station that the rest
/// of the cloud does not hide, StationView::kUnknown where all are hidden.
///
/// By voxels of 5 cm (more for a cloud that spans very far). Rays that graze their surface count as hidden; thinner
/// walls than a voxel may be looked through. Cost: two passes over the points, and a walk to some stations from each
/// occupied voxel; up to 100 MB. Independent of the points' order and of the threads.
[[nodiscard]] std::vector<std::uint16_t> nearestVisibleStations(const CloudView& cloud, const Context& context);

/// Share of the points (of some 20000, evenly drawn) that their own station can't have measured, because other points
/// of the cloud are in between: some per cent when all is well, most when ids are mixed up or positions are of another
/// cloud. 0 when no point has a station. Same grid and cost.
[[nodiscard]] double hiddenShare(const CloudView& cloud, const Context& context);

}  // namespace s2b

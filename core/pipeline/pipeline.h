// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/point_cloud.h"
#include "core/model/building.h"
#include "core/pipeline/parameters.h"

#include <set>
#include <string_view>
#include <vector>

namespace s2b
{

enum class Stage
{
    Levels,
    Walls,
    Doors,
    Windows,
    Openings,
    Columns,
    Slabs,
    Spaces
};

/// "levels,walls,..." as -STAGES takes it. A stage brings the ones that it needs with it (doors need walls need
/// levels).
/// @throws Error{BadParameter} that names the known stages.
[[nodiscard]] std::set<Stage> parseStages(std::string_view list);
[[nodiscard]] std::set<Stage> allStages();

/// One storey's heights, world z.
struct StoreyHeights
{
    double floor_m = 0.0;
    double ceiling_m = 0.0;
    bool ceilingSeen = true;  ///< false: sloped or not scanned, ceiling_m is only how far the storey reaches
};

struct PipelineOptions
{
    Parameters parameters;
    std::set<Stage> stages = allStages();
    bool geometryOnly = false;          ///< ignore the labels
    std::vector<StoreyHeights> levels;  ///< given by a person, ascending; empty: they are found
};

/// Reconstructs a building from a cloud (D3.6, 3; docs/method.md): the one place that knows the order of the stages.
///
/// @param cloud  at least one point, metres, Z up. Read only.
/// @return The building, with diagnostics. An empty one is always explained by a diagnostic.
/// @throws Error{EmptyCloud, BadCoordinates, BadParameter}; Cancelled.
/// Deterministic: same cloud, parameters and seed give the same result for any number of threads.
[[nodiscard]] Building reconstruct(const CloudView& cloud, const PipelineOptions& options, const Context& context);

}  // namespace s2b

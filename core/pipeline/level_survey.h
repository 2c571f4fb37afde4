// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/point_cloud.h"
#include "core/pipeline/pipeline.h"

#include <vector>

namespace s2b
{

/// Area of the horizontal surfaces over height.
struct HeightProfile
{
    double low_m = 0.0;           ///< world z of the first bin's lower edge
    double bin_m = 0.0;           ///< height of a bin
    std::vector<double> area_m2;  ///< of each bin

    [[nodiscard]] double high_m() const { return low_m + bin_m * static_cast<double>(area_m2.size()); }
};

/// What a run would take for the building's storeys, and what it sees them in.
struct LevelSurvey
{
    HeightProfile profile;
    std::vector<StoreyHeights> storeys;  ///< ascending
};

/// The first stages of reconstruct() alone: clutter, cells, levels.
///
/// @throws as reconstruct(). Cost: about half of a whole run; memory as a run.
/// Deterministic: the storeys are those that reconstruct() finds with the same cloud, options and seed.
[[nodiscard]] LevelSurvey surveyLevels(const CloudView& cloud, const PipelineOptions& options, const Context& context);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/rasters.h"
#include "core/report/scene.h"

#include <string>

namespace s2b::report
{

/// A drawing in SVG, and what stands below it.
struct Drawing
{
    std::string svg;
    std::string caption;
};

/// The plan of a storey: points, truth, result and errors; north up, in a round scale on A4, with world coordinates.
/// Empty svg when the storey has no element.
[[nodiscard]] Drawing drawPlan(const Scene& scene, const Level& level, const StoreyRasters& rasters);

/// A top view of signed deviations with the result's outlines. `isFloor`: of the floor instead of what stands on it.
/// Empty svg without points.
[[nodiscard]] Drawing drawDeviations(const Scene& scene, const Level& level, const StoreyRasters& rasters,
                                     bool isFloor);

/// Both faces of a wall, side by side.
[[nodiscard]] Drawing drawWall(const Scene& scene, const WallFaces& wall);

/// What the styles of a plan mean.
[[nodiscard]] std::string planLegend(const Scene& scene);

/// Colours and patterns that the drawings share: once in the page.
[[nodiscard]] std::string sharedDefinitions();

/// The scale of signed deviations, with its numbers in millimetres.
[[nodiscard]] std::string colorBar(const Scene& scene);

}  // namespace s2b::report

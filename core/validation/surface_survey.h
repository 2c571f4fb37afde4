// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/validation/face_cells.h"
#include "core/validation/validation.h"

#include <cstdint>
#include <vector>

namespace s2b::validation
{

/// What the points say of one BIM's surfaces.
struct SurfaceSurvey
{
    CloudDeviation deviation;
    std::vector<FaceCells::Cell> cells;
    std::vector<std::uint8_t> isSeen;    ///< of each cell: a point lies on it
    std::vector<std::uint8_t> isHidden;  ///< of each cell: it touches another element, or is inside one
    std::vector<float> lowest_m;         ///< of each cell: its points' feet; infinite without points
    std::vector<float> highest_m;
};

/// Measures all points against the BIM; see measureDeviation.
[[nodiscard]] SurfaceSurvey surveySurfaces(const Bim& bim, const CloudView& cloud, const ValidationParams& params,
                                           bool perPoint, const Context& context);

}  // namespace s2b::validation

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/surface_cells.h"
#include "core/model/building.h"

#include <vector>

namespace s2b
{

/// Doors, windows and plain openings (D3.6, 3.5).
struct OpeningParams
{
    double searchMargin_m = 0.10;      ///< D3.6, 3.5: first step, inside the wall's box
    double clusterRadius_m = 0.10;     ///< D3.6, 3.5: DBSCAN radius
    double minimumDoorWidth_m = 0.50;
    double maximumDoorWidth_m = 4.0;
    double minimumDoorHeight_m = 1.6;
    double minimumWindowWidth_m = 0.30;
    double minimumWindowHeight_m = 0.30;
    bool operator==(const OpeningParams&) const = default;
};

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spaces/room_plan.h"

#include <cstdint>
#include <vector>

namespace s2b
{

/// Floor slabs and flat roofs.
struct SlabParams
{
    double defaultThickness_m = 0.20;  ///< where only one side was seen
    double minimumThickness_m = 0.05;
    double maximumThickness_m = 0.60;  ///< an underside farther below is a suspended ceiling
    double minimumArea_m2 = 3.0;       ///< of a slab
    double minimumHoleArea_m2 = 1.0;
    double minimumHoleWidth_m = 0.60;
    double outlineStep_m = 0.05;  ///< smaller steps of the outline are straightened
    bool operator==(const SlabParams&) const = default;
};

struct SlabResult
{
    std::vector<Slab> slabs;
    std::vector<Diagnostic> diagnostics;
};

/// The slabs of all storeys.
///
/// Conventions:
/// - A storey's floor slab carries its rooms and the walls around them: its outline lies on those walls' outer faces,
///   or on the room's own outline where no wall was found. Walls that stick out of the building stay outside.
/// - Its top is the storey's floor. Its thickness is measured to the highest ceiling that a tenth of it at least has
///   below, when that is within the permitted range; else it is assumed, and a diagnostic says so.
/// - A hole (stair, shaft) needs evidence that one sees through: neither the floor nor the ceiling of the storey below
///   was seen there, but what is overhead above and what is below was. A floor that furniture hides is no hole.
/// - Where nothing lies above a level ceiling, it is the underside of a slab of kind Roof, of assumed thickness. A
///   sloped ceiling gives no roof slab, and a diagnostic.
/// - Evidence::faceCoverage is that of the top and of the underside.
/// @param plans    of all storeys, ascending, on the same grid
/// @param storeys  the storeys of the plans
/// @param nextId   the next free ElementId value; advanced
/// Cost: O(cells) and O(pixels) a storey.
[[nodiscard]] SlabResult findSlabs(const PlanCells& cells, const std::vector<RoomPlan>& plans,
                                   const std::vector<ElementId>& storeys, std::uint32_t& nextId,
                                   const SlabParams& params, const Context& context);

}  // namespace s2b

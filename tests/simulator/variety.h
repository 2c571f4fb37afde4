// SPDX-License-Identifier: GPL-3.0-or-later
/// Variety: buildings, fittings and scans drawn from wide ranges, as training data for the segmentation. One seed draws
/// everything. The truth of a varied building holds its walls, openings and round or rectangular columns; what is added
/// as props (steel columns, beams, roofs, free-standing walls) is in the scan and its labels only.
#pragma once

#include "tests/simulator/layout.h"
#include "tests/simulator/scanner.h"
#include "tests/simulator/scene.h"

namespace s2b::sim
{

struct Variety
{
    BuildingSpec spec;
    ScanSettings scan;
    bool outside = false;  ///< stations round the building too
};

/// A kind of building and a scanner, from the seed alone.
[[nodiscard]] Variety drawVariety(std::uint64_t seed);

/// Doors, windows, glazed fronts and passages in place of those of fitOut().
void addVariedOpenings(const BuildingSpec& spec, StoreyPlan& plan);

/// Frames, leaves, panes of many makes; `style` is shared by a building, `random` by one opening.
void addVariedDoor(Scene& scene, const Wall& wall, const Opening& opening, std::uint32_t element, std::uint64_t style,
                   Random random);
void addVariedWindow(Scene& scene, const Wall& wall, const Opening& opening, std::uint32_t element, std::uint64_t style,
                     Random random);

/// Wardrobes, kitchens, radiators, curtains, beds, lamps, pictures, pipes; `before` is in the way already.
[[nodiscard]] std::vector<Prop> furnishVaried(const BuildingSpec& spec, const StoreyPlan& plan,
                                              const std::vector<Prop>& before);

/// Steel and concrete columns, downstand beams, free-standing walls, stairs, railings.
[[nodiscard]] std::vector<Prop> addVariedStructure(const BuildingSpec& spec, const StoreyPlan& plan);

/// Replaces the roof slab of a square building by a pitched roof; walls of the last storey end below it.
void pitchRoof(const BuildingSpec& spec, SimulatedBuilding& building);

}  // namespace s2b::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/simulator/scanner.h"

#include <string>

namespace s2b::sim
{

/// Writes what there is to find and how much of it the survey saw, as JSON (docs/simulator.md): per element its box,
/// axis, thickness, host, points and the visible share of its surface; storeys, spaces, stations.
///
/// World coordinates. `building` may be null (IFC as the source): then boxes come from the meshes.
/// @throws Error{CannotWrite}
void writeTruth(const Scene& scene, const Survey& survey, const std::vector<Station>& stations,
                const SimulatedBuilding* building, const std::string& path);

}  // namespace s2b::sim

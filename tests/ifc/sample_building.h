// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"

namespace s2b::test
{

/// A small building that uses every feature of the model: two storeys, straight, oblique, curved, gabled walls and a
/// curved one under a sloped top, doors of every kind, a window, a plain opening, both columns, slabs with holes,
/// spaces with boundaries, junctions, diagnostics, names outside ASCII.
[[nodiscard]] Building sampleBuilding();

/// `count` walls of 4 m in a grid on one storey, each with one door.
[[nodiscard]] Building manyWalls(int count);

/// One storey with one wall along x: 6 m long, 0.2 m thick, 2.8 m high, axis from (0, 0).
[[nodiscard]] Building oneWall();

}  // namespace s2b::test

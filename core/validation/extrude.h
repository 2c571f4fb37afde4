// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/validation/bim.h"

#include <Eigen/Geometry>

namespace s2b::validation
{

/// The closed mesh of a polygon swept along its normal, triangles counter-clockwise as seen from outside.
/// @param section  valid; its x and y are those of `frame`.
/// @param depth_m  > 0, along the frame's z.
[[nodiscard]] Mesh extrude(const Polygon& section, const Eigen::Isometry3d& frame, double depth_m);

/// Swept up from low_m to high_m.
[[nodiscard]] Mesh extrudeUp(const Polygon& plan, double low_m, double high_m);

/// Volume that a closed mesh encloses; < 0 for one that is inside out.
[[nodiscard]] double volumeOf(const Mesh& mesh);

/// A straight wall's plan swept up, without what its openings cut out through its whole thickness.
/// @param openings  their plans and heights count.
[[nodiscard]] Mesh wallMesh(const BimElement& wall, const std::vector<const BimElement*>& openings);

/// Gives elements of files that hold sizes instead of meshes their meshes: straight walls with the openings of their
/// doors and windows (BimElement::host), everything else as its plan swept up. Doors and windows are drawn as a leaf of
/// 5 cm in the middle of their opening.
void addMeshes(Bim& bim);

}  // namespace s2b::validation

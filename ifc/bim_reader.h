// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/validation/bim.h"

#include <Eigen/Core>

#include <optional>
#include <string>

namespace s2b::ifc
{

struct BimReadOptions
{
    /// A point of the cloud or of the other model, world coordinates: an IfcMapConversion is applied where it brings
    /// the model closer to it. Nothing: the model's own coordinates.
    std::optional<Eigen::Vector3d> near = std::nullopt;
    /// With BimElement::mesh, which only distances to points need. Openings that are subtracted take half of the time.
    bool withMeshes = true;
};

/// Reads walls, doors, windows, columns, slabs and spaces of any IFC2X3, IFC4 or IFC4X3 file as a validation compares
/// them.
///
/// A wall's plan is the smallest rectangle around its body without openings; its real outline where that fills less
/// than 85 % of the rectangle (curved and bent walls). A column's is the rectangle, or its hull where that is round. A
/// door's or window's is its opening (its own body where it has none), flush with its wall. Curtain walls are no walls;
/// doors and windows in them count.
/// @throws Error{BadFile}: see readIfc; a file without any of these elements; lengths that can't be a building's.
/// Cost: see readIfc.
[[nodiscard]] validation::Bim readBim(const std::string& path, const BimReadOptions& options = {});

/// Reads a ground truth, whatever kind of file it is: IFC, the CV4AEC challenge's JSON (one file or a folder), or a
/// simulated survey's own truth.
/// @throws Error{BadFile} that says what the file is instead.
[[nodiscard]] validation::Bim readTruth(const std::string& path, const BimReadOptions& options = {});

}  // namespace s2b::ifc

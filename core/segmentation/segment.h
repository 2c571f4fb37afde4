// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/point_cloud.h"
#include "core/labels/label.h"
#include "core/segmentation/onnx_model.h"

#include <array>
#include <cstdint>
#include <vector>

namespace s2b
{

/// A class and how sure it is, for each point of a cloud.
struct Segmentation
{
    std::vector<std::uint8_t> labels;      ///< values of Label
    std::vector<std::uint8_t> confidence;  ///< the class's probability, 0..255; 0 for a point that no cell holds
    std::array<std::size_t, kLabelCount> counts{};  ///< points by class
};

struct SegmentParams
{
    std::size_t largestPass = 1500000;  ///< cells that the model sees at once; a larger storey is cut into tiles
    double largestTile_m = 48.0;        ///< a longer one too, however few its cells: a plan has pixels everywhere
    double overlap_m = 3.0;             ///< seen around a tile, and thrown away
    bool settle = true;                 ///< classes and the building that they show correct each other
    bool operator==(const SegmentParams&) const = default;
};

/// Labels the points with a model: points -> cells of the model's size -> storeys, or tiles of large ones -> inputs ->
/// network -> the class of each cell, given to its points.
///
/// @param cloud  N >= 1 points, metres, Z up; with colours (rgb) where there are any. Its labels are not looked at.
/// What is far outside the building (as the reconstruction's clutter filter says) stays unassigned, with confidence 0.
/// @throws Error{EmptyCloud, BadCoordinates}; Error{BadParameter} when the model needs colours and there are none;
/// Error{BadFile} when the model fails; Cancelled.
/// Memory: 10 bytes a point, 100 a cell, and the tensors of one pass. Deterministic for any number of threads.
[[nodiscard]] Segmentation segment(const CloudView& cloud, const OnnxModel& model, const SegmentParams& params,
                                   const Context& context);

}  // namespace s2b

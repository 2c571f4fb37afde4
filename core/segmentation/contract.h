// SPDX-License-Identifier: GPL-3.0-or-later
/// What a segmentation model says about itself: read from the metadata of its ONNX file. docs/segmentation.md is the
/// contract in words.
#pragma once

#include "core/labels/label.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace s2b
{

enum class ColourUse
{
    None,
    Optional,  ///< used where the cloud has it
    Required
};

enum class ScoreKind
{
    Logits,        ///< softmax makes probabilities of them
    Probabilities  ///< each row sums to 1
};

/// Raster of a storey's plan that a model may take beside its cells: height bins over the floor as channels.
struct PlanContract
{
    double pixel_m = 0.0;               ///< edge of a pixel; 0: the model takes no plan
    double low_m = 0.0;                 ///< lower edge of the lowest bin, above the storey's floor
    double bin_m = 0.0;                 ///< height of a bin
    int bins = 0;                       ///< how many; what is below or above all counts in the outermost
    std::vector<std::string> channels;  ///< what is told of each bin; the tensor has channels * bins layers
    int multiple = 1;                   ///< width and height are filled up to a multiple of it

    [[nodiscard]] bool isUsed() const { return pixel_m > 0.0; }
};

struct ModelContract
{
    std::vector<Label> classes;  ///< by output column; several columns may mean one class
    double cell_m = 0.0;         ///< edge of the cells that it was made for
    std::vector<std::string> features;
    std::vector<float> mean, scale;  ///< by feature: it takes (value - mean) / scale; empty: it takes the values
    ColourUse colour = ColourUse::None;
    ScoreKind scores = ScoreKind::Logits;
    PlanContract plan;
};

/// @param metadata  the model's key-value pairs; those that do not begin with "s2b." are ignored.
/// @param name      of the file, for the messages.
/// @throws Error{BadFile} in one sentence: no contract, another version of it, a key that is missing, unknown or has an
/// impossible value, a class or feature that is not known (naming the nearest).
[[nodiscard]] ModelContract parseContract(const std::map<std::string, std::string>& metadata, const std::string& name);

}  // namespace s2b

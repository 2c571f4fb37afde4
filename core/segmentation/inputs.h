// SPDX-License-Identifier: GPL-3.0-or-later
/// What is told of cells to a model: the named features and the tensors made of them. A model takes the inputs that it
/// declares, by name.
#pragma once

#include "core/base/context.h"
#include "core/segmentation/cell_set.h"
#include "core/segmentation/contract.h"
#include "core/segmentation/tensor.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace s2b
{

struct FeatureInfo
{
    std::string_view name;
    std::string_view unit;  ///< "m", "1"
    std::string_view help;
    bool needsColour = false;
};

/// All features that a contract may name, in a fixed order.
[[nodiscard]] std::span<const FeatureInfo> knownFeatures();

/// The same of the channels of a plan.
[[nodiscard]] std::span<const FeatureInfo> knownPlanChannels();

/// All inputs that a model of this contract may declare.
[[nodiscard]] std::vector<TensorSpec> inputSpecs(const ModelContract& contract);

/// Tensors for the inputs `names`, one row a cell where the input is per cell.
///
/// @pre every name is one of inputSpecs(contract); set.cells is not empty.
/// Deterministic for any number of threads.
[[nodiscard]] std::vector<Tensor> makeInputs(const ModelContract& contract, std::span<const std::string> names,
                                             const CellSet& set, const Context& context);

}  // namespace s2b

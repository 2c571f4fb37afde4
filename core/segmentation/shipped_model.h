// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace s2b
{

inline constexpr const char* kShippedModelName = "the shipped model";

/// The bytes of core/segmentation/model.onnx, kept in the program; empty in a build without that file.
[[nodiscard]] std::span<const std::byte> shippedModel();

}  // namespace s2b

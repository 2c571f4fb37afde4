// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace s2b
{

enum class TensorType
{
    Float,
    Int64
};

/// Values in row-major order.
struct Tensor
{
    std::string name;
    std::vector<std::int64_t> shape;
    std::variant<std::vector<float>, std::vector<std::int64_t>> data;

    [[nodiscard]] TensorType type() const { return data.index() == 0 ? TensorType::Float : TensorType::Int64; }
};

/// What an input of a model has to look like.
struct TensorSpec
{
    static constexpr std::int64_t kAny = -1;
    std::string name;
    TensorType type = TensorType::Float;
    std::vector<std::int64_t> shape;  ///< kAny where the size depends on the cloud
    bool isPerCell = false;           ///< one row a cell: any run of cells can be given on its own
};

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/segmentation/contract.h"
#include "core/segmentation/tensor.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace s2b
{

/// A segmentation model, ready to run on the processor. The only part that knows onnxruntime.
class OnnxModel
{
public:
    /// @throws Error{BadFile} in one sentence that names the file: unreadable, not ONNX, made for a newer onnxruntime,
    /// without a contract or with inputs and outputs that do not fit it.
    [[nodiscard]] static OnnxModel load(const std::string& path, unsigned threads);
    /// @param name  of what the bytes are, for the messages.
    [[nodiscard]] static OnnxModel fromBytes(std::span<const std::byte> bytes, const std::string& name,
                                             unsigned threads);
    ~OnnxModel();
    OnnxModel(OnnxModel&&) noexcept;
    OnnxModel& operator=(OnnxModel&&) noexcept;

    [[nodiscard]] const ModelContract& contract() const;
    [[nodiscard]] const std::string& name() const;  ///< the file's name without its folder
    [[nodiscard]] const std::vector<std::string>& inputNames() const;

    /// Scores of N cells, N * classes values row by row.
    ///
    /// A model whose inputs are all per cell runs on batches of a fixed size, several at a time; any other one runs
    /// once. The same bytes for any number of threads.
    /// @throws Error{BadFile} when the model fails on the tensors, Cancelled (within 50 ms for batches; another model
    /// stops after the operator that it is at).
    [[nodiscard]] std::vector<float> run(std::span<const Tensor> inputs, std::size_t cells,
                                         const Context& context) const;

private:
    struct Session;
    explicit OnnxModel(std::unique_ptr<Session> session);
    std::unique_ptr<Session> m_session;
};

}  // namespace s2b

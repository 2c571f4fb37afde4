// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/onnx_model.h"

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/base/parallel.h"
#include "core/segmentation/inputs.h"

#include <onnxruntime_cxx_api.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <optional>
#include <sstream>
#include <thread>

namespace s2b
{
namespace
{

constexpr std::size_t kBatch = 4096;  // cells; a batch's values stay in the processor's cache
constexpr const char* kScores = "scores";

/// Debian's onnxruntime says a thousand harmless lines on std::cerr as its first session is made (schemas that are
/// registered twice).
class SilentCerr
{
public:
    SilentCerr() : m_buffer(std::cerr.rdbuf(m_sink.rdbuf())) {}
    ~SilentCerr() { std::cerr.rdbuf(m_buffer); }
    SilentCerr(const SilentCerr&) = delete;
    SilentCerr& operator=(const SilentCerr&) = delete;

private:
    std::ostringstream m_sink;
    std::streambuf* m_buffer;
};

std::mutex& sessionMutex()
{
    static std::mutex mutex;
    return mutex;
}

/// One of the program. @pre the mutex is held.
Ort::Env& environment()
{
    static Ort::Env env(ORT_LOGGING_LEVEL_FATAL, "s2b");  // what fails is thrown, and told by us
    return env;
}

[[noreturn]] void fail(const std::string& name, const std::string& what)
{
    throw Error(ErrorCode::BadFile, name + ": " + what);
}

/// onnxruntime's own words, cut to one line.
std::string firstLine(const std::string& text)
{
    return text.substr(0, std::min(text.find('\n'), std::size_t{300}));
}

/// Why a session could not be made, for people.
[[noreturn]] void failLoading(const std::string& name, const Ort::Exception& error)
{
    const std::string text = error.what();
    const auto says = [&](const char* part) { return text.find(part) != std::string::npos; };
    if (says("IR version") || says("opset") || says("Opset"))
        fail(name, "the model was made for a newer ONNX than this onnxruntime (" + Ort::GetVersionString() +
                       ") reads: export it with opset 17 to 21 and IR version 10 or less (" + firstLine(text) + ")");
    if (error.GetOrtErrorCode() == ORT_INVALID_PROTOBUF || error.GetOrtErrorCode() == ORT_NO_MODEL ||
        says("Protobuf parsing failed") || says("No graph was found"))
        fail(name, "the file is no ONNX model, or is damaged");
    fail(name, "onnxruntime can't load the model: " + firstLine(text));
}

std::string shapeText(const std::vector<std::int64_t>& shape)
{
    std::string text = "[";
    for (const std::int64_t size : shape)
        text += (text.size() > 1 ? ", " : "") + (size < 0 ? std::string("any") : std::to_string(size));
    return text + "]";
}

std::string typeText(ONNXTensorElementDataType type)
{
    return type == ONNX_TENSOR_ELEMENT_DATA_TYPE_FLOAT   ? "float"
           : type == ONNX_TENSOR_ELEMENT_DATA_TYPE_INT64 ? "int64"
                                                         : "another type";
}

/// What the model declares of `spec.name` has to take every tensor of the spec.
void checkTensor(const std::string& model, const char* what, const Ort::TypeInfo& info, const TensorSpec& spec)
{
    if (info.GetONNXType() != ONNX_TYPE_TENSOR)
        fail(model, "the model's " + std::string(what) + " " + spec.name + " is no tensor");
    const auto tensor = info.GetTensorTypeAndShapeInfo();
    const std::vector<std::int64_t> shape = tensor.GetShape();
    const ONNXTensorElementDataType wanted =
        spec.type == TensorType::Float ? ONNX_TENSOR_ELEMENT_DATA_TYPE_FLOAT : ONNX_TENSOR_ELEMENT_DATA_TYPE_INT64;
    bool fits = tensor.GetElementType() == wanted && shape.size() == spec.shape.size();
    for (std::size_t i = 0; fits && i < shape.size(); ++i)
        fits = shape[i] < 0 || shape[i] == spec.shape[i];
    if (!fits)
        fail(model, "the model's " + std::string(what) + " " + spec.name + " is " + typeText(tensor.GetElementType()) +
                        " " + shapeText(shape) + ", after its metadata it should be " + typeText(wanted) + " " +
                        shapeText(spec.shape));
}

}  // namespace

struct OnnxModel::Session
{
    std::string name;
    ModelContract contract;
    std::vector<std::string> inputs;
    bool isPerCell = false;
    std::optional<Ort::Session> session;

    Session(std::span<const std::byte> bytes, std::string modelName, unsigned threads) : name(std::move(modelName))
    {
        open(bytes, 1);
        readContract();
        // Batches go to our threads one by one; what runs as a whole uses threads of its own.
        if (!isPerCell && threads != 1)
            open(bytes, threads);
    }

    void open(std::span<const std::byte> bytes, unsigned threads)
    {
        const std::lock_guard lock(sessionMutex());
        const SilentCerr silent;
        Ort::SessionOptions options;
        options.SetIntraOpNumThreads(
            static_cast<int>(threads == 0 ? std::max(1u, std::thread::hardware_concurrency()) : threads));
        options.SetInterOpNumThreads(1);
        options.SetGraphOptimizationLevel(GraphOptimizationLevel::ORT_ENABLE_ALL);
        options.AddConfigEntry("session.intra_op.allow_spinning", "0");
        try
        {
            session.emplace(environment(), bytes.data(), bytes.size(), options);
        }
        catch (const Ort::Exception& error)
        {
            failLoading(name, error);
        }
    }

    void readContract()
    {
        Ort::AllocatorWithDefaultOptions allocator;
        const Ort::ModelMetadata metadata = session->GetModelMetadata();
        std::map<std::string, std::string> pairs;
        for (const Ort::AllocatedStringPtr& key : metadata.GetCustomMetadataMapKeysAllocated(allocator))
            if (const auto value = metadata.LookupCustomMetadataMapAllocated(key.get(), allocator))
                pairs.emplace(key.get(), value.get());
        contract = parseContract(pairs, name);

        const std::vector<TensorSpec> specs = inputSpecs(contract);
        std::vector<std::string_view> known;
        for (const TensorSpec& spec : specs)
            known.push_back(spec.name);
        isPerCell = true;
        for (std::size_t i = 0; i < session->GetInputCount(); ++i)
        {
            inputs.emplace_back(session->GetInputNameAllocated(i, allocator).get());
            const auto spec = std::ranges::find(specs, inputs.back(), &TensorSpec::name);
            if (spec == specs.end())
                fail(name, "the model takes an input \"" + inputs.back() + "\", after its metadata it can take " +
                               joinNames(known) + "; the nearest is " + std::string(nearestName(inputs.back(), known)));
            checkTensor(name, "input", session->GetInputTypeInfo(i), *spec);
            isPerCell = isPerCell && spec->isPerCell;
        }
        if (inputs.empty())
            fail(name, "the model takes no input");
        for (std::size_t i = 0; i < session->GetOutputCount(); ++i)
            if (std::string(session->GetOutputNameAllocated(i, allocator).get()) == kScores)
            {
                checkTensor(name, "output", session->GetOutputTypeInfo(i),
                            {kScores,
                             TensorType::Float,
                             {TensorSpec::kAny, static_cast<std::int64_t>(contract.classes.size())}});
                return;
            }
        fail(name, "the model has no output \"scores\"");
    }

    /// Rows begin..end of the per-cell tensors, all of the others.
    void runRows(std::span<const Tensor> tensors, std::size_t begin, std::size_t end, const Ort::RunOptions& options,
                 float* scores)
    {
        const auto memory = Ort::MemoryInfo::CreateCpu(OrtArenaAllocator, OrtMemTypeDefault);
        std::vector<Ort::Value> values;
        std::vector<const char*> names;
        const std::vector<TensorSpec> specs = inputSpecs(contract);
        for (const Tensor& t : tensors)
        {
            std::vector<std::int64_t> shape = t.shape;
            std::size_t offset = 0, size = 1;
            if (std::ranges::find(specs, t.name, &TensorSpec::name)->isPerCell)
            {
                shape[0] = static_cast<std::int64_t>(end - begin);
                offset = begin;
                for (std::size_t k = 1; k < shape.size(); ++k)
                    offset *= static_cast<std::size_t>(shape[k]);
            }
            for (const std::int64_t s : shape)
                size *= static_cast<std::size_t>(s);
            names.push_back(t.name.c_str());
            // onnxruntime takes inputs as if it wrote to them; it does not.
            std::visit(
                [&](const auto& data)
                {
                    using Value = typename std::decay_t<decltype(data)>::value_type;
                    values.push_back(Ort::Value::CreateTensor<Value>(memory, const_cast<Value*>(data.data()) + offset,
                                                                     size, shape.data(), shape.size()));
                },
                t.data);
        }
        const char* output = kScores;
        const std::vector<Ort::Value> result =
            session->Run(options, names.data(), values.data(), values.size(), &output, 1);
        const std::size_t count = (end - begin) * contract.classes.size();
        if (result[0].GetTensorTypeAndShapeInfo().GetElementCount() != count)
            fail(name, "the model gives " + std::to_string(result[0].GetTensorTypeAndShapeInfo().GetElementCount()) +
                           " scores for " + std::to_string(end - begin) + " cells and " +
                           std::to_string(contract.classes.size()) + " classes");
        std::copy_n(result[0].GetTensorData<float>(), count, scores);
    }
};

OnnxModel::OnnxModel(std::unique_ptr<Session> session) : m_session(std::move(session)) {}
OnnxModel::~OnnxModel() = default;
OnnxModel::OnnxModel(OnnxModel&&) noexcept = default;
OnnxModel& OnnxModel::operator=(OnnxModel&&) noexcept = default;

OnnxModel OnnxModel::load(const std::string& path, unsigned threads)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        fail(path, "is a folder, give an ONNX file");
    std::ifstream file(path, std::ios::binary);
    if (!file)
        fail(path, "the model can't be read");
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    return fromBytes(std::as_bytes(std::span(bytes)), path, threads);
}

OnnxModel OnnxModel::fromBytes(std::span<const std::byte> bytes, const std::string& name, unsigned threads)
{
    if (bytes.empty())
        fail(name, "the file is empty, give an ONNX model");
    return OnnxModel(std::make_unique<Session>(bytes, name, threads));
}

const ModelContract& OnnxModel::contract() const
{
    return m_session->contract;
}

const std::string& OnnxModel::name() const
{
    return m_session->name;
}

const std::vector<std::string>& OnnxModel::inputNames() const
{
    return m_session->inputs;
}

std::vector<float> OnnxModel::run(std::span<const Tensor> inputs, std::size_t cells, const Context& context) const
{
    std::vector<float> scores(cells * m_session->contract.classes.size());
    Ort::RunOptions options;
    const std::stop_callback stop(context.cancel, [&] { options.SetTerminate(); });
    try
    {
        if (m_session->isPerCell)
            parallelChunks(cells, kBatch, context,
                           [&](std::size_t begin, std::size_t end)
                           {
                               m_session->runRows(inputs, begin, end, options,
                                                  scores.data() + begin * m_session->contract.classes.size());
                           });
        else
            m_session->runRows(inputs, 0, cells, options, scores.data());
    }
    catch (const Ort::Exception& error)
    {
        context.checkCancelled();
        fail(m_session->name, "the model failed: " + firstLine(error.what()));
    }
    return scores;
}

}  // namespace s2b

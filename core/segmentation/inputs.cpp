// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/inputs.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace s2b
{
namespace
{

constexpr std::size_t kChunk = 1u << 14;

constexpr std::array<FeatureInfo, 10> kFeatures = {{
    {"normal_z", "1", "how level the surface is: |z| of its normal, 0 where it has none"},
    {"has_normal", "1", "1 where the surface has a normal"},
    {"flatness", "m", "RMS distance of the neighbourhood from its plane"},
    {"height", "m", "above the storey's floor"},
    {"depth", "m", "below the storey's ceiling"},
    {"points", "1", "logarithm of the number of points in the cell"},
    {"has_colour", "1", "1 where the cloud has colours"},
    {"red", "1", "0 to 1; 0.5 without colours", true},
    {"green", "1", "0 to 1; 0.5 without colours", true},
    {"blue", "1", "0 to 1; 0.5 without colours", true},
}};

constexpr std::array<FeatureInfo, 2> kPlanChannels = {{
    {"cells", "1", "logarithm of 1 + the number of cells in the bin"},
    {"upright", "1", "share of the bin's cells that are upright surfaces"},
}};

float featureOf(std::size_t feature, const CellSet& set, std::size_t i)
{
    const SurfaceCell& c = set.cells[i];
    switch (feature)
    {
        case 0:
            return std::abs(c.normal.z());
        case 1:
            return c.normal.isZero() ? 0.0f : 1.0f;
        case 2:
            return c.flatness;
        case 3:
            return static_cast<float>(static_cast<double>(c.position.z()) - set.floor_m);
        case 4:
            return static_cast<float>(set.ceiling_m - static_cast<double>(c.position.z()));
        case 5:
            return std::log1p(static_cast<float>(c.count));
        case 6:
            return set.colours.empty() ? 0.0f : 1.0f;
        default:
            return set.colours.empty() ? 0.5f : static_cast<float>(set.colours[i][feature - 7]) / 255.0f;
    }
}

Tensor cellTensor(const ModelContract& contract, const CellSet& set, const Context& context)
{
    std::vector<std::size_t> features;
    for (const std::string& name : contract.features)
        features.push_back(
            static_cast<std::size_t>(std::ranges::find(kFeatures, name, &FeatureInfo::name) - kFeatures.begin()));
    std::vector<float> values(set.cells.size() * features.size());
    parallelChunks(set.cells.size(), kChunk, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       std::size_t out = begin * features.size();
                       for (std::size_t i = begin; i < end; ++i)
                           for (std::size_t k = 0; k < features.size(); ++k)
                           {
                               const float v = featureOf(features[k], set, i);
                               values[out++] = contract.mean.empty() ? v : (v - contract.mean[k]) / contract.scale[k];
                           }
                   });
    return {"cells",
            {static_cast<std::int64_t>(set.cells.size()), static_cast<std::int64_t>(features.size())},
            std::move(values)};
}

/// The plan's pixels and height bins.
struct PlanGrid
{
    double low_x = 0, low_y = 0, low_z = 0;
    std::int64_t width = 0, height = 0;
    const PlanContract& plan;

    PlanGrid(const PlanContract& p, const CellSet& set) : plan(p)
    {
        Eigen::Vector2d low = set.cells.front().position.head<2>().cast<double>(), high = low;
        for (const SurfaceCell& c : set.cells)
        {
            low = low.cwiseMin(c.position.head<2>().cast<double>());
            high = high.cwiseMax(c.position.head<2>().cast<double>());
        }
        low_x = low.x(), low_y = low.y(), low_z = set.floor_m + p.low_m;
        const auto size = [&](double extent)
        {
            const auto pixels = static_cast<std::int64_t>(extent / p.pixel_m) + 1;
            return (pixels + p.multiple - 1) / p.multiple * p.multiple;
        };
        width = size(high.x() - low.x()), height = size(high.y() - low.y());
    }
    [[nodiscard]] std::int64_t pixel(const SurfaceCell& c) const
    {
        const auto x = static_cast<std::int64_t>((static_cast<double>(c.position.x()) - low_x) / plan.pixel_m);
        const auto y = static_cast<std::int64_t>((static_cast<double>(c.position.y()) - low_y) / plan.pixel_m);
        return y * width + x;
    }
    [[nodiscard]] std::int64_t bin(const SurfaceCell& c) const
    {
        const double b = std::floor((static_cast<double>(c.position.z()) - low_z) / plan.bin_m);
        return static_cast<std::int64_t>(std::clamp(b, 0.0, static_cast<double>(plan.bins - 1)));
    }
};

Tensor planTensor(const PlanGrid& grid, const CellSet& set)
{
    const std::int64_t pixels = grid.width * grid.height, bins = grid.plan.bins;
    std::vector<float> count(static_cast<std::size_t>(bins * pixels)), upright(count.size());
    for (const SurfaceCell& c : set.cells)
    {
        const auto at = static_cast<std::size_t>(grid.bin(c) * pixels + grid.pixel(c));
        count[at] += 1.0f;
        upright[at] += !c.normal.isZero() && std::abs(c.normal.z()) < 0.3f ? 1.0f : 0.0f;
    }
    std::vector<float> values;
    for (const std::string& channel : grid.plan.channels)
        for (std::size_t k = 0; k < count.size(); ++k)
            values.push_back(channel == "cells" ? std::log1p(count[k]) : upright[k] / std::max(count[k], 1.0f));
    const auto layers = static_cast<std::int64_t>(grid.plan.channels.size()) * bins;
    return {"plan", {1, layers, grid.height, grid.width}, std::move(values)};
}

}  // namespace

std::span<const FeatureInfo> knownFeatures()
{
    return kFeatures;
}

std::span<const FeatureInfo> knownPlanChannels()
{
    return kPlanChannels;
}

std::vector<TensorSpec> inputSpecs(const ModelContract& contract)
{
    std::vector<TensorSpec> specs;
    if (!contract.features.empty())
        specs.push_back({"cells",
                         TensorType::Float,
                         {TensorSpec::kAny, static_cast<std::int64_t>(contract.features.size())},
                         true});
    if (contract.plan.isUsed())
    {
        const auto layers = static_cast<std::int64_t>(contract.plan.channels.size()) * contract.plan.bins;
        specs.push_back({"plan", TensorType::Float, {1, layers, TensorSpec::kAny, TensorSpec::kAny}, false});
        specs.push_back({"pixel", TensorType::Int64, {TensorSpec::kAny}, true});
        specs.push_back({"bin", TensorType::Int64, {TensorSpec::kAny}, true});
    }
    return specs;
}

std::vector<Tensor> makeInputs(const ModelContract& contract, std::span<const std::string> names, const CellSet& set,
                               const Context& context)
{
    std::vector<Tensor> tensors;
    for (const std::string& name : names)
    {
        if (name == "cells")
        {
            tensors.push_back(cellTensor(contract, set, context));
            continue;
        }
        const PlanGrid grid(contract.plan, set);
        if (name == "plan")
        {
            tensors.push_back(planTensor(grid, set));
            continue;
        }
        std::vector<std::int64_t> at;
        at.reserve(set.cells.size());
        for (const SurfaceCell& c : set.cells)
            at.push_back(name == "pixel" ? grid.pixel(c) : grid.bin(c));
        tensors.push_back({name, {static_cast<std::int64_t>(at.size())}, std::move(at)});
    }
    return tensors;
}

}  // namespace s2b

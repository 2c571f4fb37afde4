// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/inputs.h"

#include "core/base/parallel.h"
#include "core/segmentation/plan.h"
#include "core/segmentation/wall_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace s2b
{
namespace
{

constexpr std::size_t kChunk = 1u << 14;

constexpr std::array<FeatureInfo, 24> kFeatures = {{
    {"normal_x", "1", "|x| of the surface's normal in the building's frame, 0 where it has none"},
    {"normal_y", "1", "|y| of the same"},
    {"normal_z", "1", "how level the surface is: |z| of its normal, 0 where it has none"},
    {"has_normal", "1", "1 where the surface has a normal"},
    {"flatness", "m", "RMS distance of the neighbourhood from its plane"},
    {"height", "m", "above the storey's floor"},
    {"depth", "m", "below the storey's ceiling"},
    {"pixel_x", "1", "x within the plan's pixel, from its centre, in pixels; 0 without a plan"},
    {"pixel_y", "1", "y of the same"},
    {"bin_z", "1", "z within the plan's height bin, from its middle, in bins, at most 1; 0 without a plan"},
    {"plane_offset", "0.1 m",
     "distance from the strongest parallel plane within 0.3 m; all plane_ are 0 if not upright"},
    {"plane_strength", "1", "area of that plane, relative to its window"},
    {"plane_own", "1", "the same of the plane that the cell lies in"},
    {"plane_upper_offset", "0.1 m", "plane_offset, of planes more than 2.15 m above the floor"},
    {"plane_upper_strength", "1", "plane_strength of the same"},
    {"plane_run_up", "m", "how far the surface goes on without a gap above the cell"},
    {"plane_run_down", "m", "the same below"},
    {"plane_top", "m", "distance of the surface's highest point from the ceiling, at the cell's place"},
    {"plane_bottom", "m", "distance of its lowest point from the floor"},
    {"points", "1", "logarithm of the number of points in the cell"},
    {"has_colour", "1", "1 where the cloud has colours"},
    {"red", "1", "0 to 1; 0.5 without colours", true},
    {"green", "1", "0 to 1; 0.5 without colours", true},
    {"blue", "1", "0 to 1; 0.5 without colours", true},
}};

float featureOf(std::size_t feature, const CellSet& set, std::size_t i, const PlanPlace& place, const WallPlane& plane)
{
    const SurfaceCell& c = set.cells[i];
    switch (feature)
    {
        case 0:
            return std::abs(c.normal.x());
        case 1:
            return std::abs(c.normal.y());
        case 2:
            return std::abs(c.normal.z());
        case 3:
            return c.normal.isZero() ? 0.0f : 1.0f;
        case 4:
            return c.flatness;
        case 5:
            return static_cast<float>(static_cast<double>(c.position.z()) - set.floor_m);
        case 6:
            return static_cast<float>(set.ceiling_m - static_cast<double>(c.position.z()));
        case 7:
            return place.dx;
        case 8:
            return place.dy;
        case 9:
            return place.dz;
        case 10:
            return plane.offset;
        case 11:
            return plane.strength;
        case 12:
            return plane.own;
        case 13:
            return plane.upperOffset;
        case 14:
            return plane.upperStrength;
        case 15:
            return plane.runUp;
        case 16:
            return plane.runDown;
        case 17:
            return plane.top;
        case 18:
            return plane.bottom;
        case 19:
            return std::log1p(static_cast<float>(c.count));
        case 20:
            return set.colours.empty() ? 0.0f : 1.0f;
        default:
            return set.colours.empty() ? 0.5f : static_cast<float>(set.colours[i][feature - 21]) / 255.0f;
    }
}

Tensor cellTensor(const ModelContract& contract, const CellSet& set, const std::optional<PlanGrid>& grid,
                  const Context& context)
{
    std::vector<std::size_t> features;
    for (const std::string& name : contract.features)
        features.push_back(
            static_cast<std::size_t>(std::ranges::find(kFeatures, name, &FeatureInfo::name) - kFeatures.begin()));
    std::vector<WallPlane> planes;
    if (std::ranges::any_of(contract.features, [](const std::string& f) { return f.starts_with("plane_"); }))
        planes = findWallPlanes(set, context);
    std::vector<float> values(set.cells.size() * features.size());
    parallelChunks(set.cells.size(), kChunk, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       std::size_t out = begin * features.size();
                       for (std::size_t i = begin; i < end; ++i)
                       {
                           const PlanPlace place = grid ? grid->place(set.cells[i]) : PlanPlace{};
                           const WallPlane plane = planes.empty() ? WallPlane{} : planes[i];
                           for (std::size_t k = 0; k < features.size(); ++k)
                           {
                               const float v = featureOf(features[k], set, i, place, plane);
                               values[out++] = contract.mean.empty() ? v : (v - contract.mean[k]) / contract.scale[k];
                           }
                       }
                   });
    return {"cells",
            {static_cast<std::int64_t>(set.cells.size()), static_cast<std::int64_t>(features.size())},
            std::move(values)};
}

}  // namespace

std::span<const FeatureInfo> knownFeatures()
{
    return kFeatures;
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
    std::optional<PlanGrid> grid;
    if (contract.plan.isUsed())
        grid.emplace(contract.plan, set);
    const auto tensorOf = [&](const std::string& name) -> Tensor
    {
        if (name == "cells")
            return cellTensor(contract, set, grid, context);
        if (name == "plan")
            return planTensor(*grid, contract.plan, set);
        std::vector<std::int64_t> at;
        at.reserve(set.cells.size());
        for (const SurfaceCell& c : set.cells)
        {
            const PlanPlace p = grid->place(c);
            at.push_back(name == "pixel" ? p.y * grid->width() + p.x : p.bin);
        }
        return {name, {static_cast<std::int64_t>(at.size())}, std::move(at)};
    };
    std::vector<Tensor> tensors(names.size());
    parallelChunks(names.size(), 1, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t i = begin; i < end; ++i)
                           tensors[i] = tensorOf(names[i]);
                   });
    return tensors;
}

}  // namespace s2b

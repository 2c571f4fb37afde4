// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/segment.h"

#include "core/base/parallel.h"
#include "core/cloud/clutter.h"
#include "core/cloud/frame.h"
#include "core/cloud/surface_cells.h"
#include "core/segmentation/cell_colours.h"
#include "core/segmentation/element_classes.h"
#include "core/segmentation/inputs.h"
#include "core/segmentation/passes.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <format>
#include <future>

namespace s2b
{
namespace
{

constexpr std::size_t kChunk = 1u << 16;

/// The likeliest class of one row of scores. Columns that mean one class count together; of equally likely ones the
/// first is taken.
CellClass classOf(const float* scores, const ModelContract& contract)
{
    std::array<double, kLabelCount> probability{};
    const std::size_t columns = contract.classes.size();
    double sum = 0;
    const float largest = *std::max_element(scores, scores + columns);
    for (std::size_t k = 0; k < columns; ++k)
    {
        const auto s = static_cast<double>(scores[k]);
        const double p = contract.scores == ScoreKind::Logits ? std::exp(s - static_cast<double>(largest)) : s;
        probability[static_cast<std::size_t>(contract.classes[k])] += p;
        sum += p;
    }
    const auto best = std::max_element(probability.begin(), probability.end());
    if (!(sum > 0.0) || !std::isfinite(sum))
        return {};
    return {static_cast<Label>(best - probability.begin()),
            static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(*best / sum, 0.0, 1.0)))};
}

CellSet cellsOf(const SurfaceCells& cells, const std::vector<std::array<std::uint8_t, 3>>& colours,
                const SegmentPass& pass)
{
    CellSet set;
    set.size_m = cells.size_m, set.spacing_m = cells.spacing_m;
    set.floor_m = pass.floor_m, set.ceiling_m = pass.ceiling_m;
    set.cells.reserve(pass.cells.size());
    for (const std::uint32_t i : pass.cells)
        set.cells.push_back(cells.cells[i]);
    if (!colours.empty())
        for (const std::uint32_t i : pass.cells)
            set.colours.push_back(colours[i]);
    return set;
}

/// What the network says of every cell.
std::vector<CellClass> classesOf(const SurfaceCells& cells, const std::vector<std::array<std::uint8_t, 3>>& colours,
                                 const std::vector<SegmentPass>& passes, const OnnxModel& model, const Context& context)
{
    const ModelContract& contract = model.contract();
    std::vector<CellClass> classes(cells.cells.size());
    std::size_t total = 0;
    for (const SegmentPass& pass : passes)
        total += pass.cells.size();
    std::atomic<std::size_t> next = 0, done = 0;
    const auto run = [&](const SegmentPass& pass, const auto& tell)
    {
        tell("Features");
        const std::vector<Tensor> inputs =
            makeInputs(contract, model.inputNames(), cellsOf(cells, colours, pass), context);
        tell("Network");
        const std::vector<float> scores = model.run(inputs, pass.cells.size(), context);
        for (std::size_t i = 0; i < pass.inside; ++i)
            classes[pass.cells[i]] = classOf(scores.data() + i * contract.classes.size(), contract);
        done += pass.cells.size();
    };
    const auto runAll = [&](bool tells)
    {
        try
        {
            for (std::size_t k = next++; k < passes.size(); k = next++)
                run(passes[k],
                    [&](const char* what)
                    {
                        context.checkCancelled();
                        if (tells)
                            context.report(
                                passes.size() > 1 ? std::format("{} ({} of {})", what, k + 1, passes.size()) : what,
                                0.3 + 0.6 * static_cast<double>(done) / static_cast<double>(total));
                    });
        }
        catch (...)
        {
            next = passes.size();  // for the other one, too
            throw;
        }
    };
    // Two passes side by side: neither features nor network keep all cores busy by themselves.
    std::future<void> other;
    if (context.threads != 1 && passes.size() > 1)
        other = std::async(std::launch::async, runAll, false);
    runAll(true);
    if (other.valid())
        other.get();
    return classes;
}

}  // namespace

Segmentation segment(const CloudView& cloud, const OnnxModel& model, const SegmentParams& params,
                     const Context& context)
{
    const ModelContract& contract = model.contract();
    CloudView input = cloud;
    input.labels = nullptr;
    if (contract.colour == ColourUse::None)
        input.rgb = nullptr;
    if (input.count == 0)
        throw Error(ErrorCode::EmptyCloud, "the cloud has no points");
    if (contract.colour == ColourUse::Required && !input.rgb)
        throw Error(ErrorCode::BadParameter,
                    model.name() + ": the model needs colours and the cloud has none; use a model that works without");

    context.report("Clutter", 0.0);
    const KeptRegion region = findDenseRegion(input, {}, context);
    context.report("Surface cells", 0.05);
    CellParams cellParams;
    cellParams.size_m = contract.cell_m;
    std::vector<std::uint32_t> cellOfPoint;
    SurfaceCells cells = buildSurfaceCells(input, region, cellParams, context, &cellOfPoint);
    std::vector<std::array<std::uint8_t, 3>> colours;
    if (input.rgb)
        colours = cellColours(input, cellOfPoint, cells.cells.size(), context);
    context.report("Storeys", 0.25);
    rotateCells(cells, findDominantYaw(cells, {}, context));
    const std::vector<Level> levels = findLevels(cells, {}, context).levels;
    const std::vector<SegmentPass> passes = planPasses(cells, levels, params, context);

    std::vector<CellClass> classes = classesOf(cells, colours, passes, model, context);
    if (params.settle)
    {
        context.report("Elements", 0.9);
        settleByElements(std::move(cells), levels, classes, context);
    }
    context.report("Labels", 0.95);
    Segmentation result;
    result.labels.resize(cloud.count);
    result.confidence.resize(cloud.count);
    parallelChunks(cloud.count, kChunk, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t i = begin; i < end; ++i)
                       {
                           const std::uint32_t cell = cellOfPoint[i];
                           const CellClass c = cell == kNoCell ? CellClass{} : classes[cell];
                           result.labels[i] = static_cast<std::uint8_t>(c.label);
                           result.confidence[i] = c.confidence;
                       }
                   });
    for (const std::uint8_t label : result.labels)
        ++result.counts[label];
    context.checkCancelled();
    return result;
}

}  // namespace s2b

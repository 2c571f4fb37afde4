// SPDX-License-Identifier: GPL-3.0-or-later
/// s2b_features CLOUD.laz OUT: what the segmentation network sees of a labelled cloud, as NumPy files for training.
#include "core/cloud/clutter.h"
#include "core/cloud/frame.h"
#include "core/cloud/surface_cells.h"
#include "core/segmentation/passes.h"
#include "core/segmentation/plan.h"
#include "tests/bench/laz_reader.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

namespace
{

using namespace s2b;

/// One array as .npy (format version 1.0).
template <typename T>
void writeArray(const std::string& path, const char* type, const std::vector<T>& values, std::size_t columns)
{
    std::string header = std::string("{'descr': '") + type + "', 'fortran_order': False, 'shape': (" +
                         std::to_string(values.size() / columns) + "," +
                         (columns > 1 ? std::to_string(columns) + ")" : ")") + ", }";
    header.resize((10 + header.size() + 64) / 64 * 64 - 11, ' ');
    header += '\n';
    std::ofstream file(path, std::ios::binary);
    const std::uint16_t size = static_cast<std::uint16_t>(header.size());
    file.write("\x93NUMPY\x01\x00", 8);
    file.write(reinterpret_cast<const char*>(&size), 2);
    file << header;
    file.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
    file.close();
    if (!file)
        throw Error(ErrorCode::BadFile, "cannot write " + path);
}

std::vector<Eigen::half> halves(const std::vector<float>& values)
{
    std::vector<Eigen::half> result(values.size());
    std::transform(values.begin(), values.end(), result.begin(), [](float v) { return Eigen::half(v); });
    return result;
}

ModelContract readContract(const std::string& path)
{
    std::ifstream file(path);
    std::map<std::string, std::string> metadata;
    for (std::string line; std::getline(file, line);)
        if (const std::size_t at = line.find('='); at != std::string::npos)
            metadata[line.substr(0, at)] = line.substr(at + 1);
    return parseContract(metadata, path);
}

/// The raster is nearly empty: its values and where they are; cells and values in the order of their rows.
void writeStorey(const ModelContract& contract, CellSet set, const std::string& prefix, const Context& context)
{
    const PlanGrid grid(contract.plan, set);
    std::stable_sort(set.cells.begin(), set.cells.end(),
                     [&](const SurfaceCell& a, const SurfaceCell& b) { return grid.place(a).y < grid.place(b).y; });
    const std::vector<Tensor> tensors = makeInputs(contract, std::vector<std::string>{"plan", "cells"}, set, context);
    const auto& plan = std::get<std::vector<float>>(tensors[0].data);
    const auto layers = static_cast<std::size_t>(tensors[0].shape[1]);
    const auto width = static_cast<std::size_t>(grid.width()), height = static_cast<std::size_t>(grid.height());
    std::vector<std::uint32_t> at;
    std::vector<std::uint8_t> channel;
    std::vector<float> value;
    std::vector<std::uint32_t> rasterRows{0}, cellRows;  // where each row begins, and the end
    for (std::size_t row = 0; row < height; ++row)
    {
        for (std::size_t c = 0; c < layers; ++c)
            for (std::size_t i = row * width; i < (row + 1) * width; ++i)
                if (const float v = plan[c * width * height + i]; v != 0.0f)
                {
                    at.push_back(static_cast<std::uint32_t>(i));
                    channel.push_back(static_cast<std::uint8_t>(c));
                    value.push_back(v);
                }
        rasterRows.push_back(static_cast<std::uint32_t>(at.size()));
    }
    std::vector<std::int16_t> places;
    std::vector<std::uint8_t> labels;
    std::vector<std::uint32_t> counts;
    for (std::size_t i = 0; i < set.cells.size(); ++i)
    {
        const PlanPlace p = grid.place(set.cells[i]);
        while (cellRows.size() <= static_cast<std::size_t>(p.y))
            cellRows.push_back(static_cast<std::uint32_t>(i));
        places.insert(places.end(), {static_cast<std::int16_t>(p.x), static_cast<std::int16_t>(p.y),
                                     static_cast<std::int16_t>(p.bin)});
        labels.push_back(static_cast<std::uint8_t>(set.cells[i].label));
        counts.push_back(set.cells[i].count);
    }
    cellRows.resize(height + 1, static_cast<std::uint32_t>(set.cells.size()));
    writeArray(prefix + "shape.npy", "<f4", std::vector<float>{static_cast<float>(width), static_cast<float>(height)},
               1);
    writeArray(prefix + "raster_at.npy", "<u4", at, 1);
    writeArray(prefix + "raster_channel.npy", "|u1", channel, 1);
    writeArray(prefix + "raster_value.npy", "<f2", halves(value), 1);
    writeArray(prefix + "raster_rows.npy", "<u4", rasterRows, 1);
    writeArray(prefix + "cell_rows.npy", "<u4", cellRows, 1);
    writeArray(prefix + "cells.npy", "<f2", halves(std::get<std::vector<float>>(tensors[1].data)),
               contract.features.size());
    writeArray(prefix + "places.npy", "<i2", places, 3);
    writeArray(prefix + "labels.npy", "|u1", labels, 1);
    writeArray(prefix + "counts.npy", "<u4", counts, 1);
}

void run(const std::string& in, const std::string& out, const ModelContract& contract, const Context& context)
{
    const PointCloud cloud = readLaz(in);
    CloudView view;
    view.xyz = cloud.points.front().data();
    view.count = cloud.size();
    view.origin = cloud.origin;
    view.labels = reinterpret_cast<const std::uint8_t*>(cloud.labels.data());
    CellParams params;
    params.size_m = contract.cell_m;
    SurfaceCells cells = buildSurfaceCells(view, findDenseRegion(view, {}, context), params, context);
    rotateCells(cells, findDominantYaw(cells, {}));
    cells.hasLabels = false;  // the storeys must be those that an unlabelled cloud has
    SegmentParams whole;
    whole.largestPass = cells.cells.size();
    whole.largestTile_m = 1e9;
    const std::vector<SegmentPass> passes = planPasses(cells, findLevels(cells, {}, context).levels, whole, context);
    std::filesystem::create_directories(out);
    for (std::size_t k = 0; k < passes.size(); ++k)
    {
        CellSet set;
        set.size_m = cells.size_m, set.spacing_m = cells.spacing_m;
        set.floor_m = passes[k].floor_m, set.ceiling_m = passes[k].ceiling_m;
        for (const std::uint32_t i : passes[k].cells)
            set.cells.push_back(cells.cells[i]);
        std::printf("storey %.2f to %.2f m, %zu cells\n", set.floor_m, set.ceiling_m, set.cells.size());
        writeStorey(contract, std::move(set), out + "/" + std::to_string(k) + "_", context);
    }
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("What the segmentation network sees of a labelled cloud, as NumPy files for training.",
                 "s2b_features");
    std::string in, out, contract;
    Context context;
    app.add_option("cloud", in, "LAS or LAZ file with classes in the codes of s2b")->required();
    app.add_option("out", out, "folder to write")->required();
    app.add_option("--contract", contract, "file with the model's metadata, key=value a line")
        ->required()
        ->check(CLI::ExistingFile);
    app.add_option("--threads", context.threads, "0 = all");
    CLI11_PARSE(app, argc, argv);
    try
    {
        run(in, out, readContract(contract), context);
        return 0;
    }
    catch (const std::exception& e)
    {
        std::cerr << "s2b_features: " << e.what() << '\n';
        return 1;
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
/// s2b_speed FILE.laz... [Google Benchmark's options]: the stages of the reconstruction on clouds of several sizes.
///
/// The pipeline runs as a whole, as often as --repetitions says; the time of a stage is that from its report of
/// progress to the next one's, so that what is measured is what users run. Stages of several storeys are added up.
#include "core/pipeline/pipeline.h"
#include "tests/bench/laz_reader.h"
#include "tests/bench/process_memory.h"
#include "tests/bench/process_times.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace
{

using namespace s2b;
using bench::now;
using bench::Times;

constexpr const char* kWhole = "Whole pipeline";

struct Run
{
    std::map<std::string, Times> stages;
    double extra_b = 0.0;  ///< memory above the loaded cloud
};

/// All runs on one file. The cloud is gone when they are done: the next file's peak is its own.
struct Recording
{
    std::string name;
    std::size_t points = 0;
    std::vector<std::string> stages;  ///< in their order
    std::vector<Run> runs;
};

/// "Walls of Level 0" -> "Walls"
std::string stageOf(std::string_view text)
{
    return std::string(text.substr(0, text.find(" of ")));
}

Recording record(const std::string& path, int repetitions, unsigned threads)
{
    const PointCloud cloud = readLaz(path);
    Recording recording;
    recording.name = std::filesystem::path(path).stem().string();
    recording.points = cloud.size();
    const CloudView view{cloud.points.front().data(), cloud.size(), cloud.origin,
                         reinterpret_cast<const std::uint8_t*>(cloud.labels.data())};
    for (int i = 0; i < repetitions; ++i)
    {
        Run run;
        std::string stage;
        Times last;
        Context context;
        context.threads = threads;
        context.progress = [&](std::string_view text, double)
        {
            const Times t = now();
            if (!stage.empty())
                run.stages[stage] += t - last;
            stage = stageOf(text);
            last = t;
            if (std::find(recording.stages.begin(), recording.stages.end(), stage) == recording.stages.end())
                recording.stages.push_back(stage);
        };
        const bench::MemoryMeter memory;
        const Times start = now();
        const Building building = reconstruct(view, {}, context);
        const Times end = now();
        run.stages[stage] += end - last;
        run.stages[kWhole] = end - start;
        run.extra_b = memory.peak_b() - memory.before_b();
        recording.runs.push_back(std::move(run));
    }
    recording.stages.push_back(kWhole);
    return recording;
}

void report(benchmark::State& state, const Recording& recording, const std::string& stage)
{
    std::size_t i = 0;
    Times sum;
    double extra_b = 0.0;
    for (auto _ : state)
    {
        const Run& run = recording.runs[i++];
        const auto found = run.stages.find(stage);
        const Times t = found == run.stages.end() ? Times{} : found->second;
        state.SetIterationTime(t.wall_s);
        sum += t;
        extra_b = std::max(extra_b, run.extra_b);
    }
    const auto count = static_cast<double>(std::max<std::size_t>(i, 1));
    state.counters["cpu_s"] = sum.cpu_s / count;
    state.counters["points"] = static_cast<double>(recording.points);
    if (stage == kWhole)
        state.counters["extra_b"] = extra_b;
    state.SetItemsProcessed(static_cast<std::int64_t>(i * recording.points));
}

/// Takes "--name=value" out of the arguments; `fallback` when it is not there.
int takeOption(std::vector<char*>& arguments, std::string_view name, int fallback)
{
    for (auto a = arguments.begin(); a != arguments.end(); ++a)
    {
        const std::string_view text = *a;
        if (!text.starts_with(name) || text.size() <= name.size() || text[name.size()] != '=')
            continue;
        const std::string_view value = text.substr(name.size() + 1);
        int number = 0;
        const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
        if (error != std::errc() || end != value.data() + value.size() || number < 0)
            throw Error(ErrorCode::BadParameter, std::string(text) + " is not a number");
        arguments.erase(a);
        return number;
    }
    return fallback;
}

}  // namespace

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    try
    {
        std::vector<char*> arguments(argv + 1, argv + argc);
        const int repetitions = std::max(1, takeOption(arguments, "--repetitions", 3));
        const auto threads = static_cast<unsigned>(takeOption(arguments, "--threads", 0));
        if (arguments.empty())
            throw Error(ErrorCode::BadParameter, "give the LAZ files to measure on");
        std::vector<std::unique_ptr<Recording>> recordings;
        for (const char* path : arguments)
        {
            recordings.push_back(std::make_unique<Recording>(record(path, repetitions, threads)));
            const Recording& recording = *recordings.back();
            for (const std::string& stage : recording.stages)
                benchmark::RegisterBenchmark(stage + "/" + recording.name, [&recording, stage](benchmark::State& state)
                                             { report(state, recording, stage); })
                    ->UseManualTime()
                    ->Iterations(repetitions)
                    ->Unit(benchmark::kMillisecond);
        }
        benchmark::RunSpecifiedBenchmarks();
        benchmark::Shutdown();
    }
    catch (const std::exception& e)
    {
        std::cerr << "s2b_speed: " << e.what() << "\n";
        return 1;
    }
    return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/scene.h"

#include "core/report/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace s2b::report
{
using namespace validation;
namespace
{

constexpr double kLeastColorRange_m = 0.005;  ///< below it the colours would show the scanner's noise

std::optional<double> largestError(const ElementResult& pair)
{
    std::optional<double> largest;
    const auto take = [&](const std::optional<double>& error)
    {
        if (error && std::isfinite(*error))
            largest = std::max(largest.value_or(0.0), std::abs(*error));
    };
    take(pair.axisEnd_m ? pair.axisEnd_m : pair.centroid_m);
    take(pair.thicknessError_m);
    take(pair.heightError_m);
    return largest;
}

void judge(Row& row, const Scene& scene, const ValidationParams& params)
{
    const std::string limit =
        "the " + roundMillimetres(scene.toleranceLimit_m) + " mm of LOA" + std::to_string(params.tolerance);
    const auto compare = [&](double error_m, const std::string& what)
    {
        row.error_m = error_m;
        row.reason = what + " " + millimetres(error_m) + " mm, " +
                     (row.verdict == Verdict::Within   ? "within "
                      : row.verdict == Verdict::NoData ? "of "
                                                       : "over ") +
                     limit;
    };
    switch (row.pair.outcome)
    {
        case Outcome::Missed:
            row.verdict = Verdict::OutOfTolerance;
            row.reason = "in the truth and seen by the survey, but nothing of the result stands there";
            row.style = Style::Missed;
            return;
        case Outcome::FalsePositive:
            row.verdict = Verdict::OutOfTolerance;
            row.reason = "in the result, but nothing of the truth stands there";
            row.style = Style::FalsePositive;
            break;
        case Outcome::NotSeen:
            row.reason = "the survey saw too little of it to ask for it";
            row.style = Style::NotSeen;
            return;
        case Outcome::Matched:
        case Outcome::Excused:
            break;
    }
    const bool isJudged = row.pair.outcome != Outcome::FalsePositive;
    // Of these a survey gives the hole; where in it the leaf or pane stands is the model's guess, not a measurement.
    const bool isFilling = row.pair.elementClass == ElementClass::Door || row.pair.elementClass == ElementClass::Window;
    if (row.toResult && row.toResult->verdict != Verdict::NoData && !isFilling)
    {
        row.band = row.toResult->band;
        row.error_m = row.toResult->p95_m;
        if (isJudged)
        {
            row.verdict = row.toResult->verdict;
            compare(row.toResult->p95_m, "95 % of its points lie within");
        }
    }
    else if (isJudged && (!scene.hasPoints || isFilling) && row.pair.outcome == Outcome::Matched)
    {
        row.reason = isFilling ? "its leaf or pane is not what was measured: points don't judge it"
                               : "nothing to compare it with";
        if (const auto error_m = largestError(row.pair))
        {
            row.band = bandOf(*error_m, params);
            row.verdict = *error_m <= scene.toleranceLimit_m ? Verdict::Within : Verdict::OutOfTolerance;
            compare(*error_m, "largest error in place and size");
        }
    }
    else if (isJudged)
        row.reason = "too few points on it to judge it";
    if (isJudged)
        row.style = row.verdict == Verdict::Within           ? Style::Within
                    : row.verdict == Verdict::OutOfTolerance ? Style::OutOfTolerance
                                                             : Style::NoData;
}

/// Ascending: what a reader should look at first.
auto sortKey(const Row& row)
{
    const int group = row.verdict == Verdict::OutOfTolerance ? 0
                      : row.verdict == Verdict::Within       ? 1
                      : row.pair.outcome == Outcome::NotSeen ? 3
                                                             : 2;
    const bool hasPartner = row.pair.outcome == Outcome::Matched || row.pair.outcome == Outcome::Excused;
    const double error_m = row.error_m.value_or(0.0);
    return std::tuple(group, hasPartner, row.pair.outcome, -error_m, row.pair.elementClass, row.pair.truth,
                      row.pair.result);
}

std::string idOf(const Row& row, const ReportInput& input)
{
    const BimElement& element = row.element();
    if (!element.guid.empty())
        return cleanText(element.guid);
    const Bim& bim = row.result ? *input.result : *input.truth;
    const int index = row.result ? row.pair.result : row.pair.truth;
    return std::string(className(element.elementClass)) + " " + std::to_string(index) + " of " + fileName(bim.file);
}

int levelOf(const Row& row, const Scene& scene)
{
    for (std::size_t i = 0; i < scene.levels.size(); ++i)
    {
        const Level& level = scene.levels[i];
        if ((row.truth && row.truth->storey >= 0 && row.truth->storey == level.truth) ||
            (!row.truth && row.result && row.result->storey >= 0 && row.result->storey == level.result))
            return static_cast<int>(i);
    }
    // Of no storey: the highest floor below its middle.
    const BimElement& element = row.element();
    const double middle_m = (element.low_m + element.high_m) / 2.0 + scene.shiftOf(row).z();
    int found = scene.levels.empty() ? -1 : 0;
    for (std::size_t i = 0; i < scene.levels.size(); ++i)
    {
        if (scene.levels[i].elevation_m <= middle_m)
            found = static_cast<int>(i);
    }
    return found;
}

void addLevels(const ReportInput& input, Scene& scene)
{
    std::vector<int> partner(input.result->storeys.size(), -1);
    if (input.truth)
    {
        for (std::size_t i = 0; i < input.truth->storeys.size(); ++i)
        {
            const BimStorey& storey = input.truth->storeys[i];
            Level level;
            level.name = cleanText(storey.name);
            level.elevation_m = storey.elevation_m + scene.truthShift.z();
            level.truth = static_cast<int>(i);
            level.isSurveyed = storey.isSurveyed;
            for (const StoreyError& match : input.validation->storeys)
            {
                if (match.truth != level.truth || match.result < 0)
                    continue;
                level.result = match.result;
                if (static_cast<std::size_t>(match.result) < partner.size())
                    partner[static_cast<std::size_t>(match.result)] = level.truth;
            }
            scene.levels.push_back(level);
        }
    }
    for (std::size_t i = 0; i < input.result->storeys.size(); ++i)
    {
        if (partner[i] >= 0)
            continue;
        Level level;
        level.name = cleanText(input.result->storeys[i].name);
        level.elevation_m = input.result->storeys[i].elevation_m + scene.resultShift.z();
        level.result = static_cast<int>(i);
        scene.levels.push_back(level);
    }
    if (scene.levels.empty())
    {
        double low_m = std::numeric_limits<double>::max();
        for (const Row& row : scene.rows)
            low_m = std::min(low_m, row.element().low_m + scene.shiftOf(row).z());
        Level level;
        level.name = "All elements";
        level.elevation_m = scene.rows.empty() ? 0.0 : low_m;
        scene.levels.push_back(level);
    }
    std::stable_sort(scene.levels.begin(), scene.levels.end(),
                     [](const Level& a, const Level& b) { return a.elevation_m < b.elevation_m; });
    for (Level& level : scene.levels)
    {
        if (level.name.empty())
            level.name = "Storey at " + number(level.elevation_m + scene.base.z(), 2) + " m";
    }
}

/// The median top of a level's walls: where pictures of its walls end.
double ceilingOf(const Scene& scene, const Level& level)
{
    std::vector<double> tops;
    for (const std::size_t i : level.rows)
    {
        const Row& row = scene.rows[i];
        if (row.pair.elementClass == ElementClass::Wall)
            tops.push_back(row.element().high_m + scene.shiftOf(row).z());
    }
    constexpr double kUsual_m = 2.5;
    if (tops.empty())
        return level.elevation_m + kUsual_m;
    const auto middle = tops.begin() + static_cast<std::ptrdiff_t>(tops.size() / 2);
    std::nth_element(tops.begin(), middle, tops.end());
    return std::max(*middle, level.elevation_m + 1.0);
}

std::vector<ElementResult> pairsOf(const ReportInput& input)
{
    if (input.truth)
        return input.validation->elements;
    std::vector<ElementResult> pairs;  // one BIM against the points
    for (std::size_t i = 0; i < input.result->elements.size(); ++i)
    {
        ElementResult pair;
        pair.elementClass = input.result->elements[i].elementClass;
        pair.result = static_cast<int>(i);
        pairs.push_back(pair);
    }
    return pairs;
}

template <typename T>
const T* elementAt(const std::vector<T>& elements, int index)
{
    return index >= 0 && static_cast<std::size_t>(index) < elements.size() ? &elements[static_cast<std::size_t>(index)]
                                                                           : nullptr;
}

}  // namespace

const char* verdictName(Verdict verdict)
{
    switch (verdict)
    {
        case Verdict::Within:
            return "within tolerance";
        case Verdict::OutOfTolerance:
            return "out of tolerance";
        case Verdict::NoData:
            return "no data";
    }
    return "";
}

const char* outcomeName(Outcome outcome)
{
    switch (outcome)
    {
        case Outcome::Matched:
            return "matched";
        case Outcome::Missed:
            return "missed";
        case Outcome::NotSeen:
            return "not seen";
        case Outcome::FalsePositive:
            return "false positive";
        case Outcome::Excused:
            return "excused";
    }
    return "";
}

std::string pluralName(ElementClass elementClass)
{
    std::string name = className(elementClass);
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
    return name + "s";
}

std::size_t toleranceIndex(const ValidationParams& params)
{
    return static_cast<std::size_t>(std::clamp(params.tolerance / 10, 1, 5) - 1);
}

LoaBand bandOf(double error_m, const ValidationParams& params)
{
    LoaBand band = LoaBand::Beyond;
    for (std::size_t i = 0; i < params.loaLimit_m.size(); ++i)
    {
        if (error_m <= params.loaLimit_m[i])
            band = static_cast<LoaBand>(static_cast<std::size_t>(LoaBand::Loa10) + i);
    }
    return band;
}

Scene makeScene(const ReportInput& input)
{
    Scene scene;
    scene.base = input.truth ? input.truth->origin : input.result->origin;
    scene.resultShift = input.result->origin - scene.base;
    scene.hasTruth = input.truth != nullptr;
    scene.hasPoints = input.validation->cloudToResult.has_value();
    scene.toleranceLimit_m = input.params->loaLimit_m[toleranceIndex(*input.params)];
    // Twice the tolerance shows what is out of it in full colour, and what is within it in pale ones.
    scene.colorRange_m = std::clamp(2.0 * scene.toleranceLimit_m, kLeastColorRange_m,
                                    std::max(kLeastColorRange_m, input.params->deviationRange_m));

    const auto& toResult = input.validation->cloudToResult;
    const auto& toTruth = input.validation->cloudToTruth;
    for (const ElementResult& pair : pairsOf(input))
    {
        Row row;
        row.pair = pair;
        row.truth = input.truth ? elementAt(input.truth->elements, pair.truth) : nullptr;
        row.result = elementAt(input.result->elements, pair.result);
        if (!row.truth && !row.result)
            continue;
        row.toResult = toResult && row.result ? elementAt(toResult->elements, pair.result) : nullptr;
        row.toTruth = toTruth && row.truth ? elementAt(toTruth->elements, pair.truth) : nullptr;
        judge(row, scene, *input.params);
        row.id = idOf(row, input);
        row.name = cleanText(row.element().name);
        scene.rows.push_back(std::move(row));
    }
    std::stable_sort(scene.rows.begin(), scene.rows.end(),
                     [](const Row& a, const Row& b) { return sortKey(a) < sortKey(b); });

    addLevels(input, scene);
    scene.rowOfResult.assign(input.result->elements.size(), -1);
    for (std::size_t i = 0; i < scene.rows.size(); ++i)
    {
        Row& row = scene.rows[i];
        row.number = static_cast<int>(i) + 1;
        row.level = levelOf(row, scene);
        if (Level* level = row.level >= 0 ? &scene.levels[static_cast<std::size_t>(row.level)] : nullptr)
        {
            level->rows.push_back(i);
            row.storey = level->name;
        }
        if (row.pair.result >= 0)
            scene.rowOfResult[static_cast<std::size_t>(row.pair.result)] = static_cast<int>(i);
    }
    for (Level& level : scene.levels)
        level.ceiling_m = ceilingOf(scene, level);
    return scene;
}

}  // namespace s2b::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/contract.h"

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/segmentation/inputs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace s2b
{
namespace
{

constexpr std::string_view kPrefix = "s2b.";
constexpr std::array<std::string_view, 14> kKeys = {
    "contract", "classes",      "cell_m",     "features",   "mean",      "scale",         "colour",
    "output",   "plan_pixel_m", "plan_low_m", "plan_bin_m", "plan_bins", "plan_channels", "plan_multiple"};

std::vector<std::string_view> splitList(std::string_view text)
{
    std::vector<std::string_view> parts;
    while (true)
    {
        const std::size_t comma = text.find(',');
        std::string_view part = text.substr(0, comma);
        while (!part.empty() && part.front() == ' ')
            part.remove_prefix(1);
        while (!part.empty() && part.back() == ' ')
            part.remove_suffix(1);
        parts.push_back(part);
        if (comma == std::string_view::npos)
            return parts;
        text.remove_prefix(comma + 1);
    }
}

/// The pairs of one model, and how to complain about them.
class Reader
{
public:
    Reader(const std::map<std::string, std::string>& metadata, const std::string& name) : m_name(name)
    {
        for (const auto& [key, value] : metadata)
        {
            if (!std::string_view(key).starts_with(kPrefix))
                continue;
            const std::string_view known = std::string_view(key).substr(kPrefix.size());
            if (std::ranges::find(kKeys, known) == kKeys.end())
                fail("has the metadata key \"" + key + "\", which is not known; the nearest known one is s2b." +
                     std::string(nearestName(known, kKeys)));
            m_values.emplace(known, value);
        }
    }
    [[noreturn]] void fail(const std::string& what) const
    {
        throw Error(ErrorCode::BadFile, m_name + ": the model " + what);
    }
    [[nodiscard]] bool has(std::string_view key) const { return m_values.contains(key); }
    [[nodiscard]] const std::string& text(std::string_view key) const
    {
        const auto found = m_values.find(key);
        if (found == m_values.end())
            fail("lacks the metadata key s2b." + std::string(key) + " (docs/segmentation.md lists them)");
        return found->second;
    }
    [[nodiscard]] double toNumber(std::string_view key, std::string_view text) const
    {
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
            fail("gives s2b." + std::string(key) + " as \"" + std::string(text) + "\", which is no number");
        return value;
    }
    [[nodiscard]] double number(std::string_view key, double low, double high) const
    {
        const double value = toNumber(key, text(key));
        if (value < low || value > high)
            fail("gives s2b." + std::string(key) + " as " + text(key) + ", which is out of range");
        return value;
    }
    [[nodiscard]] int whole(std::string_view key, int low, int high) const
    {
        const double value = number(key, low, high);
        if (value != std::floor(value))
            fail("gives s2b." + std::string(key) + " as " + text(key) + ", which is no whole number");
        return static_cast<int>(value);
    }
    template <typename Value>
    [[nodiscard]] Value choice(std::string_view key,
                               const std::vector<std::pair<std::string_view, Value>>& values) const
    {
        std::vector<std::string_view> names;
        for (const auto& [name, value] : values)
        {
            if (name == text(key))
                return value;
            names.push_back(name);
        }
        fail("gives s2b." + std::string(key) + " as \"" + text(key) + "\", use one of " + joinNames(names));
    }
    /// Names of a list, each a known one.
    [[nodiscard]] std::vector<std::string> names(std::string_view key, std::string_view what,
                                                 std::span<const std::string_view> known) const
    {
        std::vector<std::string> result;
        for (const std::string_view name : splitList(text(key)))
        {
            if (std::ranges::find(known, name) == known.end())
                fail("names the " + std::string(what) + " \"" + std::string(name) +
                     "\", which is not known; the nearest known one is " + std::string(nearestName(name, known)));
            result.emplace_back(name);
        }
        return result;
    }
    [[nodiscard]] std::vector<float> numbers(std::string_view key, std::size_t count) const
    {
        std::vector<float> values;
        for (const std::string_view part : splitList(text(key)))
            values.push_back(static_cast<float>(toNumber(key, part)));
        if (values.size() != count)
            fail("gives " + std::to_string(values.size()) + " values for s2b." + std::string(key) + " and names " +
                 std::to_string(count) + " features");
        return values;
    }

private:
    const std::string& m_name;
    std::map<std::string_view, std::string> m_values;
};

std::vector<std::string_view> namesOf(std::span<const FeatureInfo> infos)
{
    std::vector<std::string_view> names;
    for (const FeatureInfo& info : infos)
        names.push_back(info.name);
    return names;
}

PlanContract readPlan(const Reader& reader)
{
    PlanContract plan;
    if (!reader.has("plan_pixel_m"))
        return plan;
    plan.pixel_m = reader.number("plan_pixel_m", 0.01, 2.0);
    plan.low_m = reader.has("plan_low_m") ? reader.number("plan_low_m", -10.0, 10.0) : 0.0;
    plan.bin_m = reader.number("plan_bin_m", 0.01, 100.0);
    plan.bins = reader.whole("plan_bins", 1, 256);
    plan.channels = reader.names("plan_channels", "plan channel", namesOf(knownPlanChannels()));
    plan.multiple = reader.has("plan_multiple") ? reader.whole("plan_multiple", 1, 1024) : 1;
    return plan;
}

/// Does anything that the contract names need the cloud's colours?
bool needsColour(const ModelContract& contract)
{
    const auto isNamed = [](std::span<const FeatureInfo> infos, const std::vector<std::string>& names)
    {
        return std::ranges::any_of(infos, [&](const FeatureInfo& info)
                                   { return info.needsColour && std::ranges::find(names, info.name) != names.end(); });
    };
    return isNamed(knownFeatures(), contract.features) || isNamed(knownPlanChannels(), contract.plan.channels);
}

}  // namespace

ModelContract parseContract(const std::map<std::string, std::string>& metadata, const std::string& name)
{
    const Reader reader(metadata, name);
    if (!reader.has("contract"))
        reader.fail("has no metadata s2b.contract, so its classes and features are not known (docs/segmentation.md)");
    if (reader.text("contract") != "1")
        reader.fail("follows version " + reader.text("contract") + " of the contract, this program knows version 1");

    ModelContract contract;
    std::vector<std::string_view> classNames;
    for (std::size_t i = 0; i < kLabelCount; ++i)
        classNames.push_back(labelName(static_cast<Label>(i)));
    for (const std::string& className : reader.names("classes", "class", classNames))
        contract.classes.push_back(static_cast<Label>(std::ranges::find(classNames, className) - classNames.begin()));
    if (contract.classes.size() < 2)
        reader.fail("names fewer than two classes");
    contract.cell_m = reader.number("cell_m", 0.005, 0.25);
    if (reader.has("features"))
        contract.features = reader.names("features", "feature", namesOf(knownFeatures()));
    if (reader.has("mean") != reader.has("scale"))
        reader.fail("has only one of s2b.mean and s2b.scale");
    if (reader.has("mean"))
    {
        contract.mean = reader.numbers("mean", contract.features.size());
        contract.scale = reader.numbers("scale", contract.features.size());
        if (std::ranges::find(contract.scale, 0.0f) != contract.scale.end())
            reader.fail("has a zero in s2b.scale");
    }
    contract.plan = readPlan(reader);
    if (contract.features.empty() && !contract.plan.isUsed())
        reader.fail("names neither features (s2b.features) nor a plan (s2b.plan_pixel_m)");
    contract.scores = reader.choice<ScoreKind>(
        "output", {{"logits", ScoreKind::Logits}, {"probabilities", ScoreKind::Probabilities}});
    if (reader.has("colour"))
        contract.colour = reader.choice<ColourUse>(
            "colour",
            {{"none", ColourUse::None}, {"optional", ColourUse::Optional}, {"required", ColourUse::Required}});
    if (contract.colour == ColourUse::None && needsColour(contract))
        reader.fail("uses colours: say s2b.colour = optional or required");
    return contract;
}

}  // namespace s2b

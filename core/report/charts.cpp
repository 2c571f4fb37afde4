// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/charts.h"

#include "core/report/color.h"
#include "core/report/text.h"

#include <algorithm>
#include <array>
#include <format>
#include <numeric>

namespace s2b::report
{
using namespace validation;
namespace
{

struct BandStyle
{
    LoaBand band;
    const char* fill;
};
/// From the best: dark green to orange, grey without data; even in print without colour they go from dark to light.
constexpr std::array<BandStyle, 7> kBands{{{LoaBand::Loa50, "#0b4f4a"},
                                           {LoaBand::Loa40, "#1f7a6c"},
                                           {LoaBand::Loa30, "#5bab8c"},
                                           {LoaBand::Loa20, "#b9d9a8"},
                                           {LoaBand::Loa10, "#f2c879"},
                                           {LoaBand::Beyond, "#d9694a"},
                                           {LoaBand::NoData, "#e3e3e3"}}};

}  // namespace

std::string histogram(const Scene& scene, const CloudDeviation& deviation, const ValidationParams& params)
{
    constexpr double kWidth = 170.0;
    constexpr double kHeight = 52.0;
    constexpr double kLeft = 12.0;
    constexpr double kTop = 5.0;
    const auto& bins = deviation.histogram;
    const std::uint64_t total = std::accumulate(bins.begin(), bins.end(), std::uint64_t{0});
    const std::uint64_t most = *std::max_element(bins.begin(), bins.end());
    if (total == 0)
        return {};
    const double range_m = params.deviationRange_m;
    const auto x = [&](double value_m) { return kLeft + (value_m / range_m + 1.0) / 2.0 * kWidth; };
    std::string svg = std::format(
        "<svg width=\"182mm\" height=\"70mm\" viewBox=\"0 0 186 70\" role=\"img\" "
        "aria-label=\"histogram of signed distances\">\n");
    const double bar = kWidth / static_cast<double>(bins.size());
    for (std::size_t i = 0; i < bins.size(); ++i)
    {
        const double middle_m =
            ((static_cast<double>(i) + 0.5) / static_cast<double>(bins.size()) * 2.0 - 1.0) * range_m;
        const double height = kHeight * static_cast<double>(bins[i]) / static_cast<double>(most);
        svg += std::format(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"#555\" "
            "stroke-width=\"0.12\"><title>{} mm: {} points</title></rect>\n",
            plainNumber(kLeft + bar * static_cast<double>(i), 2), plainNumber(kTop + kHeight - height, 2),
            plainNumber(bar, 2), plainNumber(height, 2), hex(divergingColor(middle_m / scene.colorRange_m)),
            millimetres(middle_m, true), counted(bins[i]));
    }
    svg += std::format("<line x1=\"{0}\" x2=\"{1}\" y1=\"{2}\" y2=\"{2}\" class=\"tick\"/>\n", kLeft, kLeft + kWidth,
                       kTop + kHeight);
    for (int i = -4; i <= 4; ++i)
    {
        const double value_m = range_m * i / 4.0;
        svg += std::format(
            "<line x1=\"{0}\" x2=\"{0}\" y1=\"{1}\" y2=\"{2}\" class=\"tick\"/><text x=\"{0}\" y=\"{3}\" "
            "class=\"axis\" text-anchor=\"middle\">{4}</text>\n",
            plainNumber(x(value_m), 2), kTop + kHeight, kTop + kHeight + 1.4, kTop + kHeight + 4.6,
            roundMillimetres(value_m, true));
    }
    for (const double side : {-1.0, 1.0})
    {
        const std::string place = plainNumber(x(side * scene.toleranceLimit_m), 2);
        svg += std::format("<line x1=\"{0}\" x2=\"{0}\" y1=\"{1}\" y2=\"{2}\" class=\"limit\"/>\n", place, kTop - 1.0,
                           kTop + kHeight);
    }
    svg += std::format("<text x=\"{}\" y=\"{}\" class=\"axis\">LOA{}: ±{} mm</text>\n",
                       plainNumber(x(scene.toleranceLimit_m) + 1.2, 2), kTop + 2.0, params.tolerance,
                       roundMillimetres(scene.toleranceLimit_m));
    svg += std::format(
        "<text x=\"{}\" y=\"{}\" class=\"axis\" text-anchor=\"middle\">signed distance from the nearest element "
        "[mm], positive outside</text>\n",
        kLeft + kWidth / 2.0, kTop + kHeight + 9.4);
    svg += std::format(
        "<text transform=\"translate(6 {}) rotate(-90)\" class=\"axis\" text-anchor=\"middle\">share of points"
        "</text><text x=\"{}\" y=\"{}\" class=\"axis\" text-anchor=\"end\">{} %</text>\n",
        kTop + kHeight / 2.0, kLeft - 1.0, kTop + 1.5,
        number(100.0 * static_cast<double>(most) / static_cast<double>(total), 1));
    return svg + "</svg>\n";
}

std::string bandBar(const std::map<LoaBand, int>& counts)
{
    constexpr double kWidth = 60.0;
    int total = 0;
    for (const auto& [band, count] : counts)
        total += count;
    if (total == 0)
        return {};
    std::string svg =
        "<svg class=\"bands\" width=\"60mm\" height=\"4mm\" viewBox=\"0 0 60 4\" role=\"img\" "
        "aria-label=\"shares of the accuracy bands\">";
    double x = 0.0;
    for (const BandStyle& style : kBands)
    {
        const auto found = counts.find(style.band);
        if (found == counts.end() || found->second == 0)
            continue;
        const double width = kWidth * found->second / total;
        const bool isDark = style.band >= LoaBand::Loa30 || style.band == LoaBand::Beyond;
        svg += std::format("<rect x=\"{}\" y=\"0\" width=\"{}\" height=\"4\" fill=\"{}\"><title>{}: {}</title></rect>",
                           plainNumber(x, 2), plainNumber(width, 2), style.fill, loaName(style.band), found->second);
        if (width > 4.0)
            svg +=
                std::format("<text x=\"{}\" y=\"2.9\" class=\"bandtext\" fill=\"{}\" text-anchor=\"middle\">{}</text>",
                            plainNumber(x + width / 2.0, 2), isDark ? "#fff" : "#222", found->second);
        x += width;
    }
    return svg + "</svg>";
}

std::string bandLegend(const ValidationParams& params)
{
    std::string legend = "<ul class=\"legend\">";
    for (const BandStyle& style : kBands)
    {
        std::string meaning = loaName(style.band);
        if (style.band >= LoaBand::Loa10)
        {
            const auto index = static_cast<std::size_t>(style.band) - static_cast<std::size_t>(LoaBand::Loa10);
            meaning += " (to " + roundMillimetres(params.loaLimit_m[index]) + " mm)";
        }
        legend += std::format(
            "<li><svg width=\"6mm\" height=\"3.5mm\" viewBox=\"0 0 6 3.5\" aria-hidden=\"true\"><rect "
            "width=\"6\" height=\"3.5\" fill=\"{}\"/></svg>{}</li>\n",
            style.fill, meaning);
    }
    return legend + "</ul>\n";
}

}  // namespace s2b::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/svg_sheet.h"

#include "core/report/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <format>

namespace s2b::report
{
namespace
{

constexpr std::array<int, 12> kScales{10, 20, 25, 50, 75, 100, 150, 200, 250, 500, 1000, 2000};

std::string mm(double value)
{
    return plainNumber(value, 2);
}

/// 1, 2 or 5 times a power of ten, at least `least`.
double roundStep(double least)
{
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
    {
        if (factor * power >= least * (1.0 - 1e-9))
            return factor * power;
    }
    return 10.0 * power;
}

}  // namespace

Sheet::Sheet(const Eigen::AlignedBox2d& box, double width_mm, double height_mm, double margin_mm)
    : m_box(box), m_margin_mm(margin_mm)
{
    const auto fits = [&](double scale)
    {
        return 1000.0 * box.sizes().x() / scale <= width_mm - 2.0 * margin_mm &&
               1000.0 * box.sizes().y() / scale <= height_mm - 2.0 * margin_mm;
    };
    const auto round = std::find_if(kScales.begin(), kScales.end(), fits);
    m_scale = round == kScales.end() ? kScales.back() : *round;
    while (!fits(m_scale) && m_scale < 1'000'000)
        m_scale *= 2;
    m_width_mm = length(box.sizes().x());
    m_height_mm = length(box.sizes().y());
}

Eigen::Vector2d Sheet::place(const Eigen::Vector2d& p) const
{
    return {m_margin_mm + length(p.x() - m_box.min().x()), m_margin_mm + length(m_box.max().y() - p.y())};
}

void Sheet::outlines(const std::vector<Polygon>& outlines, std::string_view attributes, std::string_view title)
{
    std::string path;
    const auto ring = [&](const std::vector<Eigen::Vector2d>& points)
    {
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const Eigen::Vector2d p = place(points[i]);
            path += (i == 0 ? "M" : "L") + mm(p.x()) + " " + mm(p.y());
        }
        if (!points.empty())
            path += "Z";
    };
    for (const Polygon& outline : outlines)
    {
        ring(outline.outer);
        for (const auto& hole : outline.holes)
            ring(hole);
    }
    if (path.empty())
        return;
    m_body += std::format("<path d=\"{}\" fill-rule=\"evenodd\" {}", path, attributes);
    m_body += title.empty() ? "/>\n" : std::format("><title>{}</title></path>\n", escapeXml(title));
}

void Sheet::line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::string_view attributes)
{
    m_body += std::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", mm(a.x()), mm(a.y()), mm(b.x()),
                          mm(b.y()), attributes);
}

void Sheet::text(const Eigen::Vector2d& at_mm, std::string_view text, std::string_view attributes)
{
    m_body += std::format("<text x=\"{}\" y=\"{}\" {}>{}</text>\n", mm(at_mm.x()), mm(at_mm.y()), attributes,
                          escapeXml(text));
}

void Sheet::image(const Raster& raster, const Image& image, std::string_view label)
{
    if (raster.isEmpty())
        return;
    const Eigen::Vector2d corner = place({raster.box().min().x(), raster.box().max().y()});
    m_body += std::format(
        "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" aria-label=\"{}\" "
        "href=\"{}\"/>\n",
        mm(corner.x()), mm(corner.y()), mm(length(raster.width * raster.cell_m)),
        mm(length(raster.height * raster.cell_m)), escapeXml(label), dataUri(image));
}

void Sheet::beginClip()
{
    m_body += std::format("<svg x=\"{0}\" y=\"{0}\" width=\"{1}\" height=\"{2}\" viewBox=\"{0} {0} {1} {2}\">\n",
                          mm(m_margin_mm), mm(m_width_mm), mm(m_height_mm));
}

void Sheet::frame(const Eigen::Vector2d& world)
{
    constexpr double kTick_mm = 25.0;  // wide enough for "32 500 100"
    const double step_m = roundStep(kTick_mm * m_scale / 1000.0);
    const auto coordinate = [](double value)
    { return value < 0 ? number(value, 0) : counted(static_cast<std::uint64_t>(std::llround(value))); };
    m_body += std::format("<rect x=\"{0}\" y=\"{0}\" width=\"{1}\" height=\"{2}\" class=\"frame\"/>\n", mm(m_margin_mm),
                          mm(m_width_mm), mm(m_height_mm));
    const Eigen::Vector2d low = m_box.min() + world;
    const Eigen::Vector2d high = m_box.max() + world;
    for (double e = std::ceil(low.x() / step_m) * step_m; e <= high.x(); e += step_m)
    {
        const double x = m_margin_mm + length(e - low.x());
        line({x, m_margin_mm + m_height_mm}, {x, m_margin_mm + m_height_mm + 1.5}, "class=\"tick\"");
        text({x, m_margin_mm + m_height_mm + 4.3}, coordinate(e), "class=\"axis\" text-anchor=\"middle\"");
    }
    for (double n = std::ceil(low.y() / step_m) * step_m; n <= high.y(); n += step_m)
    {
        const double y = m_margin_mm + length(high.y() - n);
        line({m_margin_mm - 1.5, y}, {m_margin_mm, y}, "class=\"tick\"");
        m_body += std::format(
            "<text transform=\"translate({} {}) rotate(-90)\" class=\"axis\" text-anchor=\"middle\">{}</text>\n",
            mm(m_margin_mm - 2.3), mm(y), escapeXml(coordinate(n)));
    }
    for (double e = std::ceil(low.x() / step_m) * step_m; e <= high.x(); e += step_m)
    {
        for (double n = std::ceil(low.y() / step_m) * step_m; n <= high.y(); n += step_m)
        {
            const Eigen::Vector2d p(m_margin_mm + length(e - low.x()), m_margin_mm + length(high.y() - n));
            line(p - Eigen::Vector2d(1.2, 0), p + Eigen::Vector2d(1.2, 0), "class=\"cross\"");
            line(p - Eigen::Vector2d(0, 1.2), p + Eigen::Vector2d(0, 1.2), "class=\"cross\"");
        }
    }
    const double x = m_margin_mm + m_width_mm - 4.0;
    const double y = m_margin_mm + 3.0;
    m_body += std::format("<path d=\"M{0} {1}l2 6l-2 -1.3l-2 1.3z\" class=\"north\"/>\n", mm(x), mm(y));
    text({x, y + 9.0}, "N", "class=\"axis\" text-anchor=\"middle\"");
}

void Sheet::scaleBar()
{
    constexpr double kLeast_mm = 22.0;
    constexpr double kShare = 0.4;  // of the width: the next round length is at most 2.5 times as long
    const double bar_m = roundStep(std::min(kLeast_mm, kShare * m_width_mm) * m_scale / 1000.0);
    const double bar_mm = length(bar_m);
    const double x = m_margin_mm + m_width_mm - bar_mm;
    const double y = m_margin_mm - 2.2;
    for (int i = 0; i < 4; ++i)
        m_body += std::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"1.2\" class=\"bar{}\"/>\n",
                              mm(x + i * bar_mm / 4.0), mm(y), mm(bar_mm / 4.0), i % 2);
    text({x - 1.2, y + 1.3}, "0", "class=\"axis\" text-anchor=\"end\"");
    text({x + bar_mm, y - 0.9}, plainNumber(bar_m, 2) + " m", "class=\"axis\" text-anchor=\"end\"");
}

std::string Sheet::svg(std::string_view label) const
{
    const double width_mm = m_width_mm + 2.0 * m_margin_mm;
    const double height_mm = m_height_mm + 2.0 * m_margin_mm;
    return std::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{0}\" width=\"{1}mm\" height=\"{2}mm\" "
        "viewBox=\"0 0 {1} {2}\">\n{3}</svg>\n",
        escapeXml(label), mm(width_mm), mm(height_mm), m_body);
}

}  // namespace s2b::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace s2b::report
{
namespace
{

constexpr int kFine = 2;  ///< drawn so many times as large

/// Columns from the left, the lowest bit on top.
const std::map<char, std::array<std::uint8_t, 5>>& glyphs()
{
    static const std::map<char, std::array<std::uint8_t, 5>> kGlyphs{
        {'0', {0x3E, 0x51, 0x49, 0x45, 0x3E}}, {'1', {0x00, 0x42, 0x7F, 0x40, 0x00}},
        {'2', {0x42, 0x61, 0x51, 0x49, 0x46}}, {'3', {0x21, 0x41, 0x45, 0x4B, 0x31}},
        {'4', {0x18, 0x14, 0x12, 0x7F, 0x10}}, {'5', {0x27, 0x45, 0x45, 0x45, 0x39}},
        {'6', {0x3C, 0x4A, 0x49, 0x49, 0x30}}, {'7', {0x01, 0x71, 0x09, 0x05, 0x03}},
        {'8', {0x36, 0x49, 0x49, 0x49, 0x36}}, {'9', {0x06, 0x49, 0x49, 0x29, 0x1E}},
        {'A', {0x7E, 0x11, 0x11, 0x11, 0x7E}}, {'B', {0x7F, 0x49, 0x49, 0x49, 0x36}},
        {'C', {0x3E, 0x41, 0x41, 0x41, 0x22}}, {'D', {0x7F, 0x41, 0x41, 0x22, 0x1C}},
        {'E', {0x7F, 0x49, 0x49, 0x49, 0x41}}, {'F', {0x7F, 0x09, 0x09, 0x09, 0x01}},
        {'G', {0x3E, 0x41, 0x49, 0x49, 0x7A}}, {'H', {0x7F, 0x08, 0x08, 0x08, 0x7F}},
        {'I', {0x00, 0x41, 0x7F, 0x41, 0x00}}, {'J', {0x20, 0x40, 0x41, 0x3F, 0x01}},
        {'K', {0x7F, 0x08, 0x14, 0x22, 0x41}}, {'L', {0x7F, 0x40, 0x40, 0x40, 0x40}},
        {'M', {0x7F, 0x02, 0x0C, 0x02, 0x7F}}, {'N', {0x7F, 0x04, 0x08, 0x10, 0x7F}},
        {'O', {0x3E, 0x41, 0x41, 0x41, 0x3E}}, {'P', {0x7F, 0x09, 0x09, 0x09, 0x06}},
        {'Q', {0x3E, 0x41, 0x51, 0x21, 0x5E}}, {'R', {0x7F, 0x09, 0x19, 0x29, 0x46}},
        {'S', {0x46, 0x49, 0x49, 0x49, 0x31}}, {'T', {0x01, 0x01, 0x7F, 0x01, 0x01}},
        {'U', {0x3F, 0x40, 0x40, 0x40, 0x3F}}, {'V', {0x1F, 0x20, 0x40, 0x20, 0x1F}},
        {'W', {0x3F, 0x40, 0x38, 0x40, 0x3F}}, {'X', {0x63, 0x14, 0x08, 0x14, 0x63}},
        {'Y', {0x07, 0x08, 0x70, 0x08, 0x07}}, {'Z', {0x61, 0x51, 0x49, 0x45, 0x43}},
        {'+', {0x08, 0x08, 0x3E, 0x08, 0x08}}, {'-', {0x08, 0x08, 0x08, 0x08, 0x08}},
        {'.', {0x00, 0x60, 0x60, 0x00, 0x00}}, {':', {0x00, 0x36, 0x36, 0x00, 0x00}},
        {'%', {0x23, 0x13, 0x08, 0x64, 0x62}}, {'/', {0x20, 0x10, 0x08, 0x04, 0x02}}};
    return kGlyphs;
}

Eigen::AlignedBox2i fine(const Eigen::AlignedBox2i& pixels)
{
    return {Eigen::Vector2i(pixels.min() * kFine), Eigen::Vector2i(pixels.max() * kFine)};
}

}  // namespace

Viewport Viewport::fit(const Eigen::AlignedBox2i& pixels, const Eigen::AlignedBox2d& box)
{
    Viewport view;
    view.pixels = pixels;
    view.center = box.center();
    const Eigen::Vector2d size = box.sizes().cwiseMax(0.01);
    view.pixelsPerMetre = std::min(static_cast<double>(pixels.sizes().x()) / size.x(),
                                   static_cast<double>(pixels.sizes().y()) / size.y());
    return view;
}

Eigen::Vector2d Viewport::toPixels(const Eigen::Vector2d& p) const
{
    const Eigen::Vector2d middle = (pixels.min() + pixels.max()).cast<double>() / 2.0;
    const Eigen::Vector2d d = (p - center) * pixelsPerMetre;
    return {middle.x() + d.x(), middle.y() - d.y()};
}

Eigen::Vector2d Viewport::toMetres(const Eigen::Vector2d& p) const
{
    const Eigen::Vector2d middle = (pixels.min() + pixels.max()).cast<double>() / 2.0;
    const Eigen::Vector2d d = (p - middle) / pixelsPerMetre;
    return {center.x() + d.x(), center.y() - d.y()};
}

Canvas::Canvas(int width, int height, Color background) : m_image(width * kFine, height * kFine, background) {}

void Canvas::put(int x, int y, Color color)
{
    if (x < 0 || y < 0 || x >= m_image.width || y >= m_image.height || color.a == 0)
        return;
    Color& under = m_image.at(x, y);
    if (color.a == 255)
    {
        under = color;
        return;
    }
    const auto mix = [&](std::uint8_t over, std::uint8_t below)
    { return static_cast<std::uint8_t>((over * color.a + below * (255 - color.a) + 127) / 255); };
    under = {mix(color.r, under.r), mix(color.g, under.g), mix(color.b, under.b), 255};
}

void Canvas::fill(const Eigen::AlignedBox2i& pixels, Color color)
{
    const Eigen::AlignedBox2i box = fine(pixels);
    for (int y = box.min().y(); y < box.max().y(); ++y)
    {
        for (int x = box.min().x(); x < box.max().x(); ++x)
            put(x, y, color);
    }
}

// Even-odd, at the middle of each row.
void Canvas::polygonPixels(const std::vector<std::vector<Eigen::Vector2d>>& rings, const Eigen::AlignedBox2i& within,
                           Color color)
{
    const Eigen::AlignedBox2i box = fine(within);
    std::vector<double> crossings;
    for (int y = box.min().y(); y < box.max().y(); ++y)
    {
        crossings.clear();
        const double middle = y + 0.5;
        for (const auto& ring : rings)
        {
            for (std::size_t i = 0; i < ring.size(); ++i)
            {
                const Eigen::Vector2d a = ring[i] * kFine;
                const Eigen::Vector2d b = ring[(i + 1) % ring.size()] * kFine;
                if ((a.y() <= middle) != (b.y() <= middle))
                    crossings.push_back(a.x() + (middle - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
            }
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        {
            const double from = std::max(std::ceil(crossings[i] - 0.5), static_cast<double>(box.min().x()));
            const double to = std::min(std::ceil(crossings[i + 1] - 0.5), static_cast<double>(box.max().x()));
            for (int x = static_cast<int>(from); x < static_cast<int>(to); ++x)
                put(x, y, color);
        }
    }
}

void Canvas::polygon(const Viewport& view, const Polygon& polygon, Color fill)
{
    std::vector<std::vector<Eigen::Vector2d>> rings;
    const auto add = [&](const std::vector<Eigen::Vector2d>& ring)
    {
        auto& pixels = rings.emplace_back();
        for (const Eigen::Vector2d& p : ring)
            pixels.push_back(view.toPixels(p));
    };
    add(polygon.outer);
    for (const auto& hole : polygon.holes)
        add(hole);
    polygonPixels(rings, view.pixels, fill);
}

void Canvas::segment(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::AlignedBox2i& within, Color color,
                     double width_px)
{
    const Eigen::Vector2d d = b - a;
    if (d.norm() <= 0.0)
        return;
    const Eigen::Vector2d along = d.normalized() * width_px / 2.0;
    const Eigen::Vector2d side(-along.y(), along.x());
    polygonPixels({{a - along + side, a - along - side, b + along - side, b + along + side}}, within, color);
}

void Canvas::line(const Viewport& view, const Eigen::Vector2d& a, const Eigen::Vector2d& b, Color color,
                  double width_px, double dash_px)
{
    const Eigen::Vector2d p = view.toPixels(a);
    const Eigen::Vector2d q = view.toPixels(b);
    const double length = (q - p).norm();
    constexpr double kLongest_px = 20000.0;  // of an element that reaches far out of the picture
    if (dash_px <= 0.0 || length > kLongest_px)
        return segment(p, q, view.pixels, color, width_px);
    for (double s = 0.0; s < length; s += 2.0 * dash_px)
        segment(p + (q - p) * (s / length), p + (q - p) * (std::min(s + dash_px, length) / length), view.pixels, color,
                width_px);
}

void Canvas::outline(const Viewport& view, const Polygon& polygon, Color color, double width_px, double dash_px)
{
    const auto ring = [&](const std::vector<Eigen::Vector2d>& points)
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            line(view, points[i], points[(i + 1) % points.size()], color, width_px, dash_px);
    };
    ring(polygon.outer);
    for (const auto& hole : polygon.holes)
        ring(hole);
}

void Canvas::raster(const Viewport& view, const Raster& raster, const Image& image)
{
    if (raster.isEmpty())
        return;
    // Both grids are upright: which column a pixel sees depends on its x alone, and so does the row on its y.
    const Eigen::AlignedBox2i box = fine(view.pixels);
    const auto cellOf = [&](int pixel, int axis)
    {
        const Eigen::Vector2d p = view.toMetres(Eigen::Vector2d::Constant((pixel + 0.5) / kFine));
        const double cell = std::floor((p[axis] - raster.low[axis]) / raster.cell_m);
        return cell >= 0.0 && cell < (axis == 0 ? raster.width : raster.height) ? static_cast<int>(cell) : -1;
    };
    std::vector<int> columns;
    for (int x = box.min().x(); x < box.max().x(); ++x)
        columns.push_back(cellOf(x, 0));
    for (int y = box.min().y(); y < box.max().y(); ++y)
    {
        const int row = cellOf(y, 1);
        if (row < 0)
            continue;
        const Color* cells = &image.at(0, raster.height - 1 - row);
        for (std::size_t i = 0; i < columns.size(); ++i)
        {
            if (columns[i] >= 0 && cells[columns[i]].a != 0)
                put(box.min().x() + static_cast<int>(i), y, cells[columns[i]]);
        }
    }
}

int Canvas::textWidth(std::string_view text, int size)
{
    return static_cast<int>(text.size()) * 6 * size - size;
}

void Canvas::text(const Eigen::Vector2i& at, std::string_view text, Color color, int size)
{
    int left = at.x();
    for (const char c : text)
    {
        const char capital = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        if (const auto glyph = glyphs().find(capital); glyph != glyphs().end())
        {
            for (int column = 0; column < 5; ++column)
            {
                for (int row = 0; row < 7; ++row)
                {
                    if (!(glyph->second[static_cast<std::size_t>(column)] >> row & 1))
                        continue;
                    const Eigen::Vector2i low(left + column * size, at.y() + row * size);
                    fill({low, Eigen::Vector2i(low.array() + size)}, color);
                }
            }
        }
        left += 6 * size;
    }
}

Image Canvas::image() const
{
    Image small(m_image.width / kFine, m_image.height / kFine, Color{});
    for (int y = 0; y < small.height; ++y)
    {
        for (int x = 0; x < small.width; ++x)
        {
            std::array<int, 3> sum{};
            for (int k = 0; k < kFine * kFine; ++k)
            {
                const Color& c = m_image.at(x * kFine + k % kFine, y * kFine + k / kFine);
                sum = {sum[0] + c.r, sum[1] + c.g, sum[2] + c.b};
            }
            const auto mean = [](int s)
            { return static_cast<std::uint8_t>((s + kFine * kFine / 2) / (kFine * kFine)); };
            small.at(x, y) = {mean(sum[0]), mean(sum[1]), mean(sum[2]), 255};
        }
    }
    return small;
}

}  // namespace s2b::report

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/png.h"
#include "core/report/rasters.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <string_view>

namespace s2b::report
{

/// A window of a canvas: which box of metres is seen in which pixels. x to the right, y up, the same scale for both.
struct Viewport
{
    Eigen::AlignedBox2i pixels;
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double pixelsPerMetre = 1.0;

    /// The largest scale at which the box fits.
    static Viewport fit(const Eigen::AlignedBox2i& pixels, const Eigen::AlignedBox2d& box);
    [[nodiscard]] Eigen::Vector2d toPixels(const Eigen::Vector2d& p) const;
    [[nodiscard]] Eigen::Vector2d toMetres(const Eigen::Vector2d& p) const;
};

/// Pictures without a window system: drawn at twice the size and averaged, so that edges are smooth.
class Canvas
{
public:
    Canvas(int width, int height, Color background);

    void fill(const Eigen::AlignedBox2i& pixels, Color color);
    /// Everything below takes metres and stays within the viewport.
    void polygon(const Viewport& view, const Polygon& polygon, Color fill);
    void outline(const Viewport& view, const Polygon& polygon, Color color, double width_px, double dash_px = 0.0);
    void line(const Viewport& view, const Eigen::Vector2d& a, const Eigen::Vector2d& b, Color color, double width_px,
              double dash_px = 0.0);
    /// Cells of an image made from a raster; none is drawn smaller than a pixel.
    void raster(const Viewport& view, const Raster& raster, const Image& image);
    /// Capitals, digits and a few signs in a 5 x 7 dot font; `at` is the upper left corner in pixels.
    void text(const Eigen::Vector2i& at, std::string_view text, Color color, int size = 2);
    [[nodiscard]] static int textWidth(std::string_view text, int size = 2);

    [[nodiscard]] Image image() const;

private:
    void put(int x, int y, Color color);
    void polygonPixels(const std::vector<std::vector<Eigen::Vector2d>>& rings, const Eigen::AlignedBox2i& within,
                       Color color);
    void segment(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::AlignedBox2i& within, Color color,
                 double width_px);

    Image m_image;  ///< at twice the size
};

}  // namespace s2b::report

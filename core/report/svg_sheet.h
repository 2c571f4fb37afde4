// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/png.h"
#include "core/report/rasters.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <string>
#include <string_view>

namespace s2b::report
{

/// A drawing at a round scale on paper: everything it is given is in metres, everything it writes in millimetres of
/// paper.
class Sheet
{
public:
    /// The largest round scale at which the box fits a paper of that size [mm], which leaves room for margins.
    Sheet(const Eigen::AlignedBox2d& box, double width_mm, double height_mm, double margin_mm);

    [[nodiscard]] int scale() const { return m_scale; }
    [[nodiscard]] Eigen::Vector2d place(const Eigen::Vector2d& p) const;
    [[nodiscard]] double length(double length_m) const { return 1000.0 * length_m / m_scale; }

    /// Outlines as one path; `attributes` are SVG's.
    void outlines(const std::vector<Polygon>& outlines, std::string_view attributes, std::string_view title = {});
    void line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::string_view attributes);
    void text(const Eigen::Vector2d& at_mm, std::string_view text, std::string_view attributes);
    void image(const Raster& raster, const Image& image, std::string_view label);
    void markup(std::string_view svg) { m_body += svg; }
    /// What is drawn between these two ends at the frame.
    void beginClip();
    void endClip() { m_body += "</svg>\n"; }

    /// Frame, ticks with world coordinates (east along the lower edge, north along the left one), north arrow, scale
    /// bar.
    void frame(const Eigen::Vector2d& world);
    void scaleBar();

    [[nodiscard]] std::string svg(std::string_view label) const;

private:
    Eigen::AlignedBox2d m_box;
    double m_margin_mm = 0.0;
    int m_scale = 100;
    double m_width_mm = 0.0;  ///< of the drawing without margins
    double m_height_mm = 0.0;
    std::string m_body;
};

}  // namespace s2b::report

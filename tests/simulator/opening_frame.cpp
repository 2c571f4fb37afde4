// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/opening_frame.h"

#include "tests/simulator/axis_curve.h"

#include <cmath>

namespace s2b::sim
{

OpeningFrame::OpeningFrame(Scene& scene, const Wall& wall, const Opening& opening, const Surface& surface)
    : m_scene(scene), m_surface(surface)
{
    const AxisCurve curve(wall);
    const double middle = opening.offset_m + opening.width.value_m / 2.0;
    m_u = curve.direction(middle);
    m_n = curve.normal(middle);
    m_origin = curve.at(middle) - m_u * (opening.width.value_m / 2.0);
    m_z = wall.base_m + opening.sill.value_m;
}

Eigen::Vector3d OpeningFrame::at(double x, double y, double z) const
{
    const Eigen::Vector2d p = m_origin + m_u * x + m_n * y;
    return {p.x(), p.y(), m_z + z};
}

void OpeningFrame::box(double x0, double x1, double y0, double y1, double z0, double z1) const
{
    m_scene.addBox({at((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2),
                    {(x1 - x0) / 2, (y1 - y0) / 2, (z1 - z0) / 2},
                    std::atan2(m_u.y(), m_u.x())},
                   m_surface);
}

void OpeningFrame::board(double x, double y, const Eigen::Vector2d& direction, double from, double to,
                         double halfThickness, double z0, double z1, Material material) const
{
    const Eigen::Vector2d d = m_u * direction.x() + m_n * direction.y();
    const double middle = (from + to) / 2.0;
    Surface surface = m_surface;
    surface.material = material;
    m_scene.addBox({at(x + direction.x() * middle, y + direction.y() * middle, (z0 + z1) / 2.0),
                    {(to - from) / 2.0, halfThickness, (z1 - z0) / 2.0},
                    std::atan2(d.y(), d.x())},
                   surface);
}

void OpeningFrame::leaf(double x, double y, const Eigen::Vector2d& direction, double width, double z0, double z1) const
{
    board(x, y, direction, 0.0, width, kLeaf_m / 2.0, z0, z1);
    board(x, y, direction, width - 0.18, width - 0.06, 0.055, 1.04, 1.06);  // the handle, on both faces
}

void OpeningFrame::pane(double x0, double x1, double y, double z0, double z1) const
{
    Surface surface = m_surface;
    surface.material = Material::Glass;
    m_scene.addQuad(at(x0, y, z0), at(x1, y, z0), at(x1, y, z1), at(x0, y, z1), surface);
}

}  // namespace s2b::sim

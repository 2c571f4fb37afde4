// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/simulator/scene.h"

namespace s2b::sim
{

/// Boxes in the frame of an opening: x along the wall from its lower-left corner, y to the left, z up from its sill.
class OpeningFrame
{
public:
    static constexpr double kLeaf_m = 0.04;  ///< thickness of a door leaf

    OpeningFrame(Scene& scene, const Wall& wall, const Opening& opening, const Surface& surface);

    [[nodiscard]] Eigen::Vector3d at(double x, double y, double z) const;
    /// From (x0, y0, z0) to (x1, y1, z1).
    void box(double x0, double x1, double y0, double y1, double z0, double z1) const;
    /// A box of any direction in plan: from (x, y) along `direction`, thickness to both sides.
    void board(double x, double y, const Eigen::Vector2d& direction, double from, double to, double halfThickness,
               double z0, double z1, Material material = Material::Opaque) const;
    /// A leaf with its handles, from its hinge: direction in the opening's x, y.
    void leaf(double x, double y, const Eigen::Vector2d& direction, double width, double z0, double z1) const;
    /// An upright pane at y.
    void pane(double x0, double x1, double y, double z0, double z1) const;

private:
    Scene& m_scene;
    Surface m_surface;
    Eigen::Vector2d m_origin, m_u, m_n;
    double m_z = 0.0;
};

}  // namespace s2b::sim

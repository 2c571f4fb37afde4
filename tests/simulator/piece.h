// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/simulator/building_spec.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace s2b::sim
{

using Colour = std::array<std::uint8_t, 3>;

/// What furniture is painted in.
inline const std::vector<Colour>& pieceColours()
{
    static const std::vector<Colour> kColours{{120, 85, 60},   {200, 195, 190}, {70, 80, 95},
                                              {160, 140, 110}, {60, 100, 120},  {175, 60, 50}};
    return kColours;
}

/// Boxes given in a piece's own frame: x along its width, y away from the wall, z up; origin on the floor in its
/// middle.
class Piece
{
public:
    Piece(std::string kind, const Eigen::Vector2d& at, double floor_m, double yaw_rad, int storey, const Colour& colour)
        : m_at(at.x(), at.y(), floor_m), m_yaw(yaw_rad)
    {
        m_prop.kind = std::move(kind);
        m_prop.storey = storey;
        m_prop.colour = colour;
    }
    void box(double x, double y, double z, double halfX, double halfY, double halfZ)
    {
        const double c = std::cos(m_yaw);
        const double s = std::sin(m_yaw);
        m_prop.boxes.push_back({m_at + Eigen::Vector3d(c * x - s * y, s * x + c * y, z), {halfX, halfY, halfZ}, m_yaw});
    }
    Prop take() { return std::move(m_prop); }

private:
    Eigen::Vector3d m_at;
    double m_yaw;
    Prop m_prop;
};

}  // namespace s2b::sim

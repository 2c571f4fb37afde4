// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/simulator/scanner.h"

#include <cstdint>
#include <vector>

namespace s2b::sim
{

/// How much of each element's surface a survey saw. A piece of surface of 10 cm counts as seen when a point lies on it.
class SeenSurface
{
public:
    SeenSurface(const Scene& scene, const Survey& survey);

    struct Share
    {
        double area_m2 = 0.0;
        double all = 0.0;    ///< [0, 1] of the whole surface, hidden faces included
        double left = -1.0;  ///< [0, 1] of the faces whose normal is `left`; -1 when there is none
        double right = -1.0;
    };
    /// @param left  unit vector in plan: the side of a wall.
    [[nodiscard]] Share share(std::uint32_t element, const Eigen::Vector2d& left) const;
    /// Indices of the survey's points on an element, ascending.
    [[nodiscard]] const std::vector<std::uint32_t>& points(std::uint32_t element) const { return m_points[element]; }
    [[nodiscard]] const std::vector<std::uint32_t>& triangles(std::uint32_t element) const
    {
        return m_triangles[element];
    }

private:
    [[nodiscard]] static std::uint64_t key(const Eigen::Vector3d& point, std::uint32_t element,
                                           const Eigen::Vector3d& normal);

    const Scene& m_scene;
    std::vector<std::vector<std::uint32_t>> m_points;
    std::vector<std::vector<std::uint32_t>> m_triangles;
    std::vector<std::uint64_t> m_seen;  ///< sorted
};

}  // namespace s2b::sim

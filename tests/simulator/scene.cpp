// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/scene.h"

#include <cmath>

namespace s2b::sim
{

std::uint32_t Scene::addElement(SceneElement element)
{
    elements.push_back(std::move(element));
    return static_cast<std::uint32_t>(elements.size() - 1);
}

void Scene::addTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                        const Surface& surface)
{
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), {a, b, c});
    triangles.push_back({first, first + 1, first + 2});
    surfaces.push_back(surface);
}

void Scene::addQuad(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                    const Eigen::Vector3d& d, const Surface& surface)
{
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), {a, b, c, d});
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 2, first + 3});
    surfaces.insert(surfaces.end(), 2, surface);
}

void Scene::addBox(const PropBox& box, const Surface& surface)
{
    const double c = std::cos(box.yaw_rad);
    const double s = std::sin(box.yaw_rad);
    const auto corner = [&](int x, int y, int z)
    {
        const double dx = (x != 0 ? 1.0 : -1.0) * box.half.x();
        const double dy = (y != 0 ? 1.0 : -1.0) * box.half.y();
        return Eigen::Vector3d(box.center.x() + c * dx - s * dy, box.center.y() + s * dx + c * dy,
                               box.center.z() + (z != 0 ? 1.0 : -1.0) * box.half.z());
    };
    addQuad(corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0), surface);
    addQuad(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1), surface);
    addQuad(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1), surface);
    addQuad(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1), surface);
    addQuad(corner(1, 1, 0), corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), surface);
    addQuad(corner(0, 1, 0), corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), surface);
}

Eigen::Vector3d Scene::normal(std::size_t triangle) const
{
    const auto& t = triangles[triangle];
    const Eigen::Vector3d n = (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]);
    const double length = n.norm();
    return length > 0.0 ? Eigen::Vector3d(n / length) : Eigen::Vector3d::Zero();
}

std::array<std::uint8_t, 3> labelColour(Label label)
{
    static constexpr std::array<std::array<std::uint8_t, 3>, kLabelCount> kColours{{{112, 126, 92},
                                                                                    {152, 124, 96},
                                                                                    {240, 240, 238},
                                                                                    {226, 222, 214},
                                                                                    {188, 188, 186},
                                                                                    {142, 98, 62},
                                                                                    {228, 230, 232},
                                                                                    {168, 150, 122},
                                                                                    {132, 132, 136},
                                                                                    {150, 84, 64},
                                                                                    {120, 105, 140}}};
    return kColours[static_cast<std::size_t>(label)];
}

}  // namespace s2b::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/seen_surface.h"

#include "tests/simulator/random.h"

#include <algorithm>
#include <cmath>

namespace s2b::sim
{

namespace
{

constexpr double kPiece_m = 0.10;
constexpr double kSamplesPerSquareMetre = 250.0;
constexpr double kFacing = 0.9;  ///< cosine

}  // namespace

std::uint64_t SeenSurface::key(const Eigen::Vector3d& point, std::uint32_t element, const Eigen::Vector3d& normal)
{
    // Shifted, so that axis-parallel faces at round coordinates don't lie on the border of two pieces.
    const Eigen::Vector3d q = ((point + Eigen::Vector3d(0.0137, 0.0171, 0.0093)) / kPiece_m).array().floor();
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    std::uint64_t result = element;
    result = result << 3U | static_cast<std::uint64_t>(2 * axis + (normal[axis] < 0.0 ? 1 : 0));
    for (int i = 0; i < 3; ++i)
        result = result << 13U | (static_cast<std::uint64_t>(static_cast<std::int64_t>(q[i]) + 4096) & 8191U);
    return result;
}

SeenSurface::SeenSurface(const Scene& scene, const Survey& survey)
    : m_scene(scene), m_points(scene.elements.size()), m_triangles(scene.elements.size())
{
    for (std::size_t t = 0; t < scene.triangles.size(); ++t)
        m_triangles[scene.surfaces[t].element].push_back(static_cast<std::uint32_t>(t));
    std::vector<Eigen::Vector3d> normals(scene.triangles.size());
    for (std::size_t t = 0; t < normals.size(); ++t)
        normals[t] = scene.normal(t);
    m_seen.reserve(survey.size());
    for (std::size_t i = 0; i < survey.size(); ++i)
    {
        const std::uint32_t t = survey.triangles[i];
        if (t == Survey::kNoTriangle)
            continue;
        const std::uint32_t element = scene.surfaces[t].element;
        m_points[element].push_back(static_cast<std::uint32_t>(i));
        // Back on the surface: noise must not spill into the next piece.
        const Eigen::Vector3d p = survey.points[i].cast<double>();
        m_seen.push_back(
            key(p - normals[t] * normals[t].dot(p - scene.vertices[scene.triangles[t][0]]), element, normals[t]));
    }
    std::sort(m_seen.begin(), m_seen.end());
    m_seen.erase(std::unique(m_seen.begin(), m_seen.end()), m_seen.end());
}

SeenSurface::Share SeenSurface::share(std::uint32_t element, const Eigen::Vector2d& left) const
{
    Share result;
    std::vector<double> upTo;
    for (const std::uint32_t t : m_triangles[element])
    {
        const auto& c = m_scene.triangles[t];
        const Eigen::Vector3d& a = m_scene.vertices[c[0]];
        result.area_m2 += 0.5 * (m_scene.vertices[c[1]] - a).cross(m_scene.vertices[c[2]] - a).norm();
        upTo.push_back(result.area_m2);
    }
    if (result.area_m2 < 1e-4)
        return result;
    Random random{0x5ee4, element};
    const auto samples = static_cast<std::size_t>(std::clamp(result.area_m2 * kSamplesPerSquareMetre, 60.0, 60000.0));
    std::size_t seen = 0;
    std::array<std::size_t, 2> sideSamples{};
    std::array<std::size_t, 2> sideSeen{};
    for (std::size_t i = 0; i < samples; ++i)
    {
        const auto at = std::upper_bound(upTo.begin(), upTo.end(), random.uniform() * result.area_m2) - upTo.begin();
        const std::uint32_t t =
            m_triangles[element][std::min<std::size_t>(static_cast<std::size_t>(at), upTo.size() - 1)];
        const auto& c = m_scene.triangles[t];
        const double r1 = std::sqrt(random.uniform());
        const double r2 = random.uniform();
        const Eigen::Vector3d p = (1.0 - r1) * m_scene.vertices[c[0]] + r1 * (1.0 - r2) * m_scene.vertices[c[1]] +
                                  r1 * r2 * m_scene.vertices[c[2]];
        const Eigen::Vector3d normal = m_scene.normal(t);
        const bool isSeen = std::binary_search(m_seen.begin(), m_seen.end(), key(p, element, normal));
        seen += isSeen ? 1 : 0;
        const double facing = normal.head<2>().dot(left);
        if (std::abs(facing) > kFacing)
        {
            const std::size_t side = facing > 0.0 ? 0 : 1;
            ++sideSamples[side];
            sideSeen[side] += isSeen ? 1 : 0;
        }
    }
    result.all = static_cast<double>(seen) / static_cast<double>(samples);
    if (sideSamples[0] > 0)
        result.left = static_cast<double>(sideSeen[0]) / static_cast<double>(sideSamples[0]);
    if (sideSamples[1] > 0)
        result.right = static_cast<double>(sideSeen[1]) / static_cast<double>(sideSamples[1]);
    return result;
}

}  // namespace s2b::sim

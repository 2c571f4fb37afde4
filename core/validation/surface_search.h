// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/validation/bim.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <vector>

namespace s2b::validation
{

/// A triangle of an element, relative to Bim::origin, counter-clockwise as seen from outside.
struct SurfaceTriangle
{
    Eigen::Vector3f a = Eigen::Vector3f::Zero();
    Eigen::Vector3f b = Eigen::Vector3f::Zero();
    Eigen::Vector3f c = Eigen::Vector3f::Zero();
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< unit
    int element = -1;
};

/// All triangles of the elements that have a surface: spaces have none, nor triangles narrower than 0.01 mm. Closed
/// meshes that are inside out are turned.
[[nodiscard]] std::vector<SurfaceTriangle> surfaceOf(const Bim& bim);

struct Nearest
{
    std::uint32_t triangle = 0;
    float distance_m = 0.0F;
    float signed_m = 0.0F;  ///< > 0 outside
    Eigen::Vector3f foot = Eigen::Vector3f::Zero();
};

/// Finds the nearest of some triangles (point queries of Embree's bounding volume hierarchy).
///
/// Of triangles that are equally near to 0.02 mm, as at an edge, the one that faces the point most is taken, so that
/// the side is right; then the first one. So the answer does not depend on the order of the search.
class SurfaceSearch
{
public:
    /// @param triangles  all; the caller keeps them.
    /// @param which      indices of those to search; ascending.
    SurfaceSearch(const std::vector<SurfaceTriangle>& triangles, std::vector<std::uint32_t> which);
    ~SurfaceSearch();
    SurfaceSearch(SurfaceSearch&&) noexcept;
    SurfaceSearch& operator=(SurfaceSearch&&) noexcept;

    /// Thread-safe. Cost: about 1 us.
    /// @param except  element to leave out; -1 for none.
    /// @return false when nothing is within `range_m`.
    [[nodiscard]] bool find(const Eigen::Vector3f& point, float range_m, int except, Nearest& nearest) const;

private:
    struct Engine;
    std::unique_ptr<Engine> m_engine;
};

}  // namespace s2b::validation

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/simulator/scene.h"

#include <Eigen/Core>

#include <limits>
#include <memory>

namespace s2b::sim
{

struct Hit
{
    float range_m = std::numeric_limits<float>::infinity();
    std::uint32_t triangle = 0;

    [[nodiscard]] bool isHit() const { return range_m < std::numeric_limits<float>::infinity(); }
};

/// Nearest hits on a scene's triangles (Embree). cast() may be called from several threads at once.
class RayCaster
{
public:
    explicit RayCaster(const Scene& scene);
    ~RayCaster();
    RayCaster(RayCaster&&) noexcept;
    RayCaster& operator=(RayCaster&&) noexcept;

    /// @param direction  of unit length, so that ranges are metres.
    [[nodiscard]] Hit cast(const Eigen::Vector3f& from, const Eigen::Vector3f& direction, float nearest_m = 0.0F) const;
    /// The nearest surface around a point within its horizontal plane, seen in 24 directions.
    [[nodiscard]] double horizontalClearance(const Eigen::Vector3d& at) const;

private:
    struct Engine;
    std::unique_ptr<Engine> m_engine;
};

}  // namespace s2b::sim

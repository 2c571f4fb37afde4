// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/ray_caster.h"

#include "core/base/error.h"

#include <embree4/rtcore.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace s2b::sim
{

struct RayCaster::Engine
{
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    ~Engine()
    {
        if (scene != nullptr)
            rtcReleaseScene(scene);
        if (device != nullptr)
            rtcReleaseDevice(device);
    }
};

RayCaster::RayCaster(const Scene& scene) : m_engine(std::make_unique<Engine>())
{
    m_engine->device = rtcNewDevice(nullptr);
    if (m_engine->device == nullptr)
        throw Error(ErrorCode::Internal, "Embree could not be started");
    m_engine->scene = rtcNewScene(m_engine->device);
    rtcSetSceneFlags(m_engine->scene, RTC_SCENE_FLAG_ROBUST);
    if (!scene.triangles.empty())
    {
        RTCGeometry mesh = rtcNewGeometry(m_engine->device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                     3 * sizeof(float), scene.vertices.size()));
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), scene.triangles.size()));
        for (const Eigen::Vector3d& v : scene.vertices)
            for (const double x : {v.x(), v.y(), v.z()})
                *vertices++ = static_cast<float>(x);
        for (const auto& t : scene.triangles)
            indices = std::copy(t.begin(), t.end(), indices);
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(m_engine->scene, mesh);
        rtcReleaseGeometry(mesh);
    }
    rtcCommitScene(m_engine->scene);
}

RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

Hit RayCaster::cast(const Eigen::Vector3f& from, const Eigen::Vector3f& direction, float nearest_m) const
{
    RTCRayHit ray{};
    ray.ray.org_x = from.x();
    ray.ray.org_y = from.y();
    ray.ray.org_z = from.z();
    ray.ray.dir_x = direction.x();
    ray.ray.dir_y = direction.y();
    ray.ray.dir_z = direction.z();
    ray.ray.tnear = nearest_m;
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0U;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(m_engine->scene, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return {};
    return {ray.ray.tfar, ray.hit.primID};
}

double RayCaster::horizontalClearance(const Eigen::Vector3d& at) const
{
    constexpr int kDirections = 24;
    double nearest = 1e9;
    for (int i = 0; i < kDirections; ++i)
    {
        const double angle = 2.0 * std::numbers::pi * (i + 0.25) / kDirections;
        const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0.0);
        nearest = std::min(nearest, static_cast<double>(cast(at.cast<float>(), direction.cast<float>()).range_m));
    }
    return nearest;
}

}  // namespace s2b::sim

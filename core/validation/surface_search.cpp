// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/surface_search.h"

#include "core/base/error.h"
#include "core/validation/extrude.h"

#include <embree4/rtcore.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace s2b::validation
{

namespace
{

constexpr float kSame_m = 2e-5F;
constexpr double kSliver_m = 1e-5;
constexpr float kTurned_m = 2e-4F;  // what turning may move a coordinate by, up to a kilometre from the origin

/// The nearest point of a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
/// @param along  signed distance of p to the plane.
Eigen::Vector3f footOn(const SurfaceTriangle& t, const Eigen::Vector3f& p, float along)
{
    const Eigen::Vector3f ab = t.b - t.a;
    const Eigen::Vector3f ac = t.c - t.a;
    const Eigen::Vector3f ap = p - t.a;
    const float d1 = ab.dot(ap);
    const float d2 = ac.dot(ap);
    if (d1 <= 0.0F && d2 <= 0.0F)
        return t.a;
    const Eigen::Vector3f bp = p - t.b;
    const float d3 = ab.dot(bp);
    const float d4 = ac.dot(bp);
    if (d3 >= 0.0F && d4 <= d3)
        return t.b;
    const float vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0F && d1 >= 0.0F && d3 <= 0.0F)
        return t.a + d1 / (d1 - d3) * ab;
    const Eigen::Vector3f cp = p - t.c;
    const float d5 = ab.dot(cp);
    const float d6 = ac.dot(cp);
    if (d6 >= 0.0F && d5 <= d6)
        return t.c;
    const float vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0F && d2 >= 0.0F && d6 <= 0.0F)
        return t.a + d2 / (d2 - d6) * ac;
    const float va = d3 * d6 - d5 * d4;
    if (va <= 0.0F && d4 - d3 >= 0.0F && d5 - d6 >= 0.0F)
        return t.b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t.c - t.b);
    // Inside: the foot on the plane, which is exact also for large triangles.
    return p - along * t.normal;
}

/// What a query knows while it runs.
struct Query
{
    const std::vector<SurfaceTriangle>* triangles = nullptr;
    const std::vector<std::uint32_t>* which = nullptr;
    Eigen::Vector3f point;
    int except = -1;
    bool isFound = false;
    int step = 0;  ///< distance in steps of kSame_m
    float facing = 0.0F;
    Nearest best;
};

bool visit(RTCPointQueryFunctionArguments* arguments)
{
    auto& q = *static_cast<Query*>(arguments->userPtr);
    const std::uint32_t index = (*q.which)[arguments->primID];
    const SurfaceTriangle& t = (*q.triangles)[index];
    const float radius = arguments->query->radius;
    const float along = t.normal.dot(q.point - t.a);
    const float facing = std::abs(along);
    if (facing > radius || t.element == q.except)  // most triangles end here: their plane is too far
        return false;
    const Eigen::Vector3f foot = footOn(t, q.point, along);
    const float squared = (q.point - foot).squaredNorm();
    if (!(squared <= radius * radius))
        return false;
    const float distance = std::sqrt(squared);
    const auto step = static_cast<int>(distance / kSame_m + 0.5F);
    if (q.isFound && (step > q.step || (step == q.step && facing < q.facing) ||
                      (step == q.step && facing == q.facing && index > q.best.triangle)))
        return false;
    q.isFound = true;
    q.step = step;
    q.facing = facing;
    q.best = {index, distance, along < 0.0F ? -distance : distance, foot};
    const float tighter = distance + 2.0F * kSame_m + kTurned_m;  // what is as near is still to be seen
    if (tighter >= radius)
        return false;
    arguments->query->radius = tighter;
    return true;
}

/// Turns most upright faces into the planes of x and y: the boxes of Embree's hierarchy are thin then, where those of
/// long faces at an angle would reach through whole rooms.
Eigen::Rotation2Df alignment(const std::vector<SurfaceTriangle>& triangles)
{
    Eigen::Vector2f sum = Eigen::Vector2f::Zero();
    for (const SurfaceTriangle& t : triangles)
    {
        const float area = 0.5F * (t.b - t.a).cross(t.c - t.a).norm() * t.normal.head<2>().norm();
        const float fourfold = 4.0F * std::atan2(t.normal.y(), t.normal.x());  // the same for all four faces of a box
        sum += area * Eigen::Vector2f(std::cos(fourfold), std::sin(fourfold));
    }
    return Eigen::Rotation2Df(-0.25F * std::atan2(sum.y(), sum.x()));
}

}  // namespace

std::vector<SurfaceTriangle> surfaceOf(const Bim& bim)
{
    std::vector<SurfaceTriangle> triangles;
    for (std::size_t e = 0; e < bim.elements.size(); ++e)
    {
        const BimElement& element = bim.elements[e];
        if (element.elementClass == ElementClass::Space)
            continue;
        const bool isInsideOut = volumeOf(element.mesh) < 0.0;
        for (const auto& corner : element.mesh.triangles)
        {
            const Eigen::Vector3d& a = element.mesh.vertices[corner[0]];
            const Eigen::Vector3d& b = element.mesh.vertices[corner[isInsideOut ? 2 : 1]];
            const Eigen::Vector3d& c = element.mesh.vertices[corner[isInsideOut ? 1 : 2]];
            const Eigen::Vector3d normal = (b - a).cross(c - a);
            const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
            if (!(normal.norm() > kSliver_m * longest))  // too narrow to have a side in floats
                continue;
            triangles.push_back({a.cast<float>(), b.cast<float>(), c.cast<float>(), normal.normalized().cast<float>(),
                                 static_cast<int>(e)});
        }
    }
    return triangles;
}

struct SurfaceSearch::Engine
{
    const std::vector<SurfaceTriangle>* triangles = nullptr;
    std::vector<std::uint32_t> which;
    Eigen::Matrix2f turn =
        Eigen::Matrix2f::Identity();  ///< into the hierarchy's axes; distances are measured without it
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

SurfaceSearch::SurfaceSearch(const std::vector<SurfaceTriangle>& triangles, std::vector<std::uint32_t> which)
    : m_engine(std::make_unique<Engine>())
{
    m_engine->triangles = &triangles;
    m_engine->which = std::move(which);
    m_engine->turn = alignment(triangles).toRotationMatrix();
    m_engine->device = rtcNewDevice(nullptr);
    if (m_engine->device == nullptr)
        throw Error(ErrorCode::Internal, "Embree could not be started");
    m_engine->scene = rtcNewScene(m_engine->device);
    rtcSetSceneFlags(m_engine->scene, RTC_SCENE_FLAG_ROBUST);
    const std::size_t count = m_engine->which.size();
    if (count > 0)
    {
        RTCGeometry mesh = rtcNewGeometry(m_engine->device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(
            rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count));
        if (vertices == nullptr || indices == nullptr)
        {
            rtcReleaseGeometry(mesh);
            throw Error(ErrorCode::Internal, "Embree has no memory for the surfaces");
        }
        for (const std::uint32_t t : m_engine->which)
            for (Eigen::Vector3f v : {triangles[t].a, triangles[t].b, triangles[t].c})
            {
                v.head<2>() = m_engine->turn * v.head<2>().eval();
                vertices = std::copy(v.begin(), v.end(), vertices);
            }
        for (std::uint32_t i = 0; i < 3 * count; ++i)
            *indices++ = i;
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(m_engine->scene, mesh);
        rtcReleaseGeometry(mesh);
    }
    rtcCommitScene(m_engine->scene);
}

SurfaceSearch::~SurfaceSearch() = default;
SurfaceSearch::SurfaceSearch(SurfaceSearch&&) noexcept = default;
SurfaceSearch& SurfaceSearch::operator=(SurfaceSearch&&) noexcept = default;

bool SurfaceSearch::find(const Eigen::Vector3f& point, float range_m, int except, Nearest& nearest) const
{
    if (m_engine->which.empty())
        return false;
    Query query;
    query.triangles = m_engine->triangles;
    query.which = &m_engine->which;
    query.point = point;
    query.except = except;
    RTCPointQuery at{};
    const Eigen::Vector2f turned = m_engine->turn * point.head<2>();
    at.x = turned.x();
    at.y = turned.y();
    at.z = point.z();
    at.radius = range_m + kTurned_m;
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(m_engine->scene, &at, &context, visit, &query);
    if (!query.isFound || query.best.distance_m > range_m)
        return false;
    nearest = query.best;
    return true;
}

}  // namespace s2b::validation

// SPDX-License-Identifier: GPL-3.0-or-later
/// Clouds laid out by hand for the unit tests: rectangles of points whose exact place is known.
#pragma once

#include "core/base/random.h"
#include "core/cloud/point_cloud.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

namespace s2b::test
{

/// A part of a rectangle that gets no points, along its two sides [m].
struct Gap
{
    double uBegin = 0.0, uEnd = 0.0, vBegin = 0.0, vEnd = 0.0;
};

/// Gaps in the walls of a room.
struct RoomGaps
{
    std::vector<Gap> south{};  ///< the face at low.y, u along x
    std::vector<Gap> north{};  ///< at high.y, u along x
    std::vector<Gap> west{};   ///< at low.x, u along y
    std::vector<Gap> east{};   ///< at high.x, u along y
    std::vector<Gap> ceiling{};
};

/// Points on a jittered grid, so that no row of them can fall onto a border between cells, with noise along the normal.
class HandMadeCloud
{
public:
    explicit HandMadeCloud(double spacing_m = 0.02, double noise_m = 0.0) : m_spacing(spacing_m), m_noise(noise_m) {}

    /// corner + u * a + v * b with a in [0, 1] and b in [0, 1].
    void rectangle(const Eigen::Vector3d& corner, const Eigen::Vector3d& u, const Eigen::Vector3d& v, Label label,
                   const std::vector<Gap>& gaps = {})
    {
        const double lengthU = u.norm(), lengthV = v.norm();
        const Eigen::Vector3d n = u.cross(v).normalized();
        const auto countU = static_cast<int>(std::max(1.0, std::round(lengthU / m_spacing)));
        const auto countV = static_cast<int>(std::max(1.0, std::round(lengthV / m_spacing)));
        for (int i = 0; i < countU; ++i)
            for (int j = 0; j < countV; ++j)
            {
                const double a = (i + draw()) / countU, b = (j + draw()) / countV;
                const bool isMissing = std::any_of(gaps.begin(), gaps.end(),
                                                   [&](const Gap& g)
                                                   {
                                                       return a * lengthU > g.uBegin && a * lengthU < g.uEnd &&
                                                              b * lengthV > g.vBegin && b * lengthV < g.vEnd;
                                                   });
                if (!isMissing)
                    point(corner + u * a + v * b + n * (m_noise * gauss()), label);
            }
    }
    /// A vertical rectangle above the segment from a to b.
    void wallFace(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double bottom, double top,
                  Label label = Label::Wall, const std::vector<Gap>& gaps = {})
    {
        rectangle({a.x(), a.y(), bottom}, {b.x() - a.x(), b.y() - a.y(), 0.0}, {0.0, 0.0, top - bottom}, label, gaps);
    }
    void horizontal(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double z, Label label,
                    const std::vector<Gap>& gaps = {})
    {
        rectangle({low.x(), low.y(), z}, {high.x() - low.x(), 0.0, 0.0}, {0.0, high.y() - low.y(), 0.0}, label, gaps);
    }
    void fourWalls(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double bottom, double top,
                   const RoomGaps& gaps = {})
    {
        wallFace(low, {high.x(), low.y()}, bottom, top, Label::Wall, gaps.south);
        wallFace({low.x(), high.y()}, high, bottom, top, Label::Wall, gaps.north);
        wallFace(low, {low.x(), high.y()}, bottom, top, Label::Wall, gaps.west);
        wallFace({high.x(), low.y()}, high, bottom, top, Label::Wall, gaps.east);
    }
    /// Four walls, floor and ceiling, seen from inside.
    void room(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double floor = 0.0, double ceiling = 2.6,
              const RoomGaps& gaps = {})
    {
        fourWalls(low, high, floor, ceiling, gaps);
        horizontal(low, high, floor, Label::Floor);
        horizontal(low, high, ceiling, Label::Ceiling, gaps.ceiling);
    }
    /// The mantle of a vertical cylinder between two angles.
    void mantle(const Eigen::Vector2d& center, double radius, double bottom, double top, Label label,
                double fromAngle = 0.0, double toAngle = 2 * std::numbers::pi)
    {
        const auto around = static_cast<int>(std::max(3.0, std::round(radius * (toAngle - fromAngle) / m_spacing)));
        const auto upward = static_cast<int>(std::max(1.0, std::round((top - bottom) / m_spacing)));
        for (int i = 0; i < around; ++i)
            for (int j = 0; j < upward; ++j)
            {
                const double angle = fromAngle + (toAngle - fromAngle) * (i + draw()) / around;
                const double r = radius + m_noise * gauss();
                point({center.x() + r * std::cos(angle), center.y() + r * std::sin(angle),
                       bottom + (top - bottom) * (j + draw()) / upward},
                      label);
            }
    }
    void point(const Eigen::Vector3d& p, Label label)
    {
        m_cloud.points.push_back(p.cast<float>());
        m_cloud.labels.push_back(label);
        m_stationOfPoint.push_back(m_station);
    }

    /// What follows is measured from here.
    void standAt(const Eigen::Vector3d& position)
    {
        m_station = static_cast<std::uint16_t>(m_stations.size());
        m_stations.push_back(position);
    }
    /// What follows is measured from no known station.
    void standAnywhere() { m_station = StationView::kUnknown; }
    /// Nobody knows where the points were measured from.
    void forgetStations() { m_stations.clear(); }
    /// Nobody knows which point was measured from where.
    void forgetStationOfPoints() { m_knowsStationOfPoints = false; }

    /// Turns all points about the vertical through the origin, then moves them.
    void move(double yaw_rad, const Eigen::Vector3d& by = Eigen::Vector3d::Zero())
    {
        const Eigen::AngleAxisd turn(yaw_rad, Eigen::Vector3d::UnitZ());
        for (Eigen::Vector3f& p : m_cloud.points)
            p = (turn * p.cast<double>() + by).cast<float>();
        for (Eigen::Vector3d& p : m_stations)
            p = turn * p + by;
    }
    void setLabels(Label label) { std::fill(m_cloud.labels.begin(), m_cloud.labels.end(), label); }
    /// The same points in another order.
    void shuffle(std::uint64_t seed)
    {
        for (std::size_t i = m_cloud.size(); i > 1; --i)
        {
            const auto j = static_cast<std::size_t>(randomShare(seed, 7, i) * static_cast<double>(i));
            std::swap(m_cloud.points[i - 1], m_cloud.points[j]);
            std::swap(m_cloud.labels[i - 1], m_cloud.labels[j]);
            std::swap(m_stationOfPoint[i - 1], m_stationOfPoint[j]);
        }
    }

    [[nodiscard]] std::size_t size() const { return m_cloud.size(); }
    [[nodiscard]] PointCloud& cloud() { return m_cloud; }
    [[nodiscard]] CloudView view(bool withLabels = true) const
    {
        CloudView view{m_cloud.points.empty() ? nullptr : m_cloud.points.front().data(), m_cloud.size(), m_cloud.origin,
                       withLabels && !m_cloud.labels.empty()
                           ? reinterpret_cast<const std::uint8_t*>(m_cloud.labels.data())
                           : nullptr};
        view.stations = {m_stations, m_knowsStationOfPoints ? m_stationOfPoint.data() : nullptr};
        return view;
    }

private:
    double draw() { return randomShare(1, 1, ++m_draws); }
    /// A standard normal number (Box and Muller).
    double gauss()
    {
        if (m_noise == 0.0)
            return 0.0;
        const double a = std::max(draw(), std::numeric_limits<double>::min()), b = draw();
        return std::sqrt(-2 * std::log(a)) * std::cos(2 * std::numbers::pi * b);
    }

    PointCloud m_cloud;
    std::vector<Eigen::Vector3d> m_stations;
    std::vector<std::uint16_t> m_stationOfPoint;
    std::uint16_t m_station = StationView::kUnknown;
    bool m_knowsStationOfPoints = true;
    double m_spacing, m_noise;
    std::uint64_t m_draws = 0;
};

}  // namespace s2b::test

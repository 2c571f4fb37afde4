// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/labels/label.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace s2b
{

using PointIndex = std::uint32_t;

/// A point cloud in metres, Z up. Points are float relative to a double origin (as CloudCompare's global shift), so
/// that a georeferenced scan keeps its millimetres: the float spacing at 100 m from the origin is 8 um.
///
/// World coordinate of point i: origin + points[i]. `labels` is empty or of the size of `points`.
struct PointCloud
{
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3f> points;
    std::vector<Label> labels;

    [[nodiscard]] std::size_t size() const noexcept { return points.size(); }
    [[nodiscard]] bool hasLabels() const noexcept { return !labels.empty(); }
};

/// Where the scanner stood, and which of its points were measured from where.
struct StationView
{
    static constexpr std::uint16_t kUnknown = 0xffff;

    std::span<const Eigen::Vector3d> positions;  ///< relative to the cloud's origin; at most 65534
    const std::uint16_t* ofPoint = nullptr;  ///< index of positions or kUnknown, one a point; null: not known of any

    [[nodiscard]] bool empty() const noexcept { return positions.empty(); }
    /// kUnknown when it isn't known. What was measured from a single station needs no ids.
    [[nodiscard]] std::uint16_t of(std::size_t point) const
    {
        const std::uint16_t s = ofPoint ? ofPoint[point] : positions.size() == 1 ? std::uint16_t{0} : kUnknown;
        return s < positions.size() ? s : kUnknown;
    }
};

/// A cloud to read, as its owner stores it: no copy is made. Everything is a view; the owner outlives it.
///
/// `xyz` has 3 floats a point. Georeferenced coordinates are `origin + xyz`.
struct CloudView
{
    const float* xyz = nullptr;
    std::size_t count = 0;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    const std::uint8_t* labels = nullptr;  ///< values of Label, one a point; null without labels
    const std::uint8_t* rgb = nullptr;     ///< red, green, blue of the first point; null without colours
    std::size_t rgbStride = 3;             ///< bytes from one point's colour to the next one's
    StationView stations{};                ///< empty when nothing is known of them
    /// How sure each label is, 0..255; null for labels that were given and not guessed by a model.
    const std::uint8_t* confidence = nullptr;
};

}  // namespace s2b

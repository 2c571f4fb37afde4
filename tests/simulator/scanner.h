// SPDX-License-Identifier: GPL-3.0-or-later
/// A terrestrial laser scanner by ray casting (Embree).
#pragma once

#include "core/cloud/point_cloud.h"
#include "tests/simulator/scene.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace s2b::sim
{

struct Station
{
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< local frame of the scene, the scanner's mirror
    int storey = -1;                                     ///< index, -1 outside
};

struct ScanSettings
{
    std::uint64_t seed = 1;
    unsigned threads = 0;       ///< 0 = all; the result does not depend on it
    double step_deg = 0.2;      ///< between rays, both ways; [0.01, 10]
    double lineStep_deg = 0.0;  ///< between upright lines, as many at the zenith as anywhere: a line laser that is
                                ///< turned; [0.01, 10], 0 = step_deg, fewer towards the zenith
    double rangeStep_m = 0.0;   ///< the range is rounded to it
    double tilt_deg = 0.0;      ///< of each set-up against the plumb, in a direction that is drawn
    double warp_m = 0.0;        ///< most that ranges are wrong by, smoothly over the sphere: walls seem bent
    unsigned mostStations = 0;  ///< stations near each other, drawn from those chosen; 0 = all
    double elevationMin_deg = -60.0;  ///< below that the tripod is in the way
    double rangeMin_m = 0.4;
    double rangeMax_m = 30.0;
    double noise_m = 0.002;  ///< sigma of the range at 5 m and perpendicular incidence; grows with range and incidence
    double mixedPixels = 0.25;  ///< [0, 1] share of rays at a range jump that return something in between
    double glassReturn = 0.05;  ///< [0, 1] share of rays that glass returns at slanted incidence
    bool dropOut = true;        ///< fewer returns at grazing incidence
    double labelErrors =
        0.0;               ///< [0, 1] share of points with a wrong label: half of them alone, half in patches of 0.3 m
    double voxel_m = 0.0;  ///< one point a voxel of this size, 0 = all
};

/// Points in scan order. All arrays are of one size.
struct Survey
{
    static constexpr std::uint32_t kNoTriangle = 0xffffffffU;

    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< world = origin + points[i]
    std::vector<Eigen::Vector3f> points;
    std::vector<Label> labels;  ///< with errors, if asked for; mixed pixels are Unassigned
    std::vector<std::array<std::uint8_t, 3>> colours;
    std::vector<std::uint16_t> stations;   ///< index, from 0
    std::vector<std::uint32_t> triangles;  ///< of the scene; kNoTriangle for mixed pixels

    [[nodiscard]] std::size_t size() const noexcept { return points.size(); }
    [[nodiscard]] PointCloud toPointCloud() const { return {origin, points, labels}; }
};

/// Scans from all stations.
///
/// Each ray's draws come from (seed, station, ray): the same bytes for any number of threads.
/// @throws Error{BadParameter} for a setting out of range or no station, Error{EmptyCloud} when nothing was hit.
/// Cost: about 2 million rays a second and core; 26 bytes a point.
[[nodiscard]] Survey scan(const Scene& scene, const std::vector<Station>& stations, const ScanSettings& settings);

/// Stations for a parametric building: near the middle of each space (long ones get several), in doorways that can be
/// walked through, and round the building when `outside`. Clear of furniture and walls by 0.35 m where there is room.
[[nodiscard]] std::vector<Station> chooseStations(const SimulatedBuilding& building, const Scene& scene, bool outside,
                                                  std::uint64_t seed = 1);

/// At most so many of the stations within a building: one that the seed draws, and the nearest to it on its storey.
[[nodiscard]] std::vector<Station> fewStations(const std::vector<Station>& stations, unsigned most, std::uint64_t seed);

/// Stations for any scene: the fewest (greedily) that see nearly all of each storey's free floor and of the walls along
/// it.
[[nodiscard]] std::vector<Station> chooseStations(const Scene& scene, bool outside, std::uint64_t seed = 1);

}  // namespace s2b::sim

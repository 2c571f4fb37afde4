// SPDX-License-Identifier: GPL-3.0-or-later
/// Simulated surveys for the property tests, and how a result compares with their truth.
#pragma once

#include "core/pipeline/pipeline.h"
#include "tests/simulator/building_spec.h"
#include "tests/simulator/scanner.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace s2b::test
{

struct SimulatedSurvey
{
    Building truth;
    PointCloud cloud;

    [[nodiscard]] CloudView view() const
    {
        return {cloud.points.front().data(), cloud.size(), cloud.origin,
                reinterpret_cast<const std::uint8_t*>(cloud.labels.data())};
    }
};

/// Small: a storey with a corridor and two rooms on each side of it, everything in it that a storey can have but arcs.
inline sim::BuildingSpec smallOffice()
{
    sim::BuildingSpec spec;
    spec.storeys = 1;
    spec.roomsPerSide = 2;
    spec.curvedWalls = false;
    spec.trees = false;
    return spec;
}

inline sim::ScanSettings quickScan()
{
    sim::ScanSettings settings;
    settings.step_deg = 0.7;
    settings.noise_m = 0.003;
    return settings;
}

inline SimulatedSurvey survey(const sim::BuildingSpec& spec, const sim::ScanSettings& settings)
{
    const sim::SimulatedBuilding building = sim::makeBuilding(spec);
    const sim::Scene scene = sim::makeScene(building, spec.seed);
    const std::vector<sim::Station> stations = sim::chooseStations(building, scene, false, spec.seed);
    return {building.truth, sim::scan(scene, stations, settings).toPointCloud()};
}

inline Building reconstructed(const SimulatedSurvey& s, bool geometryOnly = false, const Context& context = {})
{
    PipelineOptions options;
    options.geometryOnly = geometryOnly;
    return reconstruct(s.view(), options, context);
}

/// A wall in the world, straight.
struct WorldWall
{
    const Wall* wall = nullptr;
    Eigen::Vector2d start = Eigen::Vector2d::Zero(), end = Eigen::Vector2d::Zero();
    double base_m = 0.0;

    [[nodiscard]] double length() const { return (end - start).norm(); }
    [[nodiscard]] Eigen::Vector2d direction() const { return (end - start) / length(); }
    [[nodiscard]] Eigen::Vector2d at(double s) const { return start + direction() * s; }
    [[nodiscard]] double offset(const Eigen::Vector2d& p) const
    {
        const Eigen::Vector2d d = direction(), q = p - start;
        return d.x() * q.y() - d.y() * q.x();
    }
};

inline std::vector<WorldWall> worldWalls(const Building& b)
{
    std::vector<WorldWall> walls;
    for (const Wall& w : b.walls)
        if (w.bulge == 0.0)
        {
            const Eigen::Vector3d from = b.frame.toWorld({w.start.x(), w.start.y(), w.base_m});
            const Eigen::Vector3d to = b.frame.toWorld({w.end.x(), w.end.y(), w.base_m});
            walls.push_back({&w, from.head<2>(), to.head<2>(), from.z()});
        }
    return walls;
}

/// How far from the axis a counterpart may lie: half the wall, as a wall with one face seen has an assumed thickness.
inline double reachOf(const WorldWall& truth)
{
    return 0.1 + truth.wall->thickness.value_m / 2;
}

/// The found wall along the middle of a true one; null when there is none within reach of its axis.
inline const WorldWall* counterpart(const WorldWall& truth, const std::vector<WorldWall>& found)
{
    const WorldWall* best = nullptr;
    double nearest = reachOf(truth);
    for (const WorldWall& w : found)
    {
        const Eigen::Vector2d middle = truth.at(truth.length() / 2);
        const double s = w.direction().dot(middle - w.start), d = std::abs(w.offset(middle));
        if (std::abs(w.direction().dot(truth.direction())) > std::cos(0.035) && s > 0 && s < w.length() &&
            d < nearest && std::abs(w.base_m - truth.base_m) < 0.3)
        {
            nearest = d;
            best = &w;
        }
    }
    return best;
}

struct WallScore
{
    int truth = 0;  ///< straight walls of at least half a metre
    int found = 0;
    int bothSeen = 0;               ///< of the found, measured from both faces
    double worstAxis_m = 0.0;       ///< of those: distance of the axis from the true one, a quarter from either end
    double worstThickness_m = 0.0;  ///< of those
};

inline WallScore scoreWalls(const Building& truth, const Building& result)
{
    WallScore score;
    const std::vector<WorldWall> found = worldWalls(result);
    for (const WorldWall& t : worldWalls(truth))
    {
        if (t.length() < 0.5)
            continue;
        ++score.truth;
        const WorldWall* w = counterpart(t, found);
        if (!w)
            continue;
        ++score.found;
        if (w->wall->evidence.facesSeen < 2)
            continue;
        ++score.bothSeen;
        for (const double share : {0.25, 0.75})
            score.worstAxis_m = std::max(score.worstAxis_m, std::abs(w->offset(t.at(share * t.length()))));
        score.worstThickness_m =
            std::max(score.worstThickness_m, std::abs(w->wall->thickness.value_m - t.wall->thickness.value_m));
    }
    return score;
}

/// Share of the found walls' length that lies along a true wall.
inline double soundShare(const Building& truth, const Building& result)
{
    const std::vector<WorldWall> real = worldWalls(truth);
    double good = 0, all = 0;
    for (const WorldWall& w : worldWalls(result))
        for (double s = 0.05; s < w.length(); s += 0.1)
        {
            all += 1;
            good += std::any_of(real.begin(), real.end(),
                                [&](const WorldWall& t)
                                {
                                    const double along = t.direction().dot(w.at(s) - t.start);
                                    return along > -0.3 && along < t.length() + 0.3 &&
                                           std::abs(t.offset(w.at(s))) < reachOf(t) &&
                                           std::abs(t.base_m - w.base_m) < 0.3;
                                });
        }
    return all > 0 ? good / all : 0;
}

/// Lower corners of an opening on its wall's axis in the world.
struct WorldOpening
{
    const Opening* opening = nullptr;
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
};

inline std::vector<WorldOpening> worldOpenings(const Building& b, OpeningKind kind)
{
    std::vector<WorldOpening> openings;
    for (const Opening& o : b.openings)
        if (const Wall* w = b.wall(o.host); o.kind == kind && w->bulge == 0.0)
        {
            const auto at = [&](double s)
            {
                const Eigen::Vector2d p = w->start + w->direction() * s;
                return b.frame.toWorld({p.x(), p.y(), w->base_m + o.sill.value_m});
            };
            openings.push_back({&o, at(o.offset_m), at(o.offset_m + o.width.value_m)});
        }
    return openings;
}

struct OpeningScore
{
    int truth = 0, found = 0, extra = 0;
    std::vector<double> edge_m;    ///< both edges along the wall, of the found ones
    std::vector<double> height_m;  ///< of the found ones
};

inline OpeningScore scoreOpenings(const Building& truth, const Building& result, OpeningKind kind)
{
    OpeningScore score;
    const std::vector<WorldOpening> found = worldOpenings(result, kind);
    for (const WorldOpening& t : worldOpenings(truth, kind))
    {
        ++score.truth;
        for (const WorldOpening& f : found)
        {
            const Eigen::Vector3d along = (t.to - t.from).normalized();
            if (((t.from + t.to - f.from - f.to) / 2).norm() > 0.4)
                continue;
            ++score.found;
            const double a = along.dot(f.from - t.from), b = along.dot(f.to - t.from), width = (t.to - t.from).norm();
            score.edge_m.push_back(std::abs(std::min(a, b)));
            score.edge_m.push_back(std::abs(std::max(a, b) - width));
            score.height_m.push_back(std::abs(f.opening->height.value_m - t.opening->height.value_m));
            break;
        }
    }
    score.extra = static_cast<int>(found.size()) - score.found;
    return score;
}

inline double quantile(std::vector<double> values, double q)
{
    if (values.empty())
        return 0.0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

}  // namespace s2b::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/random.h"
#include "tests/simulator/ray_caster.h"
#include "tests/simulator/scanner.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

namespace s2b::sim
{

namespace
{

constexpr double kCell_m = 0.3;       ///< of the free floor
constexpr double kCandidate_m = 0.6;  ///< grid of places for the tripod
constexpr double kReach_m = 4.5;      ///< a station is asked to cover this far
constexpr double kClear_m = 0.4;
constexpr double kMirror_m = 1.5;       ///< above the floor
constexpr double kFace_m = 0.35;        ///< piece of a wall face
constexpr int kFan = 240;               ///< directions of the horizontal view
constexpr std::size_t kFaceWeight = 3;  ///< a piece of wall face counts as this many cells of floor
constexpr std::size_t kMinGain = 24;
constexpr double kEnough = 0.985;
constexpr double kOutside_m = 6.0;

struct Cell
{
    Eigen::Vector2d at;
    double floor;
    double clear;
};

/// What a station would see: indices of floor cells, then of wall pieces.
struct Candidate
{
    Eigen::Vector3d at;
    std::vector<std::uint32_t> sees;
};

class StoreyCover
{
public:
    StoreyCover(const Scene& scene, const RayCaster& caster, double elevation, const Eigen::Vector2d& low,
                const Eigen::Vector2d& high)
        : m_scene(scene), m_caster(caster)
    {
        for (double x = low.x(); x < high.x(); x += kCell_m)
            for (double y = low.y(); y < high.y(); y += kCell_m)
                addCell({x, y}, elevation);
        std::map<std::pair<int, int>, bool> used;
        for (const Cell& cell : m_cells)
            if (cell.clear > kClear_m &&
                used.emplace(std::pair(static_cast<int>(std::floor(cell.at.x() / kCandidate_m)),
                                       static_cast<int>(std::floor(cell.at.y() / kCandidate_m))),
                             true)
                    .second)
                addCandidate(cell);
    }

    [[nodiscard]] std::vector<Eigen::Vector3d> choose() const
    {
        const std::size_t pieces = m_cells.size() + m_faces.size();
        std::vector<char> covered(pieces, 0);
        const auto weight = [&](std::uint32_t i) { return i < m_cells.size() ? 1 : kFaceWeight; };
        const auto gain = [&](const Candidate& c)
        {
            std::size_t sum = 0;
            for (const std::uint32_t i : c.sees)
                sum += covered[i] != 0 ? 0 : weight(i);
            return sum;
        };
        std::vector<char> reachable(pieces, 0);
        for (const Candidate& c : m_candidates)
            for (const std::uint32_t i : c.sees)
                reachable[i] = 1;
        std::size_t total = 0;
        for (std::uint32_t i = 0; i < pieces; ++i)
            total += reachable[i] != 0 ? weight(i) : 0;

        // Greedy; a candidate's gain only falls, so an old value is an upper bound and most need no new look.
        std::vector<std::size_t> bound;
        for (const Candidate& c : m_candidates)
            bound.push_back(gain(c));
        std::vector<Eigen::Vector3d> result;
        std::size_t sum = 0;
        while (!bound.empty() && static_cast<double>(sum) < kEnough * static_cast<double>(total))
        {
            std::size_t best = 0;
            while (true)
            {
                best = static_cast<std::size_t>(std::max_element(bound.begin(), bound.end()) - bound.begin());
                const std::size_t now = gain(m_candidates[best]);
                if (now == bound[best])
                    break;
                bound[best] = now;
            }
            if (bound[best] < kMinGain)
                break;
            for (const std::uint32_t i : m_candidates[best].sees)
            {
                sum += covered[i] != 0 ? 0 : weight(i);
                covered[i] = 1;
            }
            bound[best] = 0;
            result.push_back(m_candidates[best].at);
        }
        return result;
    }

private:
    /// Floor below at the storey's height, and something above: rooms, not the roof or the garden.
    void addCell(const Eigen::Vector2d& at, double elevation)
    {
        const Eigen::Vector3d eye(at.x(), at.y(), elevation + kMirror_m);
        const Hit down = m_caster.cast(eye.cast<float>(), {0.0F, 0.0F, -1.0F});
        const Hit up = m_caster.cast(eye.cast<float>(), {0.0F, 0.0F, 1.0F});
        if (!down.isHit() || !up.isHit())
            return;
        const double floor = eye.z() - static_cast<double>(down.range_m);
        const bool isGround = m_scene.elements[m_scene.surfaces[down.triangle].element].isProp;
        const bool isTree = m_scene.elements[m_scene.surfaces[up.triangle].element].isProp;
        if (isGround || isTree || std::abs(floor - elevation) > 0.8 || static_cast<double>(up.range_m) > 9.0 ||
            static_cast<double>(up.range_m + down.range_m) < 1.8)
            return;
        const double clear = m_caster.horizontalClearance({at.x(), at.y(), floor + kMirror_m});
        if (clear > 0.15)
            m_cells.push_back({at, floor, clear});
    }

    void addCandidate(const Cell& cell)
    {
        Candidate c;
        c.at = {cell.at.x(), cell.at.y(), cell.floor + kMirror_m};
        std::vector<double> range(kFan);
        for (int k = 0; k < kFan; ++k)
        {
            const double angle = 2.0 * std::numbers::pi * k / kFan;
            const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0.0);
            const Hit hit = m_caster.cast(c.at.cast<float>(), direction.cast<float>());
            range[static_cast<std::size_t>(k)] = static_cast<double>(hit.range_m);
            if (!hit.isHit() || static_cast<double>(hit.range_m) > 1.4 * kReach_m)
                continue;
            const Eigen::Vector3d normal = m_scene.normal(hit.triangle);
            if (std::abs(normal.z()) > 0.3 || std::abs(normal.dot(direction)) < 0.26)
                continue;
            const Eigen::Vector3d p = c.at + direction * static_cast<double>(hit.range_m) - direction * 0.02;
            const int facing =
                static_cast<int>(std::lround(std::atan2(normal.y(), normal.x()) / (std::numbers::pi / 4.0))) & 7;
            const auto key = std::array{static_cast<int>(std::floor(p.x() / kFace_m)),
                                        static_cast<int>(std::floor(p.y() / kFace_m)), facing};
            const auto face = m_faces.emplace(key, static_cast<std::uint32_t>(m_faces.size())).first;
            c.sees.push_back(static_cast<std::uint32_t>(m_cells.size()) + face->second);
        }
        for (std::uint32_t i = 0; i < m_cells.size(); ++i)
        {
            const Eigen::Vector2d d = m_cells[i].at - cell.at;
            const double r = d.norm();
            if (r > kReach_m)
                continue;
            const auto k = static_cast<std::size_t>(
                (std::lround(std::atan2(d.y(), d.x()) / (2.0 * std::numbers::pi) * kFan) + kFan) % kFan);
            if (r < range[k] - 0.1 || r < 0.3)
                c.sees.push_back(i);
        }
        std::sort(c.sees.begin(), c.sees.end());
        c.sees.erase(std::unique(c.sees.begin(), c.sees.end()), c.sees.end());
        m_candidates.push_back(std::move(c));
    }

    const Scene& m_scene;
    const RayCaster& m_caster;
    std::vector<Cell> m_cells;
    std::map<std::array<int, 3>, std::uint32_t> m_faces;
    std::vector<Candidate> m_candidates;
};

}  // namespace

std::vector<Station> chooseStations(const Scene& scene, bool outside, std::uint64_t seed)
{
    const RayCaster caster(scene);
    Eigen::Vector2d low(1e300, 1e300);
    Eigen::Vector2d high = -low;
    double ground = 0.0;
    for (std::size_t t = 0; t < scene.triangles.size(); ++t)
    {
        const SceneElement& element = scene.elements[scene.surfaces[t].element];
        const Label label = scene.surfaces[t].label;
        for (const std::uint32_t v : scene.triangles[t])
        {
            if (element.type == "ground")
                ground = scene.vertices[v].z();
            if (element.isProp || label == Label::Unassigned || label == Label::Furniture)
                continue;
            low = low.cwiseMin(scene.vertices[v].head<2>());
            high = high.cwiseMax(scene.vertices[v].head<2>());
        }
    }
    std::vector<Station> stations;
    const auto add = [&](Eigen::Vector3d at, int storey)
    {
        at.z() += Random{seed, 0x57b, stations.size()}.uniform(-0.12, 0.12);
        stations.push_back({at, storey});
    };
    for (std::size_t k = 0; k < scene.storeys.size(); ++k)
        for (const Eigen::Vector3d& at : StoreyCover(scene, caster, scene.storeys[k].elevation_m, low, high).choose())
            add(at, static_cast<int>(k));
    if (outside)
    {
        const Eigen::Vector2d a = low.array() - kOutside_m;
        const Eigen::Vector2d b = high.array() + kOutside_m;
        const std::array<Eigen::Vector2d, 4> corners{a, Eigen::Vector2d(b.x(), a.y()), b,
                                                     Eigen::Vector2d(a.x(), b.y())};
        for (std::size_t i = 0; i < 4; ++i)
        {
            const Eigen::Vector2d d = corners[(i + 1) % 4] - corners[i];
            const int count = std::max(1, static_cast<int>(std::lround(d.norm() / (2.0 * kOutside_m))));
            for (int k = 0; k < count; ++k)
            {
                const Eigen::Vector2d p = corners[i] + d * k / count;
                const Eigen::Vector3d at(p.x(), p.y(), ground + 1.7);
                if (caster.horizontalClearance(at) > kClear_m)
                    add(at, -1);
            }
        }
    }
    return stations;
}

}  // namespace s2b::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/axis_curve.h"
#include "tests/simulator/plan.h"
#include "tests/simulator/random.h"
#include "tests/simulator/ray_caster.h"
#include "tests/simulator/scanner.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace s2b::sim
{

namespace
{

constexpr double kClear_m = 0.35;      ///< round the tripod
constexpr double kReach_m = 5.0;       ///< a long room gets a station for each stretch of this length
constexpr double kSmall_m2 = 3.0;      ///< a cubicle
constexpr double kCandidates_m = 0.2;  ///< grid of places in a room
constexpr double kOutside_m = 6.0;     ///< distance from the facade, and half the distance of stations along it

class Placer
{
public:
    Placer(const SimulatedBuilding& building, const Scene& scene, std::uint64_t seed)
        : m_building(building.truth), m_caster(scene), m_seed(seed)
    {
    }

    void rooms()
    {
        for (const Space& space : m_building.spaces)
            room(space);
    }

    void doorways()
    {
        for (const Opening& opening : m_building.openings)
        {
            const Wall* host = m_building.wall(opening.host);
            const bool isPassage = opening.kind == OpeningKind::Plain ||
                                   (opening.kind == OpeningKind::Door && opening.leafState != LeafState::Closed);
            if (host == nullptr || !isPassage || opening.sill.value_m > 0.1)
                continue;
            place(AxisCurve(*host).at(opening.offset_m + opening.width.value_m / 2.0), host->base_m,
                  opening.height.value_m, storeyIndex(host->storey), 0.25);
        }
    }

    void outside()
    {
        if (m_building.slabs.empty())
            return;
        const auto& ring = m_building.slabs.front().outline.outer;
        Eigen::Vector2d low = ring.front();
        Eigen::Vector2d high = ring.front();
        for (const Eigen::Vector2d& p : ring)
        {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        const Eigen::Vector2d a = low.array() - kOutside_m;
        const Eigen::Vector2d b = high.array() + kOutside_m;
        const std::vector<Eigen::Vector2d> corners{a, {b.x(), a.y()}, b, {a.x(), b.y()}};
        for (std::size_t i = 0; i < 4; ++i)
        {
            const Eigen::Vector2d d = corners[(i + 1) % 4] - corners[i];
            const int count = std::max(1, static_cast<int>(std::lround(d.norm() / (2.0 * kOutside_m))));
            for (int k = 0; k < count; ++k)
                place(corners[i] + d * k / count, -0.15, 3.0, -1, kClear_m);
        }
    }

    std::vector<Station> take() { return std::move(m_stations); }

private:
    [[nodiscard]] int storeyIndex(ElementId id) const
    {
        const auto it = std::find_if(m_building.storeys.begin(), m_building.storeys.end(),
                                     [&](const Storey& s) { return s.id == id; });
        return it == m_building.storeys.end() ? 0 : static_cast<int>(it - m_building.storeys.begin());
    }

    [[nodiscard]] Eigen::Vector3d local(const Eigen::Vector2d& p, double z) const
    {
        const double c = std::cos(m_building.frame.yaw_rad);
        const double s = std::sin(m_building.frame.yaw_rad);
        return {c * p.x() - s * p.y(), s * p.x() + c * p.y(), z};
    }

    bool place(const Eigen::Vector2d& at, double floor, double height, int storey, double clear)
    {
        Random random{m_seed, 0x57a, m_stations.size()};
        const Eigen::Vector3d p = local(at, floor + std::min(random.uniform(1.4, 1.65), height - 0.4));
        if (m_caster.horizontalClearance(p) < clear)
            return false;
        m_stations.push_back({p, storey});
        return true;
    }

    void room(const Space& space)
    {
        Room room;
        room.outline = space.outline.outer;
        if (room.outline.size() < 3)
            return;
        Eigen::Vector2d low = room.outline.front();
        Eigen::Vector2d high = room.outline.front();
        for (const Eigen::Vector2d& p : room.outline)
        {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        const Eigen::Vector2d extent = high - low;
        const int axis = extent.x() >= extent.y() ? 0 : 1;
        const int parts = std::max(1, static_cast<int>(std::ceil(extent[axis] / kReach_m)));
        std::vector<Eigen::Vector2d> places;
        for (double x = low.x() + 0.1; x < high.x(); x += kCandidates_m)
            for (double y = low.y() + 0.1; y < high.y(); y += kCandidates_m)
                if (room.clearance({x, y}) > kClear_m)
                    places.emplace_back(x, y);
        std::vector<Eigen::Vector2d> chosen;
        const auto placeNear = [&](const Eigen::Vector2d& target)
        {
            std::stable_sort(places.begin(), places.end(), [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
                             { return (a - target).squaredNorm() < (b - target).squaredNorm(); });
            std::vector<Eigen::Vector2d> tries{target};
            tries.insert(tries.end(), places.begin(), places.end());
            for (const Eigen::Vector2d& p : tries)
                if (room.contains(p) &&
                    place(p, space.floor_m, space.height.value_m, storeyIndex(space.storey), kClear_m))
                {
                    chosen.push_back(p);
                    return;
                }
        };
        for (int i = 0; i < parts; ++i)
        {
            Eigen::Vector2d target = parts == 1 ? room.middle() : Eigen::Vector2d(low + extent / 2.0);
            if (parts > 1)
                target[axis] = low[axis] + extent[axis] * (i + 0.5) / parts;
            else if (space.area_m2 < kSmall_m2)
                target[axis] = low[axis] + kClear_m + 0.02;  // or the tripod hides the whole floor
            placeNear(target);
        }
        // The far side of each column.
        for (const Column& column : m_building.columns)
        {
            if (chosen.empty() || column.storey != space.storey || !room.contains(column.center))
                continue;
            const Eigen::Vector2d nearest =
                *std::min_element(chosen.begin(), chosen.end(), [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
                                  { return (a - column.center).squaredNorm() < (b - column.center).squaredNorm(); });
            const Eigen::Vector2d away = (column.center - nearest).normalized();
            if (room.clearance(column.center + 0.6 * away) > 0.3)
                placeNear(column.center + 1.3 * away);
        }
    }

    const Building& m_building;
    RayCaster m_caster;
    std::uint64_t m_seed;
    std::vector<Station> m_stations;
};

}  // namespace

std::vector<Station> chooseStations(const SimulatedBuilding& building, const Scene& scene, bool outside,
                                    std::uint64_t seed)
{
    Placer placer(building, scene, seed);
    placer.rooms();
    placer.doorways();
    if (outside)
        placer.outside();
    return placer.take();
}

std::vector<Station> fewStations(const std::vector<Station>& stations, unsigned most, std::uint64_t seed)
{
    std::vector<Station> result;
    std::copy_if(stations.begin(), stations.end(), std::back_inserter(result),
                 [](const Station& s) { return s.storey >= 0; });
    if (most == 0 || result.empty())
        return stations;
    const Station first = result[Random{seed, 0xfe3}.below(result.size())];
    std::erase_if(result, [&](const Station& s) { return s.storey != first.storey; });
    std::stable_sort(result.begin(), result.end(), [&](const Station& a, const Station& b)
                     { return (a.position - first.position).norm() < (b.position - first.position).norm(); });
    result.resize(std::min<std::size_t>(most, result.size()));
    return result;
}

}  // namespace s2b::sim

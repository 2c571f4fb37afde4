// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/dbscan.h"
#include "core/openings/openings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace s2b
{
namespace
{

/// A labelled cell in a wall's own coordinates.
struct WallPoint
{
    double s = 0;      ///< along the axis
    double d = 0;      ///< to the left of it
    double z = 0;
    double across = 0; ///< |normal . wall normal|
    std::uint32_t count = 0;
};

/// A cluster of points inside the wall's body.
struct Cluster
{
    double begin = 0, end = 0, bottom = 0, top = 0;
    std::uint64_t points = 0;
    std::size_t cells = 0;
};

double quantile(std::vector<double>& values, double q)
{
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Points of one class within the body of a wall, and how far the body may reach on an unseen side.
std::vector<WallPoint> pointsInBody(const std::vector<std::uint32_t>& labelled, const SurfaceCells& cells, const Wall& wall, double margin)
{
    const Eigen::Vector2d t = wall.direction(), n = wall.normal();
    const double half = wall.thickness.value_m / 2;
    const double unseen = wall.thickness.provenance == Provenance::Assumed ? 0.15 : 0.0;
    const double low = -half - margin - (wall.evidence.faceCoverage[1] > 0 ? 0 : unseen);
    const double high = half + margin + (wall.evidence.faceCoverage[0] > 0 ? 0 : unseen);
    std::vector<WallPoint> points;
    for (const std::uint32_t i : labelled)
    {
        const SurfaceCell& c = cells.cells[i];
        const Eigen::Vector2d p = c.position.head<2>().cast<double>() - wall.start;
        const double s = t.dot(p), d = n.dot(p), z = static_cast<double>(c.position.z());
        if (s > wall.bodyStart_m - 0.05 && s < wall.bodyEnd_m + 0.05 && d > low && d < high && z > wall.base_m - 0.05 &&
            z < wall.base_m + wall.height.value_m + 0.05)
            points.push_back({s, d, z, std::abs(n.dot(c.normal.head<2>().cast<double>())), c.count});
    }
    return points;
}

std::vector<Cluster> clustersOf(const std::vector<WallPoint>& points, double radius)
{
    std::vector<Eigen::Vector2d> plane;
    plane.reserve(points.size());
    for (const WallPoint& p : points)
        plane.emplace_back(p.s, p.z);
    const std::vector<int> id = dbscan(plane, radius, 4);
    std::map<int, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < id.size(); ++i)
        if (id[i] >= 0)
            members[id[i]].push_back(i);
    std::vector<Cluster> clusters;
    for (const auto& [k, list] : members)
    {
        std::vector<double> s, z;
        Cluster c;
        for (const std::size_t i : list)
        {
            s.push_back(points[i].s), z.push_back(points[i].z);
            c.points += points[i].count;
        }
        c.cells = list.size();
        c.begin = quantile(s, 0.005), c.end = quantile(s, 0.995);
        c.bottom = quantile(z, 0.005), c.top = quantile(z, 0.995);
        clusters.push_back(c);
    }
    std::sort(clusters.begin(), clusters.end(), [](const Cluster& a, const Cluster& b) { return std::tie(a.begin, a.bottom) < std::tie(b.begin, b.bottom); });
    return clusters;
}

void join(Cluster& a, const Cluster& b)
{
    a.begin = std::min(a.begin, b.begin), a.end = std::max(a.end, b.end);
    a.bottom = std::min(a.bottom, b.bottom), a.top = std::max(a.top, b.top);
    a.points += b.points, a.cells += b.cells;
}

/// Share of the wall's faces between two places, and between two heights, that is covered by wall points.
class FaceCover
{
public:
    FaceCover(const SurfaceCells& cells, const std::vector<std::uint32_t>& wallCells, const Wall& wall)
        : m_columns(std::max(1, static_cast<int>(wall.bodyEnd_m / kStep) + 2)), m_rows(std::max(1, static_cast<int>(wall.height.value_m / kStep) + 2)),
          m_base(wall.base_m), m_covered(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows), 0)
    {
        const Eigen::Vector2d t = wall.direction(), n = wall.normal();
        for (const std::uint32_t i : wallCells)
        {
            const SurfaceCell& c = cells.cells[i];
            const Eigen::Vector2d p = c.position.head<2>().cast<double>() - wall.start;
            if (std::abs(n.dot(p)) > wall.thickness.value_m / 2 + 0.04)
                continue;
            const int x = static_cast<int>(std::floor(t.dot(p) / kStep)), y = static_cast<int>(std::floor((static_cast<double>(c.position.z()) - m_base) / kStep));
            if (x >= 0 && x < m_columns && y >= 0 && y < m_rows)
                m_covered[static_cast<std::size_t>(x) + static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(y)] = 1;
        }
    }
    [[nodiscard]] double share(double begin, double end, double bottom, double top) const
    {
        int hits = 0, all = 0;
        for (int x = std::max(0, static_cast<int>(begin / kStep)); x < std::min(m_columns, static_cast<int>(std::ceil(end / kStep))); ++x)
            for (int y = std::max(0, static_cast<int>((bottom - m_base) / kStep)); y < std::min(m_rows, static_cast<int>(std::ceil((top - m_base) / kStep))); ++y)
                hits += m_covered[static_cast<std::size_t>(x) + static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(y)], ++all;
        return all ? static_cast<double>(hits) / all : 0.0;
    }

private:
    static constexpr double kStep = 0.08;
    int m_columns, m_rows;
    double m_base;
    std::vector<std::uint8_t> m_covered;
};

}  // namespace

OpeningResult findOpenings(const SurfaceCells& cells, const Level& level, const std::vector<Wall>& walls, OpeningKind kind,
                           std::uint32_t& nextId, const OpeningParams& params, const Context& context)
{
    OpeningResult result;
    const Label label = kind == OpeningKind::Door ? Label::Door : Label::Window;
    std::vector<std::uint32_t> labelled, wallCells;
    for (std::size_t i = 0; i < cells.cells.size(); ++i)
    {
        const SurfaceCell& c = cells.cells[i];
        const double z = static_cast<double>(c.position.z());
        if (z < level.floor_m - 0.1 || z > level.ceiling_m + 0.1)
            continue;
        if (c.label == label)
            labelled.push_back(static_cast<std::uint32_t>(i));
        else if (c.label == Label::Wall)
            wallCells.push_back(static_cast<std::uint32_t>(i));
    }
    if (labelled.empty())
        return result;
    const double minimumWidth = kind == OpeningKind::Door ? params.minimumDoorWidth_m : params.minimumWindowWidth_m;
    const double minimumHeight = kind == OpeningKind::Door ? params.minimumDoorHeight_m : params.minimumWindowHeight_m;
    const double radius = std::max(params.clusterRadius_m, 2.5 * cells.size_m);
    for (const Wall& wall : walls)
    {
        context.checkCancelled();
        if (wall.bulge != 0)
            continue;
        // Strictly inside the body: a lining on the face or a leaf beside it is no part of the hole.
        const std::vector<WallPoint> inside = pointsInBody(labelled, cells, wall, -std::min(0.015, wall.thickness.value_m / 6));
        if (inside.size() < 10)
            continue;
        std::vector<Cluster> clusters = clustersOf(inside, radius);
        const FaceCover cover(cells, wallCells, wall);
        // Two jambs of one hole: nothing of the wall's faces between them.
        for (std::size_t i = 0; i + 1 < clusters.size();)
        {
            const Cluster& a = clusters[i];
            const Cluster& b = clusters[i + 1];
            const double from = std::min(a.end, b.end), to = std::max(a.begin, b.begin);
            const double bottom = std::max(a.bottom, b.bottom), top = std::min(a.top, b.top);
            const bool overlap = to - from < 0.05;
            const bool oneHole = overlap || (top - bottom > 0.5 && std::max(a.end, b.end) - a.begin < params.maximumDoorWidth_m &&
                                             (kind == OpeningKind::Door || to - from < 1.0) &&
                                             cover.share(from, to, bottom + 0.1, top - 0.2) < 0.15);
            if (oneHole)
            {
                join(clusters[i], clusters[i + 1]);
                clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(i) + 1);
            }
            else
                ++i;
        }
        for (const Cluster& c : clusters)
        {
            const double width = c.end - c.begin, height = c.top - (kind == OpeningKind::Door ? wall.base_m : c.bottom);
            if (width < minimumWidth || height < minimumHeight || c.cells < 20)
                continue;
            Opening o;
            o.host = wall.id;
            o.kind = kind;
            o.offset_m = c.begin;
            o.width = {width, Provenance::Measured, 0.0};
            // A door stands on the floor; a window has its sill where its lowest points are.
            const double sill = kind == OpeningKind::Door ? 0.0 : std::max(0.0, c.bottom - wall.base_m);
            o.sill = {sill, Provenance::Measured, 0.0};
            o.height = {std::min(c.top, wall.base_m + wall.height.value_m) - wall.base_m - sill, Provenance::Measured, 0.0};
            o.evidence.points = c.points;
            o.evidence.labelShare = 1.0;
            result.openings.push_back(o);
        }
    }
    // One hole belongs to one wall: where two claim the same place, the one with more points has it.
    std::vector<std::size_t> order(result.openings.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b)
              { return std::tuple(result.openings[b].evidence.points, a) < std::tuple(result.openings[a].evidence.points, b); });
    const auto centre = [&](const Opening& o) -> Eigen::Vector2d
    {
        const auto w = std::find_if(walls.begin(), walls.end(), [&](const Wall& v) { return v.id == o.host; });
        return w->start + w->direction() * (o.offset_m + o.width.value_m / 2);
    };
    std::vector<Opening> kept;
    for (const std::size_t i : order)
        if (std::none_of(kept.begin(), kept.end(), [&](const Opening& k)
                         { return k.host != result.openings[i].host && (centre(k) - centre(result.openings[i])).norm() < 0.5 * std::max(k.width.value_m, result.openings[i].width.value_m); }))
            kept.push_back(result.openings[i]);
    std::sort(kept.begin(), kept.end(), [](const Opening& a, const Opening& b) { return std::tie(a.host, a.offset_m) < std::tie(b.host, b.offset_m); });
    for (Opening& o : kept)
        o.id = ElementId{nextId++};
    result.openings = std::move(kept);
    return result;
}

}  // namespace s2b

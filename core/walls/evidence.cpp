// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/evidence.h"

#include "core/walls/sloped_top.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace s2b
{
namespace
{

constexpr double kTileCells = 1.5;  // edge of a coverage tile in surface cells

/// Area of the face between two places along it [m2], of tiles with at least one cell.
///
/// Tiles are a bin and a row, or as many of them as the spacing of the points needs: a thin scan of a whole face covers
/// it as well.
double coveredArea(const Face& face, double from, double to, double cell_m)
{
    const auto bins = static_cast<std::size_t>(std::max(1.0, std::ceil(kTileCells * cell_m / Face::kBin_m)));
    const int rows = std::max(1, static_cast<int>(std::ceil(kTileCells * cell_m / Face::kRow_m)));
    std::size_t tiles = 0;
    for (std::size_t first = 0; first < face.rows.size(); first += bins)
    {
        std::uint64_t seen = 0;
        std::size_t inside = 0;
        for (std::size_t b = first; b < std::min(first + bins, face.rows.size()); ++b)
            if (const double s = face.begin + (static_cast<double>(b) + 0.5) * Face::kBin_m; s > from && s < to)
                seen |= face.rows[b], ++inside;
        for (int row = 0; row < 64; row += rows)
            if (seen >> row & ((1ull << rows) - 1))
                tiles += inside * static_cast<std::size_t>(rows);
    }
    return static_cast<double>(tiles) * Face::kRow_m * Face::kBin_m;
}

double coveredArea(const Face& face, const WallBody& body, double cell_m)
{
    return coveredArea(face, body.begin, body.end, cell_m);
}

/// Share of its places' area that the face's cells cover.
double fillOf(const Face& face, double cell_m)
{
    const double area = coveredArea(face, face.begin, face.end, cell_m);
    return area <= 0 ? 0.0 : face.area_m2 / area;
}

/// Of one face.
double areaOf(const WallBody& body)
{
    if (body.topEdge.empty())
        return std::max(0.01, (body.end - body.begin) * (body.top - body.bottom));
    double area = 0;
    const std::vector<Eigen::Vector2d> edge = topBetween(body.topEdge, body.begin, body.end);
    for (std::size_t i = 0; i + 1 < edge.size(); ++i)
        area += (edge[i + 1].x() - edge[i].x()) * ((edge[i].y() + edge[i + 1].y()) / 2 - body.bottom);
    return std::max(0.01, area);
}

/// The left face's (high) and the right face's (low) parts, each once.
std::array<std::set<std::uint32_t>, 2> sidesOf(const WallBody& body)
{
    return {std::set(body.highFaces.begin(), body.highFaces.end()),
            std::set(body.lowFaces.begin(), body.lowFaces.end())};
}

}  // namespace

Evidence evidenceOf(const WallBody& body, const std::vector<Face>& faces, double cell_m)
{
    Evidence e;
    e.facesSeen = body.lowSeen + body.highSeen;
    double weight = 0, square = 0, label = 0;
    const auto sides = sidesOf(body);
    for (std::size_t side = 0; side < sides.size(); ++side)
    {
        double covered = 0;
        for (const std::uint32_t f : sides[side])
        {
            const Face& face = faces[f];
            e.points += face.points;
            weight += face.area_m2;
            square += face.area_m2 * face.rms_m * face.rms_m;
            label += face.area_m2 * face.wallShare;
            covered += coveredArea(face, body, cell_m);
        }
        e.faceCoverage[side] = std::clamp(covered / areaOf(body), 0.0, 1.0);
    }
    if (weight > 0)
        e.rms_m = std::sqrt(square / weight), e.labelShare = label / weight;
    return e;
}

double seenShare(const WallBody& body, const std::vector<Face>& faces, double cell_m)
{
    // Cells of a surface at the scan's own spacing fill their places; a third of that is still a surface seen from
    // afar.
    constexpr double fullFill = 0.35;
    double best = 0;
    for (const std::set<std::uint32_t>& side : sidesOf(body))
    {
        double covered = 0;
        for (const std::uint32_t f : side)
            covered += coveredArea(faces[f], body, cell_m) * std::min(1.0, fillOf(faces[f], cell_m) / fullFill);
        best = std::max(best, covered / areaOf(body));
    }
    return best;
}

}  // namespace s2b

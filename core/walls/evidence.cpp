// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/evidence.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <set>

namespace s2b
{
namespace
{

/// Area of the face within the body [m2], of places with at least one cell.
double coveredArea(const Face& face, const WallBody& body)
{
    double area = 0;
    for (std::size_t b = 0; b < face.rows.size(); ++b)
    {
        const double s = face.begin + (static_cast<double>(b) + 0.5) * Face::kBin_m;
        if (s > body.begin && s < body.end)
            area += std::popcount(face.rows[b]) * Face::kRow_m * Face::kBin_m;
    }
    return area;
}

/// Share of its places' area that the face's cells cover.
double fillOf(const Face& face)
{
    std::size_t places = 0;
    for (const std::uint64_t rows : face.rows)
        places += static_cast<std::size_t>(std::popcount(rows));
    return places == 0 ? 0.0 : face.area_m2 / (static_cast<double>(places) * Face::kRow_m * Face::kBin_m);
}

double areaOf(const WallBody& body)
{
    return std::max(0.01, (body.end - body.begin) * (body.top - body.bottom));
}

/// The left face's (high) and the right face's (low) parts, each once.
std::array<std::set<std::uint32_t>, 2> sidesOf(const WallBody& body)
{
    return {std::set(body.highFaces.begin(), body.highFaces.end()),
            std::set(body.lowFaces.begin(), body.lowFaces.end())};
}

}  // namespace

Evidence evidenceOf(const WallBody& body, const std::vector<Face>& faces)
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
            covered += coveredArea(face, body);
        }
        e.faceCoverage[side] = std::clamp(covered / areaOf(body), 0.0, 1.0);
    }
    if (weight > 0)
        e.rms_m = std::sqrt(square / weight), e.labelShare = label / weight;
    return e;
}

double seenShare(const WallBody& body, const std::vector<Face>& faces)
{
    // Cells of a surface at the scan's own spacing fill their places; a third of that is still a surface seen from
    // afar.
    constexpr double fullFill = 0.35;
    double best = 0;
    for (const std::set<std::uint32_t>& side : sidesOf(body))
    {
        double covered = 0;
        for (const std::uint32_t f : side)
            covered += coveredArea(faces[f], body) * std::min(1.0, fillOf(faces[f]) / fullFill);
        best = std::max(best, covered / areaOf(body));
    }
    return best;
}

}  // namespace s2b

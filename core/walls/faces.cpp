// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/faces.h"

#include "core/base/floor_to_int.h"
#include "core/walls/axis_sort.h"
#include "core/walls/face_lines.h"
#include "core/walls/face_sides.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>

namespace s2b
{
namespace
{

constexpr double kLeastFacing = 0.2;  // share of a face's cells that say from which side they were scanned

/// Gathers the storey's cells onto the faces: coverage, robust offset, labels.
class FaceGatherer
{
public:
    FaceGatherer(const std::vector<FaceLine>& lines, double tolerance) : m_tolerance(tolerance)
    {
        for (std::size_t k = 0; k < lines.size(); ++k)
        {
            const FaceLine& l = lines[k];
            const int steps = static_cast<int>(std::ceil((l.end - l.begin) / (0.5 * kTile))) + 1;
            std::uint64_t last = ~0ull;
            for (int i = 0; i <= steps; ++i)
                for (int side = -1; side <= 1; ++side)
                {
                    const double s = l.begin + (l.end - l.begin) * i / steps;
                    const std::uint64_t key = tileOf(l.t * s + l.n() * (l.offset + side * 0.04));
                    if (key == last)
                        continue;
                    last = key;
                    auto& list = m_tiles[key];
                    if (std::find(list.begin(), list.end(), static_cast<std::uint32_t>(k)) == list.end())
                        list.push_back(static_cast<std::uint32_t>(k));
                }
        }
    }
    /// FaceLine nearest to a cell within the tolerance, or -1.
    [[nodiscard]] int nearest(const std::vector<FaceLine>& lines, const Eigen::Vector2d& p,
                              const Eigen::Vector2d& normal) const
    {
        const auto tile = m_tiles.find(tileOf(p));
        if (tile == m_tiles.end())
            return -1;
        int best = -1;
        double bestDistance = m_tolerance;
        for (const std::uint32_t k : tile->second)
        {
            const FaceLine& l = lines[k];
            const double s = l.t.dot(p), d = std::abs(l.n().dot(p) - l.offset);
            if (d < bestDistance && s >= l.begin - 0.03 && s <= l.end + 0.03 && std::abs(l.n().dot(normal)) > 0.9)
                bestDistance = d, best = static_cast<int>(k);
        }
        return best;
    }

private:
    static constexpr double kTile = 0.25;
    [[nodiscard]] static std::uint64_t tileOf(const Eigen::Vector2d& p)
    {
        const auto part = [](double v)
        { return static_cast<std::uint64_t>(std::int64_t{floorToInt(v / kTile)} + (1 << 30)); };
        return part(p.x()) | part(p.y()) << 32;
    }
    double m_tolerance;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_tiles;
};

std::vector<Face> gather(const std::vector<FaceLine>& lines, const SurfaceCells& cells, const Level& level,
                         const WallParams& params)
{
    const FaceGatherer gatherer(lines, 1.5 * params.planeDistance_m);
    std::vector<Face> faces(lines.size());
    struct Sums
    {
        double w = 0, d = 0, dd = 0, wall = 0, cells = 0, all = 0, left = 0, right = 0;
    };
    std::vector<Sums> sums(lines.size());
    for (std::size_t k = 0; k < lines.size(); ++k)
    {
        faces[k].t = lines[k].t;
        faces[k].offset = lines[k].offset;
        faces[k].begin = lines[k].begin - 0.5 * cells.size_m;
        faces[k].end = lines[k].end + 0.5 * cells.size_m;
        faces[k].rows.assign(static_cast<std::size_t>(std::max(1.0, std::ceil(faces[k].length() / Face::kBin_m))), 0);
    }
    for (const SurfaceCell& c : cellsOf(cells, level))
    {
        const double z = static_cast<double>(c.position.z());
        if (c.normal.isZero() || std::abs(c.normal.z()) > 0.3f || z < level.floor_m ||
            z > level.highestCeiling_m() + 0.3)
            continue;
        const double weight = wallWeight(cells, c);
        // A model's doors and panes count among a face's cells: a leaf that it takes for wall in part is a leaf by the
        // rest, and glass that it sees in noise leaves the face whole.
        if (!cells.hasGuesses && (c.label == Label::Door || c.label == Label::Window))
            continue;
        const Eigen::Vector2d p = c.position.head<2>().cast<double>();
        const int k = gatherer.nearest(lines, p, c.normal.head<2>().cast<double>());
        if (k < 0)
            continue;
        Face& f = faces[static_cast<std::size_t>(k)];
        Sums& s = sums[static_cast<std::size_t>(k)];
        s.all += 1;
        if (weight <= 0)
            continue;
        const double d = f.n().dot(p) - f.offset, n = c.count;
        s.w += n, s.d += n * d, s.dd += n * d * d, s.cells += 1;
        // A model's labels count as much as they are sure; where it does not know, as much as not.
        s.wall += c.label == Label::Wall ? (cells.hasGuesses ? c.labelShare / 255.0 : 1.0)
                  : cells.hasGuesses     ? 0.5
                                         : 0.0;
        if (c.facesScanner)
            (f.n().dot(c.normal.head<2>().cast<double>()) > 0 ? s.left : s.right) += 1;
        f.points += c.count;
        const auto bin = static_cast<std::ptrdiff_t>(std::floor((f.t.dot(p) - f.begin) / Face::kBin_m));
        const auto row = static_cast<std::ptrdiff_t>(std::floor((z - level.floor_m) / Face::kRow_m));
        if (bin >= 0 && bin < static_cast<std::ptrdiff_t>(f.rows.size()) && row >= 0 && row < 64)
            f.rows[static_cast<std::size_t>(bin)] |= 1ull << row;
    }
    for (std::size_t k = 0; k < faces.size(); ++k)
    {
        const Sums& s = sums[k];
        if (s.w <= 0)
            continue;
        faces[k].offset += s.d / s.w;
        faces[k].rms_m = std::sqrt(std::max(0.0, s.dd / s.w - (s.d / s.w) * (s.d / s.w)));
        faces[k].wallShare = s.wall / s.all;
        faces[k].area_m2 = s.cells * cells.size_m * cells.size_m;
        if (s.left + s.right > kLeastFacing * s.cells &&
            std::max(s.left, s.right) > params.minimumAgreement * (s.left + s.right))
            faces[k].scannedSide = s.left > s.right ? 1 : -1;
    }
    std::erase_if(faces, [&](const Face& f) { return f.area_m2 < params.minimumFaceArea_m2; });
    return faces;
}

/// Walls reach the ceiling above them, at least where no opening interrupts them; leaves, cupboards and sills don't.
bool reachesCeiling(const Face& face, const PlanMask& mask)
{
    // No furniture is as long and as high as this, whatever roof is above it.
    constexpr double tall_m = 2.3, long_m = 2.5;
    std::size_t seen = 0, reaching = 0, tall = 0;
    for (std::size_t b = 0; b < face.rows.size(); ++b)
    {
        if (!face.rows[b])
            continue;
        tall += Face::kRow_m * (64 - std::countl_zero(face.rows[b])) >= tall_m;
        const double s = face.begin + (static_cast<double>(b) + 0.5) * Face::kBin_m;
        double overhead = -1;
        for (const double d : {-0.45, -0.2, 0.2, 0.45})
            overhead = std::max(overhead, mask.overhead_m(face.at(s) + d * face.n()));
        if (overhead < 0)
            overhead = 1.6;  // nothing above it was seen (outdoors, no ceiling): as high as a person will do
        ++seen;
        reaching += Face::kRow_m * (64 - std::countl_zero(face.rows[b])) >= overhead - 0.3;
    }
    return 2 * reaching > seen || static_cast<double>(tall) * Face::kBin_m > long_m;
}

/// Is it a face of a wall, or of something that stands in the room or hangs on a wall? Labels and shape weigh each
/// other: what has a wall's shape needs few labels, what hasn't needs many; without labels the shape decides.
bool isWallFace(const Face& face, const SurfaceCells& cells, const PlanMask& mask)
{
    const bool reaches = reachesCeiling(face, mask);
    if (!cells.hasLabels)
        return reaches;
    // A leaf that stands open looks like a piece of wall to a model; what is longer is a parapet.
    constexpr double leaf_m = 1.3;
    if (!reaches && cells.hasGuesses && face.length() < leaf_m)
        return false;
    return reaches ? face.wallShare > 0.4 : face.wallShare > 0.8 && face.area_m2 > 0.4;
}

/// The longer face that this one lies behind, where that one has a hole: of a pane, frame, leaf or niche within a wall
/// that wall's face; null of other faces. A strip above panes shows its lintel's underside on the one side and the
/// room's ceiling on the other: where it can't tell its own side, the pane's is taken.
const Face* frontOf(const Face& face, const std::vector<Face>& faces)
{
    for (const Face& front : faces)
    {
        const int side = front.side != 0 ? front.side : face.side;
        if (&front == &face || side == 0 || std::abs(front.t.dot(face.n())) > 0.03 ||
            front.length() < 1.2 * face.length())
            continue;
        const double behind = (front.offset - face.offset) * side;
        if (behind < 0.015 || behind > 0.5 ||
            std::min(front.end, face.end) - std::max(front.begin, face.begin) < 0.8 * face.length())
            continue;
        std::size_t bins = 0, missing = 0;
        for (std::size_t b = 0; b < face.rows.size(); ++b)
        {
            const double s = face.begin + (static_cast<double>(b) + 0.5) * Face::kBin_m;
            const auto k = static_cast<std::ptrdiff_t>((s - front.begin) / Face::kBin_m);
            if (!face.rows[b] || k < 0 || k >= static_cast<std::ptrdiff_t>(front.rows.size()))
                continue;
            ++bins;
            // The front one is missing where this one is, and goes on above it.
            const std::uint64_t rows = front.rows[static_cast<std::size_t>(k)];
            missing += 10 * std::popcount(rows & face.rows[b]) < 4 * std::popcount(face.rows[b]) && rows > face.rows[b];
        }
        if (bins > 0 && 2 * missing > bins)
            return &front;
    }
    return nullptr;
}

/// Was another face scanned from the other side, a wall's thickness behind this one?
bool hasOtherSide(const Face& face, const std::vector<Face>& faces, const WallParams& params)
{
    return face.scannedSide != 0 &&
           std::any_of(faces.begin(), faces.end(),
                       [&](const Face& o)
                       {
                           const double behind = (face.offset - o.offset) * face.scannedSide;
                           return std::abs(face.t.dot(o.n())) < 0.03 && o.scannedSide == -face.scannedSide &&
                                  behind > params.minimumThickness_m && behind < params.maximumThickness_m &&
                                  std::min(face.end, o.end) - std::max(face.begin, o.begin) > 0.5 * face.length();
                       });
}

/// Without labels, what shows no floor or ceiling of this storey beside it stands outside: trees, fences, other
/// buildings.
bool isOutside(const Face& face, const PlanMask& mask)
{
    const Eigen::Vector2d a = face.at(face.begin), b = face.at(face.end);
    const auto roomBeside = [&](double low, double high)
    { return std::max(mask.share(a, b, low, high, PlanMask::Ceiling), mask.share(a, b, low, high, PlanMask::Floor)); };
    // What was scanned from under the ceiling, though not up to the face, was scanned from inside.
    constexpr double far_m = 2.0;
    if (face.scannedSide != 0 && mask.share(a, b, face.scannedSide > 0 ? 0.05 : -far_m,
                                            face.scannedSide > 0 ? far_m : -0.05, PlanMask::Ceiling) >= 0.15)
        return false;
    return std::max(roomBeside(0.05, 0.8), roomBeside(-0.8, -0.05)) < 0.15;
}

}  // namespace

std::vector<Face> findFaces(const SurfaceCells& cells, const Level& level, const PlanMask& mask,
                            const WallParams& params, const Context& context)
{
    const std::vector<FaceLine> lines = findLines(cells, level, params, context);
    std::vector<Face> faces = gather(lines, cells, level, params);
    std::erase_if(faces, [&](const Face& f) { return !isWallFace(f, cells, mask); });
    for (Face& f : faces)
        f.isLow = !reachesCeiling(f, mask);
    findSides(faces, mask, params.mergeOffset_m);
    std::vector<int> side;
    std::vector<char> isRecessed(faces.size(), 0);
    for (const Face& f : faces)
        side.push_back(f.side);
    for (std::size_t i = 0; i < faces.size(); ++i)
        if (const Face* front = frontOf(faces[i], faces))
        {
            isRecessed[i] = 1;
            if (front->side == 0)
                side[static_cast<std::size_t>(front - faces.data())] = faces[i].side;
        }
    std::vector<Face> kept;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
        Face& f = faces[i];
        f.side = side[i];
        if (!isRecessed[i] && (cells.labelsAreSure() || !isOutside(f, mask) || hasOtherSide(f, faces, params)))
            kept.push_back(f);
    }
    return kept;
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/wall_mesh.h"

#include "core/model/wall_top.h"
#include "tests/simulator/axis_curve.h"
#include "tests/simulator/opening_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace s2b::sim
{

namespace
{

constexpr double kFrame_m = 0.05;       ///< width of a frame's profile
constexpr double kArchitrave_m = 0.06;  ///< width of the board round a door, on the wall's face
constexpr double kArchitraveDepth_m = 0.012;
constexpr double kSame_m = 1e-6;

/// Where the mesh of a wall's end lies along its axis.
double meshEnd(const Building& building, const Wall& wall, JunctionEnd end)
{
    const AxisCurve curve(wall);
    const bool isEnd = end == JunctionEnd::End;
    const double body = isEnd ? curve.length() - wall.bodyEnd_m : wall.bodyStart_m;
    double gap = body;
    if (body > 0.0)
        for (const Junction& junction : building.junctions)
        {
            const bool isA = junction.wallA == wall.id && junction.endA == end;
            const bool isB = junction.wallB == wall.id && junction.endB == end;
            const Wall* other = isA ? building.wall(junction.wallB) : isB ? building.wall(junction.wallA) : nullptr;
            if (other == nullptr)
                continue;
            gap = std::min(
                gap, endGap(curve, wall.thickness.value_m, isEnd, AxisCurve(*other), other->thickness.value_m).mesh_m);
        }
    return isEnd ? curve.length() - gap : gap;
}

void sortUnique(std::vector<double>& values)
{
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end(), [](double a, double b) { return b - a < kSame_m; }),
                 values.end());
}

struct Hole
{
    double s0, s1, z0, z1;
};

}  // namespace

void addWallMesh(Scene& scene, const Building& building, const Wall& wall, const std::vector<const Opening*>& openings,
                 std::uint32_t element)
{
    const AxisCurve curve(wall);
    const Surface surface{element, Label::Wall, Material::Opaque};
    const double h = wall.thickness.value_m / 2.0;
    const double from = meshEnd(building, wall, JunctionEnd::Start);
    const double to = meshEnd(building, wall, JunctionEnd::End);

    std::vector<Hole> holes;
    std::vector<double> along = curve.samples(from, to);
    std::vector<double> up{wall.base_m};
    for (const Opening* opening : openings)
    {
        const double z = wall.base_m + opening->sill.value_m;
        holes.push_back(
            {opening->offset_m, opening->offset_m + opening->width.value_m, z, z + opening->height.value_m});
        along.insert(along.end(), {holes.back().s0, holes.back().s1});
        up.insert(up.end(), {holes.back().z0, holes.back().z1});
    }
    for (const Eigen::Vector2d& p : wall.topProfile)
        if (p.x() > from && p.x() < to)
            along.push_back(p.x());
    sortUnique(along);
    sortUnique(up);
    const auto at = [&](double s, double offset, double z)
    {
        const Eigen::Vector2d p = curve.at(s, offset);
        return Eigen::Vector3d(p.x(), p.y(), z);
    };
    const auto inHole = [&](double s, double z)
    {
        return std::any_of(holes.begin(), holes.end(),
                           [&](const Hole& o) { return s > o.s0 && s < o.s1 && z > o.z0 && z < o.z1; });
    };

    for (std::size_t i = 0; i + 1 < along.size(); ++i)
    {
        const double a = along[i];
        const double b = along[i + 1];
        for (std::size_t k = 0; k < up.size(); ++k)
        {
            // The last row reaches to the top edge, which may slope.
            const bool isLast = k + 1 == up.size();
            const double low = up[k];
            const double highA = isLast ? topAt(wall, a) : up[k + 1];
            const double highB = isLast ? topAt(wall, b) : up[k + 1];
            if (std::max(highA, highB) - low < kSame_m || inHole((a + b) / 2.0, (low + std::min(highA, highB)) / 2.0))
                continue;
            scene.addQuad(at(b, h, low), at(a, h, low), at(a, h, highA), at(b, h, highB), surface);
            scene.addQuad(at(a, -h, low), at(b, -h, low), at(b, -h, highB), at(a, -h, highA), surface);
        }
        scene.addQuad(at(a, -h, topAt(wall, a)), at(b, -h, topAt(wall, b)), at(b, h, topAt(wall, b)),
                      at(a, h, topAt(wall, a)), surface);
        for (const Hole& o : holes)
        {
            if ((a + b) / 2.0 < o.s0 || (a + b) / 2.0 > o.s1)
                continue;
            scene.addQuad(at(a, h, o.z1), at(b, h, o.z1), at(b, -h, o.z1), at(a, -h, o.z1), surface);
            if (o.z0 > wall.base_m + kSame_m)
                scene.addQuad(at(a, -h, o.z0), at(b, -h, o.z0), at(b, h, o.z0), at(a, h, o.z0), surface);
        }
    }
    for (const Hole& o : holes)
    {
        scene.addQuad(at(o.s0, -h, o.z0), at(o.s0, h, o.z0), at(o.s0, h, o.z1), at(o.s0, -h, o.z1), surface);
        scene.addQuad(at(o.s1, h, o.z0), at(o.s1, -h, o.z0), at(o.s1, -h, o.z1), at(o.s1, h, o.z1), surface);
    }
    scene.addQuad(at(from, h, wall.base_m), at(from, -h, wall.base_m), at(from, -h, topAt(wall, from)),
                  at(from, h, topAt(wall, from)), surface);
    scene.addQuad(at(to, -h, wall.base_m), at(to, h, wall.base_m), at(to, h, topAt(wall, to)),
                  at(to, -h, topAt(wall, to)), surface);
}

void addDoorMesh(Scene& scene, const Wall& wall, const Opening& opening, std::uint32_t element, double angle_deg)
{
    const OpeningFrame frame(scene, wall, opening, {element, Label::Door, Material::Opaque});
    const double w = opening.width.value_m;
    const double z = opening.height.value_m;
    const double h = wall.thickness.value_m / 2.0;
    frame.box(0.0, kFrame_m, -h, h, 0.0, z);
    frame.box(w - kFrame_m, w, -h, h, 0.0, z);
    frame.box(kFrame_m, w - kFrame_m, -h, h, z - kFrame_m, z);
    for (const double side : {-1.0, 1.0})
    {
        const double y0 = side > 0.0 ? h : -h - kArchitraveDepth_m;
        frame.box(-kArchitrave_m, 0.0, y0, y0 + kArchitraveDepth_m, 0.0, z);
        frame.box(w, w + kArchitrave_m, y0, y0 + kArchitraveDepth_m, 0.0, z);
        frame.box(-kArchitrave_m, w + kArchitrave_m, y0, y0 + kArchitraveDepth_m, z, z + kArchitrave_m);
    }
    if (opening.leafState == LeafState::Removed)
        return;
    const bool isDouble = opening.leaves == 2;
    const double width = (w - 2.0 * kFrame_m) / (isDouble ? 2.0 : 1.0);
    const double side = opening.opensToLeft ? 1.0 : -1.0;
    constexpr double kLeaf_m = OpeningFrame::kLeaf_m;
    const double y = side * (h - kLeaf_m / 2.0);
    const double angle = opening.leafState == LeafState::Open ? angle_deg * std::numbers::pi / 180.0 : 0.0;
    const auto leaf = [&](bool hingeAtStart)
    {
        frame.leaf(hingeAtStart ? kFrame_m : w - kFrame_m, y,
                   {(hingeAtStart ? 1.0 : -1.0) * std::cos(angle), side * std::sin(angle)}, width, 0.008,
                   z - kFrame_m - 0.005);
    };
    if (isDouble || opening.hingeAtStart)
        leaf(true);
    if (isDouble || !opening.hingeAtStart)
        leaf(false);
}

void addWindowMesh(Scene& scene, const Wall& wall, const Opening& opening, std::uint32_t element)
{
    constexpr double kHalfDepth_m = 0.035;
    constexpr double kSill_m = 0.02;
    const OpeningFrame frame(scene, wall, opening, {element, Label::Window, Material::Opaque});
    const double w = opening.width.value_m;
    const double z = opening.height.value_m;
    const double h = wall.thickness.value_m / 2.0;
    const double d = std::min(kHalfDepth_m, h);
    frame.box(0.0, kFrame_m, -d, d, 0.0, z);
    frame.box(w - kFrame_m, w, -d, d, 0.0, z);
    frame.box(kFrame_m, w - kFrame_m, -d, d, 0.0, kFrame_m);
    frame.box(kFrame_m, w - kFrame_m, -d, d, z - kFrame_m, z);
    if (w > 1.1)
        frame.box(w / 2.0 - kFrame_m / 2.0, w / 2.0 + kFrame_m / 2.0, -d, d, kFrame_m, z - kFrame_m);
    if (opening.sill.value_m > 0.3 && h > d)
    {
        frame.box(0.0, w, d, h + 0.04, 0.0, kSill_m);
        frame.box(0.0, w, -h - 0.04, -d, 0.0, kSill_m);
    }
    scene.addQuad(frame.at(kFrame_m, 0.0, kFrame_m), frame.at(w - kFrame_m, 0.0, kFrame_m),
                  frame.at(w - kFrame_m, 0.0, z - kFrame_m), frame.at(kFrame_m, 0.0, z - kFrame_m),
                  {element, Label::Window, Material::Glass});
}

}  // namespace s2b::sim

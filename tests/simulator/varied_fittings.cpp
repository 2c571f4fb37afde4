// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/opening_frame.h"
#include "tests/simulator/variety.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace s2b::sim
{

namespace
{

struct DoorStyle
{
    explicit DoorStyle(std::uint64_t style)
    {
        Random random{style, 0xd57};
        hasFrame = random.chance(0.93);
        width_m = random.uniform(0.03, 0.1);
        isDeep = random.chance(0.7);
        depth_m = random.uniform(0.06, 0.14);
        proud_m = random.chance(0.5) ? random.uniform(0.0, 0.02) : 0.0;
        architrave_m = random.chance(0.6) ? random.uniform(0.04, 0.1) : 0.0;
        architraveDepth_m = random.uniform(0.006, 0.02);
        leaf_m = random.uniform(0.03, 0.06);
        position = random.pick(std::vector<double>{1.0, 1.0, 0.0, -1.0, 0.5});
        isPanelled = random.chance(0.3);
    }
    bool hasFrame, isDeep, isPanelled;
    double width_m, depth_m, proud_m, architrave_m, architraveDepth_m, leaf_m;
    double position;  ///< of the leaf in the wall's thickness: 1 flush with the side that it opens to, 0 in the middle
};

struct WindowStyle
{
    explicit WindowStyle(std::uint64_t style)
    {
        Random random{style, 0x357};
        frame_m = random.uniform(0.03, 0.11);
        halfDepth_m = random.uniform(0.02, 0.06);
        position = random.pick(std::vector<double>{0.0, 0.0, 0.9, -0.9, 0.5, -0.5});
        bay_m = random.uniform(0.5, 1.6);
        hasCasements = random.chance(0.5);
        hasTransom = random.chance(0.3);
        hasSill = random.chance(0.6);
        isDoubleGlazed = random.chance(0.6);
        hasFrame = random.chance(0.92);
        isOpaque = random.chance(0.15);
    }
    double frame_m, halfDepth_m, position, bay_m;
    bool hasCasements, hasTransom, hasSill, isDoubleGlazed, hasFrame;
    bool isOpaque;  ///< blinds, coated or dirty panes
};

/// A leaf of glass in a frame, or without one.
struct GlazedLeaf
{
    explicit GlazedLeaf(Random& random)
    {
        const bool hasFrame = random.chance(0.88);
        stile_m = hasFrame ? random.uniform(0.05, 0.14) : 0.0;
        topRail_m = hasFrame ? stile_m : random.chance(0.5) ? 0.06 : 0.0;
        bottomRail_m = hasFrame ? stile_m + (random.chance(0.5) ? random.uniform(0.0, 0.25) : 0.0) : topRail_m;
        if (hasFrame && random.chance(0.2))
            bottomRail_m = random.uniform(0.6, 1.1);  // solid below, glass above
        bars = hasFrame && random.chance(0.2) ? 1 + static_cast<int>(random.below(4)) : 0;
        isOpaque = random.chance(0.12);
        isDoubleGlazed = hasFrame && random.chance(0.4);
    }
    double stile_m, topRail_m, bottomRail_m;
    int bars;  ///< level ones across the glass
    bool isOpaque, isDoubleGlazed;
};

/// Where a leaf hangs: hinge, and the direction from it, in the opening's x, y.
struct Hinge
{
    double x, y;
    Eigen::Vector2d direction;
};

void addGlazedLeaf(const OpeningFrame& frame, const GlazedLeaf& leaf, const Hinge& hinge, double width, double half,
                   double top)
{
    const auto board = [&](double from, double to, double halfThickness, double z0, double z1, Material material)
    { frame.board(hinge.x, hinge.y, hinge.direction, from, to, halfThickness, z0, z1, material); };
    constexpr double kGap_m = 0.01;
    const double stile = std::min(leaf.stile_m, 0.3 * width);
    const double low = std::max(kGap_m, leaf.bottomRail_m);
    const double high = top - leaf.topRail_m;
    if (stile > 0.0)
    {
        board(0.0, stile, half, kGap_m, top, Material::Opaque);
        board(width - stile, width, half, kGap_m, top, Material::Opaque);
    }
    if (leaf.bottomRail_m > kGap_m)
        board(stile, width - stile, half, kGap_m, low, Material::Opaque);
    if (leaf.topRail_m > 0.0)
        board(stile, width - stile, half, high, top, Material::Opaque);
    for (int i = 1; i <= leaf.bars; ++i)
    {
        const double z = low + (high - low) * i / (leaf.bars + 1);
        board(stile, width - stile, 0.6 * half, z - 0.015, z + 0.015, Material::Opaque);
    }
    board(stile, width - stile, leaf.isDoubleGlazed ? 0.012 : 0.004, low, high,
          leaf.isOpaque ? Material::Opaque : Material::Glass);
}

void addHandle(const OpeningFrame& frame, const Hinge& hinge, double width, double half)
{
    frame.board(hinge.x, hinge.y, hinge.direction, width - 0.18, width - 0.06, half + 0.04, 1.03, 1.06);
}

/// A stretch of a glazed front that is a door.
struct DoorInFront
{
    double from, to, top;
};

}  // namespace

void addVariedDoor(Scene& scene, const Wall& wall, const Opening& opening, std::uint32_t element, std::uint64_t style,
                   Random random)
{
    const DoorStyle s(style);
    const OpeningFrame frame(scene, wall, opening, {element, Label::Door, Material::Opaque});
    const double w = opening.width.value_m;
    const double z = opening.height.value_m;
    const double h = wall.thickness.value_m / 2.0;
    const double side = opening.opensToLeft ? 1.0 : -1.0;
    const double inset = s.hasFrame ? s.width_m : 0.0;
    const double y = side * s.position * std::max(0.0, h - s.leaf_m / 2.0);
    if (s.hasFrame)
    {
        double low = -h - s.proud_m;
        double high = h + s.proud_m;
        if (!s.isDeep)
        {
            low = std::clamp(y - s.depth_m / 2.0, low, high);
            high = std::clamp(y + s.depth_m / 2.0, low, high);
        }
        frame.box(0.0, s.width_m, low, high, 0.0, z);
        frame.box(w - s.width_m, w, low, high, 0.0, z);
        frame.box(s.width_m, w - s.width_m, low, high, z - s.width_m, z);
    }
    if (s.architrave_m > 0.0 && s.hasFrame)
        for (const double face : {-1.0, 1.0})
        {
            const double y0 = face > 0.0 ? h : -h - s.architraveDepth_m;
            const double y1 = y0 + s.architraveDepth_m;
            frame.box(-s.architrave_m, 0.0, y0, y1, 0.0, z);
            frame.box(w, w + s.architrave_m, y0, y1, 0.0, z);
            frame.box(-s.architrave_m, w + s.architrave_m, y0, y1, z, z + s.architrave_m);
        }
    if (opening.leafState == LeafState::Removed)
        return;

    const bool isDouble = opening.leaves == 2;
    const double width = (w - 2.0 * inset) / (isDouble ? 2.0 : 1.0);
    const bool isOpen = opening.leafState == LeafState::Open;
    const double angle = isOpen ? random.uniform(15.0, 110.0) * std::numbers::pi / 180.0 : 0.0;
    const double hingeY = isOpen ? side * std::max(0.0, h - s.leaf_m / 2.0) : y;
    const bool isGlazed = random.chance(wall.isExternal ? 0.45 : 0.25);
    const GlazedLeaf glazed(random);
    const auto leaf = [&](bool atStart)
    {
        const Hinge hinge{
            atStart ? inset : w - inset, hingeY, {(atStart ? 1.0 : -1.0) * std::cos(angle), side * std::sin(angle)}};
        const double top = z - inset - 0.005;
        const double half = s.leaf_m / 2.0;
        if (isGlazed)
            addGlazedLeaf(frame, glazed, hinge, width, half, top);
        else
        {
            const auto board = [&](double from, double to, double halfThickness, double z0, double z1)
            { frame.board(hinge.x, hinge.y, hinge.direction, from, to, halfThickness, z0, z1); };
            board(0.0, width, half, 0.01, top);
            if (s.isPanelled)
            {
                board(0.14, width - 0.14, half + 0.01, 0.2, 0.9);
                board(0.14, width - 0.14, half + 0.01, 1.1, top - 0.15);
            }
        }
        addHandle(frame, hinge, width, half);
    };
    if (isDouble || opening.hingeAtStart)
        leaf(true);
    if (isDouble || !opening.hingeAtStart)
        leaf(false);
}

namespace
{

/// Panes, mullions and transoms between two heights of a stretch of a front.
void addGlazing(const OpeningFrame& frame, const WindowStyle& s, double from, double to, double low, double high,
                double y, double d, double mullion, Random& random)
{
    const int bays = std::max(1, static_cast<int>(std::lround((to - from) / s.bay_m)));
    const double bay = (to - from) / bays;
    std::vector<double> heights{low, high};
    const double size = high - low;
    if ((s.hasTransom && size > 1.1) || size > 2.5)
        heights.insert(heights.begin() + 1, size > 2.3 ? std::min(high - 0.35, 2.2) : high - 0.4);
    for (int i = 1; i < bays; ++i)
        frame.box(from + i * bay - mullion, from + i * bay + mullion, y - d, y + d, low, high);
    for (std::size_t k = 0; k + 1 < heights.size(); ++k)
    {
        if (k > 0)
            frame.box(from, to, y - d, y + d, heights[k] - mullion, heights[k] + mullion);
        for (int i = 0; i < bays; ++i)
        {
            double x0 = from + i * bay + (i > 0 ? mullion : 0.0);
            double x1 = from + (i + 1) * bay - (i + 1 < bays ? mullion : 0.0);
            double z0 = heights[k] + (k > 0 ? mullion : 0.0);
            double z1 = heights[k + 1] - (k + 2 < heights.size() ? mullion : 0.0);
            if (s.hasCasements && x1 - x0 > 0.3 && z1 - z0 > 0.3)
            {
                constexpr double kCasement_m = 0.05;
                const double y0 = y - d * 0.6;
                const double y1 = y + d + 0.015;
                frame.box(x0, x0 + kCasement_m, y0, y1, z0, z1);
                frame.box(x1 - kCasement_m, x1, y0, y1, z0, z1);
                frame.box(x0 + kCasement_m, x1 - kCasement_m, y0, y1, z0, z0 + kCasement_m);
                frame.box(x0 + kCasement_m, x1 - kCasement_m, y0, y1, z1 - kCasement_m, z1);
                x0 += kCasement_m;
                x1 -= kCasement_m;
                z0 += kCasement_m;
                z1 -= kCasement_m;
            }
            if (random.chance(0.04) || s.isOpaque)
                frame.box(x0, x1, y - 0.015, y + 0.015, z0, z1);  // a solid panel
            else if (s.isDoubleGlazed)
            {
                frame.pane(x0, x1, y - 0.012, z0, z1);
                frame.pane(x0, x1, y + 0.012, z0, z1);
            }
            else
                frame.pane(x0, x1, y, z0, z1);
        }
    }
}

/// Every second front that reaches the floor has a door, at one end or somewhere between.
std::optional<DoorInFront> drawDoorInFront(const Opening& opening, double frame_m, Random& random)
{
    const double room = opening.width.value_m - 2.0 * frame_m;
    const double height = opening.height.value_m - frame_m;
    if (opening.sill.value_m > 0.03 || height < 1.95 || room < 1.2 || !random.chance(0.55))
        return std::nullopt;
    const double most = room > 1.6 ? room - 0.4 : room;
    const double width =
        std::min(most, random.chance(0.25) && room > 2.2 ? random.uniform(1.5, 2.1) : random.uniform(0.8, 1.2));
    const double place = random.chance(0.3) ? 0.0 : random.chance(0.4) ? 1.0 : random.uniform(0.3, 0.7);
    const double from = frame_m + place * (room - width);
    const double top = height < 2.4 || random.chance(0.3) ? height : random.uniform(2.0, 2.2);
    return DoorInFront{from, from + width, top};
}

/// Posts and leaves of a door in a front, in the front's plane.
void addDoorInFront(const OpeningFrame& frame, const DoorInFront& door, double y, double d, bool opensToLeft,
                    Random& random)
{
    const double post = random.uniform(0.02, 0.08);
    frame.box(door.from, door.from + post, y - d, y + d, 0.0, door.top);
    frame.box(door.to - post, door.to, y - d, y + d, 0.0, door.top);
    frame.box(door.from + post, door.to - post, y - d, y + d, door.top - post, door.top);
    const GlazedLeaf glazed(random);
    const double half = random.uniform(0.02, 0.04);
    const bool isDouble = door.to - door.from > 1.35;
    const double width = (door.to - door.from - 2.0 * post) / (isDouble ? 2.0 : 1.0);
    const double angle = random.chance(0.2) ? random.uniform(15.0, 110.0) * std::numbers::pi / 180.0 : 0.0;
    const double side = opensToLeft ? 1.0 : -1.0;
    const bool isSolid = random.chance(0.1);
    const bool fromStart = random.chance(0.5);
    for (const bool atStart : {true, false})
    {
        if (!isDouble && atStart != fromStart)
            continue;
        const Hinge hinge{atStart ? door.from + post : door.to - post,
                          angle > 0.0 ? y + side * std::max(0.0, d - half) : y,
                          {(atStart ? 1.0 : -1.0) * std::cos(angle), side * std::sin(angle)}};
        if (isSolid)
            frame.board(hinge.x, hinge.y, hinge.direction, 0.0, width, half, 0.01, door.top - post);
        else
            addGlazedLeaf(frame, glazed, hinge, width, half, door.top - post - 0.005);
        addHandle(frame, hinge, width, half);
    }
}

}  // namespace

void addVariedWindow(Scene& scene, const Wall& wall, const Opening& opening, std::uint32_t element, std::uint64_t style,
                     Random random)
{
    const WindowStyle s(style);
    const OpeningFrame frame(scene, wall, opening, {element, Label::Window, Material::Opaque});
    const double w = opening.width.value_m;
    const double z = opening.height.value_m;
    const double h = wall.thickness.value_m / 2.0;
    const double d = std::min(s.halfDepth_m, h);
    const double y = s.position * (h - d);
    const double f = s.hasFrame ? std::min(s.frame_m, 0.2 * std::min(w, z)) : 0.0;
    Random doorRandom{style, 0xd1f, opening.id.value};
    const std::optional<DoorInFront> door = drawDoorInFront(opening, f, doorRandom);
    // What is left of the front beside the door.
    std::vector<std::pair<double, double>> stretches{{f, w - f}};
    if (door)
        stretches = {{f, door->from}, {door->to, w - f}};
    std::erase_if(stretches, [](const auto& stretch) { return stretch.second - stretch.first < 0.05; });
    if (s.hasFrame)
    {
        frame.box(0.0, f, y - d, y + d, 0.0, z);
        frame.box(w - f, w, y - d, y + d, 0.0, z);
        for (const auto& [from, to] : stretches)
            frame.box(from, to, y - d, y + d, 0.0, f);
        frame.box(f, w - f, y - d, y + d, z - f, z);
    }
    if (s.hasSill && opening.sill.value_m > 0.3)
    {
        if (h > y + d)
            frame.box(0.0, w, y + d, h + 0.03, 0.0, 0.02);
        if (h > d - y)
            frame.box(0.0, w, -h - 0.03, y - d, 0.0, 0.02);
    }
    const double mullion = s.hasFrame ? f / 2.0 : 0.005;
    for (const auto& [from, to] : stretches)
        addGlazing(frame, s, from, to, f, z - f, y, d, mullion, random);
    if (!door)
        return;
    if (door->top < z - f - 0.1)
        addGlazing(frame, s, door->from, door->to, door->top, z - f, y, d, mullion, random);
    addDoorInFront(OpeningFrame(scene, wall, opening, {element, Label::Door, Material::Opaque}), *door, y, d,
                   doorRandom.chance(0.5), doorRandom);
}

}  // namespace s2b::sim

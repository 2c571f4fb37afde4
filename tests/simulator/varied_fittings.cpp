// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/opening_frame.h"
#include "tests/simulator/variety.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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
    const bool isGlazed = random.chance(0.15);
    const auto leaf = [&](bool atStart)
    {
        const Eigen::Vector2d d((atStart ? 1.0 : -1.0) * std::cos(angle), side * std::sin(angle));
        const double x = atStart ? inset : w - inset;
        const double top = z - inset - 0.005;
        const double half = s.leaf_m / 2.0;
        if (isGlazed)
        {
            frame.board(x, hingeY, d, 0.0, 0.11, half, 0.01, top);
            frame.board(x, hingeY, d, width - 0.11, width, half, 0.01, top);
            frame.board(x, hingeY, d, 0.11, width - 0.11, half, 0.01, 0.25);
            frame.board(x, hingeY, d, 0.11, width - 0.11, half, top - 0.11, top);
            frame.board(x, hingeY, d, 0.11, width - 0.11, 0.004, 0.25, top - 0.11, Material::Glass);
        }
        else
        {
            frame.board(x, hingeY, d, 0.0, width, half, 0.01, top);
            if (s.isPanelled)
            {
                frame.board(x, hingeY, d, 0.14, width - 0.14, half + 0.01, 0.2, 0.9);
                frame.board(x, hingeY, d, 0.14, width - 0.14, half + 0.01, 1.1, top - 0.15);
            }
        }
        frame.board(x, hingeY, d, width - 0.18, width - 0.06, half + 0.04, 1.03, 1.06);
    };
    if (isDouble || opening.hingeAtStart)
        leaf(true);
    if (isDouble || !opening.hingeAtStart)
        leaf(false);
}

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
    if (s.hasFrame)
    {
        frame.box(0.0, f, y - d, y + d, 0.0, z);
        frame.box(w - f, w, y - d, y + d, 0.0, z);
        frame.box(f, w - f, y - d, y + d, 0.0, f);
        frame.box(f, w - f, y - d, y + d, z - f, z);
    }
    if (s.hasSill && opening.sill.value_m > 0.3)
    {
        if (h > y + d)
            frame.box(0.0, w, y + d, h + 0.03, 0.0, 0.02);
        if (h > d - y)
            frame.box(0.0, w, -h - 0.03, y - d, 0.0, 0.02);
    }
    const int bays = std::max(1, static_cast<int>(std::lround((w - 2 * f) / s.bay_m)));
    const double bay = (w - 2 * f) / bays;
    std::vector<double> heights{f, z - f};
    if ((s.hasTransom && z > 1.2) || z > 2.6)
        heights.insert(heights.begin() + 1, z > 2.4 ? std::min(z - 0.4, 2.2) : z - 0.45);
    const double mullion = s.hasFrame ? f / 2.0 : 0.005;
    for (int i = 1; i < bays; ++i)
        frame.box(f + i * bay - mullion, f + i * bay + mullion, y - d, y + d, f, z - f);
    for (std::size_t k = 0; k + 1 < heights.size(); ++k)
    {
        if (k > 0)
            frame.box(f, w - f, y - d, y + d, heights[k] - mullion, heights[k] + mullion);
        for (int i = 0; i < bays; ++i)
        {
            double x0 = f + i * bay + (i > 0 ? mullion : 0.0);
            double x1 = f + (i + 1) * bay - (i + 1 < bays ? mullion : 0.0);
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

}  // namespace s2b::sim

// SPDX-License-Identifier: GPL-3.0-or-later
/// Storeys laid out by hand: walls as the wall stage gives them, and level patches of surface cells.
#pragma once

#include "core/spaces/room_plan.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace s2b::test
{

inline Wall wallFrom(std::uint32_t id, const Eigen::Vector2d& start, const Eigen::Vector2d& end, double thickness = 0.2,
                     double height = 2.6, double base = 0.0)
{
    Wall w;
    w.id = ElementId{id};
    w.storey = ElementId{1};
    w.start = start;
    w.end = end;
    w.bodyEnd_m = (end - start).norm();
    w.thickness = {thickness, Provenance::Measured, 0.0};
    w.height = {height, Provenance::Measured, 0.0};
    w.base_m = base;
    return w;
}

/// Four walls whose inner faces are the rectangle's sides; those along x run through at the corners.
inline std::vector<Wall> boxOf(std::uint32_t firstId, const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                               double thickness = 0.2, double base = 0.0)
{
    const double h = thickness / 2;
    return {wallFrom(firstId, {low.x() - thickness, low.y() - h}, {high.x() + thickness, low.y() - h}, thickness, 2.6,
                     base),
            wallFrom(firstId + 1, {high.x() + h, low.y()}, {high.x() + h, high.y()}, thickness, 2.6, base),
            wallFrom(firstId + 2, {high.x() + thickness, high.y() + h}, {low.x() - thickness, high.y() + h}, thickness,
                     2.6, base),
            wallFrom(firstId + 3, {low.x() - h, high.y()}, {low.x() - h, low.y()}, thickness, 2.6, base)};
}

struct Patch
{
    Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();

    [[nodiscard]] bool has(const Eigen::Vector2d& p) const
    {
        return (p.array() > low.array()).all() && (p.array() < high.array()).all();
    }
};

/// Surface cells of 2.5 cm: level patches, and patches that slope along x.
class PlanScene
{
public:
    explicit PlanScene(bool hasLabels = true)
    {
        m_cells.size_m = 0.025;
        m_cells.spacing_m = 0.025;
        m_cells.hasLabels = hasLabels;
    }
    void level(const Patch& patch, double z, Label label, const std::vector<Patch>& without = {})
    {
        slope(patch, z, 0.0, label, without);
    }
    /// z at the patch's lower x, rising with x.
    void slope(const Patch& patch, double z, double rise, Label label, const std::vector<Patch>& without = {})
    {
        const Eigen::Vector3f normal = Eigen::Vector3d(-rise, 0, 1).normalized().cast<float>();
        const Eigen::Vector2d size = patch.high - patch.low;
        const auto nx = static_cast<int>(std::lround(size.x() / m_cells.size_m)),
                   ny = static_cast<int>(std::lround(size.y() / m_cells.size_m));
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x)
            {
                const Eigen::Vector2d p = patch.low + m_cells.size_m * Eigen::Vector2d(x + 0.5, y + 0.5);
                if (std::any_of(without.begin(), without.end(), [&](const Patch& hole) { return hole.has(p); }))
                    continue;
                SurfaceCell c;
                c.position = Eigen::Vector3d(p.x(), p.y(), z + rise * (p.x() - patch.low.x())).cast<float>();
                c.normal = normal;
                c.count = 2;
                c.label = label;
                c.labelShare = 255;
                m_cells.cells.push_back(c);
            }
    }
    /// Floor and ceiling of a room.
    void room(const Patch& patch, double floor = 0.0, double ceiling = 2.6)
    {
        level(patch, floor, Label::Floor);
        level(patch, ceiling, Label::Ceiling);
    }
    [[nodiscard]] PlanCells cells() const { return planCellsOf(m_cells); }

private:
    SurfaceCells m_cells;
};

inline Level levelAt(double floor, double ceiling, bool isSeen = true)
{
    Level level;
    level.floor_m = floor;
    level.ceiling_m = ceiling;
    level.ceilingSeen = isSeen;
    return level;
}

}  // namespace s2b::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/wall_planes.h"

#include "core/base/floor_to_int.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace s2b
{
namespace
{

constexpr float kUpright = 0.35f;  ///< largest |z| of an upright surface's normal
constexpr double kStrip_m = 0.02;  ///< across the planes
constexpr double kAlong_m = 0.20;  ///< along them
constexpr int kReach = 3;          ///< steps along to either side that a plane is looked for in
constexpr int kAcross = 15;        ///< strips to either side
constexpr double kUpper_m = 2.15;  ///< above the floor: over most doors and windows
constexpr double kBin_m = 0.15;    ///< of the heights that a surface has
constexpr int kBins = 32;

/// The upright cells that face one axis, in a grid across and along it.
class Facing
{
public:
    Facing(const CellSet& set, int axis) : m_set(set), m_axis(axis), m_other(1 - axis)
    {
        float low[2] = {1e30f, 1e30f}, high[2] = {-1e30f, -1e30f};
        for (std::uint32_t i = 0; i < set.cells.size(); ++i)
            if (faces(set.cells[i]))
            {
                m_members.push_back(i);
                for (int k = 0; k < 2; ++k)
                {
                    low[k] = std::min(low[k], set.cells[i].position[k]);
                    high[k] = std::max(high[k], set.cells[i].position[k]);
                }
            }
        if (m_members.empty())
            return;
        m_low[0] = static_cast<double>(low[m_axis]), m_low[1] = static_cast<double>(low[m_other]);
        m_strips = static_cast<int>((static_cast<double>(high[m_axis]) - m_low[0]) / kStrip_m) + 1;
        m_steps = static_cast<int>((static_cast<double>(high[m_other]) - m_low[1]) / kAlong_m) + 1;
        const std::size_t size = static_cast<std::size_t>(m_strips) * static_cast<std::size_t>(m_steps);
        m_area.assign(size, 0.0f);
        m_upper.assign(size, 0.0f);
        m_heights.assign(size, 0u);
        const auto area = static_cast<float>(set.size_m * set.size_m);
        for (const std::uint32_t i : m_members)
        {
            const std::size_t k = at(set.cells[i]);
            m_area[k] += area;
            if (static_cast<double>(set.cells[i].position.z()) - set.floor_m > kUpper_m)
                m_upper[k] += area;
            m_heights[k] |= 1u << bin(set.cells[i]);
        }
    }

    void describe(std::vector<WallPlane>& result, const Context& context)
    {
        if (m_members.empty())
            return;
        const double window_m = (2 * kReach + 1) * kAlong_m;
        const double clear_m = std::max(1.0, m_set.ceiling_m - m_set.floor_m);
        const std::vector<Peak> all = peaks(m_area, window_m * clear_m, context);
        const std::vector<Peak> upper = peaks(m_upper, window_m * std::max(0.3, clear_m - kUpper_m), context);
        parallelChunks(m_members.size(), 1u << 14, context,
                       [&](std::size_t begin, std::size_t end)
                       {
                           for (std::size_t m = begin; m < end; ++m)
                           {
                               const SurfaceCell& cell = m_set.cells[m_members[m]];
                               const std::size_t k = at(cell);
                               WallPlane& p = result[m_members[m]];
                               p.offset = all[k].offset, p.strength = all[k].strength, p.own = all[k].own;
                               p.upperOffset = upper[k].offset, p.upperStrength = upper[k].strength;
                               addHeights(cell, k, p);
                           }
                       });
    }

private:
    struct Peak
    {
        float offset = 0.0f, strength = 0.0f, own = 0.0f;
    };

    [[nodiscard]] bool faces(const SurfaceCell& c) const
    {
        return !c.normal.isZero() && std::abs(c.normal.z()) < kUpright &&
               (std::abs(c.normal.x()) >= std::abs(c.normal.y()) ? 0 : 1) == m_axis;
    }
    /// Steps along one strip lie together.
    [[nodiscard]] std::size_t at(const SurfaceCell& c) const
    {
        const int strip = static_cast<int>((static_cast<double>(c.position[m_axis]) - m_low[0]) / kStrip_m);
        const int step = static_cast<int>((static_cast<double>(c.position[m_other]) - m_low[1]) / kAlong_m);
        return static_cast<std::size_t>(strip) * static_cast<std::size_t>(m_steps) + static_cast<std::size_t>(step);
    }
    [[nodiscard]] int bin(const SurfaceCell& c) const
    {
        const double up = static_cast<double>(c.position.z()) - m_set.floor_m;
        return std::clamp(floorToInt(up / kBin_m) + 1, 0, kBins - 1);
    }

    /// The strongest plane about each place of the grid.
    [[nodiscard]] std::vector<Peak> peaks(const std::vector<float>& area, double full_m2, const Context& context) const
    {
        const auto steps = static_cast<std::size_t>(m_steps);
        std::vector<float> along(area.size(), 0.0f), plane(area.size(), 0.0f);
        const auto scale = static_cast<float>(1.0 / full_m2);
        for (int strip = 0; strip < m_strips; ++strip)
        {
            const float* row = area.data() + static_cast<std::size_t>(strip) * steps;
            float* out = along.data() + static_cast<std::size_t>(strip) * steps;
            for (int s = 0; s < m_steps; ++s)
            {
                float sum = 0.0f;
                for (int k = std::max(0, s - kReach); k <= std::min(m_steps - 1, s + kReach); ++k)
                    sum += row[k];
                out[s] = sum * scale;
            }
        }
        // Noise spreads a plane over its neighbouring strips.
        for (int strip = 0; strip < m_strips; ++strip)
            for (std::size_t s = 0; s < steps; ++s)
                for (int k = std::max(0, strip - 1); k <= std::min(m_strips - 1, strip + 1); ++k)
                    plane[static_cast<std::size_t>(strip) * steps + s] +=
                        along[static_cast<std::size_t>(k) * steps + s];
        std::vector<Peak> result(area.size());
        parallelChunks(static_cast<std::size_t>(m_strips), 32, context,
                       [&](std::size_t begin, std::size_t end)
                       {
                           for (std::size_t strip = begin; strip < end; ++strip)
                               for (std::size_t s = 0; s < steps; ++s)
                               {
                                   const std::size_t here = strip * steps + s;
                                   if (m_area[here] <= 0.0f)
                                       continue;
                                   Peak& p = result[here];
                                   p.own = plane[here];
                                   p.strength = p.own;
                                   for (int d = 1; d <= kAcross; ++d)
                                       for (const int side : {-d, d})
                                       {
                                           const auto k = static_cast<std::ptrdiff_t>(strip) + side;
                                           if (k < 0 || k >= m_strips)
                                               continue;
                                           const float v = plane[static_cast<std::size_t>(k) * steps + s];
                                           if (v <= p.strength)
                                               continue;
                                           p.strength = v;
                                           p.offset = static_cast<float>(d * kStrip_m / 0.1);
                                       }
                               }
                       });
        return result;
    }

    /// What the strips about the cell hold at its place along the plane.
    void addHeights(const SurfaceCell& cell, std::size_t k, WallPlane& p) const
    {
        const auto steps = static_cast<std::size_t>(m_steps);
        std::uint32_t heights = m_heights[k];
        if (k >= steps)
            heights |= m_heights[k - steps];
        if (k + steps < m_heights.size())
            heights |= m_heights[k + steps];
        const int own = bin(cell);
        const std::uint32_t above = heights >> own, below = heights << (kBins - 1 - own);
        p.runUp = static_cast<float>((std::countr_one(above) - 1) * kBin_m);
        p.runDown = static_cast<float>((std::countl_one(below) - 1) * kBin_m);
        const int top = kBins - std::countl_zero(heights), bottom = std::countr_zero(heights);
        p.top = static_cast<float>(std::clamp(m_set.ceiling_m - m_set.floor_m - (top - 1) * kBin_m, -1.0, 4.0));
        p.bottom = static_cast<float>(std::clamp((bottom - 1) * kBin_m, -1.0, 4.0));
    }

    const CellSet& m_set;
    int m_axis, m_other;
    double m_low[2] = {0, 0};
    int m_strips = 0, m_steps = 0;
    std::vector<std::uint32_t> m_members;
    std::vector<float> m_area, m_upper;
    std::vector<std::uint32_t> m_heights;
};

}  // namespace

std::vector<WallPlane> findWallPlanes(const CellSet& set, const Context& context)
{
    std::vector<WallPlane> result(set.cells.size());
    // No cell faces both axes.
    parallelChunks(2, 1, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t axis = begin; axis < end; ++axis)
                           Facing(set, static_cast<int>(axis)).describe(result, context);
                   });
    return result;
}

}  // namespace s2b

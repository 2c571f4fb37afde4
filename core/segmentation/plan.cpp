// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/plan.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace s2b
{
namespace
{

constexpr float kUpright = 0.35f;  ///< largest |z| of an upright surface's normal
constexpr float kLevel = 0.75f;    ///< smallest |z| of a level one's

enum Channel : std::size_t
{
    Cells,
    UprightShare,
    FacingX,
    FacingXPlace,
    FacingY,
    FacingYPlace,
    LevelArea,
    RestArea,
    ChannelCount
};

constexpr std::array<FeatureInfo, ChannelCount> kChannels = {{
    {"cells", "1", "logarithm of 1 + the number of cells in the bin"},
    {"upright", "1", "share of the bin's cells that are upright surfaces"},
    {"facing_x", "1", "area of the upright surfaces whose normal is nearer to the x axis"},
    {"facing_x_place", "1", "their mean x within the pixel, from its centre, in pixels"},
    {"facing_y", "1", "area of the other upright surfaces"},
    {"facing_y_place", "1", "their mean y within the pixel, from its centre, in pixels"},
    {"level", "1", "area of the level surfaces"},
    {"rest", "1", "area of slanted surfaces and of cells without a normal"},
}};

enum class Kind
{
    FacingX,
    FacingY,
    Level,
    Rest
};

Kind kindOf(const Eigen::Vector3f& normal)
{
    if (normal.isZero())
        return Kind::Rest;
    const float nz = std::abs(normal.z());
    if (nz < kUpright)
        return std::abs(normal.x()) >= std::abs(normal.y()) ? Kind::FacingX : Kind::FacingY;
    return nz > kLevel ? Kind::Level : Kind::Rest;
}

/// The channels of a plan: what is wanted of them, and how many cells a mean is of.
class Channels
{
public:
    Channels(const PlanGrid& grid, const PlanContract& plan, std::vector<float>& values)
        : m_pixels(static_cast<std::size_t>(grid.width() * grid.height())),
          m_size(m_pixels * static_cast<std::size_t>(plan.bins)),
          m_side_m2(plan.pixel_m * plan.bin_m),
          m_floor_m2(plan.pixel_m * plan.pixel_m)
    {
        for (std::size_t k = 0; k < plan.channels.size(); ++k)
        {
            const auto found = std::ranges::find(kChannels, plan.channels[k], &FeatureInfo::name);
            m_values[static_cast<std::size_t>(found - kChannels.begin())] = values.data() + k * m_size;
        }
        for (const std::size_t channel : {UprightShare, FacingXPlace, FacingYPlace})
            if (m_values[channel])
                m_counts[channel].assign(m_size, 0.0f);
    }

    void add(const PlanGrid& grid, const CellSet& set)
    {
        const double area = set.size_m * set.size_m;
        const auto upright = static_cast<float>(area / m_side_m2), level = static_cast<float>(area / m_floor_m2);
        for (const SurfaceCell& cell : set.cells)
        {
            const PlanPlace p = grid.place(cell);
            const std::size_t i =
                static_cast<std::size_t>(p.bin) * m_pixels + static_cast<std::size_t>(p.y * grid.width() + p.x);
            sum(Cells, i, 1.0f);
            const Kind kind = kindOf(cell.normal);
            mean(UprightShare, i, kind == Kind::FacingX || kind == Kind::FacingY ? 1.0f : 0.0f);
            switch (kind)
            {
                case Kind::FacingX:
                    sum(FacingX, i, upright);
                    mean(FacingXPlace, i, p.dx);
                    break;
                case Kind::FacingY:
                    sum(FacingY, i, upright);
                    mean(FacingYPlace, i, p.dy);
                    break;
                case Kind::Level:
                    sum(LevelArea, i, level);
                    break;
                case Kind::Rest:
                    sum(RestArea, i, upright);
                    break;
            }
        }
    }

    void finish()
    {
        if (float* cells = m_values[Cells])
            std::transform(cells, cells + m_size, cells, [](float n) { return std::log1p(n); });
        for (std::size_t channel = 0; channel < ChannelCount; ++channel)
            for (std::size_t i = 0; i < m_counts[channel].size(); ++i)
                if (m_counts[channel][i] > 1.0f)
                    m_values[channel][i] /= m_counts[channel][i];
    }

private:
    void sum(Channel channel, std::size_t i, float by)
    {
        if (m_values[channel])
            m_values[channel][i] += by;
    }
    void mean(Channel channel, std::size_t i, float of)
    {
        if (m_values[channel])
            m_values[channel][i] += of, m_counts[channel][i] += 1.0f;
    }

    std::size_t m_pixels, m_size;
    double m_side_m2, m_floor_m2;  ///< of a bin
    std::array<float*, ChannelCount> m_values{};
    std::array<std::vector<float>, ChannelCount> m_counts;
};

}  // namespace

PlanGrid::PlanGrid(const PlanContract& plan, const CellSet& set)
    : m_lowZ(set.floor_m + plan.low_m), m_pixel(plan.pixel_m), m_bin(plan.bin_m), m_bins(plan.bins)
{
    Eigen::Vector2f low = set.cells.front().position.head<2>(), high = low;
    for (const SurfaceCell& c : set.cells)
    {
        low = low.cwiseMin(c.position.head<2>());
        high = high.cwiseMax(c.position.head<2>());
    }
    m_lowX = static_cast<double>(low.x());
    m_lowY = static_cast<double>(low.y());
    const auto size = [&](double extent)
    {
        const auto pixels = static_cast<std::int64_t>(extent / plan.pixel_m) + 1;
        return (pixels + plan.multiple - 1) / plan.multiple * plan.multiple;
    };
    m_width = size(static_cast<double>(high.x()) - m_lowX);
    m_height = size(static_cast<double>(high.y()) - m_lowY);
}

PlanPlace PlanGrid::place(const SurfaceCell& cell) const
{
    const double x = (static_cast<double>(cell.position.x()) - m_lowX) / m_pixel;
    const double y = (static_cast<double>(cell.position.y()) - m_lowY) / m_pixel;
    const double z = (static_cast<double>(cell.position.z()) - m_lowZ) / m_bin;
    PlanPlace p;
    p.x = static_cast<std::int64_t>(x);
    p.y = static_cast<std::int64_t>(y);
    p.bin = static_cast<std::int64_t>(std::clamp(z, 0.0, static_cast<double>(m_bins - 1)));
    p.dx = static_cast<float>(x - static_cast<double>(p.x) - 0.5);
    p.dy = static_cast<float>(y - static_cast<double>(p.y) - 0.5);
    p.dz = static_cast<float>(std::clamp(z - static_cast<double>(p.bin) - 0.5, -1.0, 1.0));
    return p;
}

std::span<const FeatureInfo> knownPlanChannels()
{
    return kChannels;
}

Tensor planTensor(const PlanGrid& grid, const PlanContract& plan, const CellSet& set)
{
    const auto layers = static_cast<std::int64_t>(plan.channels.size()) * plan.bins;
    std::vector<float> values(static_cast<std::size_t>(layers * grid.width() * grid.height()), 0.0f);
    Channels channels(grid, plan, values);
    channels.add(grid, set);
    channels.finish();
    return {"plan", {1, layers, grid.height(), grid.width()}, std::move(values)};
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/plan.h"

#include "core/base/parallel.h"

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

/// One channel of all bins.
void fillChannel(Channel channel, const PlanGrid& grid, const PlanContract& plan, const CellSet& set, float* out)
{
    const std::size_t pixels = static_cast<std::size_t>(grid.width() * grid.height());
    const std::size_t size = pixels * static_cast<std::size_t>(plan.bins);
    const auto at = [&](const PlanPlace& p)
    { return static_cast<std::size_t>(p.bin) * pixels + static_cast<std::size_t>(p.y * grid.width() + p.x); };
    const double area = set.size_m * set.size_m;
    const auto uprightArea = static_cast<float>(area / (plan.pixel_m * plan.bin_m));
    const auto levelArea = static_cast<float>(area / (plan.pixel_m * plan.pixel_m));
    std::vector<float> count;
    const bool isMean = channel == UprightShare || channel == FacingXPlace || channel == FacingYPlace;
    if (isMean)
        count.assign(size, 0.0f);
    for (const SurfaceCell& cell : set.cells)
    {
        const Kind kind = kindOf(cell.normal);
        const PlanPlace p = grid.place(cell);
        const std::size_t i = at(p);
        switch (channel)
        {
            case Cells:
                out[i] += 1.0f;
                break;
            case UprightShare:
                out[i] += kind == Kind::FacingX || kind == Kind::FacingY ? 1.0f : 0.0f;
                count[i] += 1.0f;
                break;
            case FacingX:
                out[i] += kind == Kind::FacingX ? uprightArea : 0.0f;
                break;
            case FacingY:
                out[i] += kind == Kind::FacingY ? uprightArea : 0.0f;
                break;
            case FacingXPlace:
                out[i] += kind == Kind::FacingX ? p.dx : 0.0f;
                count[i] += kind == Kind::FacingX ? 1.0f : 0.0f;
                break;
            case FacingYPlace:
                out[i] += kind == Kind::FacingY ? p.dy : 0.0f;
                count[i] += kind == Kind::FacingY ? 1.0f : 0.0f;
                break;
            case LevelArea:
                out[i] += kind == Kind::Level ? levelArea : 0.0f;
                break;
            case RestArea:
                out[i] += kind == Kind::Rest ? uprightArea : 0.0f;
                break;
            case ChannelCount:
                break;
        }
    }
    for (std::size_t i = 0; i < size; ++i)
    {
        if (channel == Cells)
            out[i] = std::log1p(out[i]);
        else if (isMean && count[i] > 1.0f)
            out[i] /= count[i];
    }
}

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

Tensor planTensor(const PlanGrid& grid, const PlanContract& plan, const CellSet& set, const Context& context)
{
    const auto layers = static_cast<std::int64_t>(plan.channels.size()) * plan.bins;
    const std::size_t perChannel = static_cast<std::size_t>(plan.bins * grid.width() * grid.height());
    std::vector<float> values(perChannel * plan.channels.size(), 0.0f);
    parallelChunks(plan.channels.size(), 1, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t k = begin; k < end; ++k)
                       {
                           const auto found = std::ranges::find(kChannels, plan.channels[k], &FeatureInfo::name);
                           fillChannel(static_cast<Channel>(found - kChannels.begin()), grid, plan, set,
                                       values.data() + k * perChannel);
                       }
                   });
    return {"plan", {1, layers, grid.height(), grid.width()}, std::move(values)};
}

}  // namespace s2b

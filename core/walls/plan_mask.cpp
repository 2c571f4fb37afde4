// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/plan_mask.h"

#include "core/base/floor_to_int.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace s2b
{
namespace
{

/// Which layer a cell is evidence of; 0 for none.
std::uint8_t layerOf(const SurfaceCells& cells, const SurfaceCell& c, const Level& level)
{
    const double nz = std::abs(static_cast<double>(c.normal.z()));
    const double z = static_cast<double>(c.position.z());
    if (nz < 0.4 || z < level.floor_m - 0.15 || z > level.highestCeiling_m() + 0.4)
        return 0;
    if (cells.labelsAreSure() && (c.label == Label::Wall || c.label == Label::Window || c.label == Label::Door ||
                                  c.label == Label::Furniture || c.label == Label::Column))
        return 0;
    const bool seenFromAbove = c.facesScanner && c.normal.z() > 0, seenFromBelow = c.facesScanner && c.normal.z() < 0;
    if (nz > 0.9 && std::abs(z - level.floor_m) < 0.10)
        return seenFromBelow ? 0 : PlanMask::Floor;
    if (seenFromAbove)
        return 0;
    if (level.ceilingSeen)
        return nz > 0.9 && level.isCeiling(z, 0.15) ? PlanMask::Ceiling : 0;
    return z > level.floor_m + 1.4 && nz < 0.97 ? PlanMask::Ceiling : 0;  // a sloped ceiling
}

constexpr double kCoarse_m = 0.25;

Eigen::Vector2i pixelOf(const Eigen::Vector2d& p, const Eigen::Vector2d& low, double pixel)
{
    return {floorToInt((p.x() - low.x()) / pixel), floorToInt((p.y() - low.y()) / pixel)};
}

bool isOverhead(const SurfaceCells& cells, const SurfaceCell& c, const Level& level)
{
    const double z = static_cast<double>(c.position.z());
    return std::abs(c.normal.z()) > 0.35f && z > level.floor_m + 1.7 &&
           z < level.highestCeiling_m() + (level.ceilingSeen ? 0.05 : 0.5) &&
           static_cast<double>(c.flatness) < 0.45 * cells.size_m;
}

}  // namespace

PlanMask::PlanMask(const SurfaceCells& cells, const Level& level)
{
    m_pixel = std::max(0.03, 1.3 * cells.size_m);
    const std::span<const SurfaceCell> storey = cellsOf(cells, level);
    std::vector<std::uint8_t> layers(storey.size());
    Eigen::Vector2f lowest = Eigen::Vector2f::Constant(std::numeric_limits<float>::infinity()), highest = -lowest;
    for (std::size_t i = 0; i < storey.size(); ++i)
    {
        layers[i] = layerOf(cells, storey[i], level);
        if (layers[i] == 0)
            continue;
        lowest = lowest.cwiseMin(storey[i].position.head<2>());
        highest = highest.cwiseMax(storey[i].position.head<2>());
    }
    if (!(lowest.x() <= highest.x()))
        return;
    m_low = lowest.cast<double>() - Eigen::Vector2d::Constant(m_pixel);
    const Eigen::Vector2d high = highest.cast<double>();
    m_size = ((high - m_low) / m_pixel).array().ceil().cast<int>() + 2;
    m_layers.assign(static_cast<std::size_t>(m_size.x()) * static_cast<std::size_t>(m_size.y()), 0);
    for (std::size_t k = 0; k < storey.size(); ++k)
    {
        if (layers[k] == 0)
            continue;
        const Eigen::Vector2i i = pixelOf(storey[k].position.head<2>().cast<double>(), m_low, m_pixel);
        m_layers[static_cast<std::size_t>(i.x()) +
                 static_cast<std::size_t>(m_size.x()) * static_cast<std::size_t>(i.y())] |= layers[k];
    }
    if (area_m2(Ceiling) < 0.3 * area_m2(Floor))
        m_main = Floor;

    m_coarseSize = ((high - m_low) / kCoarse_m).array().ceil().cast<int>() + 1;
    m_overhead.assign(static_cast<std::size_t>(m_coarseSize.x()) * static_cast<std::size_t>(m_coarseSize.y()), -1.0f);
    for (const SurfaceCell& c : storey)
    {
        if (!isOverhead(cells, c, level))
            continue;
        const Eigen::Vector2i i = pixelOf(c.position.head<2>().cast<double>(), m_low, kCoarse_m);
        if ((i.array() < 0).any() || (i.array() >= m_coarseSize.array()).any())
            continue;
        float& top = m_overhead[static_cast<std::size_t>(i.x()) +
                                static_cast<std::size_t>(m_coarseSize.x()) * static_cast<std::size_t>(i.y())];
        top = std::max(top, static_cast<float>(static_cast<double>(c.position.z()) - level.floor_m));
    }
}

double PlanMask::overhead_m(const Eigen::Vector2d& p) const
{
    const Eigen::Vector2i i = pixelOf(p, m_low, kCoarse_m);
    if ((i.array() < 0).any() || (i.array() >= m_coarseSize.array()).any())
        return -1.0;
    return static_cast<double>(m_overhead[static_cast<std::size_t>(i.x()) + static_cast<std::size_t>(m_coarseSize.x()) *
                                                                                static_cast<std::size_t>(i.y())]);
}

bool PlanMask::seen(const Eigen::Vector2d& p, Layer layer) const
{
    const Eigen::Vector2i i = pixelOf(p, m_low, m_pixel);
    if ((i.array() < 0).any() || (i.array() >= m_size.array()).any())
        return false;
    return m_layers[static_cast<std::size_t>(i.x()) +
                    static_cast<std::size_t>(m_size.x()) * static_cast<std::size_t>(i.y())] &
           layer;
}

double PlanMask::area_m2(Layer layer) const
{
    return m_pixel * m_pixel *
           static_cast<double>(
               std::count_if(m_layers.begin(), m_layers.end(), [&](std::uint8_t v) { return v & layer; }));
}

double PlanMask::share(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double low, double high, Layer layer) const
{
    const double length = (b - a).norm();
    const Eigen::Vector2d t = length > 1e-9 ? Eigen::Vector2d((b - a) / length) : Eigen::Vector2d::UnitX();
    const Eigen::Vector2d n(-t.y(), t.x());
    const int ns = std::max(1, static_cast<int>(std::ceil(length / m_pixel)));
    const int nd = std::max(1, static_cast<int>(std::ceil((high - low) / m_pixel)));
    int hits = 0;
    for (int i = 0; i < ns; ++i)
        for (int j = 0; j < nd; ++j)
            hits += seen(a + t * (length * (i + 0.5) / ns) + n * (low + (high - low) * (j + 0.5) / nd), layer);
    return static_cast<double>(hits) / (ns * nd);
}

double PlanMask::freeShare(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double low, double high) const
{
    return share(a, b, low, high, m_main);
}

}  // namespace s2b

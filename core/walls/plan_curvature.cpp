// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/plan_curvature.h"

#include "core/base/parallel.h"
#include "core/geometry/parabola.h"
#include "core/walls/plan_order.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace s2b
{
namespace
{

constexpr double kPi = std::numbers::pi;
constexpr double kHeight_m = 0.2;  // of surface above each other that a pixel needs

/// The pixels by square tiles.
class Tiles
{
public:
    explicit Tiles(const std::vector<PlanPixel>& pixels) : m_pixels(pixels)
    {
        for (std::uint32_t i = 0; i < pixels.size(); ++i)
            m_order.emplace_back(tileOf(pixels[i].position.x()), tileOf(pixels[i].position.y()), i);
        std::sort(m_order.begin(), m_order.end());
    }
    /// Calls visit(pixel) for all within a square of half side `reach` about p, and some around.
    template <typename Visit>
    void near(const Eigen::Vector2d& p, double reach, Visit&& visit) const
    {
        const int y0 = tileOf(p.y() - reach), y1 = tileOf(p.y() + reach);
        for (int x = tileOf(p.x() - reach); x <= tileOf(p.x() + reach); ++x)
            for (auto at = std::lower_bound(m_order.begin(), m_order.end(), std::tuple(x, y0, 0u));
                 at != m_order.end() && std::get<0>(*at) == x && std::get<1>(*at) <= y1; ++at)
                visit(m_pixels[std::get<2>(*at)]);
    }

private:
    static constexpr double kTile_m = 0.25;
    [[nodiscard]] static int tileOf(double v) { return floorToInt(v / kTile_m); }
    const std::vector<PlanPixel>& m_pixels;
    std::vector<std::tuple<int, int, std::uint32_t>> m_order;
};

/// Curvature of the surface through a pixel, from what is within `reach` of it along its tangent; 0 when it is not
/// clearly that of one curve on both sides.
double curvatureAt(const PlanPixel& pixel, const Tiles& tiles, double reach, double steepest)
{
    const Eigen::Vector2d n = pixel.normal, t(n.y(), -n.x());
    const double cosine = std::cos(35 * kPi / 180);
    std::vector<Eigen::Vector3d> near;
    tiles.near(
        pixel.position, reach,
        [&](const PlanPixel& q)
        {
            const Eigen::Vector2d d = q.position - pixel.position;
            const double x = t.dot(d), y = n.dot(d);
            if (std::abs(x) < reach && std::abs(y) < 0.03 + steepest / 2 * x * x && std::abs(n.dot(q.normal)) > cosine)
                near.emplace_back(x, y, q.weight);
        });
    // Outwards step by step: the other face of a thin wall would be within reach of a guess.
    Eigen::Vector3d fit = Eigen::Vector3d::Zero();
    for (const double limit : {reach / 3, reach * 2 / 3, reach, reach})
    {
        Parabola p;
        for (const Eigen::Vector3d& v : near)
            if (std::abs(v.x()) <= limit && std::abs(v.y() - fit[0] - fit[1] * v.x() - fit[2] * v.x() * v.x()) < 0.03)
                p.add(v.x(), v.y(), v.z());
        const auto solved = p.solve();
        if (!solved || p.low > -0.6 * limit || p.high < 0.6 * limit || p.rms(*solved) > 0.015)
            return 0;
        fit = *solved;
    }
    return 2 * fit[2] / std::pow(1 + fit[1] * fit[1], 1.5);
}

}  // namespace

std::vector<PlanPixel> verticalPixels(const SurfaceCells& cells, const Level& level, const Context& context)
{
    std::vector<PlanEntry> order;
    for (const SurfaceCell& c : cellsOf(cells, level))
    {
        const double z = static_cast<double>(c.position.z());
        if (c.normal.isZero() || std::abs(c.normal.z()) > 0.3f || z < level.floor_m + 0.05 ||
            z > level.ceiling_m + 0.05 || wallWeight(cells, c) <= 0)
            continue;
        order.push_back(planEntry(cells, static_cast<std::uint32_t>(&c - cells.cells.data())));
    }
    sortByPlace(order, context);
    std::vector<PlanPixel> pixels;
    for (std::size_t i = 0; i < order.size();)
    {
        const std::uint64_t place = order[i].place;
        PlanPixel pixel;
        Eigen::Vector2d sum = Eigen::Vector2d::Zero(), doubled = Eigen::Vector2d::Zero();
        double points = 0;
        for (; i < order.size() && order[i].place == place; ++i)
        {
            const SurfaceCell& c = cells.cells[order[i].cell];
            const Eigen::Vector2d n = c.normal.head<2>().cast<double>().normalized();
            pixel.weight += 1;
            points += c.count;
            sum += c.count * c.position.head<2>().cast<double>();
            doubled += Eigen::Vector2d(n.x() * n.x() - n.y() * n.y(), 2 * n.x() * n.y());
        }
        // In a corner there is no one direction.
        if (pixel.weight * cells.size_m < kHeight_m || doubled.norm() < 0.7 * pixel.weight)
            continue;
        pixel.position = sum / points;
        const double a = std::atan2(doubled.y(), doubled.x()) / 2;
        pixel.normal = {std::cos(a), std::sin(a)};
        pixels.push_back(pixel);
    }
    return pixels;
}

std::vector<std::uint32_t> curvedPixels(const std::vector<PlanPixel>& pixels, double cell_m, const WallParams& params,
                                        const Context& context)
{
    const Tiles tiles(pixels);
    // Two reaches: a tight curve leaves the wide one's corridor, a wide one shows in a long stretch only.
    const double shortReach = std::max(0.4, 6 * cell_m), longReach = 3 * shortReach;
    const double tightest = 1.3 / params.minimumArcRadius_m, widest = 0.7 / params.maximumArcRadius_m;
    const auto isCurved = [&](const PlanPixel& pixel)
    {
        const double tight = std::abs(curvatureAt(pixel, tiles, shortReach, tightest));
        if (tight > 0.15 && tight < tightest)
            return true;
        if (tight >= 0.5)
            return false;
        const double wide = std::abs(curvatureAt(pixel, tiles, longReach, 0.5));
        return wide > widest && wide < 0.5;
    };
    std::vector<char> curved(pixels.size(), 0);
    parallelChunks(pixels.size(), 256, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t i = begin; i < end; ++i)
                           curved[i] = isCurved(pixels[i]);
                   });
    std::vector<std::uint32_t> seeds;
    for (std::uint32_t i = 0; i < pixels.size(); ++i)
        if (curved[i])
            seeds.push_back(i);
    return seeds;
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/columns/column_points.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace s2b
{
namespace
{

constexpr double kTile_m = 0.5;
constexpr std::size_t kChunk = 1 << 18;

/// Which boxes a tile of the plan touches.
class BoxIndex
{
public:
    explicit BoxIndex(std::span<const OrientedRectangle> boxes) : m_boxes(boxes)
    {
        Eigen::Vector2d low = Eigen::Vector2d::Constant(1e300), high = -low;
        for (const OrientedRectangle& box : boxes)
            for (const Eigen::Vector2d& corner : box.corners())
                low = low.cwiseMin(corner), high = high.cwiseMax(corner);
        m_low = low;
        m_size = ((high - low) / kTile_m).array().floor().cast<int>() + 1;
        m_tiles.resize(static_cast<std::size_t>(m_size.x()) * static_cast<std::size_t>(m_size.y()));
        for (std::size_t b = 0; b < boxes.size(); ++b)
        {
            Eigen::Vector2d from = high, to = low;
            for (const Eigen::Vector2d& corner : boxes[b].corners())
                from = from.cwiseMin(corner), to = to.cwiseMax(corner);
            const Eigen::Array2i first = tileOf(from), last = tileOf(to);
            for (int y = first.y(); y <= last.y(); ++y)
                for (int x = first.x(); x <= last.x(); ++x)
                    m_tiles[at(x, y)].push_back(b);
        }
    }
    template <typename Visit>
    void visit(const Eigen::Vector2d& p, const Visit& visit) const
    {
        const Eigen::Array2i tile = tileOf(p);
        if ((tile < 0).any() || (tile >= m_size.array()).any())
            return;
        for (const std::size_t b : m_tiles[at(tile.x(), tile.y())])
            if (m_boxes[b].contains(p))
                visit(b);
    }

private:
    [[nodiscard]] Eigen::Array2i tileOf(const Eigen::Vector2d& p) const
    {
        return ((p - m_low) / kTile_m).array().floor().cwiseMax(-1.0).cwiseMin(1e6).cast<int>();
    }
    [[nodiscard]] std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.x()) + static_cast<std::size_t>(x);
    }
    std::span<const OrientedRectangle> m_boxes;
    Eigen::Vector2d m_low = Eigen::Vector2d::Zero();
    Eigen::Vector2i m_size = Eigen::Vector2i::Zero();
    std::vector<std::vector<std::size_t>> m_tiles;
};

}  // namespace

std::vector<std::vector<Eigen::Vector2d>> pointsWithin(const CloudView& cloud, const Frame& frame,
                                                       std::span<const OrientedRectangle> boxes, double low,
                                                       double high, std::optional<Label> label, const Context& context)
{
    std::vector<std::vector<Eigen::Vector2d>> result(boxes.size());
    if (boxes.empty() || cloud.count == 0)
        return result;
    const BoxIndex index(boxes);
    const Eigen::Vector3d shift = cloud.origin - frame.origin;
    const double c = std::cos(frame.yaw_rad), s = std::sin(frame.yaw_rad);
    struct Found
    {
        std::size_t box;
        Eigen::Vector2d point;
    };
    std::vector<std::vector<Found>> found((cloud.count + kChunk - 1) / kChunk);
    parallelChunks(
        cloud.count, kChunk, context,
        [&](std::size_t begin, std::size_t end)
        {
            for (std::size_t i = begin; i < end; ++i)
            {
                const float* p = cloud.xyz + 3 * i;
                const double z = static_cast<double>(p[2]) + shift.z();
                if (z < low || z > high ||
                    (label && cloud.labels != nullptr && cloud.labels[i] != static_cast<std::uint8_t>(*label)))
                    continue;
                const double x = static_cast<double>(p[0]) + shift.x(), y = static_cast<double>(p[1]) + shift.y();
                const Eigen::Vector2d q(c * x + s * y, c * y - s * x);
                index.visit(q, [&](std::size_t b) { found[begin / kChunk].push_back({b, q}); });
            }
        });
    for (const std::vector<Found>& chunk : found)
        for (const Found& f : chunk)
            result[f.box].push_back(f.point);
    return result;
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/geometry/polygon.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

namespace s2b
{

namespace
{

/// A corner of the grid: (0, 0) is the lower-left corner of the first cell.
struct Node
{
    int x = 0;
    int y = 0;
    bool operator==(const Node&) const = default;
};

enum Direction : int
{
    kEast = 0,
    kNorth = 1,
    kWest = 2,
    kSouth = 3
};
constexpr std::array<Node, 4> kSteps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

Node stepped(Node node, int direction)
{
    const Node step = kSteps[static_cast<std::size_t>(direction)];
    return {node.x + step.x, node.y + step.y};
}

class MaskTracer
{
public:
    MaskTracer(std::span<const std::uint8_t> mask, int width, int height)
        : m_mask(mask), m_width(width), m_height(height), m_region(mask.size(), -1), m_isWalked(mask.size(), false)
    {
    }

    /// Node rings per region: the outer one first.
    std::vector<std::vector<std::vector<Node>>> run()
    {
        labelRegions();
        // Set cells lie to the left of a ring: an outer one has eastward edges at its bottom, a hole's at its top. A
        // region's lowest cell is on its outer ring, which is so found first.
        std::vector<std::vector<std::vector<Node>>> rings(static_cast<std::size_t>(m_regions));
        for (int y = 0; y < m_height; ++y)
        {
            for (int x = 0; x < m_width; ++x)
            {
                if (!isSet(x, y) || isSet(x, y - 1) || m_isWalked[at(x, y)])
                    continue;
                auto& ofRegion = rings[static_cast<std::size_t>(m_region[at(x, y)])];
                for (std::vector<Node>& ring : splitAtTouches(walk({x, y})))
                    ofRegion.push_back(std::move(ring));
            }
        }
        return rings;
    }

private:
    [[nodiscard]] std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] bool isSet(int x, int y) const
    {
        return x >= 0 && y >= 0 && x < m_width && y < m_height && m_mask[at(x, y)] != 0;
    }

    void labelRegions()
    {
        for (int y = 0; y < m_height; ++y)
        {
            for (int x = 0; x < m_width; ++x)
            {
                if (!isSet(x, y) || m_region[at(x, y)] >= 0)
                    continue;
                std::vector<Node> open{{x, y}};
                m_region[at(x, y)] = m_regions;
                while (!open.empty())
                {
                    const Node cell = open.back();
                    open.pop_back();
                    for (int d = 0; d < 4; ++d)
                    {
                        const Node next = stepped(cell, d);
                        if (!isSet(next.x, next.y) || m_region[at(next.x, next.y)] >= 0)
                            continue;
                        m_region[at(next.x, next.y)] = m_regions;
                        open.push_back(next);
                    }
                }
                ++m_regions;
            }
        }
    }

    /// Whether the edge from a node has a set cell on its left and none on its right.
    [[nodiscard]] bool isBoundary(Node node, int direction) const
    {
        // Cells around a node, counter-clockwise from the upper right one: left of an edge lies the cell of the same
        // number as its direction, right of it the one before.
        constexpr std::array<Node, 4> kCells = {{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
        const Node left = kCells[static_cast<std::size_t>(direction)];
        const Node right = kCells[static_cast<std::size_t>((direction + 3) % 4)];
        return isSet(node.x + left.x, node.y + left.y) && !isSet(node.x + right.x, node.y + right.y);
    }

    /// All nodes of the ring that begins eastward, below the cell right of `start`; set cells to the left.
    std::vector<Node> walk(Node start)
    {
        std::vector<Node> ring;
        Node node = start;
        int direction = kEast;
        do
        {
            if (direction == kEast)
                m_isWalked[at(node.x, node.y)] = true;
            ring.push_back(node);
            node = stepped(node, direction);
            // Left first: where two cells touch in a corner, the ring stays with its own.
            int turned = (direction + 1) % 4;
            while (!isBoundary(node, turned))
                turned = (turned + 3) % 4;
            direction = turned;
        } while (!(node == start && direction == kEast));
        return ring;
    }

    /// Whether two set cells touch only in this node.
    [[nodiscard]] bool isTouch(Node node) const
    {
        const bool rising = isSet(node.x, node.y) && isSet(node.x - 1, node.y - 1);
        const bool falling = isSet(node.x - 1, node.y) && isSet(node.x, node.y - 1);
        return rising != falling && isSet(node.x, node.y) == isSet(node.x - 1, node.y - 1) &&
               isSet(node.x - 1, node.y) == isSet(node.x, node.y - 1);
    }

    /// A ring that touches itself in such nodes encloses gaps there: they become rings of their own. The first ring
    /// keeps the first node.
    [[nodiscard]] std::vector<std::vector<Node>> splitAtTouches(const std::vector<Node>& walked) const
    {
        std::vector<std::vector<Node>> rings(1);
        std::vector<Node> open;
        std::map<std::pair<int, int>, std::size_t> seen;  // where in `open` a touching node was put last
        for (const Node& node : walked)
        {
            if (isTouch(node))
            {
                const auto [found, isNew] = seen.try_emplace({node.x, node.y}, open.size());
                const auto first = open.begin() + static_cast<std::ptrdiff_t>(std::min(found->second, open.size()));
                if (!isNew && first != open.end() && *first == node)
                {
                    rings.emplace_back(first, open.end());
                    open.erase(first, open.end());
                }
                found->second = open.size();
            }
            open.push_back(node);
        }
        rings.front() = std::move(open);
        return rings;
    }

    std::span<const std::uint8_t> m_mask;
    int m_width;
    int m_height;
    std::vector<int> m_region;     ///< of each cell, -1 when it is not set
    std::vector<bool> m_isWalked;  ///< the cell's lower edge belongs to a ring that has been found
    int m_regions = 0;
};

/// The corners of a ring of unit steps, in metres.
Ring cornersOf(const std::vector<Node>& nodes, const Eigen::Vector2d& origin, double cell)
{
    Ring ring;
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
        const Node& before = nodes[(i + nodes.size() - 1) % nodes.size()];
        const Node& after = nodes[(i + 1) % nodes.size()];
        if (before.x != after.x && before.y != after.y)
            ring.push_back(origin + cell * Eigen::Vector2d(nodes[i].x, nodes[i].y));
    }
    return ring;
}

}  // namespace

std::vector<Polygon> traceMask(std::span<const std::uint8_t> mask, int width, int height, const Eigen::Vector2d& origin,
                               double cell)
{
    if (width < 0 || height < 0 || mask.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        throw Error(ErrorCode::Internal, "a mask does not have width * height cells");
    std::vector<Polygon> polygons;
    for (const auto& rings : MaskTracer(mask, width, height).run())
    {
        Polygon polygon;
        polygon.outer = cornersOf(rings.front(), origin, cell);
        for (std::size_t i = 1; i < rings.size(); ++i)
            polygon.holes.push_back(cornersOf(rings[i], origin, cell));
        polygons.push_back(canonical(polygon));
    }
    sortPolygons(polygons);
    return polygons;
}

}  // namespace s2b

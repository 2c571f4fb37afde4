// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spaces/spaces.h"

#include <algorithm>
#include <cmath>
#include <format>

namespace s2b
{
namespace
{

constexpr double kTouch_m = 0.02;  // a face this near to the outline bounds it
constexpr double kTouchLength_m = 0.05;

/// Length over which two nearly parallel segments run side by side within kTouch_m.
double contact(const Segment& a, const Segment& b)
{
    const Eigen::Vector2d d = a.b - a.a, e = b.b - b.a;
    const double length = d.norm();
    if (length < 1e-9 || std::abs(d.x() * e.y() - d.y() * e.x()) > 0.02 * length * e.norm())
        return 0;
    const Eigen::Vector2d t = d / length, n(-t.y(), t.x());
    if (std::abs(n.dot((b.a + b.b) / 2 - a.a)) > kTouch_m)
        return 0;
    const double u = t.dot(b.a - a.a), v = t.dot(b.b - a.a);
    return std::min(std::max(u, v), length) - std::max(std::min(u, v), 0.0);
}

std::vector<ElementId> wallsAround(const Room& room, const RoomPlan& plan)
{
    const std::vector<Segment> sides = edgesOf(std::span(&room.outline, 1));
    std::vector<ElementId> found;
    for (std::size_t w = 0; w < plan.walls.size(); ++w)
    {
        if (!plan.isDividing[w])
            continue;
        const Polygon body{plan.walls[w].outline(), {}};
        double touching = 0;
        for (const Segment& face : edgesOf(std::span(&body, 1)))
            for (const Segment& side : sides)
                touching += std::max(0.0, contact(side, face));
        if (touching > kTouchLength_m)
            found.push_back(plan.walls[w].id);
    }
    return found;
}

}  // namespace

SpaceResult findSpaces(const RoomPlan& plan, ElementId storey, std::size_t storeyNumber, std::uint32_t& nextId,
                       const SpaceParams& params)
{
    SpaceResult result;
    int number = 0;
    for (const Room& room : plan.rooms)
    {
        const double size = area(room.outline);
        const Eigen::Vector2d middle = centroid(room.outline);
        const Eigen::Vector3d location(middle.x(), middle.y(), room.floor_m);
        const auto say = [&](Severity severity, const char* code, std::string text, ElementId element = {})
        { result.diagnostics.push_back({severity, "spaces", code, std::move(text), element, location}); };
        if (size < params.minimumArea_m2)
            continue;
        switch (room.kind)
        {
            case RoomKind::Unseen:
                say(Severity::Info, "EnclosedUnseen",
                    std::format("Walls enclose {:.1f} m2 here that were not seen: a shaft, or a room that was not "
                                "scanned; there is no space.",
                                size));
                continue;
            case RoomKind::Uncovered:
                say(Severity::Info, "EnclosedUncovered",
                    std::format("Walls enclose {:.1f} m2 here with nothing overhead; there is no space.", size));
                continue;
            case RoomKind::Open:
                say(Severity::Warning, "RoomNotClosed",
                    std::format("A room of about {:.1f} m2 was seen here, but walls make up only {:.0f} % of its "
                                "outline; there is no space.",
                                size, 100 * room.wallShare));
                continue;
            case RoomKind::Room:
                break;
        }
        Space space;
        space.id = ElementId{nextId++};
        space.storey = storey;
        space.name = std::format("{}.{:02}", storeyNumber, ++number);
        space.outline = room.outline;
        space.floor_m = room.floor_m;
        space.height = {room.ceiling_m - room.floor_m, room.ceilingSeen ? Provenance::Measured : Provenance::Assumed,
                        room.ceilingRms_m};
        space.area_m2 = size;
        space.boundedBy = wallsAround(room, plan);
        if (const double open = 1 - room.wallShare - room.roofShare; open > 0.005)
            say(Severity::Warning, "SpaceClosedByCeiling",
                std::format(
                    "No wall was found along {:.0f} % of this space's outline; the outline of its ceiling closes it.",
                    100 * open),
                space.id);
        result.spaces.push_back(std::move(space));
    }
    return result;
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/face_sides.h"

#include <algorithm>
#include <cmath>

namespace s2b
{
namespace
{

/// Which side of the face shows floor or ceiling right beside it: that is the room's. Where neither does, free space
/// further away on one side only is seen across the wall's own body (the outer face of an external wall).
struct Side
{
    int side = 0;           ///< as Face::side
    bool isBeside = false;  ///< seen right beside the face, not across a body
};

Side roomSide(const Face& face, const PlanMask& mask, PlanMask::Layer layer)
{
    // The pixel that the face itself lies in says nothing.
    const double nearBegin = 0.75 * mask.pixel_m(), nearEnd = std::max(0.10, 2.5 * mask.pixel_m()), farEnd = 0.7;
    const Eigen::Vector2d a = face.at(face.begin), b = face.at(face.end);
    const double left = mask.share(a, b, nearBegin, nearEnd, layer),
                 right = mask.share(a, b, -nearEnd, -nearBegin, layer);
    if (std::max(left, right) > 0.4)
        return {std::abs(left - right) > 0.2 ? (left > right ? 1 : -1) : 0, true};
    const double farLeft = mask.share(a, b, nearEnd, farEnd, layer),
                 farRight = mask.share(a, b, -farEnd, -nearEnd, layer);
    if (std::max(farLeft, farRight) < 0.2 || std::min(farLeft, farRight) > 0.08)
        return {};
    return {farLeft > farRight ? -1 : 1, false};
}

}  // namespace

void findSides(std::vector<Face>& faces, const PlanMask& mask, double sameOffset_m)
{
    const PlanMask::Layer main = mask.mainLayer(),
                          second = main == PlanMask::Ceiling ? PlanMask::Floor : PlanMask::Ceiling;
    std::vector<char> isSure(faces.size(), 0);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
        if (faces[i].scannedSide != 0)
        {
            faces[i].side = faces[i].scannedSide;
            faces[i].isBesideRoom = true;
            isSure[i] = 1;
            continue;
        }
        Side best = roomSide(faces[i], mask, faces[i].isLow ? PlanMask::Floor : main);
        // Free space on both sides is an answer too (a leaf, a panel): then the other layer is not asked.
        if (!best.isBeside && !faces[i].isLow)
            if (const Side other = roomSide(faces[i], mask, second);
                best.side == 0 || (other.isBeside && other.side != 0))
                best = other;
        faces[i].side = best.side;
        faces[i].isBesideRoom = best.isBeside;
        isSure[i] = best.isBeside && best.side != 0;
    }
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
        if (faces[i].isBesideRoom)
            continue;
        double nearest = 10.0;
        for (std::size_t j = 0; j < faces.size(); ++j)
        {
            if (!isSure[j] || std::abs(faces[i].t.dot(faces[j].n())) > 0.02)
                continue;
            const double gap = std::max(faces[j].begin - faces[i].end, faces[i].begin - faces[j].end);
            const double offset = faces[i].n().dot(faces[j].at((faces[j].begin + faces[j].end) / 2)) - faces[i].offset;
            if (gap < nearest && std::abs(offset) < sameOffset_m)
                nearest = gap, faces[i].side = faces[j].side;
        }
    }
}

}  // namespace s2b

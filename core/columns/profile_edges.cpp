// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/columns/profile_edges.h"

#include <array>

namespace s2b
{
namespace
{

ProfileLengths unit(int i, double factor = 1.0)
{
    ProfileLengths l = ProfileLengths::Zero();
    l[i] = factor;
    return l;
}

std::vector<ProfileEdge> makeEdges(std::optional<ProfileShape> shape)
{
    const ProfileLengths left = unit(0), right = unit(1), bottom = unit(2), top = unit(3), web = unit(4),
                         flange = unit(5);
    const ProfileLengths middle = 0.5 * (left + right);
    const auto across = [](const ProfileLengths& y, const ProfileLengths& from, const ProfileLengths& to, EdgeRole role)
    { return ProfileEdge{false, y, from, to, role}; };
    const auto upright = [](const ProfileLengths& x, const ProfileLengths& from, const ProfileLengths& to,
                            EdgeRole role) { return ProfileEdge{true, x, from, to, role}; };
    using enum EdgeRole;
    if (!shape)
        return {across(bottom, left, right, Outer), across(top, left, right, Outer), upright(left, bottom, top, Outer),
                upright(right, bottom, top, Outer)};
    const ProfileLengths webLeft = middle - 0.5 * web, webRight = middle + 0.5 * web;
    const ProfileLengths low = bottom + flange, high = top - flange;
    switch (*shape)
    {
        case ProfileShape::I:
            return {across(bottom, left, right, Outer),  across(top, left, right, Outer),
                    upright(left, bottom, low, Tip),     upright(right, bottom, low, Tip),
                    upright(left, high, top, Tip),       upright(right, high, top, Tip),
                    across(low, left, webLeft, Flange),  across(low, webRight, right, Flange),
                    across(high, left, webLeft, Flange), across(high, webRight, right, Flange),
                    upright(webLeft, low, high, Web),    upright(webRight, low, high, Web)};
        case ProfileShape::L:
            return {across(bottom, left, right, Outer),
                    upright(left, bottom, top, Outer),
                    upright(right, bottom, bottom + web, Tip),
                    across(top, left, left + web, Tip),
                    across(bottom + web, left + web, right, Flange),
                    upright(left + web, bottom + web, top, Web)};
        case ProfileShape::U:
            return {upright(left, bottom, top, Outer),       across(bottom, left, right, Outer),
                    across(top, left, right, Outer),         upright(right, bottom, low, Tip),
                    upright(right, high, top, Tip),          across(low, left + web, right, Flange),
                    across(high, left + web, right, Flange), upright(left + web, low, high, Web)};
        case ProfileShape::T:
            break;
    }
    return {across(top, left, right, Outer),     upright(left, high, top, Tip),
            upright(right, high, top, Tip),      across(bottom, webLeft, webRight, Tip),
            across(high, left, webLeft, Flange), across(high, webRight, right, Flange),
            upright(webLeft, bottom, high, Web), upright(webRight, bottom, high, Web)};
}

}  // namespace

const std::vector<ProfileEdge>& edgesOf(std::optional<ProfileShape> shape)
{
    static const std::array<std::vector<ProfileEdge>, 4> kEdges{makeEdges(ProfileShape::I), makeEdges(ProfileShape::L),
                                                                makeEdges(ProfileShape::U), makeEdges(ProfileShape::T)};
    static const std::vector<ProfileEdge> kRectangle = makeEdges(std::nullopt);
    return shape ? kEdges[static_cast<std::size_t>(*shape)] : kRectangle;
}

}  // namespace s2b

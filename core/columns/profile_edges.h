// SPDX-License-Identifier: GPL-3.0-or-later
/// The outlines of I, L, U and T sections as edges whose places are linear in a few lengths: what a fit solves for.
#pragma once

#include "core/model/section.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace s2b
{

/// Left, right, bottom and top of the box, thickness of web and flange.
using ProfileLengths = Eigen::Matrix<double, 6, 1>;

/// Which part of the section an edge bounds.
enum class EdgeRole
{
    Outer,  ///< a long side on the box
    Tip,    ///< the end of a plate
    Web,    ///< of the web, in a notch
    Flange  ///< of a flange, in a notch
};

struct ProfileEdge
{
    bool isVertical = false;  ///< along y, at a place in x
    ProfileLengths place;     ///< coefficients: place = place . lengths
    ProfileLengths begin;     ///< of its extent along the other axis
    ProfileLengths end;
    EdgeRole role = EdgeRole::Outer;
};

/// Of one shape; without a shape, of a rectangle.
[[nodiscard]] const std::vector<ProfileEdge>& edgesOf(std::optional<ProfileShape> shape);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/walls/face.h"
#include "core/walls/plan_mask.h"
#include "core/walls/walls.h"

#include <vector>

namespace s2b
{

/// What says how thick a wall is.
enum class ThicknessSource
{
    Faces,       ///< both were seen
    SameWall,    ///< a collinear piece of which both were seen
    Reveals,     ///< the depth of its openings
    OtherWalls,  ///< of its kind in the storey
    Default
};

/// Body of a wall before topology: the space between two parallel faces, or behind one.
///
/// In plan: t * s + n * d with s in [begin, end] and d in [low, high]; n is t turned by +90 degrees.
struct WallBody
{
    Eigen::Vector2d t = Eigen::Vector2d::UnitX();
    double low = 0.0, high = 0.0;
    bool lowSeen = false, highSeen = false;  ///< by a face; else assumed
    ThicknessSource thicknessSource = ThicknessSource::Faces;
    double begin = 0.0, end = 0.0;
    double bottom = 0.0, top = 0.0;  ///< heights; set by settleHeights()
    std::vector<Eigen::Vector2d>
        topEdge{};  ///< (s, z) of a sloped top, which counts instead of `top`; empty: level. Set by settleHeights()
    std::vector<std::uint32_t> lowFaces, highFaces;

    [[nodiscard]] Eigen::Vector2d n() const { return {-t.y(), t.x()}; }
    [[nodiscard]] double thickness() const { return high - low; }
    [[nodiscard]] double middle() const { return (low + high) / 2; }
    [[nodiscard]] bool bothSeen() const { return lowSeen && highSeen; }
};

/// Gives faces of nearly the same direction exactly the same one, the building's axes first: within the angle that
/// their own points cannot tell apart from it. Offsets and ends are kept at the face's middle.
void alignFaces(std::vector<Face>& faces);

/// Groups parallel faces to bodies (D3.6, 3.4.3: parallel planes up to the largest thickness).
///
/// Differs: two faces are one wall where they look away from each other with nothing seen between them, place by place
/// along the wall, so that a face may belong to walls of different thickness; what is left of a face becomes a body
/// with one face seen, with thickness 0 until settleThickness().
[[nodiscard]] std::vector<WallBody> pairFaces(const std::vector<Face>& faces, const PlanMask& mask,
                                              const WallParams& params);

}  // namespace s2b

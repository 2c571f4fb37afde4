// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/cell_index.h"
#include "core/model/building.h"
#include "core/openings/seen_through.h"

#include <functional>
#include <vector>

namespace s2b
{

struct OpeningParams;

/// A cell near a wall, in the wall's own coordinates.
struct WallPoint
{
    double s = 0;       ///< along the axis from its start [m]
    double d = 0;       ///< to the left of it [m]
    double z = 0;       ///< above the wall's base [m]
    double along = 0;   ///< |normal . axis direction|
    double across = 0;  ///< |normal . wall normal|
    double upward = 0;  ///< |normal . up|
    Label label = Label::Unassigned;
    std::uint32_t count = 0;
};

/// A hole through a wall, before it gets a kind: [begin, end] along the axis, [bottom, top] above the base [m].
struct Hole
{
    double begin = 0, end = 0, bottom = 0, top = 0;
    std::uint64_t points = 0;  ///< that say so
    double labelShare = 0;     ///< of them, those with the class's label
    Provenance sides = Provenance::Measured, head = Provenance::Measured;

    [[nodiscard]] double width() const { return end - begin; }
    [[nodiscard]] double height() const { return top - bottom; }
    [[nodiscard]] bool overlaps(const Hole& o) const
    {
        return begin < o.end && o.begin < end && bottom < o.top && o.bottom < top;
    }
    /// All of o's width, but for a frame on either side.
    [[nodiscard]] bool holds(const Hole& o) const { return begin < o.begin + 0.1 && end > o.end - 0.1; }
};

/// What was seen of a wall and close to it; a curved one is unrolled.
struct WallView
{
    const Wall* wall = nullptr;
    double half_m = 0;  ///< of the thickness
    bool leftSeen = false, rightSeen = false;
    double cell_m = 0;
    bool hasLabels = false;
    std::vector<WallPoint> points;  ///< within `reach` of the faces
    SeenThrough through;            ///< where the scanner looked through the wall, if it is known where it stood

    [[nodiscard]] bool isInBody(const WallPoint& p, double inset) const
    {
        return p.d > -half_m + inset && p.d < half_m - inset;
    }
};

[[nodiscard]] WallView viewWall(const Wall& wall, const SurfaceCells& cells, const CellIndex& index, double reach_m);

/// Holes that labelled points fill (closed leaves, frames, panes): D3.6, 3.5, first step.
[[nodiscard]] std::vector<Hole> labelledHoles(const WallView& view, OpeningKind kind, double clusterRadius_m,
                                              double maximumDoorWidth_m);

/// Holes from the floor up, from what is missing in the faces.
/// @param taken      holes that are known already
/// @param floorSeen  share of the floor that was seen within the body between two places along the axis
[[nodiscard]] std::vector<Hole> voidsFromFloor(const WallView& view, const std::vector<Hole>& taken,
                                               const std::function<double(double, double)>& floorSeen,
                                               const OpeningParams& params);

/// Holes from what is missing in one face and was seen behind it, within the wall's depth: windows, closed doors,
/// niches' openings. Something seen behind the missing face on most of its sides tells a hole from a shadow.
[[nodiscard]] std::vector<Hole> recessedHoles(const WallView& view, const std::vector<Hole>& taken,
                                              double minimumWidth_m, double maximumWidth_m, double minimumHeight_m);

}  // namespace s2b

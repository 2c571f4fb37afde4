// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/openings/wall_view.h"

#include "core/model/wall_axis.h"

#include <cmath>

namespace s2b
{

WallView viewWall(const Wall& wall, const SurfaceCells& cells, const CellIndex& index, double reach_m)
{
    WallView view;
    view.wall = &wall;
    view.half_m = wall.thickness.value_m / 2;
    view.leftSeen = wall.evidence.faceCoverage[0] > 0.10;
    view.rightSeen = wall.evidence.faceCoverage[1] > 0.10;
    view.cell_m = cells.size_m;
    view.hasLabels = cells.labelsAreSure();
    const WallAxis axis(wall);
    const double reach = view.half_m + reach_m;
    // An arc leaves its chord by its sagitta.
    const double beside = wall.bulge == 0.0 ? 0.0 : std::abs(axis.project((wall.start + wall.end) / 2).y());
    index.near(wall.start, wall.end, reach + beside,
               [&](const SurfaceCell& c)
               {
                   const Eigen::Vector2d p = axis.project(c.position.head<2>().cast<double>());
                   const double s = p.x(), d = p.y(), z = static_cast<double>(c.position.z()) - wall.base_m;
                   if (std::abs(d) > reach || s < wall.bodyStart_m - 0.1 || s > wall.bodyEnd_m + 0.1 || z < -0.1 ||
                       z > wall.height.value_m + 0.1)
                       return;
                   const Eigen::Vector2d m = c.normal.head<2>().cast<double>();
                   const Eigen::Vector2d t = axis.direction(s), n = axis.normal(s);
                   // What a model does not know is wall until a hole is seen in it.
                   const Label label = cells.hasGuesses && c.label == Label::Unassigned ? Label::Wall : c.label;
                   view.points.push_back({s, d, z, std::abs(t.dot(m)), std::abs(n.dot(m)),
                                          std::abs(static_cast<double>(c.normal.z())), label, c.count});
               });
    return view;
}

}  // namespace s2b

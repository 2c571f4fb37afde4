// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/columns/candidates.h"
#include "core/columns/column_points.h"
#include "core/columns/columns.h"
#include "core/geometry/rectangle.h"
#include "core/walls/plan_mask.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace s2b
{
namespace
{

constexpr double kLeastSeen = 0.06;  // share of a column's surface; one side in four, half hidden, shows twice that

/// Neither rectangle nor circle: what stands within the box is far from its sides.
bool isNotched(const ColumnCandidate& c)
{
    constexpr double least_m = 0.012;  // a cell's mean lies on the side that it is of to less
    return !c.isRound && c.rectangleRms > least_m;
}

/// Looks at the points of all that are not round: in cells a channel of thin plates looks like a rectangle of which one
/// side was not seen.
void fitProfiles(std::vector<ColumnCandidate>& candidates, const ColumnSource& source, const Level& level,
                 bool hasLabels, const ColumnParams& params, const Context& context)
{
    if (source.cloud == nullptr || !params.profiles)
        return;
    constexpr double around_m = 0.03;
    std::vector<ColumnCandidate*> looked;
    std::vector<OrientedRectangle> boxes;
    for (ColumnCandidate& c : candidates)
        if (!c.isRound && std::max(c.width, c.depth) < params.maximumSize_m + around_m)
        {
            looked.push_back(&c);
            boxes.push_back(rectangleAlong(c.points, c.x));
            boxes.back().half.array() += around_m;
        }
    const double margin = std::min(params.sliceMargin_m, 0.25 * (level.ceiling_m - level.floor_m));
    const auto points =
        pointsWithin(*source.cloud, source.frame, boxes, level.floor_m + margin, level.ceiling_m - margin,
                     hasLabels ? std::optional(Label::Column) : std::nullopt, context);
    const ProfileFitOptions options{params.profileTolerance_m, params.minimumSize_m, params.maximumSize_m};
    for (std::size_t i = 0; i < looked.size(); ++i)
    {
        context.checkCancelled();
        looked[i]->profile = fitProfile(points[i], Eigen::Vector2d::UnitX(), options);
    }
}

/// A column that a wall hides in part: what shows is its front. Of a rectangle flush with a wall's face, less deep than
/// wide, the depth within the wall is assumed: a square section, up to the wall's other face.
void completeEngaged(ColumnCandidate& c, const std::vector<Wall>& walls)
{
    constexpr double flush_m = 0.08;  // cells at the inner edge have no clear normal: the sides begin some cells off
    for (int side = 0; side < 4 && !c.isEngaged; ++side)
    {
        const Eigen::Vector2d y(-c.x.y(), c.x.x());
        const Eigen::Vector2d out = (side < 2 ? c.x : y) * (side % 2 ? -1.0 : 1.0);
        double& deep = side < 2 ? c.width : c.depth;
        const double wide = side < 2 ? c.depth : c.width;
        if (deep >= wide)
            continue;
        const Eigen::Vector2d back = c.center + out * (deep / 2);
        for (const Wall& w : walls)
        {
            if (w.bulge != 0 || std::abs(w.normal().dot(out)) < 0.995)
                continue;
            const Eigen::Vector2d d = back - w.start;
            const double s = w.direction().dot(d), half = w.thickness.value_m / 2,
                         inside = half + w.normal().dot(d) * (w.normal().dot(out) > 0 ? 1.0 : -1.0);
            if (s < w.bodyStart_m || s > w.bodyEnd_m || std::abs(inside) > flush_m)
                continue;
            const double more = std::min(wide - deep, 2 * half - inside);
            c.center += out * (more / 2);
            deep += more;
            c.isEngaged = true;
            break;
        }
    }
}

/// Floor or ceiling of the storey (whichever its mask knows better) was seen around it: not a tree, not a lamp post.
bool standsInBuilding(const ColumnCandidate& c, const PlanMask& mask)
{
    const double reach = std::max(c.width, c.depth) / 2 + 0.4;
    const Eigen::Vector2d middle = c.isRound ? c.circle->center : c.center;
    return mask.share(middle - reach * c.x, middle + reach * c.x, -reach, reach, mask.mainLayer()) > 0.15;
}

}  // namespace

ColumnResult findColumns(const SurfaceCells& cells, const ColumnSource& source, const Level& level,
                         const std::vector<Wall>& walls, ElementId storey, std::uint32_t& nextId,
                         const ColumnParams& params, const Context& context)
{
    ColumnResult result;
    std::vector<ColumnCandidate> candidates = columnCandidates(cells, level, walls, params, context);
    shareRadius(candidates, params, context);
    fitProfiles(candidates, source, level, cells.hasLabels, params, context);
    std::optional<PlanMask> mask;  // labels say what is a column; without them it is asked where it stands
    if (!cells.hasLabels && !candidates.empty())
        mask.emplace(cells, level);
    for (ColumnCandidate& k : candidates)
    {
        if (mask && !standsInBuilding(k, *mask))
            continue;
        if (!k.isRound && !k.profile)
            completeEngaged(k, walls);
        Column c;
        c.storey = storey;
        c.base_m = level.floor_m;
        c.height = {level.ceiling_m - level.floor_m, level.ceilingSeen ? Provenance::Measured : Provenance::Assumed,
                    0.0};
        if (k.isRound)
        {
            c.center = k.circle->center;
            c.section = CircleSection{k.circle->radius_m};
            c.evidence.rms_m = k.circle->rms_m;
        }
        else if (k.profile)
        {
            c.center = k.profile->center;
            c.yaw_rad = k.profile->yaw_rad;
            c.section = k.profile->section;
            c.evidence.rms_m = k.profile->rms_m;
        }
        else
        {
            c.center = k.center;
            c.yaw_rad = std::atan2(k.x.y(), k.x.x());
            c.section = RectangleSection{k.width, k.depth};
            c.evidence.rms_m = k.rectangleRms;
        }
        const double largest = boxOf(c.section).maxCoeff(), smallest = boxOf(c.section).minCoeff();
        // Without labels a thin or long thing is a panel or a piece of wall.
        const bool isSlender = !cells.hasLabels && (largest > 1.0 || smallest < 0.4 * largest);
        // Stray wrong labels are spread thinly over what they would make.
        const double seen = k.weight * cells.size_m * cells.size_m /
                            (2 * (largest + smallest) * std::max(0.1, level.ceiling_m - level.floor_m));
        const bool isGhost = seen < kLeastSeen;
        if (largest > params.maximumSize_m || smallest < params.minimumSize_m || isSlender || isGhost)
        {
            if (cells.hasLabels && !isGhost)
                result.diagnostics.push_back({Severity::Warning,
                                              "columns",
                                              "SizeOutOfRange",
                                              "Points labelled column form no column of a permitted size.",
                                              {},
                                              Eigen::Vector3d(c.center.x(), c.center.y(), level.floor_m)});
            continue;
        }
        c.id = ElementId{nextId++};
        for (const ColumnSpot& s : k.spots)
            c.evidence.points += s.points;
        c.sectionProvenance = k.isEngaged ? Provenance::Assumed : Provenance::Measured;
        if (k.isEngaged)
            result.diagnostics.push_back({Severity::Warning, "columns", "DepthAssumed",
                                          "The column stands in a wall; its depth within the wall is assumed.", c.id,
                                          Eigen::Vector3d(c.center.x(), c.center.y(), level.floor_m)});
        else if (!k.profile && isNotched(k) && params.profiles)
            result.diagnostics.push_back(
                {Severity::Info, "columns", "SectionAsBox",
                 "The column is neither a rectangle nor a circle, and what was seen of it is no I, L, U or T section "
                 "whose web and flanges could be measured; its section is given as the box around it.",
                 c.id, Eigen::Vector3d(c.center.x(), c.center.y(), level.floor_m)});
        c.evidence.facesSeen = 2;
        c.evidence.labelShare = cells.hasLabels ? 1.0 : 0.0;
        result.columns.push_back(c);
    }
    return result;
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/corrections/elements.h"
#include "core/corrections/junctions.h"

#include <cmath>

namespace s2b
{
namespace
{

constexpr double kLeast_m = 0.01;
constexpr double kThinnest_m = 0.001;  // of a plate
constexpr double kMost_m = 100.0;

Dimension corrected(const Dimension& was, double value_m)
{
    return {value_m, Provenance::Corrected, was.rms_m};
}

/// An opening within its host: refused where it sticks out.
void checkFits(const Building& building, const Opening& o)
{
    const Wall& host = *building.wall(o.host);
    constexpr double slack_m = 0.005;
    if (o.sill.value_m < -slack_m || o.sill.value_m + o.height.value_m > host.height.value_m + slack_m)
        refuse(building, o.id,
               std::format("would reach from {:.3f} to {:.3f} m above the foot of its wall, which is {:.3f} m high",
                           o.sill.value_m, o.sill.value_m + o.height.value_m, host.height.value_m));
    if (o.offset_m < host.bodyStart_m - slack_m || o.offset_m + o.width.value_m > host.bodyEnd_m + slack_m)
        refuse(building, o.id,
               std::format("would reach from {:.3f} to {:.3f} m along its wall, which is {:.3f} m long", o.offset_m,
                           o.offset_m + o.width.value_m, host.bodyEnd_m - host.bodyStart_m));
}

void setWall(Building& building, Wall& wall, Measure measure, double value_m)
{
    if (measure == Measure::Height)
    {
        for (const Opening& o : building.openings)
            if (o.host == wall.id && o.sill.value_m + o.height.value_m > value_m)
                refuse(building, wall.id,
                       std::format("would be lower than the top of {}, {:.3f} m", nameOf(building, o.id),
                                   o.sill.value_m + o.height.value_m));
        wall.height = corrected(wall.height, value_m);
        wall.topProfile.clear();
        return;
    }
    // The face that was seen stays where the points are.
    const double change = value_m - wall.thickness.value_m;
    if (wall.evidence.facesSeen == 1 && wall.bulge == 0)
    {
        const bool leftSeen = wall.evidence.faceCoverage[0] > wall.evidence.faceCoverage[1];
        const Eigen::Vector2d shift = wall.normal() * (leftSeen ? -change / 2 : change / 2);
        wall.start += shift;
        wall.end += shift;
    }
    wall.thickness = corrected(wall.thickness, value_m);
    settleJunctions(building, {wall.id});
}

}  // namespace

std::optional<Dimension> measureOf(const Building& building, ElementId id, Measure measure)
{
    if (const Storey* s = building.storey(id); s && measure == Measure::Height)
        return s->height;
    if (const Wall* w = building.wall(id))
        return measure == Measure::Thickness ? std::optional(w->thickness)
               : measure == Measure::Height  ? std::optional(w->height)
                                             : std::nullopt;
    if (const Opening* o = findElement(building.openings, id))
        return measure == Measure::Width    ? std::optional(o->width)
               : measure == Measure::Height ? std::optional(o->height)
               : measure == Measure::Sill   ? std::optional(o->sill)
                                            : std::nullopt;
    if (const Column* c = findElement(building.columns, id))
    {
        const auto section = [&](double value) { return Dimension{value, c->sectionProvenance, c->evidence.rms_m}; };
        if (measure == Measure::Height)
            return c->height;
        const Eigen::Vector2d box = boxOf(c->section);
        if (measure == Measure::Width)
            return section(box.x());
        if (measure == Measure::Depth && !std::holds_alternative<CircleSection>(c->section))
            return section(box.y());
        return std::nullopt;
    }
    if (const Slab* s = findElement(building.slabs, id); s && measure == Measure::Thickness)
        return s->thickness;
    if (const Space* s = findElement(building.spaces, id); s && measure == Measure::Height)
        return s->height;
    return std::nullopt;
}

Building setMeasure(Building building, ElementId id, Measure measure, double value_m)
{
    const std::optional<Dimension> was = measureOf(building, id, measure);
    if (!was)
        refuse(building, id, "has no such dimension");
    const double least = measure == Measure::Sill ? 0.0 : kLeast_m;
    if (!(value_m >= least && value_m <= kMost_m))
        refuse(building, id, std::format("can't be {} m: give {} to {} m", value_m, least, kMost_m));
    if (was->value_m == value_m && was->provenance != Provenance::Assumed)
        return building;

    if (Storey* s = findElement(building.storeys, id))
        s->height = corrected(s->height, value_m);
    else if (Wall* w = findElement(building.walls, id))
        setWall(building, *w, measure, value_m);
    else if (Opening* o = findElement(building.openings, id))
    {
        if (measure == Measure::Width)
        {
            o->offset_m += (o->width.value_m - value_m) / 2;
            o->width = corrected(o->width, value_m);
        }
        else if (measure == Measure::Height)
            o->height = corrected(o->height, value_m);
        else
            o->sill = corrected(o->sill, value_m);
        checkFits(building, *o);
    }
    else if (Column* c = findElement(building.columns, id))
    {
        if (measure == Measure::Height)
            c->height = corrected(c->height, value_m);
        else
        {
            Eigen::Vector2d box = boxOf(c->section);
            (measure == Measure::Width ? box.x() : box.y()) = value_m;
            setBox(c->section, box);
            if (!faultOf(c->section, kThinnest_m).empty())
                refuse(building, id, "would have no room between its web and flanges");
            c->sectionProvenance = Provenance::Corrected;
        }
    }
    else if (Slab* slab = findElement(building.slabs, id))
        slab->thickness = corrected(slab->thickness, value_m);
    else if (Space* space = findElement(building.spaces, id))
        space->height = corrected(space->height, value_m);
    return building;
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/corrections/elements.h"
#include "core/corrections/junctions.h"
#include "core/model/wall_axis.h"
#include "core/model/wall_top.h"

#include <cmath>
#include <numbers>

namespace s2b
{
namespace
{

constexpr double kShortest_m = 0.1;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// The part of a top edge between two places, in arc lengths from `from`.
void cutProfile(Wall& part, const Wall& whole, double from, double to)
{
    part.topProfile.clear();
    if (whole.topProfile.empty())
        return;
    part.topProfile.emplace_back(0.0, topAt(whole, from));
    double highest = part.topProfile.front().y();
    for (const Eigen::Vector2d& v : whole.topProfile)
        if (v.x() > from && v.x() < to)
            part.topProfile.emplace_back(v.x() - from, v.y());
    part.topProfile.emplace_back(to - from, topAt(whole, to));
    for (const Eigen::Vector2d& v : part.topProfile)
        highest = std::max(highest, v.y());
    part.height.value_m = highest - part.base_m;
}

Evidence shareOf(const Evidence& all, double share)
{
    Evidence part = all;
    part.points = static_cast<std::uint64_t>(std::llround(share * static_cast<double>(all.points)));
    return part;
}

/// Where on a wall another one meets it.
double meetingPlace(const Building& building, const Junction& j, const Wall& wall, const WallAxis& axis)
{
    const bool isA = j.wallA == wall.id;
    const Wall& other = *building.wall(isA ? j.wallB : j.wallA);
    const JunctionEnd end = isA ? j.endB : j.endA;
    return axis.project(end == JunctionEnd::End ? other.end : other.start).x();
}

}  // namespace

Building splitWall(Building building, ElementId id, double s_m)
{
    const Wall whole = wallOrRefuse(building, id);
    const WallAxis axis(whole);
    if (!(s_m > std::max(whole.bodyStart_m, 0.0) + kShortest_m &&
          s_m < std::min(whole.bodyEnd_m, axis.length_m()) - kShortest_m))
        refuse(building, id,
               std::format("is {:.3f} m long: it can't be split at {:.3f} m, a part would be shorter than {} m",
                           axis.length_m(), s_m, kShortest_m));
    for (const Opening& o : building.openings)
        if (o.host == id && o.offset_m < s_m && o.offset_m + o.width.value_m > s_m)
            refuse(building, id,
                   std::format("can't be split within {}: choose a place beside it", nameOf(building, o.id)));

    const ElementId restId = freeId(building);
    const double share = s_m / axis.length_m(), sweep = 4 * std::atan(whole.bulge);
    Wall first = whole, rest = whole;
    first.end = rest.start = axis.at(s_m);
    first.bulge = std::tan(share * sweep / 4);
    rest.bulge = std::tan((1 - share) * sweep / 4);
    first.bodyEnd_m = s_m;
    rest.id = restId;
    rest.bodyStart_m = 0;
    rest.bodyEnd_m = whole.bodyEnd_m - s_m;
    cutProfile(first, whole, 0, s_m);
    cutProfile(rest, whole, s_m, axis.length_m());
    first.evidence = shareOf(whole.evidence, share);
    rest.evidence = shareOf(whole.evidence, 1 - share);

    for (Opening& o : building.openings)
        if (o.host == id && o.offset_m >= s_m)
        {
            o.host = restId;
            o.offset_m -= s_m;
        }
    std::vector<Junction> junctions = building.junctions;
    for (std::size_t i = 0; i < junctions.size(); ++i)
    {
        const Junction& was = building.junctions[i];
        if (was.wallA != id && was.wallB != id)
            continue;
        const JunctionEnd end = was.wallA == id ? was.endA : was.endB;
        if (end == JunctionEnd::End || (end == JunctionEnd::Path && meetingPlace(building, was, whole, axis) > s_m))
            (was.wallA == id ? junctions[i].wallA : junctions[i].wallB) = restId;
    }
    junctions.push_back({id, restId, JunctionEnd::End, JunctionEnd::Start});
    building.junctions = std::move(junctions);
    for (Space& space : building.spaces)
        if (std::ranges::count(space.boundedBy, id))
            space.boundedBy.push_back(restId);
    *findElement(building.walls, id) = first;
    building.walls.push_back(rest);
    return building;
}

Building mergeWalls(Building building, ElementId first, ElementId second)
{
    const Wall a = wallOrRefuse(building, first), b = wallOrRefuse(building, second);
    const std::string names = std::format("with {}", nameOf(building, second));
    if (first == second)
        refuse(building, first, "can't be merged with itself: select two walls");
    if (a.storey != b.storey)
        refuse(building, first, std::format("can't be merged {}: they stand on different storeys", names));
    if (a.bulge != 0 || b.bulge != 0)
        refuse(building, first, std::format("can't be merged {}: curved walls stay apart", names));
    if (!a.topProfile.empty() || !b.topProfile.empty())
        refuse(building, first, std::format("can't be merged {}: a wall with a sloped top stays apart", names));
    const double angle = std::asin(std::min(1.0, std::abs(cross(a.direction(), b.direction()))));
    if (angle > 2 * std::numbers::pi / 180)
        refuse(building, first,
               std::format("can't be merged {}: they stand at {:.1f} degrees to each other", names,
                           angle * 180 / std::numbers::pi));
    // The longer one says where the line runs.
    const bool aLeads = a.axisLength_m() >= b.axisLength_m();
    const Wall& lead = aLeads ? a : b;
    const Wall& other = aLeads ? b : a;
    const WallAxis line(lead);
    const Eigen::Vector2d from = line.project(other.start), to = line.project(other.end);
    const double offset = std::max(std::abs(from.y()), std::abs(to.y()));
    if (offset > std::max(a.thickness.value_m, b.thickness.value_m) / 2)
        refuse(building, first, std::format("can't be merged {}: their axes are {:.3f} m apart", names, offset));

    const bool isForward = to.x() >= from.x();
    const double low = std::min({0.0, from.x(), to.x()}), high = std::max({line.length_m(), from.x(), to.x()});
    const auto along = [&](double s) { return from.x() + (isForward ? s : -s); };  // of the other's axis, on the line
    Wall one = lead;
    one.id = first;
    one.start = line.at(low);
    one.end = line.at(high);
    one.bodyStart_m = std::min({lead.bodyStart_m, along(other.bodyStart_m), along(other.bodyEnd_m)}) - low;
    one.bodyEnd_m = std::max({lead.bodyEnd_m, along(other.bodyStart_m), along(other.bodyEnd_m)}) - low;
    const auto known = [](const Dimension& d) { return d.provenance != Provenance::Assumed; };
    one.thickness = known(other.thickness) && !known(lead.thickness) ? other.thickness : lead.thickness;
    const double bottom = std::min(a.base_m, b.base_m);
    const double top = std::max(a.base_m + a.height.value_m, b.base_m + b.height.value_m);
    one.base_m = bottom;
    one.height = std::abs(top - bottom - lead.height.value_m) < 1e-9
                     ? lead.height
                     : Dimension{top - bottom, Provenance::Corrected, lead.height.rms_m};
    const double la = lead.axisLength_m(), lb = other.axisLength_m();
    for (std::size_t side = 0; side < 2; ++side)
        one.evidence.faceCoverage[side] =
            (la * lead.evidence.faceCoverage[side] + lb * other.evidence.faceCoverage[isForward ? side : 1 - side]) /
            (high - low);
    one.evidence.points = a.evidence.points + b.evidence.points;
    one.evidence.facesSeen = std::max(a.evidence.facesSeen, b.evidence.facesSeen);
    one.evidence.rms_m = (la * lead.evidence.rms_m + lb * other.evidence.rms_m) / (la + lb);
    one.evidence.labelShare = (la * lead.evidence.labelShare + lb * other.evidence.labelShare) / (la + lb);

    for (Opening& o : building.openings)
    {
        if (o.host != first && o.host != second)
            continue;
        const Wall& was = o.host == lead.id ? lead : other;
        if (o.host == lead.id)
            o.offset_m -= low;
        else
        {
            o.offset_m = (isForward ? along(o.offset_m) : along(o.offset_m + o.width.value_m)) - low;
            if (!isForward)
                o.hingeAtStart = !o.hingeAtStart, o.opensToLeft = !o.opensToLeft;
        }
        o.sill.value_m += was.base_m - bottom;
        o.host = first;
    }
    std::erase_if(building.junctions, [&](const Junction& j)
                  { return (j.wallA == first && j.wallB == second) || (j.wallA == second && j.wallB == first); });
    const WallAxis whole(one);
    for (Junction& j : building.junctions)
        for (auto [wall, end] : {std::pair(&j.wallA, &j.endA), std::pair(&j.wallB, &j.endB)})
        {
            if (*wall != first && *wall != second)
                continue;
            if (*end != JunctionEnd::Path)
            {
                const Wall& was = *wall == first ? a : b;
                const double s = whole.project(*end == JunctionEnd::End ? was.end : was.start).x();
                *end = s < 1e-6                      ? JunctionEnd::Start
                       : s > whole.length_m() - 1e-6 ? JunctionEnd::End
                                                     : JunctionEnd::Path;
            }
            *wall = first;
        }
    for (Space& space : building.spaces)
    {
        const bool hasBoth = std::ranges::count(space.boundedBy, first) && std::ranges::count(space.boundedBy, second);
        if (hasBoth)
            std::erase(space.boundedBy, second);
        std::ranges::replace(space.boundedBy, second, first);
    }
    *findElement(building.walls, first) = one;
    std::erase_if(building.walls, [&](const Wall& w) { return w.id == second; });
    settleJunctions(building, {first});
    return building;
}

NewWall wallThrough(ElementId storey, const Eigen::Vector2d& first, const Eigen::Vector2d& second,
                    const std::optional<Eigen::Vector2d>& third, double thickness_m)
{
    const Eigen::Vector2d way = second - first;
    const double length = way.norm();
    if (!(length >= kShortest_m))
        throw Error(ErrorCode::BadParameter,
                    std::format("the two points are {:.3f} m apart in plan: pick them at least {} m apart", length,
                                kShortest_m));
    const Eigen::Vector2d left = Eigen::Vector2d(-way.y(), way.x()) / length;
    NewWall wall;
    wall.storey = storey;
    double across = thickness_m;
    wall.thickness = {thickness_m, Provenance::Assumed, 0.0};
    if (third)
    {
        across = left.dot(*third - first);
        wall.thickness = {std::abs(across), Provenance::Corrected, 0.0};
    }
    constexpr double least_m = 0.01, most_m = 2.0;
    if (!(std::abs(across) >= least_m && std::abs(across) <= most_m))
        throw Error(ErrorCode::BadParameter,
                    std::format("the third point gives a thickness of {:.3f} m: pick it on the wall's other face",
                                std::abs(across)));
    wall.start = first + left * across / 2;
    wall.end = second + left * across / 2;
    return wall;
}

Building addWall(Building building, const NewWall& wall)
{
    const Storey* storey = building.storey(wall.storey);
    if (!storey)
        throw Error(ErrorCode::BadParameter, "a wall needs a storey to stand on: run Levels first");
    Wall w;
    w.id = freeId(building);
    w.storey = storey->id;
    w.start = wall.start;
    w.end = wall.end;
    w.bodyEnd_m = (wall.end - wall.start).norm();
    w.base_m = storey->elevation_m;
    w.height = {storey->height.value_m, Provenance::Assumed, 0.0};
    w.thickness = wall.thickness;
    building.walls.push_back(w);
    joinEnds(building, w.id);
    return building;
}

}  // namespace s2b

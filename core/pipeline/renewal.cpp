// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/renewal.h"

#include "core/corrections/elements.h"
#include "core/geometry/polygon.h"
#include "core/model/wall_axis.h"

#include <cmath>
#include <set>

namespace s2b
{
namespace
{

/// What of a class stays: all out of scope, and in scope what people touched.
template <typename Element>
struct Kept
{
    std::set<ElementId> touched;     ///< corrected, added or taken out
    std::vector<Element> claims;     ///< places that fresh elements may not take
    std::vector<Element> untouched;  ///< in scope, to be replaced
};

template <typename Element, typename IsIn>
Kept<Element> sortOut(const std::vector<Element>& found, const std::vector<Element>& corrected, const IsIn& isIn)
{
    Kept<Element> kept;
    const auto look = [&](const Element& e, const Element* other, bool isFound)
    {
        if (!isIn(e))
            return;
        if (other && isSame(*other, e))
        {
            if (isFound)
                kept.untouched.push_back(e);
            return;
        }
        kept.touched.insert(e.id);
        kept.claims.push_back(e);
    };
    for (const Element& e : found)
        look(e, findElement(corrected, e.id), true);
    for (const Element& e : corrected)
        look(e, findElement(found, e.id), false);
    return kept;
}

/// @param isSame  whether a fresh element is in the place of an earlier one
template <typename Element, typename IsIn, typename IsSame>
void renew(std::vector<Element>& found, std::vector<Element>& corrected, std::vector<Element> fresh, const IsIn& isIn,
           const IsSame& isSame, IdMap& ids)
{
    const Kept<Element> kept = sortOut(found, corrected, isIn);
    std::set<ElementId> taken;
    std::vector<Element> added;
    for (Element& e : fresh)
    {
        const auto claim = std::ranges::find_if(kept.claims, [&](const Element& k) { return isSame(k, e); });
        if (claim != kept.claims.end())
        {
            ids[e.id] = claim->id;
            continue;
        }
        const auto before = std::ranges::find_if(
            kept.untouched, [&](const Element& k) { return !taken.contains(k.id) && isSame(k, e); });
        const ElementId id = before == kept.untouched.end() ? e.id : before->id;
        taken.insert(id);
        ids[e.id] = id;
        e.id = id;
        added.push_back(e);
    }
    const auto replace = [&](std::vector<Element>& list)
    {
        std::erase_if(list, [&](const Element& e) { return isIn(e) && !kept.touched.contains(e.id); });
        list.insert(list.end(), added.begin(), added.end());
        std::sort(list.begin(), list.end(), [](const Element& a, const Element& b) { return a.id < b.id; });
    };
    replace(found);
    replace(corrected);
}

bool overlapsInHeight(double low, double high, double otherLow, double otherHigh)
{
    return low < otherHigh && otherLow < high;
}

bool isSameWall(const Wall& a, const Wall& b)
{
    const WallAxis axis(a), other(b);
    const double length = other.length_m();
    if (!overlapsInHeight(a.base_m, a.base_m + a.height.value_m, b.base_m, b.base_m + b.height.value_m))
        return false;
    constexpr int kSamples = 8;
    const double near = std::max(0.1, (a.thickness.value_m + b.thickness.value_m) / 2);
    int beside = 0;
    for (int i = 0; i < kSamples; ++i)
    {
        const double s = length * (i + 0.5) / kSamples;
        const Eigen::Vector2d on = axis.project(other.at(s));
        const double along = std::abs(axis.direction(on.x()).dot(other.direction(s)));
        beside += std::abs(on.y()) < near && on.x() > -near && on.x() < axis.length_m() + near && along > 0.94;
    }
    if (2 * beside > kSamples)
        return true;
    // A short one that is part of a long one, seen from the long one.
    return axis.length_m() < length && beside > 0 &&
           static_cast<double>(beside) / kSamples * length > 0.5 * axis.length_m();
}

/// An opening's place in the world, independent of its host's axis.
struct Place
{
    Eigen::Vector2d begin, end;
    double low = 0, high = 0;
};

Place placeOf(const Opening& o, const Wall& host)
{
    const WallAxis axis(host);
    const double low = host.base_m + o.sill.value_m;
    return {axis.at(o.offset_m), axis.at(o.offset_m + o.width.value_m), low, low + o.height.value_m};
}

bool isSamePlace(const Place& a, const Place& b)
{
    const double reach = 0.5 * std::max((a.end - a.begin).norm(), (b.end - b.begin).norm());
    return ((a.begin + a.end) / 2 - (b.begin + b.end) / 2).norm() < reach &&
           overlapsInHeight(a.low, a.high, b.low, b.high);
}

bool isSameOutline(const Polygon& a, const Polygon& b)
{
    const double sizeA = area(a), sizeB = area(b);
    return std::abs(sizeA - sizeB) < 0.3 * std::max(sizeA, sizeB) &&
           (centroid(a) - centroid(b)).norm() < 0.2 * std::sqrt(std::max(sizeA, sizeB));
}

/// Openings of renewed walls keep their place; those whose wall is gone go with it.
void rehost(Building& building, const std::vector<Wall>& before)
{
    std::erase_if(building.openings,
                  [&](Opening& o)
                  {
                      const Wall* now = building.wall(o.host);
                      const Wall* was = findElement(before, o.host);
                      if (!now || !was)  // in what was found, those of a wall that was added by hand stay
                          return was != nullptr;
                      if (isSame(*now, *was))
                          return false;
                      const Place place = placeOf(o, *was);
                      const WallAxis axis(*now);
                      const double a = axis.project(place.begin).x(), b = axis.project(place.end).x();
                      o.offset_m = std::min(a, b);
                      if (b < a)
                          o.hingeAtStart = !o.hingeAtStart, o.opensToLeft = !o.opensToLeft;
                      o.sill.value_m = std::max(0.0, place.low - now->base_m);
                      o.height.value_m = std::min(o.height.value_m, now->height.value_m - o.sill.value_m);
                      constexpr double slack_m = 0.02;
                      return o.offset_m < now->bodyStart_m - slack_m ||
                             o.offset_m + o.width.value_m > now->bodyEnd_m + slack_m || o.height.value_m < 0.1;
                  });
}

/// @param replaced  walls of the model that gave way to fresh ones
void renewJunctions(Building& building, const std::vector<Junction>& fresh, const std::set<ElementId>& replaced)
{
    std::erase_if(building.junctions,
                  [&](const Junction& j)
                  {
                      return replaced.contains(j.wallA) || replaced.contains(j.wallB) || !building.wall(j.wallA) ||
                             !building.wall(j.wallB);
                  });
    for (const Junction& j : fresh)
    {
        const bool isKnown = std::ranges::any_of(
            building.junctions, [&](const Junction& k)
            { return (k.wallA == j.wallA && k.wallB == j.wallB) || (k.wallA == j.wallB && k.wallB == j.wallA); });
        if (!isKnown && building.wall(j.wallA) && building.wall(j.wallB))
            building.junctions.push_back(j);
    }
}

void dropUnboundedBy(Building& building)
{
    for (Space& s : building.spaces)
        std::erase_if(s.boundedBy, [&](ElementId wall) { return !building.wall(wall); });
}

}  // namespace

void renewWalls(Model& model, std::vector<Wall> fresh, std::vector<Junction> junctions, const InScope& inScope,
                IdMap& ids)
{
    const auto isIn = [&](const Wall& w) { return inScope(w.storey); };
    const std::vector<Wall> foundBefore = model.found.walls, correctedBefore = model.corrected.walls;
    std::set<ElementId> replaced;
    for (const Wall& w : sortOut(foundBefore, correctedBefore, isIn).untouched)
        replaced.insert(w.id);
    IdMap own;
    renew(model.found.walls, model.corrected.walls, std::move(fresh), isIn, isSameWall, own);
    std::erase_if(junctions,
                  [&](Junction& j)
                  {
                      j.wallA = own[j.wallA];
                      j.wallB = own[j.wallB];
                      return j.wallA == j.wallB;
                  });
    for (const auto& [from, to] : own)
        replaced.insert(to);
    // A wall that people corrected keeps the junctions that it has to walls that stay.
    const std::set<ElementId> touched = [&]
    {
        const Kept<Wall> kept = sortOut(foundBefore, correctedBefore, isIn);
        return kept.touched;
    }();
    for (const ElementId id : touched)
        replaced.erase(id);
    renewJunctions(model.found, junctions, replaced);
    renewJunctions(model.corrected, junctions, replaced);
    rehost(model.found, foundBefore);
    rehost(model.corrected, correctedBefore);
    dropUnboundedBy(model.found);
    dropUnboundedBy(model.corrected);
    ids.merge(own);
}

void renewOpenings(Model& model, std::vector<Opening> fresh, const std::vector<Wall>& hosts,
                   const std::set<OpeningKind>& kinds, const InScope& inScope, IdMap& ids)
{
    const auto hostOf = [&](const Opening& o) -> const Wall*
    {
        if (const Wall* w = findElement(hosts, o.host))
            return w;
        if (const Wall* w = model.corrected.wall(o.host))
            return w;
        return model.found.wall(o.host);
    };
    const auto isIn = [&](const Opening& o)
    {
        // One that went with its wall was not taken out for itself: its place is free.
        const Wall* host = model.corrected.wall(o.host);
        return host && inScope(host->storey) && kinds.contains(o.kind);
    };
    const auto isSame = [&](const Opening& a, const Opening& b)
    {
        const Wall* hostA = hostOf(a);
        const Wall* hostB = hostOf(b);
        return hostA && hostB && isSamePlace(placeOf(a, *hostA), placeOf(b, *hostB));
    };
    // An opening of another kind that stays has its place too (a door that a person made a window).
    std::erase_if(fresh,
                  [&](const Opening& o)
                  {
                      return std::ranges::any_of(model.corrected.openings, [&](const Opening& k)
                                                 { return !kinds.contains(k.kind) && isSame(k, o); });
                  });
    renew(model.found.openings, model.corrected.openings, std::move(fresh), isIn, isSame, ids);
}

void renewColumns(Model& model, std::vector<Column> fresh, const InScope& inScope, IdMap& ids)
{
    renew(
        model.found.columns, model.corrected.columns, std::move(fresh),
        [&](const Column& c) { return inScope(c.storey); },
        [](const Column& a, const Column& b)
        {
            return (a.center - b.center).norm() < 0.3 &&
                   overlapsInHeight(a.base_m, a.base_m + a.height.value_m, b.base_m, b.base_m + b.height.value_m);
        },
        ids);
}

void renewSlabs(Model& model, std::vector<Slab> fresh, const InScope& inScope, IdMap& ids)
{
    renew(
        model.found.slabs, model.corrected.slabs, std::move(fresh), [&](const Slab& s) { return inScope(s.storey); },
        [](const Slab& a, const Slab& b)
        { return a.kind == b.kind && a.storey == b.storey && isSameOutline(a.outline, b.outline); }, ids);
}

void renewSpaces(Model& model, std::vector<Space> fresh, const InScope& inScope, IdMap& ids)
{
    renew(
        model.found.spaces, model.corrected.spaces, std::move(fresh), [&](const Space& s) { return inScope(s.storey); },
        [](const Space& a, const Space& b) { return a.storey == b.storey && isSameOutline(a.outline, b.outline); },
        ids);
}

void renewStoreys(Model& model, std::vector<Storey> fresh, double reach_m, IdMap& ids)
{
    // The nearest earlier storey of each fresh one, in either state; each is taken once.
    std::vector<Storey> earlier = model.found.storeys;
    std::copy_if(model.corrected.storeys.begin(), model.corrected.storeys.end(), std::back_inserter(earlier),
                 [&](const Storey& s) { return !findElement(model.found.storeys, s.id); });
    const auto distance = [&](const Storey& s, const Storey& f)
    {
        const Storey* other = model.corrected.storey(s.id);
        return std::min(std::abs(s.elevation_m - f.elevation_m),
                        other ? std::abs(other->elevation_m - f.elevation_m) : 1e9);
    };
    std::set<ElementId> taken;
    for (Storey& f : fresh)
    {
        const Storey* nearest = nullptr;
        for (const Storey& s : earlier)
            if (!taken.contains(s.id) && distance(s, f) < (nearest ? distance(*nearest, f) : reach_m))
                nearest = &s;
        ids[f.id] = nearest ? nearest->id : f.id;
        if (!nearest)
            continue;
        f.id = nearest->id;
        f.name = nearest->name;
        taken.insert(f.id);
    }
    const auto byHeight = [](const Storey& a, const Storey& b) { return a.elevation_m < b.elevation_m; };
    std::vector<Storey> found, corrected;
    for (const Storey& f : fresh)
    {
        const Storey* before = model.found.storey(f.id);
        const Storey* now = model.corrected.storey(f.id);
        found.push_back(before && (!now || !isSame(*now, *before)) ? *before
                                                                   : f);  // what was corrected keeps its beginning
        if (!before && !now)
            corrected.push_back(f);
        else if (now)
            corrected.push_back(before && isSame(*now, *before) ? f : *now);
    }
    for (const Storey& s : model.corrected.storeys)  // corrected or added by hand, and not found this time
        if (!taken.contains(s.id) && (!model.found.storey(s.id) || !isSame(*model.found.storey(s.id), s)))
        {
            corrected.push_back(s);
            if (const Storey* before = model.found.storey(s.id))
                found.push_back(*before);
        }
    std::stable_sort(found.begin(), found.end(), byHeight);
    std::stable_sort(corrected.begin(), corrected.end(), byHeight);
    for (Storey& s : corrected)  // new ones need names of their own
        for (int n = 0; std::ranges::count(corrected, s.name, &Storey::name) > 1; ++n)
            s.name = std::format("Level {}", n);
    const auto dropStoreys = [](Building& b, std::vector<Storey> storeys)
    {
        for (const Storey& s : std::vector<Storey>(b.storeys))
            if (!findElement(storeys, s.id))
                b = removeElement(std::move(b), s.id);
        b.storeys = std::move(storeys);
    };
    dropStoreys(model.found, std::move(found));
    dropStoreys(model.corrected, std::move(corrected));
}

}  // namespace s2b

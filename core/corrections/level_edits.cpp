// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/corrections/elements.h"

#include <cmath>

namespace s2b
{
namespace
{

constexpr double kOnFloor_m = 0.02;     // what begins this near to the floor stands on it
constexpr double kLeastHeight_m = 0.5;  // of what stands on a floor that was moved up
constexpr double kSlab_m = 0.2;         // between a ceiling and the floor above where nothing says it
constexpr double kDefaultHeight_m = 2.5;

void sortStoreys(Building& building)
{
    std::stable_sort(building.storeys.begin(), building.storeys.end(),
                     [](const Storey& a, const Storey& b) { return a.elevation_m < b.elevation_m; });
}

}  // namespace

Building moveLevel(Building building, ElementId id, double elevation_m)
{
    Storey* storey = findElement(building.storeys, id);
    if (!storey)
        refuse(building, id, "is no storey");
    if (!std::isfinite(elevation_m))
        refuse(building, id, "can't be moved there");
    const double was = storey->elevation_m, up = elevation_m - was;
    if (up == 0)
        return building;
    const auto stands = [&](ElementId of, double base) { return of == id && std::abs(base - was) < kOnFloor_m; };
    // The top stays where it was seen, unless the floor comes too near to it: then all goes with the floor.
    const auto shorten = [&](Dimension& height)
    {
        if (height.value_m - up >= kLeastHeight_m)
            height = {height.value_m - up, Provenance::Corrected, height.rms_m};
    };
    for (Wall& w : building.walls)
    {
        if (!stands(w.storey, w.base_m))
            continue;
        w.base_m += up;
        shorten(w.height);
        for (Opening& o : building.openings)
        {
            if (o.host != w.id)
                continue;
            if (o.sill.value_m < kOnFloor_m)  // a door follows the floor, its head stays
                shorten(o.height);
            else
                o.sill = {std::max(0.0, o.sill.value_m - up), Provenance::Corrected, o.sill.rms_m};
        }
    }
    for (Column& c : building.columns)
        if (stands(c.storey, c.base_m))
        {
            c.base_m += up;
            shorten(c.height);
        }
    for (Slab& s : building.slabs)
        if (s.kind == SlabKind::Floor && stands(s.storey, s.top_m))
        {
            s.top_m += up;
        }
    for (Space& s : building.spaces)
        if (stands(s.storey, s.floor_m))
        {
            s.floor_m += up;
            shorten(s.height);
        }
    storey->elevation_m = elevation_m;
    shorten(storey->height);
    sortStoreys(building);
    return building;
}

Building addLevel(Building building, double elevation_m)
{
    const Storey* above = nullptr;
    const Storey* below = nullptr;
    for (const Storey& s : building.storeys)
    {
        if (std::abs(s.elevation_m - elevation_m) < kLeastHeight_m)
            refuse(building, s.id, "is already at that height: move its plane instead");
        if (s.elevation_m < elevation_m)
            below = &s;
        else if (!above)
            above = &s;
    }
    Storey storey;
    storey.id = freeId(building);
    storey.elevation_m = elevation_m;
    storey.height = {above   ? above->elevation_m - elevation_m - kSlab_m
                     : below ? below->height.value_m
                             : kDefaultHeight_m,
                     Provenance::Assumed, 0.0};
    if (above)
        storey.height.value_m = std::max(storey.height.value_m, kLeastHeight_m / 2);
    int number = static_cast<int>(building.storeys.size());
    const auto isTaken = [&](const std::string& name)
    { return std::ranges::any_of(building.storeys, [&](const Storey& s) { return s.name == name; }); };
    while (isTaken(storey.name = std::format("Level {}", number)))
        ++number;
    // Below, the storey that reached through this floor ends at it.
    if (Storey* s = below ? findElement(building.storeys, below->id) : nullptr;
        s && s->elevation_m + s->height.value_m > elevation_m)
        s->height = {elevation_m - s->elevation_m, Provenance::Corrected, s->height.rms_m};
    building.storeys.push_back(storey);
    sortStoreys(building);
    return building;
}

}  // namespace s2b

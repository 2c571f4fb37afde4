// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/corrections/corrections.h"

#include "core/corrections/elements.h"
#include "core/corrections/junctions.h"

#include <cmath>
#include <set>
#include <type_traits>

namespace s2b
{
namespace
{

std::string defaultName(const Storey& s)
{
    return s.name;
}
std::string defaultName(const Wall& w)
{
    return std::format("Wall {}", w.id.value);
}
std::string defaultName(const Opening& o)
{
    const char* kind = o.kind == OpeningKind::Door ? "Door" : o.kind == OpeningKind::Window ? "Window" : "Opening";
    return std::format("{} {}", kind, o.id.value);
}
std::string defaultName(const Column& c)
{
    return std::format("Column {}", c.id.value);
}
std::string defaultName(const Slab& s)
{
    return std::format("{} {}", s.kind == SlabKind::Floor ? "Slab" : "Roof", s.id.value);
}
std::string defaultName(const Space& s)
{
    return s.name.empty() ? std::format("Space {}", s.id.value) : s.name;
}

/// Calls with the element of that id; false when there is none.
template <typename AnyBuilding, typename Function>
bool withElement(AnyBuilding& building, ElementId id, const Function& function)
{
    bool isFound = false;
    forEachClass(building,
                 [&](auto& elements)
                 {
                     if (auto* element = findElement(elements, id))
                     {
                         function(*element);
                         isFound = true;
                     }
                 });
    return isFound;
}

/// What refers to walls that are gone goes too.
void dropOrphans(Building& building)
{
    std::set<ElementId> walls;
    for (const Wall& w : building.walls)
        walls.insert(w.id);
    std::erase_if(building.openings, [&](const Opening& o) { return !walls.contains(o.host); });
    std::erase_if(building.junctions,
                  [&](const Junction& j) { return !walls.contains(j.wallA) || !walls.contains(j.wallB); });
    for (Space& space : building.spaces)
        std::erase_if(space.boundedBy, [&](ElementId wall) { return !walls.contains(wall); });
}

}  // namespace

ElementId freeId(const Building& building)
{
    std::uint32_t largest = 0;
    forEachClass(building,
                 [&](const auto& elements)
                 {
                     for (const auto& e : elements)
                         largest = std::max(largest, e.id.value);
                 });
    return ElementId{largest + 1};
}

std::string nameOf(const Building& building, ElementId id)
{
    std::string name;
    withElement(building, id, [&](const auto& e) { name = defaultName(e); });
    return name;
}

ElementId storeyOf(const Building& building, ElementId id)
{
    ElementId storey;
    withElement(building, id,
                [&](const auto& e)
                {
                    if constexpr (requires { e.storey; })
                        storey = e.storey;
                    else if constexpr (requires { e.host; })
                        storey = building.wall(e.host) ? building.wall(e.host)->storey : ElementId{};
                    else
                        storey = e.id;
                });
    return storey;
}

Building removeElement(Building building, ElementId id)
{
    if (nameOf(building, id).empty())
        refuse(building, id, "is not there");
    const bool isStorey = building.storey(id) != nullptr;
    forEachClass(building,
                 [&](auto& elements)
                 {
                     std::erase_if(elements,
                                   [&](const auto& e)
                                   {
                                       if constexpr (requires { e.storey; })
                                           return e.id == id || (isStorey && e.storey == id);
                                       else
                                           return e.id == id;
                                   });
                 });
    dropOrphans(building);
    return building;
}

Model renameElement(Model model, ElementId id, const std::string& name)
{
    if (nameOf(model.corrected, id).empty())
        refuse(model.corrected, id, "is not there");
    if (Storey* s = findElement(model.corrected.storeys, id); s && !name.empty())
        s->name = name;
    else if (Space* space = findElement(model.corrected.spaces, id))
        space->name = name;
    else if (name.empty() || name == nameOf(model.corrected, id))
        model.names.erase(id);
    else
        model.names[id] = name;
    return model;
}

std::string nameOf(const Model& model, ElementId id)
{
    const auto given = model.names.find(id);
    const std::string standard = nameOf(model.corrected, id);
    return given == model.names.end() || standard.empty() ? standard : given->second;
}

std::set<ElementId> placedByHand(const Model& model)
{
    std::set<ElementId> ids;
    const auto compare = [&](const auto& now, const auto& before, const auto& isThere)
    {
        for (const auto& e : now)
            if (const auto* was = findElement(before, e.id); !was || !isThere(e, *was))
                ids.insert(e.id);
    };
    compare(model.corrected.walls, model.found.walls, [](const Wall& a, const Wall& b)
            { return a.start == b.start && a.end == b.end && a.bulge == b.bulge && a.base_m == b.base_m; });
    compare(model.corrected.openings, model.found.openings, [](const Opening& a, const Opening& b)
            { return a.host == b.host && a.offset_m == b.offset_m && a.sill.value_m == b.sill.value_m; });
    compare(model.corrected.columns, model.found.columns, [](const Column& a, const Column& b)
            { return a.center == b.center && a.yaw_rad == b.yaw_rad && a.base_m == b.base_m; });
    return ids;
}

std::optional<ElementKind> kindOf(const Building& building, ElementId id)
{
    if (building.wall(id))
        return ElementKind::Wall;
    if (findElement(building.columns, id))
        return ElementKind::Column;
    if (const Opening* o = findElement(building.openings, id))
        return o->kind == OpeningKind::Door     ? ElementKind::Door
               : o->kind == OpeningKind::Window ? ElementKind::Window
                                                : ElementKind::Opening;
    return std::nullopt;
}

Building setKind(Building building, ElementId id, ElementKind kind)
{
    const std::optional<ElementKind> was = kindOf(building, id);
    if (was == kind)
        return building;
    const bool toOpening = kind != ElementKind::Wall && kind != ElementKind::Column;
    if (Opening* o = findElement(building.openings, id); o && toOpening)
    {
        o->kind = kind == ElementKind::Door     ? OpeningKind::Door
                  : kind == ElementKind::Window ? OpeningKind::Window
                                                : OpeningKind::Plain;
        if (o->kind != OpeningKind::Door)
            o->leaves = 0, o->leafState = LeafState::Unknown, o->hingeAtStart = o->opensToLeft = false;
        return building;
    }
    if (const Wall* w = building.wall(id); w && kind == ElementKind::Column)
    {
        if (w->bulge != 0 || !w->topProfile.empty())
            refuse(building, id, "has no rectangle for a section: it can't become a column");
        if (std::ranges::any_of(building.openings, [&](const Opening& o) { return o.host == id; }))
            refuse(building, id, "has openings: take them out before it becomes a column");
        Column c;
        c.id = id, c.storey = w->storey, c.evidence = w->evidence;
        c.center = w->start + w->direction() * (w->bodyStart_m + w->bodyEnd_m) / 2;
        c.yaw_rad = std::atan2(w->direction().y(), w->direction().x());
        c.base_m = w->base_m, c.height = w->height;
        c.section = RectangleSection{w->bodyEnd_m - w->bodyStart_m, w->thickness.value_m};
        c.sectionProvenance = w->thickness.provenance;
        building.columns.push_back(c);
        std::erase_if(building.walls, [&](const Wall& e) { return e.id == id; });
        dropOrphans(building);
        return building;
    }
    if (const Column* c = findElement(building.columns, id); c && kind == ElementKind::Wall)
    {
        const Eigen::Vector2d box = boxOf(c->section);
        if (std::holds_alternative<CircleSection>(c->section))
            refuse(building, id, "is round: it can't become a wall");
        Wall w;
        w.id = id, w.storey = c->storey, w.evidence = c->evidence;
        const double turn = box.x() >= box.y() ? c->yaw_rad : c->yaw_rad + std::acos(0.0);
        const Eigen::Vector2d along(std::cos(turn), std::sin(turn));
        w.bodyEnd_m = box.maxCoeff();
        w.start = c->center - along * w.bodyEnd_m / 2;
        w.end = c->center + along * w.bodyEnd_m / 2;
        w.base_m = c->base_m, w.height = c->height;
        w.thickness = {box.minCoeff(), c->sectionProvenance, c->evidence.rms_m};
        building.walls.push_back(w);
        std::erase_if(building.columns, [&](const Column& e) { return e.id == id; });
        return building;
    }
    refuse(building, id, "can't become that: openings change among themselves, walls and columns into each other");
}

bool differs(const Building& found, const Building& corrected, ElementId id)
{
    bool isUnchanged = true;
    forEachClass(found,
                 [&](const auto& elements)
                 {
                     using List = std::remove_cvref_t<decltype(elements)>;
                     const auto* before = findElement(elements, id);
                     const typename List::value_type* after = nullptr;
                     forEachClass(corrected,
                                  [&](const auto& others)
                                  {
                                      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(others)>, List>)
                                          after = findElement(others, id);
                                  });
                     isUnchanged = isUnchanged && (before == nullptr) == (after == nullptr) &&
                                   (!before || isSame(*before, *after));
                 });
    return !isUnchanged;
}

std::vector<ElementId> correctedElements(const Building& found, const Building& corrected)
{
    std::set<ElementId> ids;
    for (const Building* b : {&found, &corrected})
        forEachClass(*b,
                     [&](const auto& elements)
                     {
                         for (const auto& e : elements)
                             if (differs(found, corrected, e.id))
                                 ids.insert(e.id);
                     });
    return {ids.begin(), ids.end()};
}

Building resetElement(Building building, const Building& found, ElementId id)
{
    if (nameOf(found, id).empty())
        refuse(building, id, "was added by hand: there is no reconstructed state, delete it instead");
    if (const Opening* o = findElement(found.openings, id); o && !building.wall(o->host))
        refuse(found, id, "belongs to a wall that was taken out: reset that one");
    forEachClass(building, [&](auto& elements) { std::erase_if(elements, [&](const auto& e) { return e.id == id; }); });
    const auto putBack = [](auto& to, const auto& from, const auto& which)
    {
        for (const auto& e : from)
            if (which(e) && !findElement(to, e.id))
                to.push_back(e);
        std::sort(to.begin(), to.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    };
    const auto isIt = [&](const auto& e) { return e.id == id; };
    if (found.wall(id))
    {
        std::erase_if(building.openings, [&](const Opening& o) { return o.host == id; });
        putBack(building.openings, found.openings, [&](const Opening& o) { return o.host == id; });
    }
    putBack(building.storeys, found.storeys, isIt);
    std::sort(building.storeys.begin(), building.storeys.end(),
              [](const Storey& a, const Storey& b) { return a.elevation_m < b.elevation_m; });
    putBack(building.walls, found.walls, isIt);
    putBack(building.openings, found.openings, isIt);
    putBack(building.columns, found.columns, isIt);
    putBack(building.slabs, found.slabs, isIt);
    putBack(building.spaces, found.spaces, isIt);
    dropOrphans(building);
    if (const Wall* w = building.wall(id))
    {
        if (!building.storey(w->storey))
            refuse(building, id, "belongs to a storey that was taken out: reset that one first");
        for (const Junction& j : found.junctions)
            if ((j.wallA == id || j.wallB == id) && building.wall(j.wallA) && building.wall(j.wallB) &&
                std::ranges::none_of(building.junctions, [&](const Junction& k) { return isSame(j, k); }))
                building.junctions.push_back(j);
        restoreNeighbours(building, found, id);
    }
    return building;
}

}  // namespace s2b

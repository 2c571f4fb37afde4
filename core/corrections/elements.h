// SPDX-License-Identifier: GPL-3.0-or-later
/// What the corrections share: finding elements, and refusing in one sentence.
#pragma once

#include "core/base/error.h"
#include "core/corrections/corrections.h"
#include "core/corrections/model.h"
#include "core/corrections/same.h"

#include <algorithm>
#include <format>

namespace s2b
{

template <typename Element>
[[nodiscard]] auto* findElement(std::vector<Element>& elements, ElementId id)
{
    const auto found = std::find_if(elements.begin(), elements.end(), [&](const Element& e) { return e.id == id; });
    return found == elements.end() ? nullptr : &*found;
}
template <typename Element>
[[nodiscard]] const auto* findElement(const std::vector<Element>& elements, ElementId id)
{
    const auto found = std::find_if(elements.begin(), elements.end(), [&](const Element& e) { return e.id == id; });
    return found == elements.end() ? nullptr : &*found;
}

/// Calls with the list of each class of elements, storeys and spaces among them.
template <typename AnyBuilding, typename Function>
void forEachClass(AnyBuilding& building, const Function& function)
{
    function(building.storeys);
    function(building.walls);
    function(building.openings);
    function(building.columns);
    function(building.slabs);
    function(building.spaces);
}

[[noreturn]] inline void refuse(const Building& building, ElementId id, const std::string& why)
{
    const std::string name = nameOf(building, id);
    throw Error(ErrorCode::BadParameter,
                std::format("{} {}", name.empty() ? std::format("element {}", id.value) : name, why));
}

[[nodiscard]] inline Wall& wallOrRefuse(Building& building, ElementId id)
{
    if (Wall* wall = findElement(building.walls, id))
        return *wall;
    refuse(building, id, "is no wall");
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"

#include <map>
#include <set>
#include <string>

namespace s2b
{

/// A reconstruction, and what people made of it. The same ids are the same elements.
struct Model
{
    Building found;                          ///< as the points say
    Building corrected;                      ///< as people left it
    std::map<ElementId, std::string> names;  ///< that people gave to walls, openings, columns and slabs
};

/// The name that a person gave, or the default one ("Wall 12"); empty for an unknown id.
[[nodiscard]] std::string nameOf(const Model& model, ElementId id);

/// Gives the element a name; an empty one is its default again. An unknown id throws Error{BadParameter}.
[[nodiscard]] Model renameElement(Model model, ElementId id, const std::string& name);

/// Those whose place a person set: walls, openings and columns that were added, or lie elsewhere than they were found.
[[nodiscard]] std::set<ElementId> placedByHand(const Model& model);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
/// Puts what was found anew in the place of what was found before, around people's corrections.
#pragma once

#include "core/pipeline/reconstruct_from.h"

#include <functional>
#include <map>
#include <vector>

namespace s2b
{

/// Which id of a fresh run an element has in the model; 0: it was dropped.
using IdMap = std::map<ElementId, ElementId>;

using InScope = std::function<bool(ElementId storey)>;

/// Each replaces the untouched elements in scope (found and corrected) by the fresh ones, see reconstructFrom().
/// @param ids  filled in for the fresh elements
void renewWalls(Model& model, std::vector<Wall> fresh, std::vector<Junction> junctions, const InScope& inScope,
                IdMap& ids);
void renewOpenings(Model& model, std::vector<Opening> fresh, const std::vector<Wall>& hosts,
                   const std::set<OpeningKind>& kinds, const InScope& inScope, IdMap& ids);
void renewColumns(Model& model, std::vector<Column> fresh, const InScope& inScope, IdMap& ids);
void renewSlabs(Model& model, std::vector<Slab> fresh, const InScope& inScope, IdMap& ids);
void renewSpaces(Model& model, std::vector<Space> fresh, const InScope& inScope, IdMap& ids);
/// @param reach_m  the largest distance at which a storey is the same
void renewStoreys(Model& model, std::vector<Storey> fresh, double reach_m, IdMap& ids);

}  // namespace s2b

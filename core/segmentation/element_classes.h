// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/cloud/surface_cells.h"
#include "core/levels/levels.h"

#include <cstdint>
#include <vector>

namespace s2b
{

/// A class and how sure it is.
struct CellClass
{
    Label label = Label::Unassigned;
    std::uint8_t confidence = 0;  ///< the class's probability, 0..255
};

/// Corrects a model's classes by the building that they show. A network sees a pane that fills its opening, or the
/// frame of a door, as a piece of wall; who knows the wall's faces and where the hole in them ends knows better.
///
/// The walls, openings and columns are reconstructed of the cells with these classes (stages as in core/pipeline). Then
/// what lies in an opening between the wall's faces is its window or door, an upright surface in a face beside the
/// openings is wall, and what lies on a column's outline is column.
///
/// @param cells  turned to the building's main directions; their own labels are not looked at
/// @param levels  of the cells; a model's labels would not change them
/// @param classes  by cell; changed in place
/// Cost: about that of a reconstruction without slabs and spaces. Deterministic for any number of threads.
void settleByElements(SurfaceCells cells, const std::vector<Level>& levels, std::vector<CellClass>& classes,
                      const Context& context);

}  // namespace s2b

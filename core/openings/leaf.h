// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/openings/wall_view.h"

namespace s2b
{

/// Finds out what the leaf of a door does, and on which jamb and side an open one hangs (D3.6, 3.5, second step).
///
/// With labels: closed, when points labelled door fill the hole; open, when they stand beside the wall within a leaf's
/// reach of a jamb. Without: open, when an upright plate as wide as the hole (or half of it) and no higher stands out
/// from a jamb. Sets leafState, leaves, hingeAtStart and opensToLeft; leaves the state Unknown otherwise.
void findLeaf(Opening& opening, const WallView& view, const Hole& hole);

}  // namespace s2b

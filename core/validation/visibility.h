// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/validation/surface_survey.h"

namespace s2b::validation
{

/// Lets the points say which truth elements were seen, where the truth file does not (BimElement::visibility).
///
/// An element counts when points lie on at least minimumCoverage of its visible surface (without faces that touch other
/// elements); a straight wall, when they lie on three times that share of one of its sides; a door or window in a wall,
/// when they lie on that share, and on 0.1 m2, of the wall around it: an open or missing leaf is no reason to leave it
/// out. A storey was surveyed when at least that share of its floor slabs' upper side has points, which nobody sees
/// from below, or three times that share of its walls; without floor slabs, when one of its walls or columns counts.
/// Floor and ceiling of a storey are the median heights where its counted walls' points begin and end.
void judgeVisibility(Bim& truth, const SurfaceSurvey& survey, const ValidationParams& params);

}  // namespace s2b::validation

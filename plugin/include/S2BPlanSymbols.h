// SPDX-License-Identifier: GPL-3.0-or-later
// What a floor plan draws of the windows that it cuts: from straight above, a pane's own faces are seen edge on.
#pragma once

#include "core/model/building.h"

#include <memory>

class ccHObject;
class ccMainAppInterface;
class ccShiftedObject;

namespace s2b
{
	//! The outline of each hole that is cut and the pane in it, in the plane of the cut
	/** Each is drawn only while its window is in the tree of the model, and shown.
	    \param tree      the model's
	    \param reference gives the global shift and scale
	    \param cut_m     height of the cut, building frame
	    \return null without any window there
	**/
	std::unique_ptr<ccHObject> makePlanSymbols(ccMainAppInterface& app, const ccHObject& tree, const Building& building, ElementId storey, const ccShiftedObject& reference, double cut_m);
} // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
// What a floor plan draws of the windows that it cuts: from straight above, a pane's own faces are seen edge on.
#pragma once

#include "core/model/building.h"

#include <functional>
#include <memory>

class ccHObject;
class ccMainAppInterface;
class ccShiftedObject;

namespace s2b
{
	//! The outline of each hole that is cut and the pane in it, in the plane of the cut
	/** Each is drawn only while its window is in the tree of the model, shown, and where it was.
	    \param tree      the model's
	    \param reference gives the global shift and scale
	    \param cut_m     height of the cut, building frame
	    \param onChange  called while they are drawn, once for each change: something of the model was moved, drawn anew, added or
	                     deleted, and what is shown is to be made anew, later
	**/
	std::unique_ptr<ccHObject> makePlanSymbols(ccMainAppInterface& app, const ccHObject& tree, const Building& building, ElementId storey, const ccShiftedObject& reference, double cut_m, std::function<void()> onChange);
} // namespace s2b

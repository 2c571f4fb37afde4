// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ccHObject.h>

class ccMainAppInterface;

namespace s2b
{
	//! How high above a storey's floor its plan is cut: doors and most windows are open there
	inline constexpr double kPlanCut_m = 1.2;

	//! Whether there is something to cut, or a plan to come back from
	bool canToggleFloorPlan(const ccHObject::Container& selection);

	//! The active view from straight above, along the walls, with everything cut above the selected storey's floor
	/** The storey is that of the selected element, or the lowest of the selected model. A second time goes back to the view
	    as it was, or on to another storey when one is selected. Only the display changes: no entity does. The plan follows
	    corrections of the model.
	**/
	void toggleFloorPlan(ccMainAppInterface& app);
} // namespace s2b

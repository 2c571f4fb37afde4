// SPDX-License-Identifier: GPL-3.0-or-later
// The actions of the menu, as functions of the application.
#pragma once

#include <ccHObject.h>
#include <vector>

class ccMainAppInterface;
class ccPointCloud;

namespace s2b
{
	//! The clouds of a selection; empty when something else is selected too
	std::vector<ccPointCloud*> cloudsOf(const ccHObject::Container& selection);

	//! The reconstructed model that the selection is (a part of), or null
	ccHObject* modelOf(const ccHObject::Container& selection);

	//! Asks for the parameters, reconstructs in a worker thread and adds the model to the DB tree
	/** Two or more clouds are taken together. They are not changed. Cancelling leaves nothing behind. **/
	void reconstructSelection(ccMainAppInterface& app);

	//! Asks for a file and writes the selected model without the elements that were deleted from its tree
	void exportSelection(ccMainAppInterface& app);
} // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
// The actions of the menu, as functions of the application.
#pragma once

#include "core/model/building.h"

#include <QString>
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

	//! The model of a tree without what was deleted from it
	/** \throws Error{BadFile} when the tree does not hold one **/
	Building correctedModel(const ccHObject& tree);

	//! Says something in the console, after "[S2B] "
	void say(ccMainAppInterface& app, const QString& text, bool isWarning = false);
	//! Says it in a box too
	void complain(ccMainAppInterface& app, const QString& text);

	//! Asks for the parameters, reconstructs in a worker thread and adds the model to the DB tree
	/** Two or more clouds are taken together. They are not changed. Cancelling leaves nothing behind. **/
	void reconstructSelection(ccMainAppInterface& app);

	//! Asks for the model, labels the points in a worker thread and adds class and confidence to the clouds as scalar fields
	/** Two or more clouds are taken together. Nothing else of them changes. Cancelling leaves nothing behind. **/
	void segmentSelection(ccMainAppInterface& app);

	//! Asks for a file and writes the selected model without the elements that were deleted from its tree
	void exportSelection(ccMainAppInterface& app);

	//! What Validate takes: clouds, one model, or both
	struct ValidationSelection
	{
		std::vector<ccPointCloud*> clouds;
		ccHObject*                 model = nullptr;
		bool                       isEmpty() const
		{
			return clouds.empty() && !model;
		}
	};
	//! Empty when something else is selected too
	ValidationSelection validationSelection(const ccHObject::Container& selection);

	//! Asks for the ground truth, compares in a worker thread; adds the elements in the colours of their verdicts and a
	//! copy of each cloud with its deviations to the DB tree, and writes the report
	/** What is selected is only hidden. Cancelling leaves nothing behind. **/
	void validateSelection(ccMainAppInterface& app);
} // namespace s2b

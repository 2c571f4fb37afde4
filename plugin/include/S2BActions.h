// SPDX-License-Identifier: GPL-3.0-or-later
// The actions of the menu, as functions of the application.
#pragma once

#include "core/corrections/model.h"
#include "core/pipeline/pipeline.h"

#include <QString>
#include <ccHObject.h>
#include <set>
#include <vector>

class ccMainAppInterface;
class ccPointCloud;

namespace s2b
{
	//! The clouds of a selection; empty when something else is selected too, or one that is a part of a model
	std::vector<ccPointCloud*> cloudsOf(const ccHObject::Container& selection);

	//! The reconstructed model that the selection is (a part of), or null
	ccHObject* modelOf(const ccHObject::Container& selection);

	//! The model of a tree as people left it: see readModel()
	/** \throws Error{BadFile} when the tree does not hold one, Error{BadParameter} for a motion that an element can't take **/
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

	//! What a stage runs on: clouds, a model (or a part of it), or both
	struct StageSelection
	{
		std::vector<ccPointCloud*> clouds;
		ccHObject*                 model = nullptr;
		ElementId                  storey; //!< of the part that is selected; 0: all
		bool                       isEmpty() const
		{
			return clouds.empty() && !model;
		}
	};
	//! Empty when something else is selected too
	StageSelection stageSelection(const ccHObject::Container& selection);

	//! Runs single stages on the selection with the parameters of the last reconstruction, in a worker thread
	/** What earlier stages and people's corrections left in the tree is used, and what they need and nobody made is made
	    first. A storey, or a part of one, that is selected is the only one that is renewed.
	    \param stages  those of the action
	**/
	void runStages(ccMainAppInterface& app, const std::set<Stage>& stages);

	//! Says what was found, what is assumed and what was uncertain in the console
	void sayResult(ccMainAppInterface& app, const Building& building);

	//! Adds a model of these clouds to the DB tree
	/** \param given  the levels that it was made with, if any were given **/
	void addModel(ccMainAppInterface& app, const Model& model, const std::vector<ccPointCloud*>& clouds, const std::vector<StoreyHeights>& given = {});

	//! Shows or hides what is behind the faces of the selected model
	void toggleTranslucent(ccMainAppInterface& app);

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

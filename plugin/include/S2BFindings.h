// SPDX-License-Identifier: GPL-3.0-or-later
// A reconstruction's diagnostics as entities: a label where each of them is.
#pragma once

#include "core/model/building.h"

#include <QString>
#include <ccHObject.h>
#include <memory>
#include <vector>

class ccMainAppInterface;
class ccShiftedObject;

namespace s2b
{
	//! The key under which a label keeps which diagnostic it is: its code
	inline constexpr char kFindingKey[] = "S2B.Finding";
	//! The key of the group
	inline constexpr char kFindingsKey[] = "S2B.Findings";

	//! "Thickness assumed" of "ThicknessAssumed"
	QString findingTitle(const QString& code);

	//! Where a diagnostic is, building frame; where only its height is known, in the middle of the plan
	Eigen::Vector3d placeOf(const Building& building, const Diagnostic& diagnostic);

	//! A group of one label for each diagnostic, the worst first; null without any
	/** What a diagnostic says is its label's meta data, so that it survives a save to .bin.
	    \param reference gives the global shift and scale
	**/
	std::unique_ptr<ccHObject> makeFindings(const Building& building, const ccShiftedObject& reference);

	//! Brings the group of a model to its present diagnostics
	/** Those that people took out of the tree stay out, and those that they hid or showed stay so. Without any difference
	    nothing is touched.
	    \param before    the building that the group was made of
	    \param reference gives the global shift and scale
	**/
	void renewFindings(ccMainAppInterface& app, ccHObject& model, const Building& before, const Building& after, const ccShiftedObject& reference);

	//! Brings the counts in the groups' names to the labels that are left; false when they were right
	bool recountFindings(ccHObject& tree);

	//! What the meta data of a label says
	struct Finding
	{
		unsigned  id       = 0; //!< unique id of the label
		Severity  severity = Severity::Info;
		QString   title;
		QString   stage;
		QString   text;
		QString   element; //!< "Wall 12", empty when it is about none
		CCVector3 place;   //!< in the entities' own coordinates
	};

	//! The findings below an entity, in the order of the tree
	std::vector<Finding> findingsIn(const ccHObject& tree);

	//! The finding that a single selected label is; null for any other selection
	ccHObject* findingOf(const ccHObject::Container& selection);

	//! Takes the camera to a finding and opens its label, and closes the one before
	void showFinding(ccMainAppInterface& app, ccHObject& label);
} // namespace s2b

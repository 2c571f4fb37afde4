// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/corrections/model.h"

#include <QString>
#include <functional>
#include <set>

class ccHObject;
class ccMainAppInterface;

namespace s2b
{
	//! Brings a model's group in the DB tree to another state; entities that show what they should stay as they are
	/** What is hidden stays hidden, what is selected elsewhere selected. The findings are renewed, new ones are said.
	    \param anew  elements whose entities are made anew in any case
	**/
	void updateTree(ccMainAppInterface& app, ccHObject& root, const Model& model, const std::set<ElementId>& anew = {});

	//! Reads a group, corrects its model and shows the result
	/** \param unmoved  elements whose entities' motion does not count
	    \return what was wrong, in one sentence; empty when all went well. Then nothing was changed.
	**/
	QString editModel(ccMainAppInterface& app, ccHObject& root, const std::function<Model(const Model&)>& change, const std::set<ElementId>& unmoved = {});

	//! Shows or hides what is behind a model's faces
	void setTranslucent(ccHObject& root, bool isTranslucent);
	//! Whether a model is shown so
	bool isTranslucent(const ccHObject& root);
} // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
// Where the camera looks, and what is picked out in the DB tree.
#pragma once

#include <QString>
#include <ccHObject.h>

class QAbstractItemModel;
class ccMainAppInterface;

namespace s2b
{
	//! Takes the camera to a place without turning it
	/** \param radius how much around it is shown, in the entities' own units **/
	void lookAt(ccMainAppInterface& app, const CCVector3& place, double radius);

	//! Takes the camera to an entity without turning it
	void lookAt(ccMainAppInterface& app, const ccHObject& entity);

	//! Makes an entity the only selected one, and shows it in the DB tree
	void selectOnly(ccMainAppInterface& app, ccHObject* entity);

	//! The entity of that unique id, or null when it is gone
	ccHObject* findEntity(ccMainAppInterface& app, unsigned id);

	//! Shows names that changed in the DB tree
	void redrawTree(ccMainAppInterface& app);

	//! The model behind the DB tree: it tells when entities come and go. Null in a window without one.
	QAbstractItemModel* treeModel(ccMainAppInterface& app);
} // namespace s2b

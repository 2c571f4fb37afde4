// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BView.h"

#include <QMainWindow>
#include <QTreeView>
#include <ccGLWindowInterface.h>
#include <ccMainAppInterface.h>

namespace s2b
{
	namespace
	{
		QTreeView* treeView(ccMainAppInterface& app)
		{
			return app.getMainWindow()->findChild<QTreeView*>("dbTreeView"); // CloudCompare's own name for it
		}

		void lookAtBox(ccMainAppInterface& app, const ccBBox& box)
		{
			ccGLWindowInterface* view = app.getActiveGLWindow();
			if (!view || !box.isValid())
				return;
			view->updateConstellationCenterAndZoom(&box);
			view->redraw();
		}
	} // namespace

	void lookAt(ccMainAppInterface& app, const CCVector3& place, double radius)
	{
		const auto      reach = static_cast<PointCoordinateType>(radius);
		const CCVector3 corner(reach, reach, reach);
		ccBBox          box;
		box.add(place - corner);
		box.add(place + corner);
		box.setValidity(true);
		lookAtBox(app, box);
	}

	void lookAt(ccMainAppInterface& app, const ccHObject& entity)
	{
		// Asking for the box changes nothing, but is not const.
		lookAtBox(app, const_cast<ccHObject&>(entity).getDisplayBB_recursive(false));
	}

	void selectOnly(ccMainAppInterface& app, ccHObject* entity)
	{
		const ccHObject::Container selection = app.getSelectedEntities(); // a copy: it changes below
		for (ccHObject* other : selection)
		{
			if (other != entity)
				app.setSelectedInDB(other, false);
		}
		if (!entity)
			return;
		app.setSelectedInDB(entity, true);
		if (QTreeView* view = treeView(app))
			view->scrollTo(view->currentIndex());
	}

	ccHObject* findEntity(ccMainAppInterface& app, unsigned id)
	{
		return app.dbRootObject() ? app.dbRootObject()->find(id) : nullptr;
	}

	void redrawTree(ccMainAppInterface& app)
	{
		if (QTreeView* view = treeView(app))
			view->viewport()->update();
	}

	QAbstractItemModel* treeModel(ccMainAppInterface& app)
	{
		const QTreeView* view = treeView(app);
		return view ? view->model() : nullptr;
	}
} // namespace s2b

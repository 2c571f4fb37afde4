// SPDX-License-Identifier: GPL-3.0-or-later
// The action Segment...
#include "S2BActions.h"
#include "S2BInput.h"
#include "S2BSegment.h"
#include "S2BSegmentDlg.h"
#include "S2BWorker.h"

#include <QMainWindow>
#include <algorithm>
#include <ccMainAppInterface.h>
#include <ccPointCloud.h>

namespace s2b
{
	void segmentSelection(ccMainAppInterface& app)
	{
		const std::vector<ccPointCloud*> clouds = cloudsOf(app.getSelectedEntities());
		if (clouds.empty())
			return;
		try
		{
			const bool    hasColors = std::all_of(clouds.begin(), clouds.end(), [](const ccPointCloud* cloud)
                                               { return cloud->hasColors(); });
			const QString subject   = clouds.size() == 1 ? clouds.front()->getName() : QString("%1 clouds, taken together").arg(clouds.size());
			S2BSegmentDlg dialog(subject, hasColors, app.getMainWindow());
			if (dialog.exec() != QDialog::Accepted)
				return;

			Input      input;
			const bool isDone = runInBackground(app, {}, [&](const Context& context)
			                                    {
				                                    input = readClouds({clouds.begin(), clouds.end()}, {false, {}, {}}, context);
				                                    segmentInput(input, openModel(dialog.modelPath(), context.threads), context); });
			if (!isDone)
			{
				say(app, "cancelled, nothing was changed");
				return;
			}
			say(app, QString("labels from %1: %2").arg(input.labelField, segmentationText(input)));
			std::size_t first = 0;
			for (ccPointCloud* cloud : clouds)
			{
				addSegmentationFields(*cloud, input, first);
				first += cloud->size();
				cloud->prepareDisplayForRefresh();
			}
			app.refreshAll();
			app.updateUI();
		}
		catch (const std::bad_alloc&)
		{
			complain(app, "Not enough memory: subsample the cloud first.");
		}
		catch (const std::exception& e)
		{
			complain(app, QString::fromUtf8(e.what()));
		}
	}
} // namespace s2b

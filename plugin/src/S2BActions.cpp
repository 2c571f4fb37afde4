// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BActions.h"

#include "S2BEntities.h"
#include "S2BExportDlg.h"
#include "S2BModel.h"
#include "S2BReconstructDlg.h"
#include "S2BRun.h"
#include "S2BSummary.h"
#include "S2BWorker.h"
#include "core/base/error.h"

#include <QFileInfo>
#include <QMainWindow>
#include <QMessageBox>
#include <ccMainAppInterface.h>
#include <ccPointCloud.h>

namespace s2b
{
	namespace
	{
		constexpr int kMaxDiagnostics = 50;
	} // namespace

	void say(ccMainAppInterface& app, const QString& text, bool isWarning)
	{
		app.dispToConsole("[S2B] " + text, isWarning ? ccMainAppInterface::WRN_CONSOLE_MESSAGE : ccMainAppInterface::STD_CONSOLE_MESSAGE);
	}

	void complain(ccMainAppInterface& app, const QString& text)
	{
		say(app, text, true);
		QMessageBox box(QMessageBox::Warning, "Scan to BIM", text, QMessageBox::Ok, app.getMainWindow());
		box.setObjectName("S2BMessage");
		box.exec();
	}

	void sayResult(ccMainAppInterface& app, const Building& building)
	{
		for (const QString& line : summary(building))
			say(app, line);
		for (const QString& line : assumptions(building))
			say(app, line, true);
		int shown = 0;
		for (const Diagnostic& diagnostic : building.diagnostics)
		{
			if (++shown > kMaxDiagnostics)
				break;
			say(app, diagnosticText(building, diagnostic), diagnostic.severity != Severity::Info);
		}
		if (building.diagnostics.size() > kMaxDiagnostics)
			say(app, QString("... and %1 more").arg(building.diagnostics.size() - kMaxDiagnostics));
	}

	Building correctedModel(const ccHObject& tree)
	{
		return readModel(tree).model.corrected;
	}

	std::vector<ccPointCloud*> cloudsOf(const ccHObject::Container& selection)
	{
		std::vector<ccPointCloud*> clouds;
		for (ccHObject* entity : selection)
		{
			if (!entity || !entity->isA(CC_TYPES::POINT_CLOUD) || modelOf({entity}))
				return {};
			clouds.push_back(static_cast<ccPointCloud*>(entity));
		}
		return clouds;
	}

	ccHObject* modelOf(const ccHObject::Container& selection)
	{
		if (selection.size() != 1)
			return nullptr;
		for (ccHObject* entity = selection.front(); entity; entity = entity->getParent())
		{
			if (entity->hasMetaData(kBuildingKey))
				return entity;
		}
		return nullptr;
	}

	void reconstructSelection(ccMainAppInterface& app)
	{
		const std::vector<ccPointCloud*> clouds = cloudsOf(app.getSelectedEntities());
		if (clouds.empty())
			return;
		try
		{
			S2BReconstructDlg dialog({clouds.begin(), clouds.end()}, app.getMainWindow());
			if (dialog.exec() != QDialog::Accepted)
				return;
			const RunChoice choice = dialog.choice();

			const std::optional<Building> building = reconstructInBackground({clouds.begin(), clouds.end()}, choice, clouds.front()->getName(), app);
			if (!building)
			{
				say(app, "cancelled, nothing was changed");
				return;
			}
			sayResult(app, *building);
			if (!choice.ifcPath.isEmpty())
				say(app, "wrote " + choice.ifcPath);
			addModel(app, Model{*building, *building, {}}, clouds, choice.pipeline.levels);
			app.redrawAll();
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

	void exportSelection(ccMainAppInterface& app)
	{
		const ccHObject* model = modelOf(app.getSelectedEntities());
		if (!model)
			return;
		try
		{
			const Model corrected = readModel(*model).model;

			S2BExportDlg dialog(model->getName().section('.', 0, 0).remove(" [BIM]") + ".ifc", app.getMainWindow());
			if (dialog.exec() != QDialog::Accepted)
				return;
			const QString path = dialog.path();

			ifc::WriteOptions options;
			options.schema       = dialog.schema().toStdString();
			options.epsg         = dialog.epsg();
			options.projectName  = QFileInfo(path).completeBaseName().toStdString();
			options.names        = corrected.names;
			options.placedByHand = placedByHand(corrected);
			writeModel(corrected.corrected, path, options);
			say(app, "wrote " + path);
		}
		catch (const std::exception& e)
		{
			complain(app, QString::fromUtf8(e.what()));
		}
	}
} // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
// The action Validate against BIM...
#include "S2BActions.h"
#include "S2BInput.h"
#include "S2BRun.h"
#include "S2BValidate.h"
#include "S2BValidateDlg.h"
#include "S2BValidationDock.h"
#include "S2BValidationTree.h"
#include "S2BWorker.h"
#include "core/base/error.h"
#include "core/report/scene.h"

#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QMainWindow>
#include <QTemporaryDir>
#include <QUrl>
#include <algorithm>
#include <ccMainAppInterface.h>
#include <ccMesh.h>
#include <ccPointCloud.h>

namespace s2b
{
	namespace
	{
		constexpr double kRead     = 0.3; // shares of the time
		constexpr double kCompared = 0.9;

		// Labels tell furniture from walls; without usable ones the geometry alone does.
		Input readWithUsableLabels(const std::vector<ccPointCloud*>& clouds, const Context& running)
		{
			const std::vector<const ccPointCloud*> all(clouds.begin(), clouds.end());
			try
			{
				return readClouds(all, {true, {}, builtInLabelMap("s2b")}, running);
			}
			catch (const Error& e)
			{
				if (e.code() != ErrorCode::BadLabels)
					throw;
				running.say(LogLevel::Warning, std::string("the labels are not used: ") + e.what());
				return readClouds(all, {false, {}, {}}, running);
			}
		}

		QString plainName(QString name)
		{
			return name.remove(" [BIM]").section(" - ", 0, 0).section('.', 0, 0).trimmed();
		}

		const ccShiftedObject* referenceOf(const ValidationSelection& selection)
		{
			if (!selection.clouds.empty())
				return selection.clouds.front();
			ccHObject::Container meshes;
			selection.model->filterChildren(meshes, true, CC_TYPES::MESH, true);
			return meshes.empty() ? nullptr : static_cast<ccMesh*>(meshes.front());
		}

		struct Work
		{
			ValidationChoice choice;
			QString          name; //!< of what is validated
			const Building*  building = nullptr;
			QString          cloudName;
			KeptReport       report; //!< where it is written
			//! Runs in the worker
			ValidationOutcome compare(const CloudView* cloud, const Context& context) const;
		};

		// The model is written and read back: what is measured is what everybody else will read.
		ValidationOutcome Work::compare(const CloudView* cloud, const Context& context) const
		{
			context.report("Reading the models", 0.0);
			std::optional<Eigen::Vector3d> near;
			if (cloud)
				near = middleOf(*cloud);
			std::optional<validation::Bim> truth;
			if (!choice.truthPath.isEmpty())
				truth = readGroundTruth(choice.truthPath, near, choice.storeys, context);
			if (truth && cloud)
				checkPlace(*truth, *cloud);
			if (truth && !near)
				near = validation::centerOf(*truth);

			validation::Bim result;
			if (building)
			{
				context.report("Reading the models", kRead / 2);
				const QTemporaryDir folder;
				const QString       path = folder.filePath(name + ".ifc");
				if (!folder.isValid())
					throw Error(ErrorCode::CannotWrite, "there is no temporary folder to write the model to: " + folder.errorString().toStdString());
				ifc::WriteOptions options;
				options.projectName = name.toStdString();
				writeModel(*building, path, options);
				result = readModel(path, near, context);
			}
			else
			{
				result = std::move(*truth);
				truth.reset();
			}
			validation::ValidationParams params;
			params.tolerance          = choice.tolerance;
			ValidationOutcome outcome = compareModels(std::move(truth), std::move(result), cloud, params, partOf(context, kRead, kCompared));
			report::writeReport(reportInput(outcome, cloud, {cloudName, building, {}}), QFile::encodeName(report.folder).toStdString(), partOf(context, kCompared, 1.0));
			return outcome;
		}

		// A report that nobody asked for is kept for as long as the window, so that it can be asked for later: by then the
		// cloud may be gone.
		KeptReport reportOf(const ValidationChoice& choice)
		{
			if (!choice.reportFolder.isEmpty())
				return {choice.reportFolder, nullptr};
			auto temporary = std::make_shared<QTemporaryDir>();
			if (!temporary->isValid())
				throw Error(ErrorCode::CannotWrite, "there is no temporary folder to write the report to: " + temporary->errorString().toStdString());
			const QString folder = temporary->filePath("report");
			return {folder, std::move(temporary)};
		}

		using Copies = std::vector<std::unique_ptr<ccPointCloud>>;

		// Runs in the worker: millions of points are copied.
		Copies deviationCopies(const std::vector<ccPointCloud*>& clouds, const ValidationOutcome& outcome)
		{
			const double limit_m = report::makeScene(reportInput(outcome, nullptr, {})).colorRange_m;
			Copies       copies;
			std::size_t  first = 0;
			for (const ccPointCloud* cloud : clouds)
			{
				copies.push_back(deviationCopy(*cloud, *outcome.figures.cloudToResult, first, limit_m));
				first += cloud->size();
			}
			return copies;
		}

		void showOutcome(ccMainAppInterface& app, const ValidationSelection& selection, const ValidationOutcome& outcome, Copies copies, const QString& name, const KeptReport& report)
		{
			std::unique_ptr<ccHObject> tree;
			if (const ccShiftedObject* reference = referenceOf(selection))
				tree = makeValidationTree(outcome, *reference, name + " [validation]");

			// From here on nothing fails.
			ccHObject* shown = selection.model ? selection.model : static_cast<ccHObject*>(selection.clouds.front());
			for (std::size_t i = 0; i < copies.size(); ++i)
			{
				copies[i]->setDisplay(selection.clouds[i]->getDisplay());
				app.addToDB(copies[i].release(), false, true, false, false);
				selection.clouds[i]->setEnabled(false);
			}
			ccHObject* validation = tree && tree->getChildrenNumber() ? tree.release() : nullptr; // the application's
			if (validation)
			{
				if (!report.temporary)
					validation->setMetaData(kReportKey, QDir(report.folder).absolutePath());
				validation->setDisplay_recursive(shown->getDisplay());
				app.addToDB(validation, false, true, false, false);
			}
			if (selection.model)
				selection.model->setEnabled(false);
			if (validation)
			{
				auto* dock = S2BDock::of<S2BValidationDock>(app);
				dock->setValidation(validation, report);
				dock->offer();
			}
			app.refreshAll();
			app.redrawAll();
			app.updateUI();
		}
	} // namespace

	ValidationSelection validationSelection(const ccHObject::Container& selection)
	{
		ValidationSelection found;
		for (ccHObject* entity : selection)
		{
			ccHObject* model = entity ? modelOf({entity}) : nullptr;
			if (model && (!found.model || found.model == model))
				found.model = model;
			else if (!model && entity && entity->isA(CC_TYPES::POINT_CLOUD))
				found.clouds.push_back(static_cast<ccPointCloud*>(entity));
			else
				return {};
		}
		return found;
	}

	void validateSelection(ccMainAppInterface& app)
	{
		const ValidationSelection selection = validationSelection(app.getSelectedEntities());
		if (selection.isEmpty())
			return;
		try
		{
			QStringList names;
			for (const ccPointCloud* cloud : selection.clouds)
				names << cloud->getName();
			Work work;
			work.cloudName = names.join(", ");
			if (selection.model)
				names.prepend(selection.model->getName());
			work.name = plainName(names.front());

			S2BValidateDlg dialog(names.join(" and "), work.name, selection.model && !selection.clouds.empty(), app.getMainWindow());
			if (dialog.exec() != QDialog::Accepted)
				return;
			work.choice = dialog.choice();
			work.report = reportOf(work.choice);

			Building building;
			if (selection.model)
			{
				building      = correctedModel(*selection.model);
				work.building = &building;
			}
			std::optional<ValidationOutcome> outcome;
			Copies                           copies;
			const bool                       isDone = runInBackground(app, {}, [&](const Context& context)
                                                {
				                                                const std::optional<Input> input = selection.clouds.empty() ? std::nullopt : std::optional(readWithUsableLabels(selection.clouds, context));
				                                                outcome                          = work.compare(input ? &input->view : nullptr, context);
				                                                copies = deviationCopies(selection.clouds, *outcome); });
			if (!isDone || !outcome)
			{
				say(app, "cancelled, nothing was changed");
				return;
			}
			for (const QString& line : validationSummary(*outcome))
				say(app, line);
			showOutcome(app, selection, *outcome, std::move(copies), work.name, work.report);
			if (work.choice.reportFolder.isEmpty())
				return;
			const QString page = QDir(work.choice.reportFolder).absoluteFilePath("report.html");
			say(app, "wrote " + page);
			if (work.choice.opensReport && !QDesktopServices::openUrl(QUrl::fromLocalFile(page)))
				say(app, "the page could not be opened here: open it with a browser", true);
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

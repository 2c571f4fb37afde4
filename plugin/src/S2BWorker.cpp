// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BWorker.h"

#include "S2BInput.h"
#include "S2BMemory.h"
#include "S2BReconstructDlg.h"
#include "S2BRun.h"
#include "S2BSegment.h"
#include "S2BSummary.h"
#include "S2BValidate.h"
#include "core/base/error.h"

#include <QEventLoop>
#include <QFutureWatcher>
#include <QMainWindow>
#include <QtConcurrent>
#include <ccMainAppInterface.h>
#include <ccProgressDialog.h>
#include <exception>
#include <map>
#include <stop_token>

namespace s2b
{
	namespace
	{
		// The core's names of its stages, in words for people who have never heard of them.
		QString progressText(std::string_view stage)
		{
			static const std::map<QString, QString> kTexts{
			    {"Clutter", "Leaving out the surroundings"},
			    {"Surface cells", "Sorting the points into surface cells"},
			    {"Building frame", "Finding the directions of the walls"},
			    {"Levels", "Finding floors and ceilings"},
			    {"Rooms", "Dividing the plans into rooms"},
			    {"Slabs", "Outlines of the slabs"},
			    {"Spaces", "Rooms as spaces"},
			};
			const QString text  = QString::fromUtf8(stage.data(), static_cast<int>(stage.size()));
			const auto    known = kTexts.find(text);
			return known == kTexts.end() ? text : known->second;
		}
	} // namespace

	bool runInBackground(ccMainAppInterface& app, Context context, const std::function<void(const Context&)>& work)
	{
		ccProgressDialog progress(true, app.getMainWindow());
		progress.setObjectName("S2BProgress");
		progress.setMethodTitle(QString("Scan to BIM"));
		progress.setInfo(QString("Starting"));
		progress.setWindowModality(Qt::ApplicationModal);
		progress.setAutoClose(false);
		progress.setAutoReset(false);
		progress.setMinimumDuration(0);

		std::stop_source stop;
		QObject::connect(&progress, &QProgressDialog::canceled, &progress, [&]
		                 {
			                 stop.request_stop();
			                 progress.setLabelText("Cancelling"); });

		// What the worker says is queued to the window's thread, which alone touches widgets.
		context.cancel   = stop.get_token();
		context.progress = [&progress](std::string_view text, double fraction)
		{
			const QString line    = progressText(text);
			const int     percent = static_cast<int>(100.0 * fraction);
			QMetaObject::invokeMethod(
			    &progress, [&progress, line, percent]
			    {
				    if (progress.wasCanceled())
					    return;
				    progress.setLabelText(line);
				    progress.setValue(percent); },
			    Qt::QueuedConnection);
		};
		context.log = [&progress, &app](LogLevel level, std::string_view text)
		{
			const QString line = "[S2B] " + QString::fromUtf8(text.data(), static_cast<int>(text.size()));
			QMetaObject::invokeMethod(
			    &progress, [&app, line, level]
			    { app.dispToConsole(line, level == LogLevel::Info ? ccMainAppInterface::STD_CONSOLE_MESSAGE : ccMainAppInterface::WRN_CONSOLE_MESSAGE); },
			    Qt::QueuedConnection);
		};

		bool               isDone = false;
		std::exception_ptr failure;
		const auto         guarded = [&]
		{
			try
			{
				work(context);
				isDone = true;
			}
			catch (const Cancelled&)
			{
			}
			catch (...)
			{
				failure = std::current_exception();
			}
			returnFreeMemory(); // 0.4 GB after 30 million points
		};

		QEventLoop           loop;
		QFutureWatcher<void> watcher;
		QObject::connect(&watcher, &QFutureWatcher<void>::finished, &loop, &QEventLoop::quit);
		progress.show();
		watcher.setFuture(QtConcurrent::run(guarded));
		loop.exec();
		stop.request_stop(); // CloudCompare quits: the worker may not outlive what it works with
		watcher.waitForFinished();
		progress.close();

		if (failure)
			std::rethrow_exception(failure);
		return isDone;
	}

	Input readClouds(const std::vector<const ccPointCloud*>& clouds, const LabelChoice& labels, const Context& running)
	{
		running.report(labels.use ? "Reading the points and their labels" : "Reading the points", 0.0);
		Input      input    = makeInput(clouds, labels, {}, running);
		const bool hasModel = labels.orModel && !input.view.labels && hasShippedModel();
		if (!input.warning.isEmpty())
			running.say(LogLevel::Warning, insteadOfLabels(input, hasModel).toStdString());
		if (hasModel)
		{
			segmentInput(input, openModel({}, running.threads), partOf(running, 0.0, kLabelled));
			running.say(LogLevel::Info, "labels of the shipped model: " + segmentationText(input).toStdString());
			return input;
		}
		if (!input.labelField.isEmpty())
			running.say(LogLevel::Info, labelSummary(input, QString::fromStdString(labels.map.name)).toStdString());
		if (!input.stationText.isEmpty())
			running.say(LogLevel::Info, input.stationText.toStdString());
		return input;
	}

	std::optional<Building> reconstructInBackground(const std::vector<const ccPointCloud*>& clouds, const RunChoice& choice, const QString& projectName, ccMainAppInterface& app)
	{
		Context context;
		context.threads = choice.threads;
		context.seed    = choice.seed;
		std::optional<Building> building;
		runInBackground(app, context, [&](const Context& running)
		                {
			                const Input input  = readClouds(clouds, choice.labels, running);
			                const bool  isLabelled = input.view.confidence && input.labelField != kClassField; // just now, by the model
			                Building    result  = reconstruct(input.view, choice.pipeline, partOf(running, isLabelled ? kLabelled : 0.0, 1.0));
			                running.report("Writing the IFC file", 1.0);
			                if (!choice.ifcPath.isEmpty())
			                {
				                ifc::WriteOptions options = writeOptions(choice.pipeline, choice.seed, projectName, choice.schema);
				                options.epsg              = choice.epsg;
				                writeModel(result, choice.ifcPath, options);
			                }
			                building = std::move(result); });
		return building;
	}
} // namespace s2b

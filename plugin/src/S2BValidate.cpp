// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BValidate.h"

#include "S2BRun.h"
#include "core/base/error.h"
#include "core/report/scene.h"
#include "core/validation/overlap.h"
#include "ifc/bim_reader.h"

#include <Eigen/Geometry>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <chrono>
#include <functional>
#include <future>
#include <limits>
#include <mutex>
#include <thread>

namespace s2b
{
	using validation::Bim;
	using validation::ElementClass;

	namespace
	{
		constexpr int kPoll_ms = 20;

		// The libraries that read IFC can't be stopped: on a cancel the thread is left to end by itself, with what it owns.
		Bim readInterruptibly(const std::function<Bim()>& read, const Context& context)
		{
			auto task   = std::make_shared<std::packaged_task<Bim()>>([read]
                                                                    {
				                                                          const std::lock_guard lock(ifcMutex());
				                                                          return read(); });
			auto result = task->get_future();
			std::thread([task]
			            { (*task)(); })
			    .detach();
			while (result.wait_for(std::chrono::milliseconds(kPoll_ms)) != std::future_status::ready)
				context.checkCancelled();
			return result.get();
		}

		Eigen::AlignedBox3d boxOf(const CloudView& cloud)
		{
			Eigen::Vector3f low  = Eigen::Vector3f::Constant(std::numeric_limits<float>::max());
			Eigen::Vector3f high = -low;
			for (std::size_t i = 0; i < cloud.count; ++i)
			{
				const Eigen::Map<const Eigen::Vector3f> p(cloud.xyz + 3 * i);
				low  = low.cwiseMin(p);
				high = high.cwiseMax(p);
			}
			return {Eigen::Vector3d(low.cast<double>() + cloud.origin), Eigen::Vector3d(high.cast<double>() + cloud.origin)};
		}

		QString millimetres(double length_m)
		{
			return QString("%1 mm").arg(1000.0 * length_m, 0, 'f', 1);
		}

		QString classLine(ElementClass elementClass, const validation::ClassScore& score)
		{
			const QString name = QString::fromStdString(report::pluralName(elementClass)).toLower();
			QString       line = QString("%1: %2 in the result, %3 in the truth").arg(name).arg(score.resultCount).arg(score.truthCount);
			if (score.notSeenCount)
				line += QString(" and %1 not seen").arg(score.notSeenCount);
			line += QString("; F1 %1 at IoU 0.5, %2 at 0.25").arg(score.at50.f1, 0, 'f', 3).arg(score.at25.f1, 0, 'f', 3);
			if (score.iou)
				line += QString("; mean IoU %1").arg(*score.iou, 0, 'f', 3);
			if (score.axisEnd_m)
				line += QString("; axis ends %1").arg(millimetres(*score.axisEnd_m));
			return line;
		}
	} // namespace

	Bim readModel(const QString& path, const std::optional<Eigen::Vector3d>& near, const Context& context)
	{
		const std::string file = QFile::encodeName(path).toStdString();
		return readInterruptibly([file, near]
		                         { return ifc::readBim(file, {.near = near}); },
		                         context);
	}

	Bim readGroundTruth(const QString& path, const std::optional<Eigen::Vector3d>& near, const QStringList& storeys, const Context& context)
	{
		const std::string        file  = QFile::encodeName(path).toStdString();
		Bim                      truth = readInterruptibly([file, near]
                                      { return ifc::readTruth(file, {.near = near}); },
                                      context);
		std::vector<std::string> names;
		for (const QString& storey : storeys)
			names.push_back(storey.toStdString());
		validation::selectStoreys(truth, names);
		return truth;
	}

	Eigen::Vector3d middleOf(const CloudView& cloud)
	{
		return boxOf(cloud).center();
	}

	void checkPlace(const Bim& bim, const CloudView& cloud)
	{
		validation::checkOverlap(bim, bim, &cloud);
	}

	ValidationOutcome compareModels(std::optional<Bim> truth, Bim result, const CloudView* cloud, const validation::ValidationParams& params, const Context& context)
	{
		ValidationOutcome outcome;
		outcome.truth  = std::move(truth);
		outcome.result = std::move(result);
		outcome.params = params;
		if (outcome.truth)
			outcome.figures = validation::validate(*outcome.truth, outcome.result, cloud, params, context);
		if (cloud && (!outcome.figures.cloudToResult || outcome.figures.cloudToResult->distance_m.empty()))
			outcome.figures.cloudToResult = validation::measureDeviation(outcome.result, *cloud, params, true, context);
		return outcome;
	}

	report::ReportInput reportInput(const ValidationOutcome& outcome, const CloudView* cloud, const ReportText& text)
	{
		report::ReportInput input;
		input.truth           = outcome.truth ? &*outcome.truth : nullptr;
		input.result          = &outcome.result;
		input.validation      = &outcome.figures;
		input.params          = &outcome.params;
		input.cloud           = cloud;
		input.building        = text.building;
		input.cloudName       = text.cloudName.toStdString();
		input.softwareVersion = "Scan to BIM for CloudCompare " S2B_VERSION;
		input.parameters      = text.parameters;
		if (const std::string time = reproducibleTime(); !time.empty())
			input.timestamp = time + "Z";
		return input;
	}

	QStringList validationSummary(const ValidationOutcome& outcome)
	{
		QStringList lines;
		if (outcome.truth)
		{
			for (const ElementClass elementClass : {ElementClass::Wall, ElementClass::Door, ElementClass::Window, ElementClass::Column})
			{
				const auto score = outcome.figures.scores.find(elementClass);
				if (score != outcome.figures.scores.end() && (score->second.truthCount || score->second.resultCount))
					lines << classLine(elementClass, score->second);
			}
		}
		if (const auto& deviation = outcome.figures.cloudToResult)
		{
			QString line = QString("points to walls, mean absolute: %1 of the result").arg(millimetres(deviation->wallMeanAbsolute_m));
			if (outcome.figures.cloudToTruth)
				line += QString(", %1 of the truth").arg(millimetres(outcome.figures.cloudToTruth->wallMeanAbsolute_m));
			lines << line;
		}
		const report::Scene scene  = report::makeScene(reportInput(outcome, nullptr, {}));
		int                 within = 0;
		int                 out    = 0;
		for (const report::Row& row : scene.rows)
		{
			within += row.verdict == validation::Verdict::Within ? 1 : 0;
			out += row.verdict == validation::Verdict::OutOfTolerance ? 1 : 0;
		}
		lines << QString("%1 of %2 judged elements are within LOA%3 (%4)").arg(within).arg(within + out).arg(outcome.params.tolerance).arg(millimetres(scene.toleranceLimit_m));
		return lines;
	}

	QString defaultReportFolder(const QString& path)
	{
		const QFileInfo file(path);
		return QDir(file.absolutePath()).filePath(file.completeBaseName() + "_report");
	}

	Context partOf(const Context& whole, double from, double to)
	{
		Context part  = whole;
		part.progress = [progress = whole.progress, from, to](std::string_view text, double fraction)
		{
			if (progress)
				progress(text, from + (to - from) * fraction);
		};
		return part;
	}
} // namespace s2b

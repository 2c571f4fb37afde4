// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BCommand.h"

#include "S2BEntities.h"
#include "S2BInput.h"
#include "S2BLasHeader.h"
#include "S2BMemory.h"
#include "S2BOptions.h"
#include "S2BRun.h"
#include "S2BSegment.h"
#include "S2BSummary.h"
#include "S2BValidate.h"
#include "core/report/scene.h"

#include <QDir>
#include <QFileInfo>
#include <ccLog.h>
#include <ccMesh.h>
#include <ccPointCloud.h>

namespace s2b
{
	namespace
	{
		constexpr int kMaxDiagnostics = 25; // of each severity on the console; all of them are counted

		// CloudCompare only rejects what it doesn't know when it gets there, after hours of ours perhaps. Which commands it
		// knows can't be asked, but a keyword can't be registered twice. A keyword that is free is one that
		// nobody knows, and ends the run.
		bool isCommand(ccCommandLineInterface& cmd, const QString& keyword)
		{
			struct Probe : ccCommandLineInterface::Command
			{
				using Command::Command;
				bool process(ccCommandLineInterface&) override
				{
					return false;
				}
			};
			if (keyword == "HELP" || keyword == "SILENT")
				return true;
			const int verbosity = ccLog::VerbosityLevel();
			ccLog::SetVerbosityLevel(ccLog::LOG_ERROR); // silences the warning that it is registered already
			const bool isFree = cmd.registerCommand(ccCommandLineInterface::Command::Shared(new Probe("probe", keyword)));
			ccLog::SetVerbosityLevel(verbosity);
			return !isFree;
		}

		QString defaultIfcPath(const CLCloudDesc& desc)
		{
			return QDir(desc.path.isEmpty() ? QString(".") : desc.path).absoluteFilePath(desc.basename + ".ifc");
		}

		// CloudCompare goes on with what it could read of a truncated LAS file. Its commands that change the number of
		// points on purpose give the cloud another name.
		void checkComplete(const CLCloudDesc& desc)
		{
			for (const char* suffix : {".laz", ".las", ".LAZ", ".LAS"})
			{
				const QString                path  = QDir(desc.path).filePath(desc.basename + suffix);
				const std::optional<quint64> count = lasPointCount(path);
				if (desc.indexInFile < 0 && count && desc.pc->size() < *count)
					throw Error(ErrorCode::BadFile, QString("the file '%1' is truncated, only %2 of its %3 points could be read: get a whole copy of it").arg(path).arg(desc.pc->size()).arg(*count).toStdString());
			}
		}

		Context makeContext(ccCommandLineInterface& cmd, const CommandOptions& options)
		{
			Context context;
			context.threads  = options.threads;
			context.seed     = options.seed;
			context.progress = [&cmd, last = QString()](std::string_view text, double fraction) mutable
			{
				const QString stage = QString::fromUtf8(text.data(), static_cast<int>(text.size()));
				if (stage != last)
					cmd.print(QString("[S2B] %1 % %2").arg(100.0 * fraction, 3, 'f', 0).arg(stage));
				last = stage;
			};
			context.log = [&cmd](LogLevel level, std::string_view text)
			{
				const QString line = "[S2B] " + QString::fromUtf8(text.data(), static_cast<int>(text.size()));
				if (level == LogLevel::Info)
					cmd.print(line);
				else
					cmd.warning(line);
			};
			return context;
		}

		void printDiagnostics(ccCommandLineInterface& cmd, const Building& building)
		{
			for (const Severity severity : {Severity::Error, Severity::Warning, Severity::Info})
			{
				int count = 0;
				for (const Diagnostic& diagnostic : building.diagnostics)
				{
					if (diagnostic.severity != severity || ++count > kMaxDiagnostics)
						continue;
					const QString line = "[S2B] " + diagnosticText(building, diagnostic);
					if (severity == Severity::Info)
						cmd.print(line);
					else
						cmd.warning(line);
				}
				if (count > kMaxDiagnostics)
					cmd.print(QString("[S2B] ... and %1 more of that kind").arg(count - kMaxDiagnostics));
			}
		}

		constexpr double kRead          = 0.2; // shares of the time
		constexpr double kReconstructed = 0.7; // share of the time, when the model is validated too
		constexpr double kCompared      = 0.9;

		std::vector<const ccPointCloud*> openedClouds(ccCommandLineInterface& cmd)
		{
			std::vector<const ccPointCloud*> clouds;
			for (const CLCloudDesc& desc : cmd.clouds())
			{
				checkComplete(desc);
				clouds.push_back(desc.pc);
			}
			return clouds;
		}

		// Copies beside the clouds that were opened, for the commands that follow; without any nobody could save them.
		void addDeviationClouds(ccCommandLineInterface& cmd, const ValidationOutcome& outcome)
		{
			if (cmd.arguments().isEmpty() || !outcome.figures.cloudToResult)
				return;
			const double             limit_m = report::makeScene(reportInput(outcome, nullptr, {})).colorRange_m;
			std::vector<CLCloudDesc> copies;
			std::size_t              first = 0;
			for (const CLCloudDesc& desc : cmd.clouds())
			{
				auto copy = deviationCopy(*desc.pc, *outcome.figures.cloudToResult, first, limit_m);
				first += desc.pc->size();
				copies.emplace_back(copy.release(), desc.basename + "_S2B_DEVIATION", desc.path);
			}
			cmd.clouds().insert(cmd.clouds().end(), copies.begin(), copies.end());
		}

		void finishValidation(ccCommandLineInterface& cmd, const ValidationOutcome& outcome, const CloudView* cloud, const ReportText& text, const QString& folder, const Context& context)
		{
			report::writeReport(reportInput(outcome, cloud, text), QFile::encodeName(folder).toStdString(), context);
			for (const QString& line : validationSummary(outcome))
				cmd.print("[S2B] " + line);
			cmd.print(QString("[S2B] wrote %1").arg(QDir(folder).filePath("report.html")));
			addDeviationClouds(cmd, outcome);
		}

		QString cloudNames(const ccCommandLineInterface& cmd)
		{
			QStringList names;
			for (const CLCloudDesc& desc : cmd.clouds())
				names << desc.basename;
			return names.join(", ");
		}

		// The model of -SEGMENT, opened before any work: a bad one is told at once.
		std::optional<OnnxModel> chosenModel(ccCommandLineInterface& cmd, const CommandOptions& options)
		{
			std::optional<OnnxModel> model;
			if (options.segment)
			{
				model = openModel(options.modelPath, options.threads);
				cmd.print(QString("[S2B] segmentation with %1: %2").arg(QString::fromStdString(model->name()), modelText(*model)));
			}
			return model;
		}

		// A reconstruction of a cloud without labels of use takes those of the shipped model, unless geometry alone is asked for.
		bool labelsItself(const CommandOptions& options, const Input& input)
		{
			return options.reconstruct && !options.segment && !options.pipeline.geometryOnly && !input.view.labels && hasShippedModel();
		}

		// The points, and the labels that they have where no model is to make them.
		Input readInput(ccCommandLineInterface& cmd, const CommandOptions& options)
		{
			const std::vector<const ccPointCloud*> clouds = openedClouds(cmd);

			Input input = makeInput(clouds, {!options.pipeline.geometryOnly && !options.segment, options.labelField, options.labelMap}, options.stationFile);
			cmd.print(QString("[S2B] %1 points in %2").arg(input.view.count).arg(clouds.size() == 1 ? QString("one cloud") : QString("%1 clouds, taken together").arg(clouds.size())));
			if (!input.warning.isEmpty())
				cmd.warning("[S2B] " + insteadOfLabels(input, labelsItself(options, input)));
			if (!input.labelField.isEmpty())
				cmd.print("[S2B] " + labelSummary(input, QString::fromStdString(options.labelMap.name)));
			if (!input.stationText.isEmpty())
				cmd.print("[S2B] " + input.stationText);
			return input;
		}

		void labelWith(ccCommandLineInterface& cmd, const std::optional<OnnxModel>& model, Input& input, const Context& context)
		{
			if (!model)
				return;
			segmentInput(input, *model, context);
			cmd.print("[S2B] labels: " + segmentationText(input));
		}

		// For the commands that follow; without any nobody could save them.
		void addFields(ccCommandLineInterface& cmd, const Input& input)
		{
			if (cmd.arguments().isEmpty())
				return;
			std::size_t first = 0;
			for (const CLCloudDesc& desc : cmd.clouds())
			{
				addSegmentationFields(*desc.pc, input, first);
				first += desc.pc->size();
			}
		}

		// -SEGMENT -STAGES none: the labels are all that is wanted.
		void segmentOnly(ccCommandLineInterface& cmd, const CommandOptions& options)
		{
			if (cmd.clouds().empty())
				throw Error(ErrorCode::EmptyCloud, "there is no point cloud: open one before -S2B with -O FILE");
			const StepMeter                meter;
			const std::optional<OnnxModel> model = chosenModel(cmd, options);
			Input                          input = readInput(cmd, options);
			labelWith(cmd, model, input, makeContext(cmd, options));
			if (cmd.arguments().isEmpty())
				cmd.warning("[S2B] the labels are not saved: add -SAVE_CLOUDS");
			addFields(cmd, input);
			cmd.print("[S2B] " + meter.text());
		}

		// -STAGES none: nothing is reconstructed, what is there is compared.
		void compareOnly(ccCommandLineInterface& cmd, const CommandOptions& options)
		{
			if (cmd.clouds().empty() && (options.ifcPath.isEmpty() || options.truthPath.isEmpty()))
				throw Error(ErrorCode::BadParameter, "there is nothing to compare the model with: give both -IFC FILE and -VALIDATE FILE, or open a point cloud before -S2B with -O FILE");

			const StepMeter  meter;
			const Context    context = makeContext(cmd, options);
			Input            input;
			const CloudView* cloud = nullptr;
			if (!cmd.clouds().empty())
			{
				const std::optional<OnnxModel> model = chosenModel(cmd, options);
				input                                = readInput(cmd, options);
				labelWith(cmd, model, input, partOf(context, 0.0, kRead));
				cloud = &input.view;
			}
			std::optional<Eigen::Vector3d> near;
			if (cloud)
				near = middleOf(*cloud);
			context.report("Reading the models", kRead);
			std::optional<validation::Bim> truth;
			if (!options.truthPath.isEmpty())
				truth = readGroundTruth(options.truthPath, near, options.storeys, context);
			if (truth && !near)
				near = validation::centerOf(*truth);
			// One model alone is measured against the points, whichever option named it.
			validation::Bim result;
			QString         base = options.ifcPath;
			if (!options.ifcPath.isEmpty())
				result = readModel(options.ifcPath, near, context);
			else
			{
				result = std::move(*truth);
				truth.reset();
				base = defaultIfcPath(cmd.clouds().front());
			}
			if (cloud)
			{
				checkPlace(result, *cloud);
				if (truth)
					checkPlace(*truth, *cloud);
			}
			const ValidationOutcome outcome = compareModels(std::move(truth), std::move(result), cloud, options.validation, partOf(context, kRead, kCompared));
			const QString           folder  = options.reportFolder.isEmpty() ? defaultReportFolder(base) : options.reportFolder;
			finishValidation(cmd, outcome, cloud, {cloudNames(cmd), nullptr, {}}, folder, partOf(context, kCompared, 1.0));
			cmd.print("[S2B] " + meter.text());
		}

		void reconstructAll(ccCommandLineInterface& cmd, const CommandOptions& options)
		{
			if (cmd.clouds().empty())
				throw Error(ErrorCode::EmptyCloud, "there is no point cloud: open one before -S2B with -O FILE");

			const StepMeter   meter;
			const CLCloudDesc first = cmd.clouds().front();
			const QString     path  = options.ifcPath.isEmpty() ? defaultIfcPath(first) : options.ifcPath;

			std::optional<OnnxModel> model = chosenModel(cmd, options);
			Input                    input = readInput(cmd, options);
			if (labelsItself(options, input))
				model = openModel({}, options.threads);

			// A truth that can't be used is found out before the work, not after it.
			const Context                  context = makeContext(cmd, options);
			std::optional<validation::Bim> truth;
			if (!options.truthPath.isEmpty())
			{
				truth = readGroundTruth(options.truthPath, middleOf(input.view), options.storeys, context);
				checkPlace(*truth, input.view);
			}

			const double labelled = model ? kLabelled : 0.0;
			labelWith(cmd, model, input, partOf(context, 0.0, labelled));
			const Building    building = reconstruct(input.view, options.pipeline, partOf(context, labelled, options.validates() ? kReconstructed : 1.0));
			ifc::WriteOptions record   = writeOptions(options.pipeline, options.seed, first.basename, options.schema);
			record.epsg                = options.epsg;
			if (model)
				record.parameters.emplace_back("segmentation", QFileInfo(QString::fromStdString(model->name())).fileName().toStdString());
			writeModel(building, path, record);

			printDiagnostics(cmd, building);
			for (const QString& line : summary(building))
				cmd.print("[S2B] " + line);
			for (const QString& line : assumptions(building))
				cmd.warning("[S2B] " + line);
			cmd.print(QString("[S2B] wrote %1").arg(path));
			if (options.validates())
			{
				// What is measured is the file that was written, as everybody else will read it.
				const ValidationOutcome outcome = compareModels(std::move(truth), readModel(path, middleOf(input.view), context), &input.view, options.validation, partOf(context, kReconstructed, kCompared));
				const QString           folder  = options.reportFolder.isEmpty() ? defaultReportFolder(path) : options.reportFolder;
				finishValidation(cmd, outcome, &input.view, {cloudNames(cmd), &building, record.parameters}, folder, partOf(context, kCompared, 1.0));
			}
			cmd.print("[S2B] " + meter.text());

			if (options.segment)
				addFields(cmd, input);
			for (NamedMesh& element : makeMeshes(building, *first.pc))
			{
				ccMesh* mesh = element.mesh.release();
				cmd.meshes().emplace_back(mesh, first.basename + '_' + element.name, first.path);
			}
		}

		void run(ccCommandLineInterface& cmd)
		{
			const CommandOptions options = parseCommandOptions(cmd.arguments(), [&](const QString& keyword)
			                                                   { return isCommand(cmd, keyword); });
			if (options.reconstruct)
				reconstructAll(cmd, options);
			else if (options.segment && options.ifcPath.isEmpty() && options.truthPath.isEmpty())
				segmentOnly(cmd, options);
			else
				compareOnly(cmd, options);
		}
	} // namespace
} // namespace s2b

S2BCommand::S2BCommand()
    : Command("Scan to BIM", "S2B")
{
}

// An exception that left here would abort CloudCompare.
bool S2BCommand::process(ccCommandLineInterface& cmd)
{
	try
	{
		s2b::run(cmd);
		return true;
	}
	catch (const std::bad_alloc&)
	{
		return cmd.error("[S2B] not enough memory: subsample the cloud first, or use a machine with more");
	}
	catch (const std::exception& e)
	{
		return cmd.error(QString("[S2B] %1").arg(QString::fromUtf8(e.what())));
	}
}

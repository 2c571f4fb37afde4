// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BCommand.h"

#include "S2BEntities.h"
#include "S2BInput.h"
#include "S2BLasHeader.h"
#include "S2BMemory.h"
#include "S2BOptions.h"
#include "S2BRun.h"
#include "S2BSummary.h"

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

		void run(ccCommandLineInterface& cmd)
		{
			const CommandOptions options = parseCommandOptions(cmd.arguments(), [&](const QString& keyword)
			                                                   { return isCommand(cmd, keyword); });
			if (cmd.clouds().empty())
				throw Error(ErrorCode::EmptyCloud, "there is no point cloud: open one before -S2B with -O FILE");

			const StepMeter                  meter;
			std::vector<const ccPointCloud*> clouds;
			for (const CLCloudDesc& desc : cmd.clouds())
			{
				checkComplete(desc);
				clouds.push_back(desc.pc);
			}
			const CLCloudDesc first = cmd.clouds().front();
			const QString     path  = options.ifcPath.isEmpty() ? defaultIfcPath(first) : options.ifcPath;

			const Input input = makeInput(clouds, {!options.pipeline.geometryOnly, options.labelField, options.labelMap});
			cmd.print(QString("[S2B] %1 points in %2").arg(input.view.count).arg(clouds.size() == 1 ? QString("one cloud") : QString("%1 clouds, taken together").arg(clouds.size())));
			if (!input.warning.isEmpty())
				cmd.warning("[S2B] " + input.warning);
			if (!input.labelField.isEmpty())
				cmd.print("[S2B] " + labelSummary(input, QString::fromStdString(options.labelMap.name)));

			const Building building = reconstruct(input.view, options.pipeline, makeContext(cmd, options));
			writeModel(building, path, writeOptions(options.pipeline, options.seed, first.basename, options.schema));

			printDiagnostics(cmd, building);
			for (const QString& line : summary(building))
				cmd.print("[S2B] " + line);
			cmd.print(QString("[S2B] wrote %1").arg(path));
			cmd.print("[S2B] " + meter.text());

			for (NamedMesh& element : makeMeshes(building, *clouds.front()))
			{
				ccMesh* mesh = element.mesh.release();
				cmd.meshes().emplace_back(mesh, first.basename + '_' + element.name, first.path);
			}
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

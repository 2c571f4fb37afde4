// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BOptions.h"

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/pipeline/presets.h"
#include "core/validation/validation_parameters.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryFile>
#include <algorithm>
#include <string_view>

namespace s2b
{
	namespace
	{
		constexpr unsigned kMaxThreads = 1024;
		constexpr unsigned kEpsg[]     = {1024, 32766}; // what the registry gives out

		// "-THREADS", but not "-2.9:0.0"
		bool isKeyword(const QString& argument)
		{
			return argument.startsWith('-') && !(argument.size() > 1 && (argument[1].isDigit() || argument[1] == '.'));
		}

		[[noreturn]] void fail(const QString& sentence, ErrorCode code = ErrorCode::BadParameter)
		{
			throw Error(code, sentence.toStdString());
		}

		std::uint64_t wholeNumber(const char* option, const QString& text, std::uint64_t minimum, std::uint64_t maximum)
		{
			bool                ok     = false;
			const std::uint64_t number = text.toULongLong(&ok);
			if (!ok || number < minimum || number > maximum)
				fail(QString("-%1 takes a whole number from %2 to %3, not '%4'").arg(option).arg(minimum).arg(maximum).arg(text));
			return number;
		}

		QString schemaName(const QString& text)
		{
			static const QStringList kKnown{"IFC4", "IFC4X3_ADD2"};
			const QString            name = text.toUpper();
			if (!kKnown.contains(name))
				fail(QString("-SCHEMA '%1' is not supported: use %2").arg(text, kKnown.join(" or ")));
			return name;
		}

		// Found out before minutes of work, not after them.
		QString writableIfcPath(const QString& text)
		{
			const QFileInfo file(text);
			const QFileInfo folder(file.absolutePath());
			if (file.isDir())
				fail(QString("-IFC '%1' is a folder: give the name of a file").arg(text), ErrorCode::CannotWrite);
			if (!folder.isDir())
				fail(QString("-IFC '%1' can't be written: the folder '%2' does not exist").arg(text, folder.filePath()), ErrorCode::CannotWrite);
			if (!folder.isWritable() || (file.exists() && !file.isWritable()))
				fail(QString("-IFC '%1' can't be written: no permission for it, choose another place").arg(text), ErrorCode::CannotWrite);
			return file.absoluteFilePath();
		}

		// A truth may be a file, or a folder of the CV4AEC challenge's files.
		QString readablePath(const char* option, const QString& text)
		{
			const QFileInfo file(text);
			if (!file.exists())
				fail(QString("-%1 '%2' does not exist: give a file to read").arg(option, text), ErrorCode::BadFile);
			if (!file.isReadable())
				fail(QString("-%1 '%2' can't be read: no permission for it").arg(option, text), ErrorCode::BadFile);
			return file.absoluteFilePath();
		}

		QString reportFolder(const QString& text)
		{
			QFileInfo folder(QFileInfo(text).absoluteFilePath());
			if (folder.exists() && !folder.isDir())
				fail(QString("-REPORT '%1' is a file: give a folder").arg(text), ErrorCode::CannotWrite);
			while (!folder.exists() && folder.absolutePath() != folder.absoluteFilePath())
				folder = QFileInfo(folder.absolutePath());
			// Permissions do not tell everything: a file is tried.
			if (!folder.isDir() || !QTemporaryFile(QDir(folder.filePath()).filePath("s2b_XXXXXX")).open())
				fail(QString("-REPORT '%1' can't be written: nothing can be written there, choose another place").arg(text), ErrorCode::CannotWrite);
			return QFileInfo(text).absoluteFilePath();
		}

		void setStages(CommandOptions& options, const QString& list)
		{
			options.reconstruct = list.trimmed().compare("none", Qt::CaseInsensitive) != 0;
			if (options.reconstruct)
				options.pipeline.stages = parseStages(list.toStdString());
		}

		std::vector<StoreyHeights> levelHeights(const QString& list)
		{
			std::vector<StoreyHeights> levels;
			for (const QString& level : list.split(','))
			{
				const QStringList heights   = level.split(':');
				bool              isFloor   = false;
				bool              isCeiling = false;
				StoreyHeights     storey;
				storey.floor_m   = heights.value(0).toDouble(&isFloor);
				storey.ceiling_m = heights.value(1).toDouble(&isCeiling);
				if (heights.size() != 2 || !isFloor || !isCeiling || storey.ceiling_m <= storey.floor_m || (!levels.empty() && storey.floor_m < levels.back().ceiling_m))
					fail(QString("-LEVELS '%1' is no list of storeys: give floor:ceiling in metres from the lowest up, for example 0.00:2.60,2.90:5.50").arg(list));
				levels.push_back(storey);
			}
			return levels;
		}

		QStringList storeyNames(const QString& list)
		{
			QStringList names;
			for (const QString& name : list.split(',', Qt::SkipEmptyParts))
				names << name.trimmed();
			if (names.isEmpty())
				fail("-STOREYS needs the names of storeys, separated by commas");
			return names;
		}

		void setAny(CommandOptions& options, const QString& assignment)
		{
			if (assignment.trimmed().startsWith("validation.", Qt::CaseInsensitive))
				validation::setParameter(options.validation, assignment.toStdString());
			else
				setParameter(options.pipeline.parameters, assignment.toStdString());
		}

		std::string localPath(const QString& path)
		{
			return QFile::encodeName(path).toStdString();
		}
	} // namespace

	int epsgCode(const QString& text)
	{
		return static_cast<int>(wholeNumber("EPSG", text, kEpsg[0], kEpsg[1]));
	}

	const std::vector<CommandOption>& commandOptions()
	{
		static const std::vector<CommandOption> kTable{
		    {"LABELS", "NAME", false, "scalar field with a class code per point (default: Classification or label if there)", [](CommandOptions& o, const QString& v)
		     { o.labelField = v; }},
		    {"LABEL_MAP", "NAME|FILE", false, "which code means what: s2b (default), s3dis, scannet, asprs, or a TOML file", [](CommandOptions& o, const QString& v)
		     { o.labelMap = loadLabelMap(localPath(v)); }},
		    {"SEGMENT", "[FILE.onnx]", false, "label the points with an ONNX model first: the shipped one, or FILE", [](CommandOptions& o, const QString& v)
		     { o.segment = true; o.modelPath = v.isEmpty() ? v : readablePath("SEGMENT", v); }},
		    {"GEOMETRY_ONLY", "", false, "use no labels", [](CommandOptions& o, const QString&)
		     { o.pipeline.geometryOnly = true; }},
		    {"STATIONS", "FILE", false, "where the scanner stood: lines 'id x y z' (id: the points' source id), or JSON (default: the clouds' sensors)", [](CommandOptions& o, const QString& v)
		     { o.stationFile = readablePath("STATIONS", v); }},
		    {"STAGES", "LIST", false, "levels,walls,doors,windows,openings,columns,slabs,spaces (default: all), or none: the file of -IFC is read and compared", [](CommandOptions& o, const QString& v)
		     { setStages(o, v); }},
		    {"PRESET", "LIST", false, "parameters for a kind of building (residential, office, hall) or survey (mobile-mapping), or one of each: office,mobile-mapping", [](CommandOptions& o, const QString& v)
		     { applyPresets(o.pipeline.parameters, v.toStdString()); }},
		    {"LEVELS", "LIST", false, "the storeys' floors and ceilings in world heights, from the lowest up: 0.00:2.60,2.90:5.50 (default: found in the cloud)", [](CommandOptions& o, const QString& v)
		     { o.pipeline.levels = levelHeights(v); }},
		    {"CONFIG", "FILE", false, "parameters from a TOML file, after those of -PRESET", [](CommandOptions& o, const QString& v)
		     { loadConfig(o.pipeline.parameters, localPath(v)); }},
		    {"SET", "name=value", true, "one parameter, after those of -CONFIG", [](CommandOptions& o, const QString& v)
		     { setAny(o, v); }},
		    {"IFC", "FILE", false, "the file to write (default: <cloud>.ifc beside the cloud); with -STAGES none the file to read", [](CommandOptions& o, const QString& v)
		     { o.ifcPath = o.reconstruct ? writableIfcPath(v) : readablePath("IFC", v); }},
		    {"SCHEMA", "NAME", false, "IFC4 (default) or IFC4X3_ADD2", [](CommandOptions& o, const QString& v)
		     { o.schema = schemaName(v); }},
		    {"EPSG", "N", false, "the projected coordinate system of the cloud's coordinates: the IFC gets an IfcMapConversion instead of a site placement", [](CommandOptions& o, const QString& v)
		     { o.epsg = epsgCode(v); }},
		    {"VALIDATE", "FILE", false, "ground truth to compare with: any IFC file, or the CV4AEC challenge's JSON", [](CommandOptions& o, const QString& v)
		     { o.truthPath = readablePath("VALIDATE", v); }},
		    {"STOREYS", "LIST", false, "the truth's storeys to compare, names or GUIDs separated by commas (default: all)", [](CommandOptions& o, const QString& v)
		     { o.storeys = storeyNames(v); }},
		    {"REPORT", "FOLDER", false, "report.html, report.json, elements.csv and issues.bcf (default when validating: <ifc base>_report beside the IFC file)", [](CommandOptions& o, const QString& v)
		     { o.reportFolder = reportFolder(v); }},
		    {"THREADS", "N", false, "worker threads (default: all); the result does not depend on it", [](CommandOptions& o, const QString& v)
		     { o.threads = static_cast<unsigned>(wholeNumber("THREADS", v, 1, kMaxThreads)); }},
		    {"SEED", "N", false, "of the random draws (default: 1)", [](CommandOptions& o, const QString& v)
		     { o.seed = wholeNumber("SEED", v, 0, 0xFFFFFFFFu); }},
		};
		return kTable;
	}

	CommandOptions parseCommandOptions(QStringList& arguments, const std::function<bool(const QString&)>& isOtherCommand)
	{
		CommandOptions options;
		options.labelMap = builtInLabelMap("s2b");

		std::vector<std::string_view> names;
		for (const CommandOption& option : commandOptions())
			names.emplace_back(option.name);

		// Gathered first, applied after: -SET wins over -CONFIG wherever it stands.
		std::vector<std::pair<const CommandOption*, QString>> given;
		while (!arguments.isEmpty())
		{
			const QString argument = arguments.front();
			const QString keyword  = argument.startsWith('-') ? argument.mid(1) : QString();
			const auto    row      = std::find_if(commandOptions().begin(), commandOptions().end(), [&](const CommandOption& option)
                                          { return keyword.compare(option.name, Qt::CaseInsensitive) == 0; });
			if (row == commandOptions().end())
			{
				if (!keyword.isEmpty() && isOtherCommand(keyword.toUpper()))
					break;
				const auto near = nearestName(keyword.toStdString(), names);
				fail(QString("'%1' is not an option of -S2B, the nearest is -%2 (all: %3)").arg(argument, QString::fromStdString(std::string(near)), QString::fromStdString(joinNames(names))));
			}
			arguments.pop_front();

			QString    value;
			const bool isOptional = *row->value == '[';
			if (isOptional && !arguments.isEmpty() && !arguments.front().startsWith('-'))
				value = arguments.takeFirst();
			else if (*row->value && !isOptional)
			{
				if (arguments.isEmpty() || isKeyword(arguments.front()))
					fail(QString("-%1 needs a value: -%1 %2").arg(row->name, row->value));
				value = arguments.takeFirst();
			}
			const bool again = std::any_of(given.begin(), given.end(), [&](const auto& other)
			                               { return other.first == &*row; });
			if (again && !row->repeatable)
				fail(QString("-%1 is given twice: give it once").arg(row->name));
			given.emplace_back(&*row, value);
		}
		std::stable_sort(given.begin(), given.end(), [](const auto& a, const auto& b)
		                 { return a.first < b.first; });
		for (const auto& [option, value] : given)
			option->apply(options, value);

		if (options.pipeline.geometryOnly && !options.labelField.isEmpty())
			fail("-GEOMETRY_ONLY and -LABELS contradict each other: give one of them");
		if (options.segment && (options.pipeline.geometryOnly || !options.labelField.isEmpty()))
			fail(QString("-SEGMENT and -%1 contradict each other: give one of them").arg(options.labelField.isEmpty() ? "GEOMETRY_ONLY" : "LABELS"));
		validation::checkParams(options.validation);
		if (options.truthPath.isEmpty() && !options.storeys.isEmpty())
			fail("-STOREYS chooses storeys of a ground truth: give one with -VALIDATE FILE");
		if (!options.reconstruct && !options.segment && options.ifcPath.isEmpty() && options.truthPath.isEmpty())
			fail("-STAGES none reconstructs nothing and there is no model to measure: give one with -IFC FILE, and a ground truth with -VALIDATE FILE");
		return options;
	}
} // namespace s2b

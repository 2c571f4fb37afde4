// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BRun.h"

#include <QDateTime>
#include <QFile>
#include <QStringList>

namespace s2b
{
	std::string reproducibleTime()
	{
		bool            isSet = false;
		const qlonglong epoch = qEnvironmentVariable("SOURCE_DATE_EPOCH").toLongLong(&isSet);
		return isSet ? QDateTime::fromSecsSinceEpoch(epoch, Qt::UTC).toString("yyyy-MM-ddTHH:mm:ss").toStdString() : std::string();
	}

	ifc::WriteOptions writeOptions(const PipelineOptions& run, std::uint64_t seed, const QString& projectName, const QString& schema)
	{
		ifc::WriteOptions options;
		options.schema      = schema.toStdString();
		options.projectName = projectName.toStdString();
		if (const std::string time = reproducibleTime(); !time.empty())
			options.timestamp = time;

		for (const ParameterInfo& info : parameterTable())
			options.parameters.emplace_back(info.name, QString::number(info.value(run.parameters), 'g', 12).toStdString());
		options.parameters.emplace_back("seed", std::to_string(seed));
		options.parameters.emplace_back("geometryOnly", run.geometryOnly ? "1" : "0");
		if (!run.levels.empty())
		{
			QStringList levels;
			for (const StoreyHeights& level : run.levels)
				levels << QString("%1:%2").arg(level.floor_m, 0, 'f', 3).arg(level.ceiling_m, 0, 'f', 3);
			options.parameters.emplace_back("levels", levels.join(',').toStdString());
		}
		return options;
	}

	void writeModel(const Building& building, const QString& path, const ifc::WriteOptions& options)
	{
		const std::lock_guard lock(ifcMutex());
		ifc::writeIfc(building, QFile::encodeName(path).toStdString(), options);
	}

	std::mutex& ifcMutex()
	{
		static std::mutex mutex;
		return mutex;
	}
} // namespace s2b

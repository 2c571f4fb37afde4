// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BSummary.h"

#include "S2BInput.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace s2b
{
	namespace
	{
		QString counted(std::size_t count, const char* one, const char* many)
		{
			return QString("%1 %2").arg(count).arg(count == 1 ? one : many);
		}

		std::size_t openingsOf(const Building& building, ElementId storey, OpeningKind kind)
		{
			return static_cast<std::size_t>(std::count_if(building.openings.begin(), building.openings.end(), [&](const Opening& opening)
			                                              {
				                                              const Wall* host = building.wall(opening.host);
				                                              return opening.kind == kind && host && host->storey == storey; }));
		}

		template <typename Element>
		std::size_t countOf(const std::vector<Element>& elements, ElementId storey)
		{
			return static_cast<std::size_t>(std::count_if(elements.begin(), elements.end(), [&](const Element& element)
			                                              { return element.storey == storey; }));
		}
	} // namespace

	QStringList summary(const Building& building)
	{
		QStringList lines;
		for (const Storey& storey : building.storeys)
		{
			QStringList parts;
			const auto  add = [&](std::size_t count, const char* one, const char* many)
			{
				if (count)
					parts << counted(count, one, many);
			};
			add(countOf(building.walls, storey.id), "wall", "walls");
			add(openingsOf(building, storey.id, OpeningKind::Door), "door", "doors");
			add(openingsOf(building, storey.id, OpeningKind::Window), "window", "windows");
			add(openingsOf(building, storey.id, OpeningKind::Plain), "plain opening", "plain openings");
			add(countOf(building.columns, storey.id), "column", "columns");
			add(countOf(building.slabs, storey.id), "slab", "slabs");
			add(countOf(building.spaces, storey.id), "space", "spaces");
			lines << QString("%1 at %2, %3 m high: %4")
			             .arg(QString::fromStdString(storey.name))
			             .arg(elevationText(building, storey))
			             .arg(storey.height.value_m, 0, 'f', 2)
			             .arg(parts.isEmpty() ? QString("nothing") : parts.join(", "));
		}
		const auto assumed = std::count_if(building.walls.begin(), building.walls.end(), [](const Wall& wall)
		                                   { return wall.thickness.provenance == Provenance::Assumed; });
		if (assumed)
			lines << QString("%1 of %2 walls were seen from one side: their thickness is assumed").arg(assumed).arg(building.walls.size());
		if (building.storeys.empty())
			lines << "no storey was found";
		return lines;
	}

	QString elevationText(const Building& building, const Storey& storey)
	{
		const double world_mm = std::round(1000.0 * (building.frame.origin.z() + storey.elevation_m));
		return QString("%1 m").arg((world_mm == 0 ? 0.0 : world_mm) / 1000.0, 0, 'f', 3); // not "-0.000"
	}

	QString labelSummary(const Input& input, const QString& mapName)
	{
		QStringList parts;
		for (std::size_t i = 0; i < kLabelCount; ++i)
		{
			if (input.labelCounts[i])
				parts << QString("%1 %2").arg(QString::fromStdString(std::string(labelName(static_cast<Label>(i)))), QLocale(QLocale::English).toString(static_cast<qulonglong>(input.labelCounts[i])));
		}
		return QString("labels from the field '%1' with the map '%2': %3").arg(input.labelField, mapName, parts.join(", "));
	}

	QString diagnosticText(const Building& building, const Diagnostic& diagnostic)
	{
		QString text = QString("%1: %2").arg(QString::fromStdString(diagnostic.stage), QString::fromStdString(diagnostic.text));
		if (!diagnostic.location.isZero())
		{
			const Eigen::Vector3d p = building.frame.toWorld(diagnostic.location);
			text += QString(" (at %1, %2, %3)").arg(p.x(), 0, 'f', 2).arg(p.y(), 0, 'f', 2).arg(p.z(), 0, 'f', 2);
		}
		return text;
	}
} // namespace s2b

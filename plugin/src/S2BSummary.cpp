// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BSummary.h"

#include "S2BInput.h"
#include "core/corrections/corrections.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace s2b
{
	namespace
	{
		constexpr std::size_t kMaxNames = 12; // in one line

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
		if (building.storeys.empty())
			lines << "no storey was found";
		return lines;
	}

	QStringList assumptions(const Building& building)
	{
		QStringList lines;
		const auto  add = [&](const auto& elements, auto isAssumed, const QString& what)
		{
			QStringList names;
			std::size_t count = 0;
			for (const auto& element : elements)
			{
				if (!isAssumed(element))
					continue;
				if (++count <= kMaxNames)
					names << QString::fromStdString(nameOf(building, element.id));
			}
			if (count > kMaxNames)
				names << "...";
			if (count)
				lines << QString("%1 of %2 %3: %4").arg(count).arg(elements.size()).arg(what, names.join(", "));
		};
		add(building.walls, [](const Wall& wall)
		    { return wall.thickness.provenance == Provenance::Assumed; },
		    "walls were seen from one side, their thickness is assumed");
		add(building.slabs, [](const Slab& slab)
		    { return slab.thickness.provenance == Provenance::Assumed; },
		    "slabs were seen from one side, their thickness is assumed");
		add(building.columns, [](const Column& column)
		    { return column.sectionProvenance == Provenance::Assumed; },
		    "columns were seen in part, their section is assumed");
		add(building.storeys, [](const Storey& storey)
		    { return storey.height.provenance == Provenance::Assumed; },
		    "storeys have no level ceiling, their height is that of the walls");
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
		const QString text    = QString("%1: %2").arg(QString::fromStdString(diagnostic.stage), QString::fromStdString(diagnostic.text));
		const QString element = QString::fromStdString(nameOf(building, diagnostic.element));
		QStringList   where;
		if (!element.isEmpty())
			where << element;
		const Eigen::Vector3d p = building.frame.toWorld(diagnostic.location);
		if (!diagnostic.location.head<2>().isZero())
			where << QString("at %1, %2, %3").arg(p.x(), 0, 'f', 2).arg(p.y(), 0, 'f', 2).arg(p.z(), 0, 'f', 2);
		else if (diagnostic.location.z() != 0)
			where << QString("at the height %1 m").arg(p.z(), 0, 'f', 2);
		return where.isEmpty() ? text : QString("%1 (%2)").arg(text, where.join(", "));
	}
} // namespace s2b

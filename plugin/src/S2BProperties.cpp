// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BEntities.h"

namespace s2b
{
	namespace
	{
		QString provenanceText(Provenance provenance)
		{
			switch (provenance)
			{
			case Provenance::Measured:
				return "measured";
			case Provenance::Corrected:
				return "corrected";
			default:
				return "assumed";
			}
		}
		QString metres(double value_m)
		{
			return QString::number(value_m, 'f', 3) + " m";
		}
		QString text(const Dimension& d)
		{
			return metres(d.value_m) + " (" + provenanceText(d.provenance) + ')';
		}
		QString percent(double share)
		{
			return QString::number(100.0 * share, 'f', 0) + " %";
		}

		void addEvidence(QVariantMap& map, const Evidence& evidence, bool isWall)
		{
			map["Evidence: points"] = static_cast<qulonglong>(evidence.points);
			map["Evidence: RMS"]    = QString(QString::number(1000.0 * evidence.rms_m, 'f', 1) + " mm");
			map["Evidence: labels"] = percent(evidence.labelShare);
			if (isWall)
			{
				map["Evidence: faces seen"]    = evidence.facesSeen;
				map["Evidence: face coverage"] = QString("left %1, right %2").arg(percent(evidence.faceCoverage[0]), percent(evidence.faceCoverage[1]));
			}
		}

		QVariantMap wallProperties(const Wall& wall)
		{
			QVariantMap map;
			map["Length"]    = metres(wall.axisLength_m());
			map["Thickness"] = text(wall.thickness);
			map["Height"]    = text(wall.height);
			map["Base"]      = metres(wall.base_m);
			if (wall.isExternalKnown)
				map["External"] = wall.isExternal ? "yes" : "no";
			addEvidence(map, wall.evidence, true);
			return map;
		}

		QVariantMap openingProperties(const Opening& opening)
		{
			QVariantMap map;
			map["Width"]  = text(opening.width);
			map["Height"] = text(opening.height);
			map["Sill"]   = text(opening.sill);
			map["Host"]   = QString("Wall %1").arg(opening.host.value);
			if (opening.leaves)
				map["Leaves"] = opening.leaves;
			addEvidence(map, opening.evidence, false);
			return map;
		}

		QVariantMap columnProperties(const Column& column)
		{
			QVariantMap   map;
			const QString origin = " (" + provenanceText(column.sectionProvenance) + ')';
			if (const auto* circle = std::get_if<CircleSection>(&column.section))
				map["Diameter"] = QString(metres(2.0 * circle->radius_m) + origin);
			else
			{
				const Eigen::Vector2d box     = boxOf(column.section);
				const auto*           profile = std::get_if<ProfileSection>(&column.section);
				const QString         shape   = profile ? QString(shapeName(profile->shape)) + ' ' : QString();
				map["Section"]                = QString(shape + metres(box.x()) + " x " + metres(box.y()) + origin);
				if (profile)
				{
					map["Web"]    = metres(profile->web_m);
					map["Flange"] = metres(profile->flange_m);
				}
			}
			map["Height"] = text(column.height);
			addEvidence(map, column.evidence, false);
			return map;
		}

		QVariantMap slabProperties(const Slab& slab)
		{
			QVariantMap map;
			map["Top"]       = metres(slab.top_m);
			map["Thickness"] = text(slab.thickness);
			addEvidence(map, slab.evidence, false);
			return map;
		}

		QVariantMap spaceProperties(const Space& space)
		{
			QVariantMap map;
			map["Area"]   = QString(QString::number(space.area_m2, 'f', 2) + " m2");
			map["Height"] = text(space.height);
			map["Walls"]  = static_cast<qulonglong>(space.boundedBy.size());
			return map;
		}

		template <typename Elements, typename ToMap>
		bool lookUp(const Elements& elements, ElementId id, QVariantMap& map, ToMap toMap)
		{
			for (const auto& element : elements)
			{
				if (element.id == id)
				{
					map = toMap(element);
					return true;
				}
			}
			return false;
		}
	} // namespace

	QVariantMap properties(const Building& building, ElementId id)
	{
		QVariantMap map;
		if (!lookUp(building.walls, id, map, wallProperties) && !lookUp(building.openings, id, map, openingProperties)
		    && !lookUp(building.columns, id, map, columnProperties) && !lookUp(building.slabs, id, map, slabProperties))
			lookUp(building.spaces, id, map, spaceProperties);
		map[kIdKey] = id.value;
		return map;
	}
} // namespace s2b

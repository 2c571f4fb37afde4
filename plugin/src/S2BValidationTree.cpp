// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BValidationTree.h"

#include "core/report/scene.h"

#include <array>
#include <ccMesh.h>
#include <ccPointCloud.h>

namespace s2b
{
	namespace
	{
		struct StyleGroup
		{
			report::Style style;
			const char*   name;
			ccColor::Rgb  color;
		};
		// The colours of the report's plans.
		const std::array<StyleGroup, 6> kGroups{{
		    {report::Style::Missed, "Missed", ccColor::Rgb(192, 40, 28)},
		    {report::Style::FalsePositive, "False positives", ccColor::Rgb(122, 58, 160)},
		    {report::Style::OutOfTolerance, "Out of tolerance", ccColor::Rgb(242, 166, 40)},
		    {report::Style::Within, "Within tolerance", ccColor::Rgb(90, 150, 205)},
		    {report::Style::NoData, "No data", ccColor::Rgb(175, 175, 175)},
		    {report::Style::NotSeen, "Not seen", ccColor::Rgb(205, 205, 205)},
		}};

		QString text(const std::string& utf8)
		{
			return QString::fromStdString(utf8);
		}

		QString millimetres(double length_m)
		{
			return QString("%1 mm").arg(1000.0 * length_m, 0, 'f', 1);
		}

		QVariantMap metaData(const report::Row& row)
		{
			QVariantMap map;
			map["No."]          = row.number;
			map[kGuidKey]       = text(row.id);
			map["Name"]         = text(row.name);
			map["Class"]        = validation::className(row.pair.elementClass);
			map["Storey"]       = text(row.storey);
			map["Verdict"]      = report::verdictName(row.verdict);
			map["Outcome"]      = report::outcomeName(row.pair.outcome);
			map["Reason"]       = text(row.reason);
			map["LOA"]          = validation::loaName(row.band);
			const auto addError = [&](const char* key, const std::optional<double>& error_m)
			{
				if (error_m)
					map[key] = millimetres(*error_m);
			};
			if (row.truth && row.result)
				map["IoU"] = QString::number(row.pair.iou, 'f', 3);
			addError("Error: centre", row.pair.centroid_m);
			addError("Error: axis ends", row.pair.axisEnd_m);
			addError("Error: thickness", row.pair.thicknessError_m);
			addError("Error: height", row.pair.heightError_m);
			if (row.toResult && row.toResult->points)
			{
				map["Points: count"]       = static_cast<qulonglong>(row.toResult->points);
				map["Points: mean"]        = millimetres(row.toResult->meanSigned_m);
				map["Points: RMS"]         = millimetres(row.toResult->rms_m);
				map["Points: 95 % within"] = millimetres(row.toResult->p95_m);
				map["Points: coverage"]    = QString("%1 %").arg(100.0 * row.toResult->coverage, 0, 'f', 0);
			}
			return map;
		}

		std::unique_ptr<ccMesh> makeMesh(const validation::Mesh& solid, const Eigen::Vector3d& origin, const ccShiftedObject& reference, const ccColor::Rgb& color)
		{
			if (solid.triangles.empty())
				return {};
			auto vertices = std::make_unique<ccPointCloud>("vertices");
			if (!vertices->reserve(static_cast<unsigned>(solid.vertices.size())))
				throw std::bad_alloc();
			for (const Eigen::Vector3d& vertex : solid.vertices)
			{
				const Eigen::Vector3d world = vertex + origin;
				vertices->addPoint(reference.toLocal3d(CCVector3d(world.x(), world.y(), world.z())).toPC());
			}
			vertices->setColor(color);
			vertices->copyGlobalShiftAndScale(reference);
			vertices->setEnabled(false);
			auto mesh = std::make_unique<ccMesh>(vertices.get());
			mesh->addChild(vertices.release());
			if (!mesh->reserve(solid.triangles.size()))
				throw std::bad_alloc();
			for (const auto& t : solid.triangles)
				mesh->addTriangle(t[0], t[1], t[2]);
			mesh->copyGlobalShiftAndScale(reference);
			mesh->computePerTriangleNormals();
			mesh->showNormals(true);
			mesh->showColors(true);
			return mesh;
		}
	} // namespace

	std::unique_ptr<ccHObject> makeValidationTree(const ValidationOutcome& outcome, const ccShiftedObject& reference, const QString& name)
	{
		const report::Scene scene = report::makeScene(reportInput(outcome, nullptr, {}));
		auto                root  = std::make_unique<ccHObject>(name);
		root->setMetaData(kValidationKey, name);
		for (const StyleGroup& style : kGroups)
		{
			auto group = std::make_unique<ccHObject>(style.name);
			for (const report::Row& row : scene.rows)
			{
				if (row.style != style.style)
					continue;
				const Eigen::Vector3d& origin = row.result ? outcome.result.origin : outcome.truth->origin;
				auto                   mesh   = makeMesh(row.element().mesh, origin, reference, style.color);
				if (!mesh)
					continue;
				const QString kind    = validation::className(row.pair.elementClass);
				const QString element = text(row.name).startsWith(kind, Qt::CaseInsensitive) ? text(row.name) : kind + ' ' + text(row.name);
				mesh->setName(QString("%1: %2").arg(row.number).arg(element));
				mesh->setMetaData(metaData(row));
				// What lies over or fills the rest would hide it.
				const bool isHiding = row.pair.elementClass == validation::ElementClass::Slab || row.pair.elementClass == validation::ElementClass::Space;
				mesh->setEnabled(!isHiding);
				group->addChild(mesh.release());
			}
			group->setEnabled(style.style != report::Style::NotSeen);
			if (group->getChildrenNumber())
			{
				group->setName(QString("%1 (%2)").arg(style.name).arg(group->getChildrenNumber()));
				root->addChild(group.release());
			}
		}
		return root;
	}

	ccHObject* validationOf(const ccHObject::Container& selection)
	{
		if (selection.size() != 1)
			return nullptr;
		for (ccHObject* entity = selection.front(); entity; entity = entity->getParent())
		{
			if (entity->hasMetaData(kValidationKey))
				return entity;
		}
		return nullptr;
	}

	QColor verdictColor(const ccHObject& element)
	{
		const QString group = element.getParent() ? element.getParent()->getName() : QString();
		for (const StyleGroup& style : kGroups)
		{
			if (group.startsWith(style.name))
				return {style.color.r, style.color.g, style.color.b};
		}
		return Qt::gray;
	}
} // namespace s2b

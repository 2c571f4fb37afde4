// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BEntities.h"

#include "S2BFindings.h"
#include "S2BModel.h"
#include "S2BSummary.h"
#include "core/corrections/corrections.h"
#include "core/corrections/elements.h"

#include <QCryptographicHash>
#include <algorithm>
#include <array>
#include <ccMesh.h>
#include <ccPlane.h>
#include <ccPointCloud.h>
#include <ccPolyline.h>

namespace s2b
{
	namespace
	{
		constexpr double kSpaceLift_m = 0.02; // a space is drawn as a thin plate, just above the floor slab
		constexpr double kPlaneEdge_m = 1.0;  // a level plane reaches this far over the walls
		constexpr double kLevelMark_m = 0.8;
		constexpr double kAxisLift_m  = 0.02;
		constexpr double kArcStep_m   = 0.25;

		struct ClassStyle
		{
			ElementClass kind;
			const char*  one;
			const char*  many;
			ccColor::Rgb color;
		};
		// Light, because CloudCompare's lamp dims them; told apart by hue and lightness also by the colour blind.
		const std::array<ClassStyle, 7> kStyles{{
		    {ElementClass::Wall, "Wall", "Walls", ccColor::Rgb(255, 246, 228)},
		    {ElementClass::Door, "Door", "Doors", ccColor::Rgb(226, 138, 66)},
		    {ElementClass::Window, "Window", "Windows", ccColor::Rgb(120, 205, 255)},
		    {ElementClass::Opening, "Opening", "Openings", ccColor::Rgb(150, 220, 120)},
		    {ElementClass::Column, "Column", "Columns", ccColor::Rgb(228, 96, 96)},
		    {ElementClass::Slab, "Slab", "Slabs", ccColor::Rgb(176, 186, 204)},
		    {ElementClass::Space, "Space", "Spaces", ccColor::Rgb(176, 236, 204)},
		}};
		const ccColor::Rgb              kLevelColor(90, 170, 255);
		const ccColor::Rgb              kAxisColor(235, 60, 60);

		const ClassStyle& styleOf(ElementClass kind)
		{
			return kStyles[static_cast<std::size_t>(kind)];
		}

		CCVector3 toLocal(const Building& building, const ccShiftedObject& reference, const Eigen::Vector3d& p)
		{
			const Eigen::Vector3d world = building.frame.toWorld(p);
			return reference.toLocal3d(CCVector3d(world.x(), world.y(), world.z())).toPC();
		}

		std::unique_ptr<ccMesh> makeMesh(const Building& building, const ccShiftedObject& reference, const Solid& solid, const ccColor::Rgb& color)
		{
			auto vertices = std::make_unique<ccPointCloud>("vertices");
			if (solid.triangles.empty())
				return {};
			if (!vertices->reserve(static_cast<unsigned>(solid.vertices.size())))
				throw std::bad_alloc();
			for (const Eigen::Vector3d& p : solid.vertices)
				vertices->addPoint(toLocal(building, reference, p));
			vertices->setColor(color);
			vertices->copyGlobalShiftAndScale(reference);
			vertices->setEnabled(false);
			vertices->setLocked(false);

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

		ElementClass classOf(OpeningKind kind)
		{
			return kind == OpeningKind::Door ? ElementClass::Door : kind == OpeningKind::Window ? ElementClass::Window
			                                                                                    : ElementClass::Opening;
		}

		std::unique_ptr<ccPolyline> makeAxis(const Building& building, const ccShiftedObject& reference, const Wall& wall)
		{
			const double                 length = wall.axisLength_m();
			const int                    pieces = wall.bulge == 0 ? 1 : std::max(4, static_cast<int>(length / kArcStep_m));
			std::vector<Eigen::Vector3d> points;
			for (int i = 0; i <= pieces; ++i)
			{
				const Eigen::Vector2d p = pointOnAxis(wall, length * i / pieces).position;
				points.emplace_back(p.x(), p.y(), wall.base_m + kAxisLift_m);
			}
			return makePolyline(building, reference, points, false, kAxisColor, QString("Axis of wall %1").arg(wall.id.value));
		}

		// The outline of a plain opening in the middle of its wall: there is no body to draw.
		std::unique_ptr<ccPolyline> makeVoid(const Building& building, const ccShiftedObject& reference, const Wall& host, const Opening& opening)
		{
			const double                 z0 = host.base_m + opening.sill.value_m;
			const double                 z1 = z0 + opening.height.value_m;
			const Eigen::Vector2d        a  = pointOnAxis(host, opening.offset_m).position;
			const Eigen::Vector2d        b  = pointOnAxis(host, opening.offset_m + opening.width.value_m).position;
			std::vector<Eigen::Vector3d> points{{a.x(), a.y(), z0}, {b.x(), b.y(), z0}, {b.x(), b.y(), z1}, {a.x(), a.y(), z1}};
			return makePolyline(building, reference, points, true, styleOf(ElementClass::Opening).color, QString::fromStdString(nameOf(building, opening.id)));
		}

		// How far level planes reach: over the walls and columns, or where there are none over the scan.
		Eigen::AlignedBox2d planOf(const Building& building, const ccShiftedObject& reference)
		{
			Eigen::AlignedBox2d plan;
			for (const Wall& wall : building.walls)
			{
				plan.extend(wall.start);
				plan.extend(wall.end);
			}
			for (const Column& column : building.columns)
				plan.extend(column.center);
			auto* scan = dynamic_cast<ccHObject*>(const_cast<ccShiftedObject*>(&reference));
			if (plan.isEmpty() && scan && scan->getOwnBB().isValid())
			{
				const ccBBox box = scan->getOwnBB();
				for (const auto& [x, y] : {std::pair(box.minCorner().x, box.minCorner().y), std::pair(box.maxCorner().x, box.maxCorner().y)})
				{
					const CCVector3d world = reference.toGlobal3d(CCVector3d(x, y, 0.0));
					plan.extend(building.frame.toBuilding({world.x, world.y, 0.0}).head<2>().eval());
				}
			}
			if (plan.isEmpty())
				plan.extend(Eigen::Vector2d::Zero());
			plan.min().array() -= kPlaneEdge_m;
			plan.max().array() += kPlaneEdge_m;
			return plan;
		}

		// The mark of a level in an elevation: a short line beyond the plan, with the level's name, where no wall is behind it.
		std::unique_ptr<ccPolyline> makeLevelMark(const Building& building, const ccShiftedObject& reference, const Storey& storey, const Eigen::AlignedBox2d& plan, const QString& name)
		{
			const double z    = storey.elevation_m - kPlaneDrop_m;
			auto         mark = makePolyline(building, reference, {{plan.max().x(), plan.min().y(), z}, {plan.max().x() + kLevelMark_m, plan.min().y(), z}}, false, kLevelColor, name);
			mark->showNameIn3D(true);
			return mark;
		}

		// A translucent rectangle at the floor's height.
		std::unique_ptr<ccHObject> makeLevelPlane(const Building& building, const ccShiftedObject& reference, const Storey& storey, const Eigen::AlignedBox2d& plan)
		{
			const Eigen::Vector2d size   = plan.sizes();
			const CCVector3       centre = toLocal(building, reference, {plan.center().x(), plan.center().y(), storey.elevation_m - kPlaneDrop_m});
			const auto            scale  = reference.getGlobalScale();
			ccGLMatrix            pose;
			pose.initFromParameters(static_cast<PointCoordinateType>(building.frame.yaw_rad), CCVector3(0, 0, 1), centre);
			auto plane = std::make_unique<ccPlane>(static_cast<PointCoordinateType>(size.x() * scale), static_cast<PointCoordinateType>(size.y() * scale), &pose, QString("Floor level %1").arg(elevationText(building, storey)));
			plane->setColor(kLevelColor);
			plane->showColors(true);
			plane->enableStippling(true);
			plane->addChild(makeLevelMark(building, reference, storey, plan, plane->getName()).release());
			plane->copyGlobalShiftAndScale(reference);
			plane->setMetaData(QString(kLevelKey), storey.id.value);
			plane->setMetaData(QString(kShapeKey), QString("%1 %2 %3").arg(storey.elevation_m, 0, 'f', 6).arg(size.x()).arg(size.y()));
			return plane;
		}

		// Tells whether an entity shows what is there now.
		QString shapeOf(const Building& building, ElementId id, const std::vector<Eigen::Vector3d>& points)
		{
			QCryptographicHash hash(QCryptographicHash::Sha1);
			for (const Eigen::Vector3d& p : points)
				hash.addData(reinterpret_cast<const char*>(p.data()), 3 * sizeof(double));
			const QVariantMap map = properties(building, id);
			for (auto item = map.begin(); item != map.end(); ++item)
				hash.addData((item.key() + item.value().toString()).toUtf8());
			return hash.result().toHex();
		}

		ccHObject* classGroup(ccHObject& storey, ElementClass kind)
		{
			const QString name = styleOf(kind).many;
			for (unsigned i = 0; i < storey.getChildrenNumber(); ++i)
			{
				if (storey.getChild(i)->getName() == name)
					return storey.getChild(i);
			}
			auto* group = new ccHObject(name);
			group->setEnabled(kind != ElementClass::Space);
			storey.addChild(group);
			return group;
		}
	} // namespace

	std::unique_ptr<ccPolyline> makePolyline(const Building& building, const ccShiftedObject& reference, const std::vector<Eigen::Vector3d>& points, bool isClosed, const ccColor::Rgb& color, const QString& name)
	{
		auto vertices = std::make_unique<ccPointCloud>("vertices");
		if (!vertices->reserve(static_cast<unsigned>(points.size())))
			throw std::bad_alloc();
		for (const Eigen::Vector3d& p : points)
			vertices->addPoint(toLocal(building, reference, p));
		vertices->setEnabled(false);
		auto line = std::make_unique<ccPolyline>(vertices.get());
		line->addPointIndex(0, vertices->size());
		line->addChild(vertices.release());
		line->setClosed(isClosed);
		line->setColor(color);
		line->showColors(true);
		line->setWidth(2);
		line->setName(name);
		line->copyGlobalShiftAndScale(reference);
		return line;
	}

	std::optional<Solid> elementSolid(const Building& building, ElementId id)
	{
		if (const Wall* wall = building.wall(id))
			return wallSolid(building, *wall);
		if (const Opening* opening = findElement(building.openings, id))
		{
			const Wall* host = building.wall(opening->host);
			return host && opening->kind != OpeningKind::Plain ? std::optional(fillingSolid(*host, *opening)) : std::nullopt;
		}
		if (const Column* column = findElement(building.columns, id))
			return columnSolid(*column);
		if (const Slab* slab = findElement(building.slabs, id))
			return prism(slab->outline, slab->top_m - slab->thickness.value_m, slab->top_m);
		if (const Space* space = findElement(building.spaces, id))
			return prism(space->outline, space->floor_m, space->floor_m + kSpaceLift_m);
		return std::nullopt;
	}

	std::vector<NamedMesh> makeMeshes(const Building& building, const ccShiftedObject& reference)
	{
		std::vector<NamedMesh> meshes;
		const auto             add = [&](ElementClass kind, ElementId id, ElementId storey)
		{
			const std::optional<Solid> solid = elementSolid(building, id);
			auto                       mesh  = solid ? makeMesh(building, reference, *solid, styleOf(kind).color) : nullptr;
			if (!mesh)
				return;
			const QString name = QString::fromStdString(nameOf(building, id));
			mesh->setName(name);
			mesh->setMetaData(properties(building, id));
			mesh->setMetaData(QString(kShapeKey), shapeOf(building, id, solid->vertices));
			meshes.push_back({id, storey, kind, name, std::move(mesh)});
		};
		for (const Wall& wall : building.walls)
			add(ElementClass::Wall, wall.id, wall.storey);
		for (const Opening& opening : building.openings)
		{
			if (const Wall* host = building.wall(opening.host))
				add(classOf(opening.kind), opening.id, host->storey);
		}
		for (const Column& column : building.columns)
			add(ElementClass::Column, column.id, column.storey);
		for (const Slab& slab : building.slabs)
			add(ElementClass::Slab, slab.id, slab.storey);
		for (const Space& space : building.spaces)
			add(ElementClass::Space, space.id, space.storey);
		return meshes;
	}

	std::unique_ptr<ccHObject> makeTree(const Building& building, const ccShiftedObject& reference, const QString& name)
	{
		return makeTree(Model{building, building, {}}, reference, name);
	}

	std::unique_ptr<ccHObject> makeTree(const Model& model, const ccShiftedObject& reference, const QString& name, const Eigen::AlignedBox2d& known)
	{
		const Building&           building = model.corrected;
		const Eigen::AlignedBox2d plan     = known.isEmpty() ? planOf(building, reference) : known;
		const CCVector3d          shift    = reference.getGlobalShift();
		auto                      root     = std::make_unique<ccHObject>(name);
		storeModel(*root, model);
		root->setMetaData(QString(kShiftKey), QVariantList{shift.x, shift.y, shift.z, reference.getGlobalScale()});
		root->setMetaData(QString(kPlanKey), QVariantList{plan.min().x(), plan.min().y(), plan.max().x(), plan.max().y()});

		std::vector<NamedMesh> meshes = makeMeshes(building, reference);
		for (const Storey& storey : building.storeys)
		{
			auto* group = new ccHObject(QString::fromStdString(storey.name));
			root->addChild(group);
			group->setMetaData(QString(kIdKey), storey.id.value);
			group->setMetaData("Elevation", elevationText(building, storey));
			group->setMetaData("Height", QString("%1 m").arg(storey.height.value_m, 0, 'f', 3));
			group->addChild(makeLevelPlane(building, reference, storey, plan).release());
			for (NamedMesh& element : meshes)
			{
				if (element.storey != storey.id)
					continue;
				const Slab* slab = findElement(building.slabs, element.id);
				if (slab && slab->kind == SlabKind::Roof)
					element.mesh->setEnabled(false); // it would hide everything below it
				classGroup(*group, element.kind)->addChild(element.mesh.release());
			}
			for (const Opening& opening : building.openings)
			{
				const Wall* host = building.wall(opening.host);
				if (!host || host->storey != storey.id || opening.kind != OpeningKind::Plain)
					continue;
				auto line = makeVoid(building, reference, *host, opening);
				line->setMetaData(properties(building, opening.id));
				line->setMetaData(QString(kShapeKey), shapeOf(building, opening.id, {{opening.offset_m, host->base_m, 0}, {host->start.x(), host->start.y(), 0}, {host->end.x(), host->end.y(), 0}}));
				classGroup(*group, ElementClass::Opening)->addChild(line.release());
			}
			auto* axes = new ccHObject("Wall axes");
			axes->setEnabled(false);
			for (const Wall& wall : building.walls)
			{
				if (wall.storey != storey.id)
					continue;
				auto axis = makeAxis(building, reference, wall);
				axis->setMetaData(QString(kAxisKey), wall.id.value);
				axis->setMetaData(QString(kShapeKey), shapeOf(building, wall.id, {{wall.start.x(), wall.start.y(), wall.base_m}, {wall.end.x(), wall.end.y(), wall.bulge}}));
				axes->addChild(axis.release());
			}
			group->addChild(axes);
		}
		QVariantList bodiless;
		const auto   entities = elementEntities(*root);
		forEachClass(building, [&](const auto& elements)
		             {
			             for (const auto& e : elements)
			             {
				             const auto entity = entities.find(e.id);
				             if (entity == entities.end())
					             bodiless << e.id.value;
				             else
					             entity->second->setName(QString::fromStdString(nameOf(model, e.id)));
			             } });
		root->setMetaData(QString(kBodilessKey), bodiless);
		if (auto findings = makeFindings(building, reference))
			root->addChild(findings.release());
		return root;
	}
} // namespace s2b

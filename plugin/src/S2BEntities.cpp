// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BEntities.h"

#include "S2BBuildingText.h"
#include "S2BSummary.h"
#include "solids.h"

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
		constexpr double kAxisLift_m  = 0.02;
		constexpr double kArcStep_m   = 0.25;

		struct ClassStyle
		{
			ElementClass kind;
			const char*  one;
			const char*  many;
			ccColor::Rgb color;
		};
		// Calm, told apart by hue and lightness also by the colour blind.
		const std::array<ClassStyle, 7> kStyles{{
		    {ElementClass::Wall, "Wall", "Walls", ccColor::Rgb(232, 220, 200)},
		    {ElementClass::Door, "Door", "Doors", ccColor::Rgb(196, 118, 60)},
		    {ElementClass::Window, "Window", "Windows", ccColor::Rgb(110, 180, 220)},
		    {ElementClass::Opening, "Opening", "Openings", ccColor::Rgb(150, 190, 130)},
		    {ElementClass::Column, "Column", "Columns", ccColor::Rgb(190, 90, 90)},
		    {ElementClass::Slab, "Slab", "Slabs", ccColor::Rgb(150, 155, 165)},
		    {ElementClass::Space, "Space", "Spaces", ccColor::Rgb(170, 210, 190)},
		}};
		const ccColor::Rgb              kLevelColor(120, 160, 210);
		const ccColor::Rgb              kAxisColor(200, 60, 60);

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

		QString nameOf(ElementClass kind, ElementId id)
		{
			return QString("%1 %2").arg(styleOf(kind).one).arg(id.value);
		}

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
			return makePolyline(building, reference, points, true, styleOf(ElementClass::Opening).color, nameOf(ElementClass::Opening, opening.id));
		}

		// A rectangle over all of the building's plan at the floor's height.
		std::unique_ptr<ccHObject> makeLevelPlane(const Building& building, const ccShiftedObject& reference, const Storey& storey)
		{
			Eigen::AlignedBox2d plan;
			for (const Wall& wall : building.walls)
			{
				plan.extend(wall.start);
				plan.extend(wall.end);
			}
			for (const Column& column : building.columns)
				plan.extend(column.center);
			if (plan.isEmpty())
				return {};
			const Eigen::Vector2d edge(kPlaneEdge_m, kPlaneEdge_m);
			const Eigen::Vector2d size   = plan.sizes() + 2.0 * edge;
			const CCVector3       centre = toLocal(building, reference, {plan.center().x(), plan.center().y(), storey.elevation_m});
			const auto            scale  = reference.getGlobalScale();
			ccGLMatrix            pose;
			pose.initFromParameters(static_cast<PointCoordinateType>(building.frame.yaw_rad), CCVector3(0, 0, 1), centre);
			auto plane = std::make_unique<ccPlane>(static_cast<PointCoordinateType>(size.x() * scale), static_cast<PointCoordinateType>(size.y() * scale), &pose, QString("Floor level %1").arg(elevationText(building, storey)));
			plane->setColor(kLevelColor);
			plane->showColors(true);
			plane->copyGlobalShiftAndScale(reference);
			const bool hasSlab = std::any_of(building.slabs.begin(), building.slabs.end(), [&](const Slab& slab)
			                                 { return slab.storey == storey.id; });
			plane->setEnabled(!hasSlab); // both at the same height would flicker
			return plane;
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

	std::vector<NamedMesh> makeMeshes(const Building& building, const ccShiftedObject& reference)
	{
		std::vector<NamedMesh> meshes;
		const auto             add = [&](ElementClass kind, ElementId id, ElementId storey, const QString& name, const Solid& solid)
		{
			auto mesh = makeMesh(building, reference, solid, styleOf(kind).color);
			if (!mesh)
				return;
			mesh->setName(name);
			mesh->setMetaData(properties(building, id));
			meshes.push_back({id, storey, kind, name, std::move(mesh)});
		};
		for (const Wall& wall : building.walls)
			add(ElementClass::Wall, wall.id, wall.storey, nameOf(ElementClass::Wall, wall.id), wallSolid(building, wall));
		for (const Opening& opening : building.openings)
		{
			if (const Wall* host = building.wall(opening.host))
				add(classOf(opening.kind), opening.id, host->storey, nameOf(classOf(opening.kind), opening.id), fillingSolid(*host, opening));
		}
		for (const Column& column : building.columns)
			add(ElementClass::Column, column.id, column.storey, nameOf(ElementClass::Column, column.id), columnSolid(column));
		for (const Slab& slab : building.slabs)
			add(ElementClass::Slab, slab.id, slab.storey, QString(slab.kind == SlabKind::Roof ? "Roof %1" : "Slab %1").arg(slab.id.value), prism(slab.outline, slab.top_m - slab.thickness.value_m, slab.top_m));
		for (const Space& space : building.spaces)
		{
			const QString name = space.name.empty() ? nameOf(ElementClass::Space, space.id) : QString::fromStdString(space.name);
			add(ElementClass::Space, space.id, space.storey, name, prism(space.outline, space.floor_m, space.floor_m + kSpaceLift_m));
		}
		return meshes;
	}

	std::unique_ptr<ccHObject> makeTree(const Building& building, const ccShiftedObject& reference, const QString& name)
	{
		auto root = std::make_unique<ccHObject>(name);
		root->setMetaData(QString(kBuildingKey), QVariantMap{{"text", buildingText(building)}});

		std::vector<NamedMesh> meshes = makeMeshes(building, reference);
		for (const Storey& storey : building.storeys)
		{
			auto* group = new ccHObject(QString::fromStdString(storey.name));
			root->addChild(group);
			group->setMetaData("Elevation", elevationText(building, storey));
			group->setMetaData("Height", QString("%1 m").arg(storey.height.value_m, 0, 'f', 3));
			if (auto plane = makeLevelPlane(building, reference, storey))
				group->addChild(plane.release());
			for (NamedMesh& element : meshes)
			{
				if (element.storey != storey.id)
					continue;
				// A ceiling would hide everything below it.
				if (element.name.startsWith("Roof"))
					element.mesh->setEnabled(false);
				classGroup(*group, element.kind)->addChild(element.mesh.release());
			}
			for (const Opening& opening : building.openings)
			{
				const Wall* host = building.wall(opening.host);
				if (!host || host->storey != storey.id || opening.kind != OpeningKind::Plain)
					continue;
				auto line = makeVoid(building, reference, *host, opening);
				line->setMetaData(properties(building, opening.id));
				classGroup(*group, ElementClass::Opening)->addChild(line.release());
			}
			auto* axes = new ccHObject("Wall axes");
			axes->setEnabled(false);
			for (const Wall& wall : building.walls)
			{
				if (wall.storey == storey.id)
					axes->addChild(makeAxis(building, reference, wall).release());
			}
			group->addChild(axes);
		}
		return root;
	}
} // namespace s2b

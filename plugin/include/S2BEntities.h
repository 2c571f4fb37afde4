// SPDX-License-Identifier: GPL-3.0-or-later
// A building as CloudCompare's entities: a tree for the window, a list of meshes for the command line.
#pragma once

#include "core/corrections/model.h"
#include "solids.h"

#include <QString>
#include <QVariantMap>
#include <ccColorTypes.h>
#include <memory>
#include <optional>
#include <vector>

class ccHObject;
class ccMesh;
class ccPolyline;
class ccShiftedObject;

namespace s2b
{
	enum class ElementClass
	{
		Wall,
		Door,
		Window,
		Opening,
		Column,
		Slab,
		Space
	};

	//! The solid of one element
	struct NamedMesh
	{
		ElementId               id;
		ElementId               storey;
		ElementClass            kind = ElementClass::Wall;
		QString                 name; //!< "Wall 12"
		std::unique_ptr<ccMesh> mesh;
	};

	//! The key under which an element's entity keeps its id, and the group the building itself
	inline constexpr char kIdKey[]       = "S2B.Id";
	inline constexpr char kBuildingKey[] = "S2B.Building";

	//! A level plane is drawn this far below its floor, so that the slab's top does not flicker
	inline constexpr double kPlaneDrop_m = 0.005;

	//! What is drawn of an element; nothing for an unknown id, a storey and a plain opening
	std::optional<Solid> elementSolid(const Building& building, ElementId id);

	//! One coloured mesh per element that has a body, in storey order
	/** \param reference gives the global shift and scale, so that the meshes lie over the cloud **/
	std::vector<NamedMesh> makeMeshes(const Building& building, const ccShiftedObject& reference);

	//! The tree storey > class > element, with level planes, wall axes and every element's dimensions as meta data
	/** The caller owns it until it is in the DB tree. **/
	std::unique_ptr<ccHObject> makeTree(const Building& building, const ccShiftedObject& reference, const QString& name);
	//! The tree of a model that people corrected
	/** \param plan  how far the level planes reach, building frame; empty: over what is there, or over the reference **/
	std::unique_ptr<ccHObject> makeTree(const Model& model, const ccShiftedObject& reference, const QString& name, const Eigen::AlignedBox2d& plan = {});

	//! A line through points in the building frame
	std::unique_ptr<ccPolyline> makePolyline(const Building& building, const ccShiftedObject& reference, const std::vector<Eigen::Vector3d>& points, bool isClosed, const ccColor::Rgb& color, const QString& name);

	//! Dimensions and evidence of every element, as CloudCompare's Properties panel shows them
	QVariantMap properties(const Building& building, ElementId id);
} // namespace s2b

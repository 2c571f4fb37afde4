// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BBuildingText.h"

#include "core/base/error.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace Eigen
{
	template <int N>
	void to_json(nlohmann::json& j, const Eigen::Matrix<double, N, 1>& v)
	{
		j = std::vector<double>(v.data(), v.data() + N);
	}
	template <int N>
	void from_json(const nlohmann::json& j, Eigen::Matrix<double, N, 1>& v)
	{
		for (int i = 0; i < N; ++i)
			v[i] = j.at(static_cast<std::size_t>(i)).get<double>();
	}
} // namespace Eigen

namespace s2b
{
	constexpr int kFormat = 1; // raised when a field changes its meaning

	void to_json(nlohmann::json& j, const ElementId& id)
	{
		j = id.value;
	}
	void from_json(const nlohmann::json& j, ElementId& id)
	{
		j.get_to(id.value);
	}
	void to_json(nlohmann::json& j, const Section& section)
	{
		const Eigen::Vector2d box = boxOf(section);
		if (const auto* circle = std::get_if<CircleSection>(&section))
			j = {{"radius_m", circle->radius_m}};
		else
			j = {{"width_m", box.x()}, {"depth_m", box.y()}};
		if (const auto* profile = std::get_if<ProfileSection>(&section))
			j.update({{"shape", shapeName(profile->shape)}, {"web_m", profile->web_m}, {"flange_m", profile->flange_m}});
	}
	void from_json(const nlohmann::json& j, Section& section)
	{
		const auto size = [&](const char* name)
		{ return j.at(name).get<double>(); };
		if (j.contains("radius_m"))
			section = CircleSection{size("radius_m")};
		else if (!j.contains("shape"))
			section = RectangleSection{size("width_m"), size("depth_m")};
		else
		{
			const auto name  = j.at("shape").get<std::string>();
			const auto known = {ProfileShape::I, ProfileShape::L, ProfileShape::U, ProfileShape::T};
			const auto shape = std::find_if(known.begin(), known.end(), [&](ProfileShape s)
			                                { return name == shapeName(s); });
			if (shape == known.end())
				throw Error(ErrorCode::BadFile, "a column's section has the unknown shape \"" + name + '"');
			section = ProfileSection{*shape, size("width_m"), size("depth_m"), size("web_m"), size("flange_m")};
		}
	}
	NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Dimension, value_m, provenance, rms_m)
	NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Evidence, points, faceCoverage, facesSeen, rms_m, labelShare)
	NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Frame, origin, yaw_rad)
	NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Polygon, outer, holes)
	NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Storey, id, name, elevation_m, height)
	NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Wall, id, storey, start, end, bulge, bodyStart_m, bodyEnd_m, base_m, height, thickness, topProfile, isExternal, isExternalKnown, evidence)
	NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Opening, id, host, kind, offset_m, width, height, sill, leaves, leafState, hingeAtStart, opensToLeft, evidence)
	NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Column, id, storey, center, yaw_rad, base_m, height, section, sectionProvenance, evidence)
	NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Slab, id, storey, kind, outline, top_m, thickness, evidence)
	NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Space, id, storey, name, outline, floor_m, height, area_m2, boundedBy)
	NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Junction, wallA, wallB, endA, endB)
	NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Diagnostic, severity, stage, code, text, element, location)
	NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Building, frame, storeys, walls, openings, columns, slabs, spaces, junctions, diagnostics)

	QString buildingText(const Building& building)
	{
		nlohmann::json j = building;
		j["format"]      = kFormat;
		return QString::fromStdString(j.dump());
	}

	Building parseBuilding(const QString& text)
	{
		try
		{
			const nlohmann::json j = nlohmann::json::parse(text.toStdString());
			if (j.at("format").get<int>() != kFormat)
				throw Error(ErrorCode::BadFile, "this group was made by another version of Scan to BIM: reconstruct the cloud again");
			return j.get<Building>();
		}
		catch (const nlohmann::json::exception&)
		{
			throw Error(ErrorCode::BadFile, "the model of this group can't be read: reconstruct the cloud again");
		}
	}
} // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
// The closed surfaces of a building's elements, to draw. Knows neither Qt nor CloudCompare.
#pragma once

#include "core/model/building.h"

#include <array>
#include <cstdint>
#include <vector>

namespace s2b
{
	//! A closed surface in the building frame [m], outward facing
	struct Solid
	{
		std::vector<Eigen::Vector3d>              vertices;
		std::vector<std::array<std::uint32_t, 3>> triangles;
	};

	//! Position and left normal on a wall's axis at arc length s
	struct AxisPoint
	{
		Eigen::Vector2d position;
		Eigen::Vector2d normal;
	};
	AxisPoint pointOnAxis(const Wall& wall, double s);

	//! The wall's body with its openings cut and its top profile followed; an arc in steps of about 5 degrees
	Solid wallSolid(const Building& building, const Wall& wall);

	//! The leaf of a door or the pane of a window in the middle of its wall; empty for a plain opening
	Solid fillingSolid(const Wall& host, const Opening& opening);

	Solid columnSolid(const Column& column);

	//! A prism over a polygon with holes; empty when the outline can't be triangulated (it crosses itself)
	Solid prism(const Polygon& outline, double bottom_m, double top_m);
} // namespace s2b

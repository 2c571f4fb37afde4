// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids.h"

#include "core/model/wall_top.h"

#include <Delaunay2dMesh.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace s2b
{
	namespace
	{
		constexpr double kSame_m   = 1.0e-6; // nearer edges are one edge
		constexpr double kStep_rad = 5.0 * std::numbers::pi / 180.0;
		constexpr double kLeaf_m   = 0.05; // drawn thickness of a door leaf
		constexpr double kPane_m   = 0.03; // and of a window pane

		using Corners = std::array<Eigen::Vector3d, 4>;

		// Corners counter-clockwise seen from outside. A quad that has collapsed to a line adds nothing.
		void addTriangle(Solid& solid, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
		{
			if ((b - a).cross(c - a).norm() < kSame_m * kSame_m)
				return;
			const auto first = static_cast<std::uint32_t>(solid.vertices.size());
			solid.vertices.insert(solid.vertices.end(), {a, b, c});
			solid.triangles.push_back({first, first + 1, first + 2});
		}
		void addQuad(Solid& solid, const Corners& q)
		{
			addTriangle(solid, q[0], q[1], q[2]);
			addTriangle(solid, q[0], q[2], q[3]);
		}

		void sortUnique(std::vector<double>& values)
		{
			std::sort(values.begin(), values.end());
			values.erase(std::unique(values.begin(), values.end(), [](double a, double b)
			                         { return b - a < kSame_m; }),
			             values.end());
		}

		double sweepOf(const Wall& wall)
		{
			return 4.0 * std::atan(wall.bulge);
		}

		struct Hole
		{
			double s0, s1, z0, z1;
		};

		std::vector<Hole> holesOf(const Building& building, const Wall& wall)
		{
			std::vector<Hole> holes;
			for (const Opening& o : building.openings)
			{
				if (o.host != wall.id)
					continue;
				const double sill = wall.base_m + o.sill.value_m;
				holes.push_back({std::max(o.offset_m, wall.bodyStart_m), std::min(o.offset_m + o.width.value_m, wall.bodyEnd_m), std::max(sill, wall.base_m), sill + o.height.value_m});
			}
			return holes;
		}

		// The lines that cut the wall's face into cells that are either solid or void.
		void makeGrid(const Wall& wall, const std::vector<Hole>& holes, std::vector<double>& s, std::vector<double>& z)
		{
			s          = {wall.bodyStart_m, wall.bodyEnd_m};
			double top = topAt(wall, wall.bodyStart_m);
			for (const auto& p : wall.topProfile)
			{
				top = std::max(top, p.y());
				s.push_back(p.x());
			}
			z = {wall.base_m, top};
			for (const Hole& hole : holes)
			{
				s.insert(s.end(), {hole.s0, hole.s1});
				z.insert(z.end(), {hole.z0, hole.z1});
			}
			for (std::size_t i = 1; i < wall.topProfile.size(); ++i) // where the sloping edge crosses a line of the grid
			{
				const Eigen::Vector2d a = wall.topProfile[i - 1];
				const Eigen::Vector2d b = wall.topProfile[i];
				for (const Hole& hole : holes)
				{
					for (const double level : {hole.z0, hole.z1})
					{
						const double t = (level - a.y()) / (b.y() - a.y());
						if (t > 0 && t < 1)
							s.push_back(a.x() + t * (b.x() - a.x()));
					}
				}
			}
			if (wall.bulge != 0)
			{
				const int    steps = std::max(1, static_cast<int>(std::ceil(std::abs(sweepOf(wall)) / kStep_rad)));
				const double step  = wall.axisLength_m() / steps;
				for (int i = 1; i < steps; ++i)
					s.push_back(i * step);
			}
			std::erase_if(s, [&](double v)
			              { return v < wall.bodyStart_m - kSame_m || v > wall.bodyEnd_m + kSame_m; });
			std::erase_if(z, [&](double v)
			              { return v < wall.base_m - kSame_m || v > top + kSame_m; });
			sortUnique(s);
			sortUnique(z);
		}

		// A box about the wall's axis between two arc lengths.
		Solid axisBox(const Wall& wall, double s0, double s1, double z0, double z1, double thickness_m)
		{
			Wall piece              = wall;
			piece.bodyStart_m       = s0;
			piece.bodyEnd_m         = s1;
			piece.base_m            = z0;
			piece.height.value_m    = z1 - z0;
			piece.thickness.value_m = thickness_m;
			piece.topProfile.clear();
			return wallSolid(Building{}, piece);
		}
	} // namespace

	AxisPoint pointOnAxis(const Wall& wall, double s)
	{
		const Eigen::Vector2d chord  = wall.end - wall.start;
		const double          length = chord.norm();
		const Eigen::Vector2d along  = length > 0 ? Eigen::Vector2d(chord / length) : Eigen::Vector2d::UnitX();
		const Eigen::Vector2d left(-along.y(), along.x());
		if (wall.bulge == 0 || length <= 0)
			return {wall.start + s * along, left};

		// The arc turns by the sweep; the centre lies on the left of the chord for a counter-clockwise arc.
		const double            sweep  = sweepOf(wall);
		const double            radius = length / (2.0 * std::sin(sweep / 2.0)); // signed as the sweep
		const Eigen::Vector2d   centre = wall.start + 0.5 * chord + left * radius * std::cos(sweep / 2.0);
		const double            angle  = s / radius;
		const Eigen::Rotation2D turn(angle);
		const Eigen::Vector2d   spoke = turn * (wall.start - centre);
		const Eigen::Vector2d   inward(-spoke / radius); // to the left of the direction, whichever way the arc turns
		return {centre + spoke, inward.normalized()};
	}

	Solid wallSolid(const Building& building, const Wall& wall)
	{
		Solid solid;
		if (!(wall.bodyEnd_m - wall.bodyStart_m > kSame_m))
			return solid;
		const std::vector<Hole> holes = holesOf(building, wall);
		std::vector<double>     s, z;
		makeGrid(wall, holes, s, z);
		const auto columns = static_cast<int>(s.size()) - 1;
		const auto rows    = static_cast<int>(z.size()) - 1;

		const auto at = [](const std::vector<double>& v, int i)
		{ return v[static_cast<std::size_t>(i)]; };
		const auto isSolid = [&](int i, int j)
		{
			if (i < 0 || j < 0 || i >= columns || j >= rows)
				return false;
			const double cs = 0.5 * (at(s, i) + at(s, i + 1));
			const double cz = 0.5 * (at(z, j) + at(z, j + 1));
			if (std::max(topAt(wall, at(s, i) + kSame_m), topAt(wall, at(s, i + 1) - kSame_m)) <= at(z, j) + kSame_m)
				return false;
			return std::none_of(holes.begin(), holes.end(), [&](const Hole& h)
			                    { return cs > h.s0 && cs < h.s1 && cz > h.z0 && cz < h.z1; });
		};
		const double half   = 0.5 * wall.thickness.value_m;
		const auto   corner = [&](int i, int j, double side)
		{
			const AxisPoint       p  = pointOnAxis(wall, at(s, i));
			const Eigen::Vector2d xy = p.position + side * half * p.normal;
			return Eigen::Vector3d(xy.x(), xy.y(), std::min(at(z, j), topAt(wall, at(s, i))));
		};
		for (int i = 0; i < columns; ++i)
		{
			for (int j = 0; j < rows; ++j)
			{
				if (!isSolid(i, j))
					continue;
				const Corners right{corner(i, j, -1), corner(i + 1, j, -1), corner(i + 1, j + 1, -1), corner(i, j + 1, -1)};
				const Corners left{corner(i, j, 1), corner(i + 1, j, 1), corner(i + 1, j + 1, 1), corner(i, j + 1, 1)};
				addQuad(solid, right);
				addQuad(solid, {left[1], left[0], left[3], left[2]});
				if (!isSolid(i - 1, j))
					addQuad(solid, {left[0], right[0], right[3], left[3]});
				if (!isSolid(i + 1, j))
					addQuad(solid, {right[1], left[1], left[2], right[2]});
				if (!isSolid(i, j - 1))
					addQuad(solid, {left[0], left[1], right[1], right[0]});
				if (!isSolid(i, j + 1))
					addQuad(solid, {right[3], right[2], left[2], left[3]});
			}
		}
		return solid;
	}

	Solid fillingSolid(const Wall& host, const Opening& opening)
	{
		if (opening.kind == OpeningKind::Plain)
			return {};
		const double depth = std::min(opening.kind == OpeningKind::Door ? kLeaf_m : kPane_m, host.thickness.value_m);
		const double sill  = host.base_m + opening.sill.value_m;
		return axisBox(host, opening.offset_m, opening.offset_m + opening.width.value_m, sill, sill + opening.height.value_m, depth);
	}

	Solid columnSolid(const Column& column)
	{
		const Polygon outline{column.outline(), {}};
		return prism(outline, column.base_m, column.base_m + column.height.value_m);
	}

	Solid prism(const Polygon& outline, double bottom_m, double top_m)
	{
		// CloudCompare's constrained triangulation works in float: about the first corner, to keep the millimetres.
		if (outline.outer.size() < 3)
			return {};
		const Eigen::Vector2d               origin = outline.outer.front();
		std::vector<CCVector2>              points;
		std::vector<Eigen::Vector2d>        exact;
		std::vector<int>                    segments;
		std::vector<std::vector<CCVector2>> rings;
		const auto                          addRing = [&](const std::vector<Eigen::Vector2d>& ring)
		{
			const int first = static_cast<int>(points.size());
			const int count = static_cast<int>(ring.size());
			rings.emplace_back();
			for (int i = 0; i < count; ++i)
			{
				const Eigen::Vector2d p = ring[static_cast<std::size_t>(i)] - origin;
				exact.push_back(ring[static_cast<std::size_t>(i)]);
				points.emplace_back(static_cast<PointCoordinateType>(p.x()), static_cast<PointCoordinateType>(p.y()));
				rings.back().push_back(points.back());
				segments.insert(segments.end(), {first + i, first + (i + 1) % count});
			}
		};
		addRing(outline.outer);
		for (const auto& hole : outline.holes)
			addRing(hole);

		CCCoreLib::Delaunay2dMesh triangulation;
		std::string               error;
		if (!triangulation.buildMesh(points, segments, error) || !triangulation.removeOuterTriangles(points, rings.front(), true))
			return {};
		for (std::size_t i = 1; i < rings.size(); ++i)
			triangulation.removeOuterTriangles(points, rings[i], false);

		Solid      solid;
		const auto at = [&](unsigned i, double z)
		{ return Eigen::Vector3d(exact[i].x(), exact[i].y(), z); };
		for (unsigned t = 0; t < triangulation.size(); ++t)
		{
			const CCCoreLib::VerticesIndexes* v = triangulation.getTriangleVertIndexes(t);
			unsigned                          a = v->i1, b = v->i2, c = v->i3;
			if (std::max({a, b, c}) >= exact.size())
				return {};
			const Eigen::Vector2d ab = exact[b] - exact[a];
			const Eigen::Vector2d ac = exact[c] - exact[a];
			if (ab.x() * ac.y() - ab.y() * ac.x() < 0)
				std::swap(b, c);
			addTriangle(solid, at(a, top_m), at(b, top_m), at(c, top_m));
			addTriangle(solid, at(a, bottom_m), at(c, bottom_m), at(b, bottom_m));
		}
		for (std::size_t i = 0; i < segments.size(); i += 2) // outer rings turn left, holes right: outside is on the right
		{
			const auto a = static_cast<unsigned>(segments[i]);
			const auto b = static_cast<unsigned>(segments[i + 1]);
			addQuad(solid, {at(a, bottom_m), at(b, bottom_m), at(b, top_m), at(a, top_m)});
		}
		return solid;
	}
} // namespace s2b

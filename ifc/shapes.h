// SPDX-License-Identifier: GPL-3.0-or-later
/// Geometry, placements and colours as IFC instances.
#pragma once

#include "core/model/building.h"
#include "ifc/builder.h"

#include <Eigen/Core>

#include <array>
#include <map>
#include <vector>

namespace s2b::ifc
{

enum class Style
{
    Wall,
    Column,
    Slab,
    Leaf,
    Frame,
    Glass,
    Space
};

/// A ring of straight and circular pieces in plan: the points in order, each with the middle of the arc that leads from
/// it to the next, where it is an arc.
struct Ring
{
    struct Corner
    {
        Eigen::Vector2d point;
        bool isArc = false;
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    };
    std::vector<Corner> corners;
};

class Shapes
{
public:
    /// Makes the contexts: Model with its Body, Axis and FootPrint.
    explicit Shapes(Builder& builder);

    [[nodiscard]] Instance modelContext() const { return m_model; }

    /// Placement relative to another (none: the world): origin, and the x axis' direction in plan.
    Instance placement(Instance relativeTo, const Eigen::Vector3d& origin,
                       const Eigen::Vector2d& x = Eigen::Vector2d::UnitX());

    /// Solids, all extruded along z from z = `bottom` unless said otherwise.
    Instance box(const Eigen::Vector3d& corner, const Eigen::Vector3d& size);
    Instance cylinder(double radius, double height);
    /// A column's body: the lower-left corner of the section's box at the origin; a circle about it.
    Instance column(const Section& section, double height);
    Instance prism(const Ring& ring, double bottom, double height);
    Instance prism(const Polygon& polygon, double bottom, double height);
    /// A polygon in the x-z plane, extruded along y from `front` to `front + depth`, with holes.
    Instance plate(const std::vector<Eigen::Vector2d>& outer, const std::vector<std::vector<Eigen::Vector2d>>& holes,
                   double front, double depth);
    /// A closed triangle mesh.
    Instance mesh(const std::vector<Eigen::Vector3d>& vertices, const std::vector<std::array<int, 3>>& triangles);

    /// Curves in plan.
    Instance line(const Eigen::Vector2d& a, const Eigen::Vector2d& b);
    Instance arc(const Eigen::Vector2d& a, const Eigen::Vector2d& middle, const Eigen::Vector2d& b);

    /// Gives a solid its class' colour and returns it.
    Instance paint(Instance item, Style style);

    struct Representation
    {
        InstanceList body;
        const char* bodyType = "SweptSolid";
        Instance axis;
        InstanceList footPrint;
    };
    Instance shape(const Representation& representation);

    /// Closed curves of an outline and its holes.
    InstanceList outlines(const Polygon& polygon);

private:
    Instance point(const std::vector<double>& coordinates);
    Instance direction(const std::vector<double>& ratios);
    Instance axes(const Eigen::Vector3d& origin, const Eigen::Vector2d& x);
    Instance axes2(const Eigen::Vector2d& origin);
    Instance curve(const Ring& ring);
    Instance profile(Instance outer, const InstanceList& holes);
    Instance extrude(Instance profile, Instance position, double depth);
    Instance representation(Instance context, const char* identifier, const char* type, const InstanceList& items);

    Builder& m_builder;
    Instance m_model;
    Instance m_body;
    Instance m_axis;
    Instance m_footPrint;
    std::map<std::vector<double>, Instance> m_directions;
    std::map<std::array<double, 3>, Instance> m_origins;  // axis placements without a rotation
    std::map<Style, Instance> m_styles;
};

}  // namespace s2b::ifc

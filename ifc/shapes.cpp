// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc/shapes.h"

#include <algorithm>
#include <cmath>

namespace s2b::ifc
{
namespace
{

struct Colour
{
    const char* name;
    double red, green, blue, transparency;
};

Colour colourOf(Style style)
{
    switch (style)
    {
        case Style::Wall:
            return {"Wall", 0.87, 0.85, 0.81, 0.0};
        case Style::Column:
            return {"Column", 0.62, 0.64, 0.67, 0.0};
        case Style::Slab:
            return {"Slab", 0.72, 0.72, 0.70, 0.0};
        case Style::Leaf:
            return {"Door leaf", 0.66, 0.47, 0.29, 0.0};
        case Style::Frame:
            return {"Frame", 0.95, 0.95, 0.93, 0.0};
        case Style::Glass:
            return {"Glass", 0.62, 0.80, 0.88, 0.7};
        case Style::Space:
            return {"Space", 0.98, 0.90, 0.55, 0.8};
    }
    return {"Other", 0.5, 0.5, 0.5, 0.0};
}

Ring ringOf(const std::vector<Eigen::Vector2d>& points)
{
    Ring ring;
    for (const Eigen::Vector2d& p : points)
        ring.corners.push_back({p});
    return ring;
}

}  // namespace

Shapes::Shapes(Builder& builder) : m_builder(builder)
{
    m_model = builder.add("IfcGeometricRepresentationContext",
                          {{"ContextType", "Model"},
                           {"CoordinateSpaceDimension", 3},
                           {"Precision", 1e-5},
                           {"WorldCoordinateSystem", axes(Eigen::Vector3d::Zero(), Eigen::Vector2d::UnitX())}});
    const auto sub = [&](const char* identifier, std::string_view view)
    {
        return builder.add("IfcGeometricRepresentationSubContext", {{"ContextIdentifier", identifier},
                                                                    {"ContextType", "Model"},
                                                                    {"ParentContext", m_model},
                                                                    {"TargetView", Enumeration{view}}});
    };
    m_body = sub("Body", "MODEL_VIEW");
    m_axis = sub("Axis", "GRAPH_VIEW");
    m_footPrint = sub("FootPrint", "PLAN_VIEW");
}

Instance Shapes::point(const std::vector<double>& coordinates)
{
    return m_builder.add("IfcCartesianPoint", {{"Coordinates", coordinates}});
}

Instance Shapes::direction(const std::vector<double>& ratios)
{
    Instance& instance = m_directions[ratios];
    if (!instance)
        instance = m_builder.add("IfcDirection", {{"DirectionRatios", ratios}});
    return instance;
}

Instance Shapes::axes(const Eigen::Vector3d& origin, const Eigen::Vector2d& x)
{
    if (x == Eigen::Vector2d::UnitX())
    {
        Instance& instance = m_origins[{origin.x(), origin.y(), origin.z()}];
        if (!instance)
            instance =
                m_builder.add("IfcAxis2Placement3D", {{"Location", point({origin.x(), origin.y(), origin.z()})}});
        return instance;
    }
    return m_builder.add("IfcAxis2Placement3D", {{"Location", point({origin.x(), origin.y(), origin.z()})},
                                                 {"Axis", direction({0.0, 0.0, 1.0})},
                                                 {"RefDirection", direction({x.x(), x.y(), 0.0})}});
}

Instance Shapes::axes2(const Eigen::Vector2d& origin)
{
    return m_builder.add("IfcAxis2Placement2D", {{"Location", point({origin.x(), origin.y()})}});
}

Instance Shapes::placement(Instance relativeTo, const Eigen::Vector3d& origin, const Eigen::Vector2d& x)
{
    return m_builder.add("IfcLocalPlacement", {{"PlacementRelTo", relativeTo}, {"RelativePlacement", axes(origin, x)}});
}

Instance Shapes::extrude(Instance profile, Instance position, double depth)
{
    return m_builder.add("IfcExtrudedAreaSolid", {{"SweptArea", profile},
                                                  {"Position", position},
                                                  {"ExtrudedDirection", direction({0.0, 0.0, 1.0})},
                                                  {"Depth", depth}});
}

Instance Shapes::box(const Eigen::Vector3d& corner, const Eigen::Vector3d& size)
{
    const Instance rectangle =
        m_builder.add("IfcRectangleProfileDef", {{"ProfileType", Enumeration{"AREA"}},
                                                 {"Position", axes2(corner.head<2>() + 0.5 * size.head<2>())},
                                                 {"XDim", size.x()},
                                                 {"YDim", size.y()}});
    return extrude(rectangle, axes({0.0, 0.0, corner.z()}, Eigen::Vector2d::UnitX()), size.z());
}

Instance Shapes::cylinder(double radius, double height)
{
    const Instance circle = m_builder.add(
        "IfcCircleProfileDef",
        {{"ProfileType", Enumeration{"AREA"}}, {"Position", axes2(Eigen::Vector2d::Zero())}, {"Radius", radius}});
    return extrude(circle, axes(Eigen::Vector3d::Zero(), Eigen::Vector2d::UnitX()), height);
}

Instance Shapes::column(const Section& section, double height)
{
    if (const auto* circle = std::get_if<CircleSection>(&section))
        return cylinder(circle->radius_m, height);
    const Eigen::Vector2d box = boxOf(section);
    const auto* s = std::get_if<ProfileSection>(&section);
    if (s == nullptr)
        return this->box(Eigen::Vector3d::Zero(), {box.x(), box.y(), height});
    const Instance position = axes2(0.5 * box);
    const auto profile = [&](const char* entity, std::vector<Builder::Attribute> sizes)
    {
        sizes.insert(sizes.begin(), {{"ProfileType", Enumeration{"AREA"}}, {"Position", position}});
        return extrude(m_builder.add(entity, sizes), axes(Eigen::Vector3d::Zero(), Eigen::Vector2d::UnitX()), height);
    };
    switch (s->shape)
    {
        case ProfileShape::I:
            return profile("IfcIShapeProfileDef", {{"OverallWidth", s->width_m},
                                                   {"OverallDepth", s->depth_m},
                                                   {"WebThickness", s->web_m},
                                                   {"FlangeThickness", s->flange_m}});
        case ProfileShape::L:
            return profile("IfcLShapeProfileDef",
                           {{"Depth", s->depth_m}, {"Width", s->width_m}, {"Thickness", s->web_m}});
        case ProfileShape::U:
        case ProfileShape::T:
            break;
    }
    return profile(s->shape == ProfileShape::U ? "IfcUShapeProfileDef" : "IfcTShapeProfileDef",
                   {{"Depth", s->depth_m},
                    {"FlangeWidth", s->width_m},
                    {"WebThickness", s->web_m},
                    {"FlangeThickness", s->flange_m}});
}

Instance Shapes::curve(const Ring& ring)
{
    std::vector<std::vector<double>> points;
    TypedList segments;
    std::vector<int> run;  // of straight pieces
    const auto add = [&](const Eigen::Vector2d& p)
    {
        points.push_back({p.x(), p.y()});
        return static_cast<int>(points.size());
    };
    const auto endRun = [&]
    {
        if (run.size() > 1)
            segments.push_back({"IfcLineIndex", run});
        run.clear();
    };
    run.push_back(add(ring.corners.front().point));
    for (std::size_t i = 0; i < ring.corners.size(); ++i)
    {
        const bool isLast = i + 1 == ring.corners.size();
        const int from = run.back();
        if (ring.corners[i].isArc)
        {
            endRun();
            const int middle = add(ring.corners[i].middle);
            const int to = isLast ? 1 : add(ring.corners[i + 1].point);
            segments.push_back({"IfcArcIndex", std::vector<int>{from, middle, to}});
            run.push_back(to);
        }
        else
            run.push_back(isLast ? 1 : add(ring.corners[i + 1].point));
    }
    endRun();
    const Instance list = m_builder.add("IfcCartesianPointList2D", {{"CoordList", points}});
    return m_builder.add("IfcIndexedPolyCurve", {{"Points", list}, {"Segments", segments}, {"SelfIntersect", false}});
}

Instance Shapes::profile(Instance outer, const InstanceList& holes)
{
    if (holes.empty())
        return m_builder.add("IfcArbitraryClosedProfileDef",
                             {{"ProfileType", Enumeration{"AREA"}}, {"OuterCurve", outer}});
    return m_builder.add("IfcArbitraryProfileDefWithVoids",
                         {{"ProfileType", Enumeration{"AREA"}}, {"OuterCurve", outer}, {"InnerCurves", holes}});
}

Instance Shapes::prism(const Ring& ring, double bottom, double height)
{
    return extrude(profile(curve(ring), {}), axes({0.0, 0.0, bottom}, Eigen::Vector2d::UnitX()), height);
}

InstanceList Shapes::outlines(const Polygon& polygon)
{
    InstanceList curves = {curve(ringOf(polygon.outer))};
    for (const auto& hole : polygon.holes)
        curves.push_back(curve(ringOf(hole)));
    return curves;
}

Instance Shapes::prism(const Polygon& polygon, double bottom, double height)
{
    InstanceList curves = outlines(polygon);
    const Instance outer = curves.front();
    curves.erase(curves.begin());
    return extrude(profile(outer, curves), axes({0.0, 0.0, bottom}, Eigen::Vector2d::UnitX()), height);
}

Instance Shapes::plate(const std::vector<Eigen::Vector2d>& outer,
                       const std::vector<std::vector<Eigen::Vector2d>>& holes, double front, double depth)
{
    InstanceList inner;
    for (const auto& hole : holes)
        inner.push_back(curve(ringOf(hole)));
    // The profile's x is x and its y is z, so its normal looks along -y: extruded from the back to the front.
    const Instance position = m_builder.add("IfcAxis2Placement3D", {{"Location", point({0.0, front + depth, 0.0})},
                                                                    {"Axis", direction({0.0, -1.0, 0.0})},
                                                                    {"RefDirection", direction({1.0, 0.0, 0.0})}});
    return extrude(profile(curve(ringOf(outer)), inner), position, depth);
}

Instance Shapes::mesh(const std::vector<Eigen::Vector3d>& vertices, const std::vector<std::array<int, 3>>& triangles)
{
    std::vector<std::vector<double>> points;
    for (const Eigen::Vector3d& v : vertices)
        points.push_back({v.x(), v.y(), v.z()});
    std::vector<std::vector<int>> indices;
    for (const auto& t : triangles)
        indices.push_back({t[0] + 1, t[1] + 1, t[2] + 1});
    const Instance list = m_builder.add("IfcCartesianPointList3D", {{"CoordList", points}});
    return m_builder.add("IfcTriangulatedFaceSet", {{"Coordinates", list}, {"Closed", true}, {"CoordIndex", indices}});
}

Instance Shapes::line(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return m_builder.add("IfcPolyline", {{"Points", InstanceList{point({a.x(), a.y()}), point({b.x(), b.y()})}}});
}

Instance Shapes::arc(const Eigen::Vector2d& a, const Eigen::Vector2d& middle, const Eigen::Vector2d& b)
{
    const std::vector<std::vector<double>> points = {{a.x(), a.y()}, {middle.x(), middle.y()}, {b.x(), b.y()}};
    const Instance list = m_builder.add("IfcCartesianPointList2D", {{"CoordList", points}});
    return m_builder.add("IfcIndexedPolyCurve", {{"Points", list},
                                                 {"Segments", TypedList{{"IfcArcIndex", std::vector<int>{1, 2, 3}}}},
                                                 {"SelfIntersect", false}});
}

Instance Shapes::paint(Instance item, Style style)
{
    Instance& instance = m_styles[style];
    if (!instance)
    {
        const Colour colour = colourOf(style);
        const Instance rgb =
            m_builder.add("IfcColourRgb", {{"Red", colour.red}, {"Green", colour.green}, {"Blue", colour.blue}});
        // Rendering rather than its supertype Shading, whose transparency IfcOpenShell, for one, doesn't read.
        const Instance shading =
            m_builder.add("IfcSurfaceStyleRendering", {{"SurfaceColour", rgb},
                                                       {"Transparency", colour.transparency},
                                                       {"ReflectanceMethod", Enumeration{"NOTDEFINED"}}});
        instance =
            m_builder.add("IfcSurfaceStyle",
                          {{"Name", colour.name}, {"Side", Enumeration{"BOTH"}}, {"Styles", InstanceList{shading}}});
    }
    m_builder.add("IfcStyledItem", {{"Item", item}, {"Styles", InstanceList{instance}}});
    return item;
}

Instance Shapes::representation(Instance context, const char* identifier, const char* type, const InstanceList& items)
{
    return m_builder.add("IfcShapeRepresentation", {{"ContextOfItems", context},
                                                    {"RepresentationIdentifier", identifier},
                                                    {"RepresentationType", type},
                                                    {"Items", items}});
}

Instance Shapes::shape(const Representation& parts)
{
    InstanceList representations;
    if (!parts.footPrint.empty())
        representations.push_back(representation(m_footPrint, "FootPrint", "Curve2D", parts.footPrint));
    if (parts.axis)
        representations.push_back(representation(m_axis, "Axis", "Curve2D", {parts.axis}));
    representations.push_back(representation(m_body, "Body", parts.bodyType, parts.body));
    return m_builder.add("IfcProductDefinitionShape", {{"Representations", representations}});
}

}  // namespace s2b::ifc

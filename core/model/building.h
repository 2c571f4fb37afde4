// SPDX-License-Identifier: GPL-3.0-or-later
/// The reconstructed building: what the stages produce, and what the IFC writer, CloudCompare's tree and the metrics
/// read.
///
/// Conventions (docs/conventions.md): metres, radians, Z up. Elements are in the *building frame*: axes along the
/// dominant wall directions, z = 0 at the lowest storey's floor. Building::frame takes them to the world of the input.
#pragma once

#include "core/model/section.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace s2b
{

/// Where a value comes from. A default is always visible as an assumption: in the model, the IFC and the report.
enum class Provenance
{
    Measured,   ///< from points
    Assumed,    ///< a default or another element's value: no point says it
    Corrected,  ///< measured, then moved by topology (for example an end drawn to a junction), or set by a person
};

/// A length in metres with its provenance and residual.
struct Dimension
{
    double value_m = 0.0;
    Provenance provenance = Provenance::Assumed;
    double rms_m = 0.0;  ///< of the points that say it about it; 0 when assumed
};

/// Unique within a Building; stable for the same input, parameters and seed. 0 is "none".
struct ElementId
{
    std::uint32_t value = 0;
    auto operator<=>(const ElementId&) const = default;
};

/// What the points say of an element.
struct Evidence
{
    std::uint64_t points = 0;  ///< input points on its faces
    std::array<double, 2>
        faceCoverage{};       ///< [0, 1] share of the left and right face (seen from start to end) with points
    int facesSeen = 0;        ///< 0, 1 or 2
    double rms_m = 0.0;       ///< RMS distance of those points to the element's faces
    double labelShare = 0.0;  ///< [0, 1] share of those points whose label is the element's class; 0 without labels
};

/// The rigid transform between building frame and world: world = origin + Rz(yaw) * building.
struct Frame
{
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    double yaw_rad = 0.0;

    [[nodiscard]] Eigen::Vector3d toWorld(const Eigen::Vector3d& p) const
    {
        return origin + Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) * p;
    }
    [[nodiscard]] Eigen::Vector3d toBuilding(const Eigen::Vector3d& p) const
    {
        return Eigen::AngleAxisd(-yaw_rad, Eigen::Vector3d::UnitZ()) * (p - origin);
    }
};

/// Simple polygon with holes in plan. Outer ring counter-clockwise, holes clockwise, first point not repeated.
struct Polygon
{
    std::vector<Eigen::Vector2d> outer;
    std::vector<std::vector<Eigen::Vector2d>> holes;
};

struct Storey
{
    ElementId id;
    std::string name;          ///< "Level 0" ...
    double elevation_m = 0.0;  ///< top of the finished floor, building frame
    Dimension height;          ///< floor to ceiling
};

/// A wall: a vertical plate about an axis (straight line, or circular arc) in plan.
///
/// The axis is the centre line; axes of joined walls meet exactly in one point. The body reaches from bodyStart_m to
/// bodyEnd_m along the axis (0 and the axis' length when it ends where the axis does), so that bodies at a junction
/// touch without overlapping. Left is the side of the axis' normal, the direction turned by +90 degrees.
struct Wall
{
    ElementId id;
    ElementId storey;
    Eigen::Vector2d start = Eigen::Vector2d::Zero();
    Eigen::Vector2d end = Eigen::Vector2d::Zero();
    double bulge =
        0.0;  ///< 0: straight. Else tan(sweep / 4) of the arc from start to end, > 0 counter-clockwise (as DXF)
    double bodyStart_m = 0.0;
    double bodyEnd_m = 0.0;
    double base_m = 0.0;  ///< z of the lower edge
    Dimension height;
    Dimension thickness;
    std::vector<Eigen::Vector2d>
        topProfile;  ///< empty: level top. Else (s along the axis, z) of the top edge, s ascending (gables)
    bool isExternal = false;
    bool isExternalKnown = false;  ///< false: neither side says it, and nothing is claimed
    Evidence evidence;

    /// Arc length, or the distance of the ends [m].
    [[nodiscard]] double axisLength_m() const;
    /// Unit direction at the start (of the chord for a straight wall).
    [[nodiscard]] Eigen::Vector2d direction() const;
    /// Unit normal to the left of direction().
    [[nodiscard]] Eigen::Vector2d normal() const;
    /// Outline of the body in plan, counter-clockwise; an arc is sampled to 1 mm sagitta.
    [[nodiscard]] std::vector<Eigen::Vector2d> outline() const;
};

enum class OpeningKind
{
    Door,
    Window,
    Plain  ///< nothing in it
};

enum class LeafState
{
    Unknown,
    Closed,
    Open,
    Removed
};

/// A rectangular hole through its host wall, with or without a door or window in it.
struct Opening
{
    ElementId id;
    ElementId host;  ///< Wall
    OpeningKind kind = OpeningKind::Plain;
    double offset_m = 0.0;  ///< of its lower-left corner along the host's axis from the axis' start (arc length)
    Dimension width;
    Dimension height;
    Dimension sill;  ///< above the host's base
    int leaves = 0;  ///< door leaves; 0 unknown
    LeafState leafState = LeafState::Unknown;
    bool hingeAtStart = false;  ///< of a single leaf, only when leafState is Open
    bool opensToLeft = false;   ///< the leaf stands on the wall's left side, only when leafState is Open
    Evidence evidence;
};

struct Column
{
    ElementId id;
    ElementId storey;
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double yaw_rad = 0.0;  ///< of its x axis in the building frame
    double base_m = 0.0;
    Dimension height;
    Section section;
    Provenance sectionProvenance = Provenance::Measured;
    Evidence evidence;

    /// Outline of the section in plan, counter-clockwise; a circle is sampled to 1 mm sagitta.
    [[nodiscard]] std::vector<Eigen::Vector2d> outline() const;
};

enum class SlabKind
{
    Floor,
    Roof
};

struct Slab
{
    ElementId id;
    ElementId storey;
    SlabKind kind = SlabKind::Floor;
    Polygon outline;
    double top_m = 0.0;
    Dimension thickness;
    Evidence evidence;
};

struct Space
{
    ElementId id;
    ElementId storey;
    std::string name;
    Polygon outline;
    double floor_m = 0.0;
    Dimension height;
    double area_m2 = 0.0;
    std::vector<ElementId> boundedBy;  ///< walls
};

enum class JunctionEnd
{
    Start,
    End,
    Path
};

/// Two walls that meet: where on each (IfcRelConnectsPathElements).
struct Junction
{
    ElementId wallA;
    ElementId wallB;
    JunctionEnd endA = JunctionEnd::End;
    JunctionEnd endB = JunctionEnd::Start;
};

enum class Severity
{
    Info,
    Warning,
    Error
};

/// Something that could not be reconstructed, or only with an assumption: where and why.
struct Diagnostic
{
    Severity severity = Severity::Info;
    std::string stage;                                   ///< "levels", "walls" ...
    std::string code;                                    ///< "ThicknessAssumed" ...; stable, documented
    std::string text;                                    ///< one sentence for people
    ElementId element;                                   ///< 0 when there is none
    Eigen::Vector3d location = Eigen::Vector3d::Zero();  ///< building frame
};

struct Building
{
    Frame frame;
    std::vector<Storey> storeys;  ///< ascending elevation
    std::vector<Wall> walls;
    std::vector<Opening> openings;
    std::vector<Column> columns;
    std::vector<Slab> slabs;
    std::vector<Space> spaces;
    std::vector<Junction> junctions;
    std::vector<Diagnostic> diagnostics;

    [[nodiscard]] const Storey* storey(ElementId id) const;
    [[nodiscard]] const Wall* wall(ElementId id) const;
};

}  // namespace s2b

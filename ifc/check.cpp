// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc/check.h"

#include "core/base/error.h"
#include "ifc/wall_geometry.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

namespace s2b::ifc
{
namespace
{

constexpr double kSmallest_m = 1e-4;  // below this no viewer's geometry kernel makes a solid
constexpr double kLargest_m = 1e5;    // of a building's coordinates in its own frame

[[noreturn]] void fail(const std::string& what)
{
    throw Error(ErrorCode::Internal, "the model can't be written: " + what);
}

std::string label(const char* kind, ElementId id)
{
    return std::string(kind) + " " + std::to_string(id.value);
}

void checkFinite(double value, const std::string& element, const char* what)
{
    if (!std::isfinite(value) || std::abs(value) > kLargest_m)
        fail(element + " has no usable " + what);
}

void checkSize(double value, const std::string& element, const char* what)
{
    if (!(value >= kSmallest_m && value <= kLargest_m))
        fail(element + " has no " + what + " (" + std::to_string(value) + " m)");
}

void checkPoint(const Eigen::Vector2d& p, const std::string& element, const char* what)
{
    checkFinite(p.x(), element, what);
    checkFinite(p.y(), element, what);
}

void checkEvidence(const Evidence& evidence, const std::string& element)
{
    for (const double share : {evidence.faceCoverage[0], evidence.faceCoverage[1], evidence.labelShare})
        if (!(share >= 0.0 && share <= 1.0))
            fail(element + " has a share outside [0, 1] in its evidence");
    if (!(evidence.rms_m >= 0.0 && evidence.rms_m <= kLargest_m))
        fail(element + " has no usable RMS distance");
}

void checkDimension(const Dimension& dimension, const std::string& element, const char* what)
{
    checkSize(dimension.value_m, element, what);
    if (!(dimension.rms_m >= 0.0 && dimension.rms_m <= kLargest_m))
        fail(element + " has no usable RMS of its " + what);
}

double signedArea(const std::vector<Eigen::Vector2d>& ring)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const Eigen::Vector2d a = ring[i] - ring[0];
        const Eigen::Vector2d b = ring[(i + 1) % ring.size()] - ring[0];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
}

void checkRing(const std::vector<Eigen::Vector2d>& ring, const std::string& element)
{
    if (ring.size() < 3)
        fail(element + " has an outline of fewer than three points");
    for (const Eigen::Vector2d& p : ring)
        checkPoint(p, element, "outline");
    if (std::abs(signedArea(ring)) < kSmallest_m * kSmallest_m)
        fail(element + " has an outline without an area");
}

void checkPolygon(const Polygon& polygon, const std::string& element)
{
    checkRing(polygon.outer, element);
    double left = std::abs(signedArea(polygon.outer));
    for (const auto& hole : polygon.holes)
    {
        checkRing(hole, element);
        left -= std::abs(signedArea(hole));
    }
    if (left <= 0.0)
        fail(element + " has holes larger than its outline");
}

/// RFC 3629: no overlong forms, no surrogates, nothing past U+10FFFF.
bool isUtf8(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    for (std::size_t i = 0; i < text.size();)
    {
        const unsigned first = byte(i);
        const std::size_t length = first < 0x80U   ? 1
                                   : first < 0xC2U ? 0
                                   : first < 0xE0U ? 2
                                   : first < 0xF0U ? 3
                                   : first < 0xF5U ? 4
                                                   : 0;
        if (length == 0)
            return false;
        for (std::size_t k = 1; k < length; ++k)
            if ((byte(i + k) & 0xC0U) != 0x80U)
                return false;
        const unsigned second = byte(i + 1);
        if ((first == 0xE0U && second < 0xA0U) || (first == 0xEDU && second >= 0xA0U) ||
            (first == 0xF0U && second < 0x90U) || (first == 0xF4U && second >= 0x90U))
            return false;
        i += length;
    }
    return true;
}

void checkText(const std::string& text, const std::string& element)
{
    if (!isUtf8(text))
        fail(element + " has a name that is not UTF-8");
}

void checkWall(const Wall& wall)
{
    const std::string name = label("wall", wall.id);
    checkPoint(wall.start, name, "start");
    checkPoint(wall.end, name, "end");
    checkSize((wall.end - wall.start).norm(), name, "length");
    checkFinite(wall.bulge, name, "bulge");
    checkFinite(wall.base_m, name, "base");
    checkFinite(wall.bodyStart_m, name, "start of its body");
    checkFinite(wall.bodyEnd_m, name, "end of its body");
    checkSize(wall.bodyEnd_m - wall.bodyStart_m, name, "length of its body");
    checkDimension(wall.height, name, "height");
    checkDimension(wall.thickness, name, "thickness");
    checkEvidence(wall.evidence, name);
    double last = -kLargest_m;
    for (const Eigen::Vector2d& p : wall.topProfile)
    {
        checkPoint(p, name, "top");
        if (p.x() < last)
            fail(name + " has a top profile that does not ascend along the axis");
        last = p.x();
    }
    const WallGeometry geometry(wall);
    if (!(geometry.lowestTop_m() - wall.base_m >= -kSmallest_m && geometry.highestTop_m() - wall.base_m >= kSmallest_m))
        fail(name + " has a top below its base");
    if (geometry.isArc() && !(geometry.radius_m() > 0.5 * wall.thickness.value_m + kSmallest_m))
        fail(name + " is thicker than its radius allows");
    if (geometry.isArc() && !(geometry.bodySweep_rad() < 2.0 * M_PI))
        fail(name + " is bent to more than a full circle");
}

void checkOpening(const Opening& opening)
{
    const std::string name = label("opening", opening.id);
    checkFinite(opening.offset_m, name, "offset");
    checkFinite(opening.sill.value_m, name, "sill");
    checkDimension(opening.width, name, "width");
    checkDimension(opening.height, name, "height");
    checkEvidence(opening.evidence, name);
}

void checkColumn(const Column& column)
{
    const std::string name = label("column", column.id);
    checkPoint(column.center, name, "centre");
    checkFinite(column.yaw_rad, name, "rotation");
    checkFinite(column.base_m, name, "base");
    checkDimension(column.height, name, "height");
    if (const auto* circle = std::get_if<CircleSection>(&column.section))
        checkSize(circle->radius_m, name, "radius");
    else
    {
        const Eigen::Vector2d box = boxOf(column.section);
        checkSize(box.x(), name, "width");
        checkSize(box.y(), name, "depth");
    }
    if (const std::string fault = faultOf(column.section, kSmallest_m); !fault.empty())
        fail(name + " has " + fault);
    checkEvidence(column.evidence, name);
}

/// Ids that may be referred to.
class Ids
{
public:
    void add(ElementId id, const char* kind)
    {
        if (id.value == 0)
            fail(std::string("a ") + kind + " has no id");
        if (!m_all.insert(id).second)
            fail(label(kind, id) + " has the id of another element");
    }
    [[nodiscard]] bool has(ElementId id) const { return m_all.contains(id); }

private:
    std::set<ElementId> m_all;
};

}  // namespace

void checkWritable(const Building& building, const WriteOptions& options)
{
    for (const std::string* text : {&options.projectName, &options.timestamp})
        if (!isUtf8(*text))
            throw Error(ErrorCode::BadParameter, "the project name or time stamp is not UTF-8 text; give another");
    for (const auto& [name, value] : options.parameters)
        if (name.empty() || !isUtf8(name) || !isUtf8(value))
            throw Error(ErrorCode::BadParameter,
                        "parameter \"" + name + "\" can't be recorded in the IFC: it is not UTF-8 text");
    if (options.epsg && *options.epsg <= 0)
        throw Error(ErrorCode::BadParameter,
                    "EPSG code " + std::to_string(*options.epsg) + " is not a positive number");

    if (!building.frame.origin.allFinite() || !std::isfinite(building.frame.yaw_rad))
        fail("the building's frame is not finite");
    Ids storeys;
    Ids walls;
    Ids all;
    for (const Storey& storey : building.storeys)
    {
        all.add(storey.id, "storey");
        storeys.add(storey.id, "storey");
        checkFinite(storey.elevation_m, label("storey", storey.id), "elevation");
        checkFinite(storey.height.value_m, label("storey", storey.id), "height");
        checkText(storey.name, label("storey", storey.id));
    }
    const auto checkStorey = [&](ElementId storey, const std::string& element)
    {
        if (!storeys.has(storey))
            fail(element + " is on storey " + std::to_string(storey.value) + ", which does not exist");
    };
    for (const Wall& wall : building.walls)
    {
        all.add(wall.id, "wall");
        walls.add(wall.id, "wall");
        checkStorey(wall.storey, label("wall", wall.id));
        checkWall(wall);
    }
    for (const Opening& opening : building.openings)
    {
        all.add(opening.id, "opening");
        if (!walls.has(opening.host))
            fail(label("opening", opening.id) + " is in wall " + std::to_string(opening.host.value) +
                 ", which does not exist");
        checkOpening(opening);
    }
    for (const Column& column : building.columns)
    {
        all.add(column.id, "column");
        checkStorey(column.storey, label("column", column.id));
        checkColumn(column);
    }
    for (const Slab& slab : building.slabs)
    {
        const std::string name = label("slab", slab.id);
        all.add(slab.id, "slab");
        checkStorey(slab.storey, name);
        checkPolygon(slab.outline, name);
        checkFinite(slab.top_m, name, "top");
        checkDimension(slab.thickness, name, "thickness");
        checkEvidence(slab.evidence, name);
    }
    for (const Space& space : building.spaces)
    {
        const std::string name = label("space", space.id);
        all.add(space.id, "space");
        checkStorey(space.storey, name);
        checkPolygon(space.outline, name);
        checkFinite(space.floor_m, name, "floor");
        checkDimension(space.height, name, "height");
        checkText(space.name, name);
        for (const ElementId wall : space.boundedBy)
            if (!walls.has(wall))
                fail(name + " is bounded by wall " + std::to_string(wall.value) + ", which does not exist");
    }
    for (const Junction& junction : building.junctions)
        if (!walls.has(junction.wallA) || !walls.has(junction.wallB) || junction.wallA == junction.wallB)
            fail("a junction joins walls " + std::to_string(junction.wallA.value) + " and " +
                 std::to_string(junction.wallB.value) + ", which are not two existing walls");
    for (const Diagnostic& diagnostic : building.diagnostics)
        checkText(diagnostic.text, "a diagnostic");
}

}  // namespace s2b::ifc

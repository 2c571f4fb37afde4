// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/building_json.h"

#include "core/model/wall_axis.h"

#include <nlohmann/json.hpp>

namespace s2b
{

std::string buildingJson(const Building& building)
{
    using nlohmann::json;
    const auto world = [&](const Eigen::Vector2d& p)
    {
        const Eigen::Vector3d w = building.frame.toWorld({p.x(), p.y(), 0.0});
        return json{w.x(), w.y()};
    };
    const auto ring = [&](const std::vector<Eigen::Vector2d>& points)
    {
        json r = json::array();
        for (const Eigen::Vector2d& p : points)
            r.push_back(world(p));
        return r;
    };
    json out;
    out["yaw_rad"] = building.frame.yaw_rad;
    for (const Storey& s : building.storeys)
        out["storeys"].push_back({{"id", s.id.value},
                                  {"name", s.name},
                                  {"floor", s.elevation_m + building.frame.origin.z()},
                                  {"height", s.height.value_m}});
    for (const Wall& w : building.walls)
        out["walls"].push_back({{"id", w.id.value},
                                {"storey", w.storey.value},
                                {"outline", ring(w.outline())},
                                {"axis", {world(w.start), world(w.end)}},
                                {"bulge", w.bulge},
                                {"thickness", w.thickness.value_m},
                                {"base", w.base_m},
                                {"height", w.height.value_m},
                                {"facesSeen", w.evidence.facesSeen}});
    for (const Opening& o : building.openings)
    {
        const Wall* w = building.wall(o.host);
        const WallAxis axis(*w);
        const double from = o.offset_m, to = from + o.width.value_m, half = w->thickness.value_m / 2;
        out["openings"].push_back(
            {{"id", o.id.value},
             {"storey", w->storey.value},
             {"kind", static_cast<int>(o.kind)},
             {"outline", ring({axis.at(from, -half), axis.at(to, -half), axis.at(to, half), axis.at(from, half)})},
             {"sill", o.sill.value_m},
             {"height", o.height.value_m}});
    }
    for (const Column& c : building.columns)
        out["columns"].push_back({{"id", c.id.value},
                                  {"storey", c.storey.value},
                                  {"center", world(c.center)},
                                  {"yaw", c.yaw_rad + building.frame.yaw_rad},
                                  {"round", std::holds_alternative<CircleSection>(c.section)}});
    const auto polygon = [&](const Polygon& p)
    {
        json rings = json::array({ring(p.outer)});
        for (const auto& hole : p.holes)
            rings.push_back(ring(hole));
        return rings;
    };
    for (const Slab& s : building.slabs)
        out["slabs"].push_back({{"id", s.id.value},
                                {"storey", s.storey.value},
                                {"kind", static_cast<int>(s.kind)},
                                {"rings", polygon(s.outline)},
                                {"top", s.top_m},
                                {"thickness", s.thickness.value_m},
                                {"measured", s.thickness.provenance == Provenance::Measured},
                                {"points", s.evidence.points},
                                {"coverage", s.evidence.faceCoverage},
                                {"rms", s.evidence.rms_m}});
    for (const Space& s : building.spaces)
    {
        json walls = json::array();
        for (const ElementId w : s.boundedBy)
            walls.push_back(w.value);
        out["spaces"].push_back({{"id", s.id.value},
                                 {"storey", s.storey.value},
                                 {"name", s.name},
                                 {"rings", polygon(s.outline)},
                                 {"area", s.area_m2},
                                 {"floor", s.floor_m},
                                 {"height", s.height.value_m},
                                 {"measured", s.height.provenance == Provenance::Measured},
                                 {"boundedBy", walls}});
    }
    for (const Diagnostic& d : building.diagnostics)
        out["diagnostics"].push_back(
            {{"stage", d.stage}, {"code", d.code}, {"text", d.text}, {"element", d.element.value}});
    return out.dump(1);
}

}  // namespace s2b

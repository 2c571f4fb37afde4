// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/building_json.h"

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
        out["storeys"].push_back({{"id", s.id.value}, {"name", s.name}, {"floor", s.elevation_m + building.frame.origin.z()}, {"height", s.height.value_m}});
    for (const Wall& w : building.walls)
        out["walls"].push_back({{"id", w.id.value}, {"storey", w.storey.value}, {"outline", ring(w.outline())}, {"axis", {world(w.start), world(w.end)}},
                                {"thickness", w.thickness.value_m}, {"base", w.base_m}, {"height", w.height.value_m}, {"facesSeen", w.evidence.facesSeen}});
    for (const Opening& o : building.openings)
    {
        const Wall* w = building.wall(o.host);
        const Eigen::Vector2d a = w->start + w->direction() * o.offset_m, b = a + w->direction() * o.width.value_m,
                              n = w->normal() * (w->thickness.value_m / 2);
        out["openings"].push_back({{"id", o.id.value}, {"storey", w->storey.value}, {"kind", static_cast<int>(o.kind)}, {"outline", ring({a - n, b - n, b + n, a + n})},
                                   {"sill", o.sill.value_m}, {"height", o.height.value_m}});
    }
    for (const Column& c : building.columns)
        out["columns"].push_back({{"id", c.id.value}, {"storey", c.storey.value}, {"center", world(c.center)}, {"yaw", c.yaw_rad + building.frame.yaw_rad},
                                  {"round", std::holds_alternative<CircleSection>(c.section)}});
    for (const Diagnostic& d : building.diagnostics)
        out["diagnostics"].push_back({{"stage", d.stage}, {"code", d.code}, {"text", d.text}, {"element", d.element.value}});
    return out.dump(1);
}

}  // namespace s2b

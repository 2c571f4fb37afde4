// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/truth_json.h"

#include "tests/simulator/axis_curve.h"
#include "tests/simulator/output_file.h"
#include "tests/simulator/plan_box.h"
#include "tests/simulator/seen_surface.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>

namespace s2b::sim
{

namespace
{

using Json = nlohmann::ordered_json;

double rounded(double value)
{
    return std::round(value * 1e4) / 1e4;
}

/// Everything about one element in plan, local frame of the scene.
struct Shape
{
    PlanBox box;
    double low = 0.0;
    double high = 0.0;
};

class TruthWriter
{
public:
    TruthWriter(const Scene& scene, const Survey& survey, const std::vector<Station>& stations,
                const SimulatedBuilding* simulated)
        : m_scene(scene),
          m_survey(survey),
          m_stations(stations),
          m_building(simulated != nullptr ? &simulated->truth : nullptr),
          m_seen(scene, survey),
          m_yaw(m_building != nullptr ? m_building->frame.yaw_rad : 0.0)
    {
        for (std::uint32_t i = 0; i < scene.elements.size(); ++i)
            m_indexOfGuid[scene.elements[i].guid] = i;
    }

    [[nodiscard]] Json write() const
    {
        Json result;
        result["source"] = "s2b_survey";
        result["note"] = "metres, world coordinates of the survey";
        result["labels"] = {{"0", "unassigned"}, {"1", "floor"}, {"2", "ceiling"},   {"3", "wall"},
                            {"4", "column"},     {"5", "door"},  {"6", "window"},    {"7", "beam"},
                            {"8", "stair"},      {"9", "roof"},  {"10", "furniture"}};
        result["points"] = m_survey.size();
        Json stations = Json::array();
        for (const Station& s : m_stations)
            stations.push_back({world(s.position, 0), world(s.position, 1), world(s.position, 2), s.storey});
        result["stations"] = stations;
        result["storeys"] = storeys();
        result["spaces"] = spaces();
        Json elements = Json::array();
        Json furniture = Json::array();
        for (std::uint32_t i = 0; i < m_scene.elements.size(); ++i)
        {
            if (!m_scene.elements[i].isProp)
                elements.push_back(element(i));
            else if (m_scene.elements[i].storey >= 0)
                furniture.push_back({{"kind", m_scene.elements[i].type},
                                     {"storey_index", m_scene.elements[i].storey},
                                     {"obb", obb(shapeOfMesh(i))}});
        }
        result["elements"] = elements;
        result["furniture"] = furniture;
        return result;
    }

private:
    [[nodiscard]] double world(const Eigen::Vector3d& local, int axis) const
    {
        return rounded(m_scene.origin[axis] + local[axis]);
    }
    [[nodiscard]] Json world(const Eigen::Vector2d& local) const
    {
        return {rounded(m_scene.origin.x() + local.x()), rounded(m_scene.origin.y() + local.y())};
    }
    [[nodiscard]] Eigen::Vector2d turned(const Eigen::Vector2d& p) const
    {
        return {std::cos(m_yaw) * p.x() - std::sin(m_yaw) * p.y(), std::sin(m_yaw) * p.x() + std::cos(m_yaw) * p.y()};
    }
    [[nodiscard]] Json ring(const std::vector<Eigen::Vector2d>& building) const
    {
        Json result = Json::array();
        for (const Eigen::Vector2d& p : building)
            result.push_back(world(turned(p)));
        return result;
    }
    [[nodiscard]] Json obb(const Shape& s) const
    {
        return {{"center",
                 {rounded(m_scene.origin.x() + s.box.center.x()), rounded(m_scene.origin.y() + s.box.center.y()),
                  rounded(m_scene.origin.z() + (s.low + s.high) / 2.0)}},
                {"half", {rounded(s.box.half.x()), rounded(s.box.half.y()), rounded((s.high - s.low) / 2.0)}},
                {"yaw", s.box.yaw_rad}};
    }

    [[nodiscard]] Shape shapeOfMesh(std::uint32_t index, const double* yaw = nullptr) const
    {
        Shape s;
        s.low = 1e300;
        s.high = -1e300;
        std::vector<Eigen::Vector2d> plan;
        for (const std::uint32_t t : m_seen.triangles(index))
            for (const std::uint32_t v : m_scene.triangles[t])
            {
                plan.push_back(m_scene.vertices[v].head<2>());
                s.low = std::min(s.low, m_scene.vertices[v].z());
                s.high = std::max(s.high, m_scene.vertices[v].z());
            }
        s.box = yaw != nullptr ? boxAlong(plan, *yaw) : smallestBox(plan);
        return s;
    }

    [[nodiscard]] Json storeys() const
    {
        Json result = Json::array();
        for (std::size_t k = 0; k < m_scene.storeys.size(); ++k)
        {
            // Floor and ceiling as the storey's stations saw them.
            const SceneStorey& storey = m_scene.storeys[k];
            std::vector<float> floors;
            std::vector<float> ceilings;
            for (std::size_t i = 0; i < m_survey.size(); ++i)
            {
                if (m_survey.triangles[i] == Survey::kNoTriangle ||
                    m_stations[m_survey.stations[i]].storey != static_cast<int>(k))
                    continue;
                const Label label = m_scene.surfaces[m_survey.triangles[i]].label;
                const float z = m_survey.points[i].z();
                if (label == Label::Floor && std::abs(static_cast<double>(z) - storey.elevation_m) < 0.8)
                    floors.push_back(z);
                else if (label == Label::Ceiling && static_cast<double>(z) > storey.elevation_m + 1.8)
                    ceilings.push_back(z);
            }
            const auto median = [&](std::vector<float>& values) -> Json
            {
                if (values.empty())
                    return nullptr;
                const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
                std::nth_element(values.begin(), middle, values.end());
                return rounded(m_scene.origin.z() + static_cast<double>(*middle));
            };
            const auto count = std::count_if(m_stations.begin(), m_stations.end(),
                                             [&](const Station& s) { return s.storey == static_cast<int>(k); });
            result.push_back({{"index", k},
                              {"GlobalId", storey.guid},
                              {"name", storey.name},
                              {"elevation", rounded(m_scene.origin.z() + storey.elevation_m)},
                              {"scanned", count > 0},
                              {"stations", count},
                              {"floor_z", median(floors)},
                              {"ceiling_z", median(ceilings)}});
        }
        return result;
    }

    [[nodiscard]] Json spaces() const
    {
        Json result = Json::array();
        if (m_building == nullptr)
            return result;
        for (const Space& space : m_building->spaces)
            result.push_back({{"GlobalId", "space-" + std::to_string(space.id.value)},
                              {"name", space.name},
                              {"storey", "storey-" + std::to_string(space.storey.value)},
                              {"z_min", rounded(m_scene.origin.z() + space.floor_m)},
                              {"z_max", rounded(m_scene.origin.z() + space.floor_m + space.height.value_m)},
                              {"area", rounded(space.area_m2)},
                              {"polygon", ring(space.outline.outer)}});
        return result;
    }

    [[nodiscard]] Json element(std::uint32_t index) const
    {
        const SceneElement& e = m_scene.elements[index];
        Json d;
        d["GlobalId"] = e.guid;
        d["type"] = e.type;
        d["name"] = e.name;
        d["elem"] = index;
        d["storey"] = e.storey >= 0 ? Json(m_scene.storeys[static_cast<std::size_t>(e.storey)].guid) : Json(nullptr);
        d["storey_index"] = e.storey;
        d["points"] = m_seen.points(index).size();

        const bool isWall = e.type.starts_with("IfcWall");
        const bool isFilling = e.type.starts_with("IfcDoor") || e.type.starts_with("IfcWindow");
        const Wall* wall = isWall && m_building != nullptr ? m_building->wall(e.id) : nullptr;
        Shape shape = wall != nullptr ? shapeOfWall(*wall) : isFilling ? shapeOfFilling(index) : shapeOfMesh(index);
        const SeenSurface::Share seen =
            m_seen.share(index, {-std::sin(shape.box.yaw_rad), std::cos(shape.box.yaw_rad)});
        d["area"] = rounded(seen.area_m2);
        d["visible_fraction"] = rounded(seen.all);
        d["z_min"] = rounded(m_scene.origin.z() + shape.low);
        d["z_max"] = rounded(m_scene.origin.z() + shape.high);
        d["obb"] = obb(shape);
        if (isWall)
            describeWall(d, shape, wall, seen);
        else if (isFilling)
            describeFilling(d, e, shape);
        else if (e.type.starts_with("IfcColumn"))
            describeColumn(d, e);
        else if (e.type.starts_with("IfcSlab") && m_building != nullptr)
            for (const Slab& slab : m_building->slabs)
                if (slab.id == e.id)
                    d["footprint"] = Json::array({ring(slab.outline.outer)});
        return d;
    }

    [[nodiscard]] Shape shapeOfWall(const Wall& wall) const
    {
        std::vector<Eigen::Vector2d> outline;
        for (const Eigen::Vector2d& p : wall.outline())
            outline.push_back(turned(p));
        const Eigen::Vector2d chord = turned(wall.end - wall.start);
        Shape s;
        const double yaw = std::atan2(chord.y(), chord.x());
        s.box = boxAlong(outline, yaw < 0.0 ? yaw + std::numbers::pi : yaw);
        s.low = wall.base_m;
        s.high = wall.base_m + wall.height.value_m;
        for (const Eigen::Vector2d& p : wall.topProfile)
            s.high = std::max(s.high, p.y());
        return s;
    }

    /// Along the host wall's direction where there is one.
    [[nodiscard]] Shape shapeOfFilling(std::uint32_t index) const
    {
        const SceneElement& e = m_scene.elements[index];
        const auto host = m_indexOfGuid.find(e.host);
        if (host == m_indexOfGuid.end())
            return shapeOfMesh(index);
        double yaw = 0.0;
        const Wall* wall = m_building != nullptr ? m_building->wall(m_scene.elements[host->second].id) : nullptr;
        if (wall == nullptr)
            yaw = shapeOfMesh(host->second).box.yaw_rad;
        else
        {
            const Opening& opening = openingOf(e.id);
            const Eigen::Vector2d d =
                turned(AxisCurve(*wall).direction(opening.offset_m + opening.width.value_m / 2.0));
            yaw = std::atan2(d.y(), d.x());
        }
        return shapeOfMesh(index, &yaw);
    }

    [[nodiscard]] const Opening& openingOf(ElementId id) const
    {
        return *std::find_if(m_building->openings.begin(), m_building->openings.end(),
                             [&](const Opening& o) { return o.id == id; });
    }

    void describeWall(Json& d, const Shape& shape, const Wall* wall, const SeenSurface::Share& seen) const
    {
        const Eigen::Vector2d u(std::cos(shape.box.yaw_rad), std::sin(shape.box.yaw_rad));
        d["axis"] = {world(Eigen::Vector2d(shape.box.center - u * shape.box.half.x())),
                     world(Eigen::Vector2d(shape.box.center + u * shape.box.half.x()))};
        d["thickness"] = rounded(wall != nullptr ? wall->thickness.value_m : 2.0 * shape.box.half.y());
        d["length"] = rounded(2.0 * shape.box.half.x());
        d["height"] = rounded(shape.high - shape.low);
        d["curved"] = wall != nullptr && wall->bulge != 0.0;
        if (wall != nullptr)
        {
            d["ifc_axis"] = {world(turned(wall->start)), world(turned(wall->end))};
            d["bulge"] = wall->bulge;
            d["footprint"] = Json::array({ring(wall->outline())});
        }
        d["visible_side_pos"] = seen.left < 0.0 ? Json(nullptr) : Json(rounded(seen.left));
        d["visible_side_neg"] = seen.right < 0.0 ? Json(nullptr) : Json(rounded(seen.right));
    }

    void describeFilling(Json& d, const SceneElement& e, const Shape& shape) const
    {
        Shape hole = shape;
        if (m_building != nullptr)
        {
            const Opening& o = openingOf(e.id);
            const Wall& host = *m_building->wall(o.host);
            hole.box = {turned(AxisCurve(host).at(o.offset_m + o.width.value_m / 2.0)),
                        {o.width.value_m / 2.0, host.thickness.value_m / 2.0},
                        shape.box.yaw_rad};
            hole.low = host.base_m + o.sill.value_m;
            hole.high = hole.low + o.height.value_m;
            d["sill"] = rounded(o.sill.value_m);
            if (o.kind == OpeningKind::Door)
            {
                d["state"] = o.leafState == LeafState::Open      ? "open"
                             : o.leafState == LeafState::Removed ? "removed"
                                                                 : "closed";
                d["leaves"] = o.leaves;
            }
        }
        d["opening"] = obb(hole);
        d["host"] = e.host.empty() ? Json(nullptr) : Json(e.host);
        d["width"] = rounded(2.0 * hole.box.half.x());
        d["height"] = rounded(hole.high - hole.low);
        const auto host = m_indexOfGuid.find(e.host);
        if (host == m_indexOfGuid.end())
            return;
        constexpr double kNear_m = 0.4;
        const Eigen::Vector2d u(std::cos(hole.box.yaw_rad), std::sin(hole.box.yaw_rad));
        const auto near = [&](std::uint32_t i)
        {
            const Eigen::Vector3d p = m_survey.points[i].cast<double>();
            const Eigen::Vector2d q = p.head<2>() - hole.box.center;
            return std::abs(q.dot(u)) < hole.box.half.x() + kNear_m && p.z() > hole.low - kNear_m &&
                   p.z() < hole.high + kNear_m && q.norm() < hole.box.half.x() + 1.5;
        };
        const auto& points = m_seen.points(host->second);
        d["host_points_near"] = std::count_if(points.begin(), points.end(), near);
    }

    void describeColumn(Json& d, const SceneElement& e) const
    {
        if (m_building == nullptr)
            return;
        for (const Column& column : m_building->columns)
        {
            if (column.id != e.id)
                continue;
            const auto* circle = std::get_if<CircleSection>(&column.section);
            const auto* profile = std::get_if<ProfileSection>(&column.section);
            d["section"] = circle != nullptr ? "round" : profile != nullptr ? shapeName(profile->shape) : "rect";
            if (circle == nullptr && profile == nullptr)
                continue;
            std::vector<Eigen::Vector2d> outline = column.outline();
            if (profile != nullptr)
            {
                d["web"] = rounded(profile->web_m);
                d["flange"] = rounded(profile->flange_m);
            }
            else
            {
                outline.clear();
                for (int i = 0; i < 96; ++i)
                    outline.push_back(column.center +
                                      circle->radius_m * Eigen::Vector2d(std::cos(i * std::numbers::pi / 48.0),
                                                                         std::sin(i * std::numbers::pi / 48.0)));
            }
            d["footprint"] = Json::array({ring(outline)});
        }
    }

    const Scene& m_scene;
    const Survey& m_survey;
    const std::vector<Station>& m_stations;
    const Building* m_building;
    SeenSurface m_seen;
    double m_yaw;
    std::map<std::string, std::uint32_t> m_indexOfGuid;
};

}  // namespace

void writeTruth(const Scene& scene, const Survey& survey, const std::vector<Station>& stations,
                const SimulatedBuilding* building, const std::string& path)
{
    OutputFile file(path);
    std::ofstream out(file.temporary(), std::ios::binary);
    out << TruthWriter(scene, survey, stations, building).write().dump(1) << '\n';
    out.close();
    if (!out)
        file.fail("the disk may be full");
    file.commit();
}

}  // namespace s2b::sim

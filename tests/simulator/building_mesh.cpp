// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/axis_curve.h"
#include "tests/simulator/random.h"
#include "tests/simulator/scene.h"
#include "tests/simulator/triangulate.h"
#include "tests/simulator/variety.h"
#include "tests/simulator/wall_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace s2b::sim
{

namespace
{

std::array<std::uint8_t, 3> tinted(const std::array<std::uint8_t, 3>& base, Random random)
{
    std::array<std::uint8_t, 3> result{};
    const double shade = 5.0 * random.gaussian();
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = static_cast<std::uint8_t>(std::clamp(base[i] + shade + 3.0 * random.gaussian(), 0.0, 255.0));
    return result;
}

void addPlate(Scene& scene, const Polygon& outline, double bottom, double top, std::uint32_t element, Label topLabel,
              Label bottomLabel)
{
    for (const auto& t : triangulate(outline))
    {
        const auto at = [&](std::size_t i, double z) { return Eigen::Vector3d(t[i].x(), t[i].y(), z); };
        scene.addTriangle(at(0, top), at(1, top), at(2, top), {element, topLabel, Material::Opaque});
        scene.addTriangle(at(2, bottom), at(1, bottom), at(0, bottom), {element, bottomLabel, Material::Opaque});
    }
    std::vector<std::vector<Eigen::Vector2d>> rings = outline.holes;
    rings.push_back(outline.outer);
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            const Eigen::Vector2d& a = ring[i];
            const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
            scene.addQuad({a.x(), a.y(), bottom}, {b.x(), b.y(), bottom}, {b.x(), b.y(), top}, {a.x(), a.y(), top},
                          {element, topLabel, Material::Opaque});
        }
}

void addColumn(Scene& scene, const Column& column, std::uint32_t element)
{
    const auto* circle = std::get_if<CircleSection>(&column.section);
    Polygon outline{column.outline(), {}};
    if (circle != nullptr)  // rounder than the metrics' outline
    {
        constexpr int kFacets = 96;  // 0.13 mm sagitta at 0.25 m
        outline.outer.clear();
        for (int i = 0; i < kFacets; ++i)
        {
            const double angle = 2.0 * std::numbers::pi * i / kFacets;
            outline.outer.push_back(column.center +
                                    circle->radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
        }
    }
    addPlate(scene, outline, column.base_m, column.base_m + column.height.value_m, element, Label::Column,
             Label::Column);
}

}  // namespace

Scene makeScene(const SimulatedBuilding& simulated, std::uint64_t seed)
{
    const Building& building = simulated.truth;
    Scene scene;
    scene.origin = building.frame.origin;
    std::map<ElementId, int> storeyIndex;
    for (const Storey& storey : building.storeys)
    {
        storeyIndex[storey.id] = static_cast<int>(scene.storeys.size());
        scene.storeys.push_back({"storey-" + std::to_string(storey.id.value), storey.name, storey.elevation_m});
    }
    const auto add = [&](const char* type, const char* prefix, ElementId id, ElementId storey, Label label)
    {
        SceneElement element;
        element.type = type;
        element.guid = prefix + std::to_string(id.value);
        element.name = element.guid;
        element.id = id;
        element.storey = storeyIndex.contains(storey) ? storeyIndex.at(storey) : -1;
        element.colour = tinted(labelColour(label), Random{seed, 0xc0, id.value});
        return scene.addElement(std::move(element));
    };

    for (const Wall& wall : building.walls)
    {
        const std::uint32_t element = add("IfcWall", "wall-", wall.id, wall.storey, Label::Wall);
        std::vector<const Opening*> openings;
        for (const Opening& opening : building.openings)
            if (opening.host == wall.id)
                openings.push_back(&opening);
        addWallMesh(scene, building, wall, openings, element);
        for (const Opening* opening : openings)
        {
            if (opening->kind == OpeningKind::Plain)
                continue;
            const bool isDoor = opening->kind == OpeningKind::Door;
            const std::uint32_t filling = add(isDoor ? "IfcDoor" : "IfcWindow", isDoor ? "door-" : "window-",
                                              opening->id, wall.storey, isDoor ? Label::Door : Label::Window);
            scene.elements[filling].host = scene.elements[element].guid;
            if (simulated.hasVariedFittings)
                (isDoor ? addVariedDoor : addVariedWindow)(scene, wall, *opening, filling, seed,
                                                           Random{seed, 0xd005, opening->id.value});
            else if (isDoor)
                addDoorMesh(scene, wall, *opening, filling,
                            Random{seed, 0xd004, opening->id.value}.uniform(30.0, 90.0));
            else
                addWindowMesh(scene, wall, *opening, filling);
        }
    }
    for (const Column& column : building.columns)
        addColumn(scene, column, add("IfcColumn", "column-", column.id, column.storey, Label::Column));
    for (const Slab& slab : building.slabs)
    {
        const Label top = slab.kind == SlabKind::Roof ? Label::Roof : Label::Floor;
        addPlate(scene, slab.outline, slab.top_m - slab.thickness.value_m, slab.top_m,
                 add("IfcSlab", "slab-", slab.id, slab.storey, top), top, Label::Ceiling);
    }
    for (const Space& space : building.spaces)
    {
        const Storey* storey = building.storey(space.storey);
        constexpr double kSuspended_m = 0.05;
        if (storey == nullptr || space.height.value_m > storey->height.value_m - kSuspended_m)
            continue;
        const double z = space.floor_m + space.height.value_m;
        addPlate(scene, space.outline, z, z + 0.02,
                 add("IfcCovering", "ceiling-", space.id, space.storey, Label::Ceiling), Label::Ceiling,
                 Label::Ceiling);
    }
    for (const Prop& prop : simulated.props)
    {
        SceneElement element;
        element.type = prop.kind;
        element.guid = "prop-" + std::to_string(scene.elements.size());
        element.storey = prop.storey;
        element.isProp = true;
        element.colour = prop.colour;
        const Surface surface{scene.addElement(std::move(element)), prop.label, Material::Opaque};
        for (const PropBox& box : prop.boxes)
            scene.addBox(box, surface);
        for (const auto& t : prop.triangles)
            scene.addTriangle(t[0], t[1], t[2], surface);
    }

    const double c = std::cos(building.frame.yaw_rad);
    const double s = std::sin(building.frame.yaw_rad);
    for (Eigen::Vector3d& v : scene.vertices)
        v = {c * v.x() - s * v.y(), s * v.x() + c * v.y(), v.z()};
    return scene;
}

}  // namespace s2b::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "tests/simulator/building_spec.h"
#include "tests/simulator/layout.h"
#include "tests/simulator/variety.h"

#include <cmath>
#include <numbers>

namespace s2b::sim
{

namespace
{

void require(bool isFine, const std::string& what)
{
    if (!isFine)
        throw Error(ErrorCode::BadParameter, what);
}

void check(const BuildingSpec& spec)
{
    require(spec.storeys >= 1 && spec.storeys <= 50, "the number of storeys must be 1 to 50");
    require(spec.layout != Layout::Corridor || (spec.roomsPerSide >= 2 && spec.roomsPerSide <= 100),
            "the number of rooms on each side of the corridor must be 2 to 100");
    require(std::isfinite(spec.yaw_deg) && spec.origin.allFinite(), "yaw and origin must be finite numbers");
    require(std::abs(spec.facadeAngle_deg) <= 20.0, "the angle of the end facade must be at most 20 degrees");
    require(!spec.curvedFacade || spec.facadeAngle_deg == 0.0, "the end facade can be oblique or curved, not both");
    const auto isRange = [](const Range& r, double low, double high)
    { return r.min_m >= low && r.min_m <= r.max_m && r.max_m <= high; };
    const bool isCorridor = spec.layout == Layout::Corridor;
    require(isRange(spec.roomWidth_m, isCorridor ? 2.5 : 1.0, 100.0),
            "room widths must be an ascending range within 2.5 m (a single room: 1 m) to 100 m");
    require(isRange(spec.roomDepth_m, isCorridor ? 4.0 : 1.0, 100.0),
            "room depths must be an ascending range within 4 m (a single room: 1 m) to 100 m");
    require(isRange(spec.corridorWidth_m, 1.4, 20.0),
            "the corridor's width must be an ascending range within 1.4 m to 20 m");
    require(isRange(spec.clearHeight_m, 2.2, 20.0), "the clear height must be an ascending range within 2.2 m to 20 m");
    require(isRange(spec.slabThickness_m, 0.1, 1.0),
            "the slab thickness must be an ascending range within 0.1 m to 1 m");
    require(!spec.exteriorThickness_m.empty() && !spec.partitionThickness_m.empty(),
            "a list of wall thicknesses is empty");
    for (const std::vector<double>* list : {&spec.exteriorThickness_m, &spec.partitionThickness_m})
        for (const double t : *list)
            require(t >= 0.03 && t <= 0.8, "wall thicknesses must be 0.03 m to 0.8 m");
    require(spec.cubicleThickness_m >= 0.03 && spec.cubicleThickness_m <= 0.2,
            "the thickness of cubicle walls must be 0.03 m to 0.2 m");
    for (const double share : {spec.openDoors, spec.removedDoors, spec.openDoors + spec.removedDoors})
        require(share >= 0.0 && share <= 1.0, "the shares of open and removed doors must be 0 to 1, also together");
}

void addSlab(Building& building, std::uint32_t& nextId, std::size_t storey, SlabKind kind,
             const std::vector<Eigen::Vector2d>& outline, double top_m, double thickness_m)
{
    Slab slab;
    slab.id = {nextId++};
    slab.storey = building.storeys[storey].id;
    slab.kind = kind;
    slab.outline.outer = outline;
    slab.top_m = top_m;
    slab.thickness = {thickness_m, Provenance::Measured, 0.0};
    building.slabs.push_back(std::move(slab));
}

}  // namespace

BuildingSpec oneRoom(double width_m, double depth_m, double height_m)
{
    constexpr double kThickness_m = 0.30;
    BuildingSpec spec;
    spec.layout = Layout::OneRoom;
    spec.storeys = 1;
    spec.roomWidth_m = {width_m + kThickness_m, width_m + kThickness_m};
    spec.roomDepth_m = {depth_m + kThickness_m, depth_m + kThickness_m};
    spec.clearHeight_m = {height_m, height_m};
    spec.slabThickness_m = {0.25, 0.25};
    spec.exteriorThickness_m = {kThickness_m};
    spec.doors = spec.windows = spec.plainOpenings = spec.cubicles = spec.furniture = spec.trees = false;
    spec.rectangularColumns = spec.roundColumns = spec.engagedColumns = spec.obliqueWalls = spec.curvedWalls = false;
    return spec;
}

BuildingSpec twoRoomsWithDoor()
{
    BuildingSpec spec = oneRoom();
    spec.layout = Layout::TwoRooms;
    spec.partitionThickness_m = {0.15};
    spec.doors = true;
    return spec;
}

SimulatedBuilding makeBuilding(const BuildingSpec& spec)
{
    check(spec);
    SimulatedBuilding result;
    Building& building = result.truth;
    building.frame.origin = spec.origin;
    building.frame.yaw_rad = spec.yaw_deg * std::numbers::pi / 180.0;

    const Shell shell = makeShell(spec);
    const double storeyHeight = shell.clearHeight_m + shell.slab_m;
    std::uint32_t nextId = 1;
    for (int i = 0; i < spec.storeys; ++i)
    {
        Storey storey;
        storey.id = {nextId++};
        storey.name = "Level " + std::to_string(i);
        storey.elevation_m = i * storeyHeight;
        storey.height = {shell.clearHeight_m, Provenance::Measured, 0.0};
        building.storeys.push_back(storey);
    }
    const bool hasStairs = spec.stairs && spec.layout == Layout::Corridor;
    std::vector<Eigen::Vector2d> outline;
    for (std::size_t i = 0; i < building.storeys.size(); ++i)
    {
        StoreyPlan plan(building, i, shell.clearHeight_m, nextId);
        outline = layOut(spec, shell, plan);
        fitOut(spec, plan);
        addSlab(building, nextId, i, SlabKind::Floor, outline, building.storeys[i].elevation_m, shell.slab_m);
        if (hasStairs && i > 0)
            building.slabs.back().outline.holes.push_back(stairHole(shell));
        if (hasStairs && i + 1 < building.storeys.size())
            result.props.push_back(makeStairs(shell, plan));
        if (spec.furniture)
            for (Prop& prop : furnish(spec, plan))
                result.props.push_back(std::move(prop));
        if (spec.varied)
        {
            for (Prop& prop : addVariedStructure(spec, plan))
                result.props.push_back(std::move(prop));
            if (spec.furniture)
                for (Prop& prop : furnishVaried(spec, plan, result.props))
                    result.props.push_back(std::move(prop));
        }
    }
    addSlab(building, nextId, building.storeys.size() - 1, SlabKind::Roof, outline,
            building.storeys.back().elevation_m + storeyHeight, shell.slab_m);
    result.hasVariedFittings = spec.varied;
    if (spec.pitchedRoof)
        pitchRoof(spec, result);
    if (spec.trees)
    {
        Eigen::Vector2d low = outline.front();
        Eigen::Vector2d high = outline.front();
        for (const Eigen::Vector2d& p : outline)
        {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        for (Prop& prop : makeSurroundings(spec.seed, low, high, spec.groundLevel_m))
            result.props.push_back(std::move(prop));
    }
    return result;
}

}  // namespace s2b::sim

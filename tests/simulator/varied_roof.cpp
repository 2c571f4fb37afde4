// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/variety.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace s2b::sim
{

namespace
{

/// Height of the roof's underside over y; the ridge, if any, runs along x.
struct Pitch
{
    double eaves_m = 0.0;
    double slope = 0.0;
    double low_m = 0.0, high_m = 0.0;  ///< outer faces of the long facades
    bool isGable = true;

    [[nodiscard]] double at(double y) const
    {
        const double run = isGable ? std::min(y - low_m, high_m - y) : y - low_m;
        return eaves_m + slope * run;
    }
    [[nodiscard]] double ridge() const { return 0.5 * (low_m + high_m); }
};

std::vector<Eigen::Vector2d> profileOf(const Wall& wall, const Pitch& pitch)
{
    const AxisCurve curve(wall);
    std::vector<double> along = curve.samples(wall.bodyStart_m, wall.bodyEnd_m);
    if (!curve.isArc())
    {
        const double y0 = curve.at(0.0).y();
        const double dy = curve.direction(0.0).y();
        const double s = std::abs(dy) > 1e-6 ? (pitch.ridge() - y0) / dy : -1.0;
        if (pitch.isGable && s > along.front() && s < along.back())
            along.insert(along.begin() + 1, s);
    }
    std::vector<Eigen::Vector2d> profile;
    for (const double s : along)
        profile.emplace_back(s, std::max(pitch.at(curve.at(s).y()), wall.base_m + 0.02));
    return profile;
}

/// Underside and top of the roof. A flat one's underside is a ceiling to whoever is below.
std::vector<Prop> plates(const Pitch& pitch, double x0, double x1, double overhang, double thickness)
{
    constexpr double kCeiling = 0.25;  // slope; |n_z| above 0.97
    std::vector<double> ys{pitch.low_m - overhang, pitch.high_m + overhang};
    if (pitch.isGable)
        ys.insert(ys.begin() + 1, pitch.ridge());
    std::vector<Prop> result;
    for (const double lift : {0.0, thickness})
    {
        Prop roof;
        roof.kind = "roof";
        roof.label = lift == 0.0 && pitch.slope < kCeiling ? Label::Ceiling : Label::Roof;
        roof.storey = -1;
        roof.colour = {150, 84, 64};
        for (std::size_t i = 0; i + 1 < ys.size(); ++i)
        {
            const auto point = [&](double x, double y) { return Eigen::Vector3d(x, y, pitch.at(y) + lift); };
            const Eigen::Vector3d a = point(x0 - overhang, ys[i]), b = point(x1 + overhang, ys[i]);
            const Eigen::Vector3d c = point(x1 + overhang, ys[i + 1]), d = point(x0 - overhang, ys[i + 1]);
            const bool isTop = lift > 0.0;
            roof.triangles.push_back({a, isTop ? b : c, isTop ? c : b});
            roof.triangles.push_back({a, isTop ? c : d, isTop ? d : c});
        }
        result.push_back(std::move(roof));
    }
    return result;
}

/// A rafter down one side of the roof: a slanted box below its underside.
void addRafter(Prop& prop, const Pitch& pitch, double x, double half, double depth, double y0, double y1)
{
    const auto point = [&](double dx, double y, double dz) { return Eigen::Vector3d(x + dx, y, pitch.at(y) - dz); };
    const auto quad =
        [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d)
    {
        prop.triangles.push_back({a, b, c});
        prop.triangles.push_back({a, c, d});
    };
    quad(point(-half, y0, depth), point(-half, y1, depth), point(half, y1, depth), point(half, y0, depth));
    quad(point(half, y0, 0), point(half, y0, depth), point(half, y1, depth), point(half, y1, 0));
    quad(point(-half, y0, 0), point(-half, y1, 0), point(-half, y1, depth), point(-half, y0, depth));
}

}  // namespace

void pitchRoof(const BuildingSpec& spec, SimulatedBuilding& simulated)
{
    Building& building = simulated.truth;
    const auto isRoof = [](const Slab& s) { return s.kind == SlabKind::Roof; };
    const auto slab = std::find_if(building.slabs.begin(), building.slabs.end(), isRoof);
    if (slab == building.slabs.end() || spec.curvedFacade || spec.facadeAngle_deg != 0.0)
        return;
    Random random{spec.seed, 0x400f};
    const Storey& storey = building.storeys.back();
    double x0 = 1e9, x1 = -1e9;
    Pitch pitch;
    pitch.low_m = 1e9;
    pitch.high_m = -1e9;
    for (const Eigen::Vector2d& p : slab->outline.outer)
    {
        x0 = std::min(x0, p.x());
        x1 = std::max(x1, p.x());
        pitch.low_m = std::min(pitch.low_m, p.y());
        pitch.high_m = std::max(pitch.high_m, p.y());
    }
    pitch.isGable = random.chance(0.75);
    const double run = pitch.isGable ? pitch.ridge() - pitch.low_m : pitch.high_m - pitch.low_m;
    pitch.slope = std::tan(random.uniform(2.0, 48.0) * std::numbers::pi / 180.0);
    pitch.slope = std::min(pitch.slope, 4.0 / run);
    const double knee = random.chance(0.4) ? random.uniform(0.05, 0.5) : random.uniform(0.4, 2.6);
    pitch.eaves_m = storey.elevation_m + std::max(knee, 2.3 - pitch.slope * run);
    building.slabs.erase(slab);

    for (Wall& wall : building.walls)
    {
        if (wall.storey != storey.id)
            continue;
        wall.topProfile = profileOf(wall, pitch);
        double top = 0.0;
        for (const Eigen::Vector2d& p : wall.topProfile)
            top = std::max(top, p.y());
        wall.height.value_m = top - wall.base_m;
    }
    std::erase_if(building.openings,
                  [&](const Opening& o)
                  {
                      const Wall* host = building.wall(o.host);
                      if (host->storey != storey.id)
                          return false;
                      const AxisCurve curve(*host);
                      const double top = host->base_m + o.sill.value_m + o.height.value_m + 0.05;
                      return pitch.at(curve.at(o.offset_m).y()) < top ||
                             pitch.at(curve.at(o.offset_m + o.width.value_m).y()) < top;
                  });
    for (Column& column : building.columns)
        if (column.storey == storey.id)
            column.height.value_m = pitch.at(column.center.y()) - column.base_m;
    const auto pokesOut = [&](const PropBox& box)
    {
        const double reach = box.half.head<2>().norm();
        return box.center.z() + box.half.z() >
               std::min(pitch.at(box.center.y() - reach), pitch.at(box.center.y() + reach));
    };
    const int last = static_cast<int>(building.storeys.size()) - 1;
    std::erase_if(simulated.props,
                  [&](const Prop& prop)
                  {
                      return prop.storey == last && prop.label == Label::Furniture &&
                             std::any_of(prop.boxes.begin(), prop.boxes.end(), pokesOut);
                  });
    // Lamps and beams hung from the level ceiling that is gone.
    const double level = storey.elevation_m + storey.height.value_m;
    std::erase_if(simulated.props,
                  [&](const Prop& prop)
                  {
                      return prop.storey == last &&
                             (prop.kind == "lamp" || prop.kind == "beam" || prop.kind == "duct") &&
                             !prop.boxes.empty() && prop.boxes.front().center.z() > level - 1.2;
                  });
    const double overhang = random.uniform(0.2, 0.9);
    for (Prop& plate : plates(pitch, x0, x1, overhang, random.uniform(0.15, 0.35)))
        simulated.props.push_back(std::move(plate));
    if (!random.chance(0.25))
        return;
    Prop rafters;
    rafters.kind = "rafters";
    rafters.label = Label::Beam;
    rafters.storey = last;
    rafters.colour = {168, 150, 122};
    const double spacing = random.uniform(0.6, 1.4), half = random.uniform(0.03, 0.07),
                 depth = random.uniform(0.06, 0.2);
    const double inside = 0.5;
    for (double x = x0 + 0.5; x < x1 - 0.3; x += spacing)
    {
        addRafter(rafters, pitch, x, half, depth, pitch.low_m + inside,
                  pitch.isGable ? pitch.ridge() : pitch.high_m - inside);
        if (pitch.isGable)
            addRafter(rafters, pitch, x, half, depth, pitch.ridge(), pitch.high_m - inside);
    }
    simulated.props.push_back(std::move(rafters));
}

}  // namespace s2b::sim

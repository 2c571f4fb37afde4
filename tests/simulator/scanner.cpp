// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/scanner.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/simulator/random.h"
#include "tests/simulator/ray_caster.h"
#include "tests/simulator/voxel_set.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace s2b::sim
{

namespace
{

constexpr std::size_t kRingsPerChunk = 4;
constexpr double kOutsideCoarser = 2.0;  ///< angular step of stations outside, against those inside

double radians(double degrees)
{
    return degrees * std::numbers::pi / 180.0;
}

void check(const ScanSettings& s)
{
    const auto require = [](bool isFine, const char* what)
    {
        if (!isFine)
            throw Error(ErrorCode::BadParameter, what);
    };
    require(s.step_deg >= 0.01 && s.step_deg <= 10.0, "the angular step must be 0.01 to 10 degrees");
    require(s.lineStep_deg == 0.0 || (s.lineStep_deg >= 0.01 && s.lineStep_deg <= 10.0),
            "the step between lines must be 0 (as between rays) or 0.01 to 10 degrees");
    require(std::abs(s.tilt_deg) <= 20.0 && std::abs(s.warp_m) <= 1.0,
            "the tilt must be at most 20 degrees and the warp at most 1 m");
    require(s.rangeStep_m >= 0.0 && s.rangeStep_m <= 1.0, "the step of the range must be 0 to 1 m");
    require(s.elevationMin_deg >= -90.0 && s.elevationMin_deg < 90.0, "the lowest elevation must be -90 to 90 degrees");
    require(s.rangeMin_m >= 0.0 && s.rangeMax_m > s.rangeMin_m, "the range limits must be ascending and not negative");
    require(s.noise_m >= 0.0 && s.noise_m <= 1.0, "the range noise must be 0 to 1 m");
    require(s.voxel_m == 0.0 || (s.voxel_m >= 0.001 && s.voxel_m <= 1.0),
            "the voxel must be 0 (none) or 0.001 m to 1 m");
    for (const double share : {s.mixedPixels, s.glassReturn, s.labelErrors})
        require(share >= 0.0 && share <= 1.0, "shares (mixed pixels, glass returns, label errors) must be 0 to 1");
}

/// A label that is not the true one, of those that a classifier would give in a building.
Label wrongLabel(Label truth, Random& random)
{
    static const std::vector<Label> kLabels{Label::Unassigned, Label::Floor, Label::Ceiling, Label::Wall,
                                            Label::Column,     Label::Door,  Label::Window,  Label::Furniture};
    while (true)
    {
        const Label label = random.pick(kLabels);
        if (label != truth)
            return label;
    }
}

struct Return
{
    float range_m = std::numeric_limits<float>::infinity();  ///< infinite: nothing within reach
    std::uint32_t triangle = 0;
    bool isLost = false;  ///< there is something, but no light came back
    bool isGlass = false;
};

class StationScan
{
public:
    StationScan(const Scene& scene, const RayCaster& caster, const std::vector<Eigen::Vector3f>& normals,
                const Station& station, std::size_t index, const ScanSettings& settings)
        : m_scene(scene),
          m_caster(caster),
          m_normals(normals),
          m_settings(settings),
          m_from(station.position.cast<float>()),
          m_index(index),
          m_step(radians(settings.step_deg) * (station.storey < 0 ? kOutsideCoarser : 1.0)),
          m_lowest(radians(settings.elevationMin_deg)),
          m_phase(Random{settings.seed, 0x94a5e, index}.uniform(0.0, 2.0 * std::numbers::pi)),
          m_tilt(Eigen::Matrix3f::Identity())
    {
        Random random{settings.seed, 0x711, index};
        const double about = random.uniform(0.0, 2.0 * std::numbers::pi);
        if (settings.tilt_deg != 0.0)
            m_tilt =
                Eigen::AngleAxisd(radians(settings.tilt_deg), Eigen::Vector3d(std::cos(about), std::sin(about), 0.0))
                    .toRotationMatrix()
                    .cast<float>();
        m_warpPhase = random.uniform(0.0, 2.0 * std::numbers::pi);
    }

    [[nodiscard]] std::size_t rings() const
    {
        return static_cast<std::size_t>((std::numbers::pi / 2.0 - m_lowest) / m_step) + 1;
    }

    /// All rays of one elevation. Rows get shorter towards the zenith, as after the usual thinning of a scan's poles;
    /// those of a line laser do not.
    void scanRing(std::size_t ring, Survey& out) const
    {
        const double elevation = m_lowest + static_cast<double>(ring) * m_step;
        const bool isLineLaser = m_settings.lineStep_deg > 0.0;
        const double rays = isLineLaser ? 2.0 * std::numbers::pi / radians(m_settings.lineStep_deg)
                                        : 2.0 * std::numbers::pi * std::cos(elevation) / m_step;
        const auto count = std::max<std::size_t>(8, static_cast<std::size_t>(rays));
        const double jitter = isLineLaser ? 0.05 : 0.25;
        std::vector<Eigen::Vector3f> directions(count);  // in the world: what the scanner takes for upright may lean
        std::vector<Return> returns(count);
        std::vector<Random> random;
        random.reserve(count);
        for (std::size_t i = 0; i < count; ++i)
        {
            random.push_back(Random{m_settings.seed, 0x4a7, m_index, ring, i});
            Random& r = random.back();
            const double azimuth = m_phase + (static_cast<double>(i) + r.uniform(-jitter, jitter)) * 2.0 *
                                                 std::numbers::pi / static_cast<double>(count);
            directions[i] = m_tilt * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                                     std::cos(elevation) * std::sin(azimuth), std::sin(elevation))
                                         .cast<float>();
            returns[i] = shoot(directions[i], r);
        }
        for (std::size_t i = 0; i < count; ++i)
            measure(directions[i], returns[i], returns[(i + 1) % count], directions[(i + 1) % count], random[i], out);
    }

private:
    /// Follows the ray through glass until something returns it.
    Return shoot(const Eigen::Vector3f& direction, Random& random) const
    {
        Return result;
        float nearest = 0.0F;
        for (int pane = 0; pane < 8; ++pane)
        {
            const Hit hit = m_caster.cast(m_from, direction, nearest);
            result.range_m = hit.range_m;
            if (!hit.isHit())
                return result;
            result.triangle = hit.triangle;
            if (m_scene.surfaces[hit.triangle].material == Material::Opaque)
                return result;
            // Glass returns a little anywhere and much more straight on; each pane that is passed costs light twice.
            const double cosine = std::abs(static_cast<double>(direction.dot(m_normals[hit.triangle])));
            const double angle_deg = std::acos(std::min(1.0, cosine)) * 180.0 / std::numbers::pi;
            if (random.chance(m_settings.glassReturn +
                              (m_settings.glassReturn > 0.0 ? 0.5 : 0.0) * std::exp(-angle_deg * angle_deg / 16.0)))
            {
                result.isGlass = true;
                return result;
            }
            result.isLost = result.isLost || random.chance(0.25);
            nearest = hit.range_m + 1e-3F;
        }
        return result;
    }

    /// Whether two neighbouring rays end on different things, one behind the other: not on one plane seen at a grazing
    /// angle.
    bool isEdge(const Return& a, const Eigen::Vector3f& directionA, const Return& b,
                const Eigen::Vector3f& directionB) const
    {
        constexpr float kLeast_m = 0.04F;
        constexpr float kMost_m = 2.5F;  // two returns this far apart are told apart
        constexpr float kFlat_m = 0.01F;
        const float jump = std::abs(a.range_m - b.range_m);
        if (!(jump > kLeast_m && jump < kMost_m))
            return false;
        const Eigen::Vector3f between = directionA * a.range_m - directionB * b.range_m;
        return std::abs(between.dot(m_normals[a.triangle])) > kFlat_m &&
               std::abs(between.dot(m_normals[b.triangle])) > kFlat_m;
    }

    void measure(const Eigen::Vector3f& direction, const Return& hit, const Return& neighbour,
                 const Eigen::Vector3f& neighbourDirection, Random& random, Survey& out) const
    {
        double range = static_cast<double>(hit.range_m);
        if (!std::isfinite(range) || hit.isLost || range < m_settings.rangeMin_m || range > m_settings.rangeMax_m)
            return;
        const double cosine = std::abs(static_cast<double>(direction.dot(m_normals[hit.triangle])));
        if (m_settings.dropOut)
        {
            const double grazing = std::sqrt(std::clamp((cosine - 0.035) / 0.14, 0.0, 1.0));
            const double far = range > 0.7 * m_settings.rangeMax_m ? 0.7 : 1.0;
            if (!random.chance(grazing * far))
                return;
        }
        bool isMixed = false;
        if (isEdge(hit, direction, neighbour, neighbourDirection) && random.chance(m_settings.mixedPixels))
        {
            // Part of the beam on either surface: shares near 0 and 1 are the likeliest (arcsine distribution).
            const double share = std::pow(std::sin(0.5 * std::numbers::pi * random.uniform()), 2.0);
            range += share * (static_cast<double>(neighbour.range_m) - range);
            isMixed = share > 0.03 && share < 0.97;
        }
        const double sigma = m_settings.noise_m * (0.55 + 0.04 * range + 0.25 / std::max(cosine, 0.25));
        range += sigma * random.gaussian();
        if (m_settings.rangeStep_m > 0.0)
            range = std::round(range / m_settings.rangeStep_m) * m_settings.rangeStep_m;
        const Eigen::Vector3f own = m_tilt.transpose() * direction;
        if (m_settings.warp_m != 0.0)
            range += m_settings.warp_m * 0.5 *
                     (std::sin(2.0 * std::atan2(own.y(), own.x()) + m_warpPhase) +
                      std::sin(4.0 * std::asin(std::clamp(own.z(), -1.0F, 1.0F)) + 2.0 * m_warpPhase));
        const Eigen::Vector3f point = m_from + own * static_cast<float>(range);

        const Surface& surface = m_scene.surfaces[hit.triangle];
        Label label = isMixed ? Label::Unassigned : surface.label;
        if (m_settings.labelErrors > 0.0)
        {
            constexpr float kPatch_m = 0.3F;
            const Eigen::Vector3f cell = (point / kPatch_m).array().floor();
            Random patch{m_settings.seed, 0xbad, static_cast<std::uint64_t>(static_cast<std::int64_t>(cell.x())),
                         static_cast<std::uint64_t>(static_cast<std::int64_t>(cell.y())),
                         static_cast<std::uint64_t>(static_cast<std::int64_t>(cell.z()))};
            if (patch.chance(0.5 * m_settings.labelErrors))
                label = wrongLabel(surface.label, patch);
            else if (random.chance(0.5 * m_settings.labelErrors))
                label = wrongLabel(surface.label, random);
        }

        const auto& base = m_scene.elements[surface.element].colour;
        double light = 0.72 + 0.28 * cosine;
        if (surface.label == Label::Floor)  // tiles
            light *=
                (static_cast<int>(std::floor(point.x() / 0.5F)) + static_cast<int>(std::floor(point.y() / 0.5F))) % 2 ==
                        0
                    ? 1.0
                    : 0.94;
        std::array<std::uint8_t, 3> colour{};
        const double grain = 5.0 * (random.uniform() + random.uniform() - 1.0);
        for (std::size_t c = 0; c < 3; ++c)
            colour[c] = static_cast<std::uint8_t>(
                std::clamp((hit.isGlass ? 50.0 + 0.5 * base[c] : 1.0 * base[c]) * light + grain, 0.0, 255.0));

        out.points.push_back(point);
        out.labels.push_back(label);
        out.colours.push_back(colour);
        out.stations.push_back(static_cast<std::uint16_t>(m_index));
        out.triangles.push_back(isMixed ? Survey::kNoTriangle : hit.triangle);
    }

    const Scene& m_scene;
    const RayCaster& m_caster;
    const std::vector<Eigen::Vector3f>& m_normals;
    const ScanSettings& m_settings;
    Eigen::Vector3f m_from;
    std::size_t m_index;
    double m_step;
    double m_lowest;
    double m_phase;
    double m_warpPhase = 0.0;
    Eigen::Matrix3f m_tilt;
};

}  // namespace

Survey scan(const Scene& scene, const std::vector<Station>& stations, const ScanSettings& settings)
{
    check(settings);
    if (stations.empty())
        throw Error(ErrorCode::BadParameter, "there is no place for a station in this building: give stations by hand");
    if (stations.size() > 65534)
        throw Error(ErrorCode::BadParameter, "there are more than 65534 stations: scan the building in parts");
    const RayCaster caster(scene);
    std::vector<Eigen::Vector3f> normals(scene.triangles.size());
    for (std::size_t i = 0; i < normals.size(); ++i)
        normals[i] = scene.normal(i).cast<float>();

    Survey survey;
    survey.origin = scene.origin;
    VoxelSet voxels(settings.voxel_m);
    for (std::size_t s = 0; s < stations.size(); ++s)
    {
        const StationScan station(scene, caster, normals, stations[s], s, settings);
        const std::size_t rings = station.rings();
        std::vector<Survey> parts((rings + kRingsPerChunk - 1) / kRingsPerChunk);
        parallelChunks(rings, kRingsPerChunk, settings.threads,
                       [&](std::size_t begin, std::size_t end)
                       {
                           for (std::size_t ring = begin; ring < end; ++ring)
                               station.scanRing(ring, parts[begin / kRingsPerChunk]);
                       });
        for (const Survey& part : parts)
            for (std::size_t i = 0; i < part.size(); ++i)
            {
                if (!voxels.insert(part.points[i]))
                    continue;
                survey.points.push_back(part.points[i]);
                survey.labels.push_back(part.labels[i]);
                survey.colours.push_back(part.colours[i]);
                survey.stations.push_back(part.stations[i]);
                survey.triangles.push_back(part.triangles[i]);
            }
    }
    if (survey.points.empty())
        throw Error(ErrorCode::EmptyCloud, "no ray hit anything within the range limits");
    return survey;
}

}  // namespace s2b::sim

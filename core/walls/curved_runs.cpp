// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/curved_runs.h"

#include "core/geometry/circle.h"
#include "core/geometry/dbscan.h"
#include "core/geometry/parabola.h"
#include "core/walls/plan_curvature.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

namespace s2b
{
namespace
{

constexpr double kPi = std::numbers::pi;
constexpr double kBin_m = 0.05;     // along a run
constexpr double kGap_m = 1.5;      // largest gap in a run: a wide door
constexpr double kTight_m = 0.006;  // largest distance of a place from its circle
constexpr double kSweep_rad = 30 * kPi / 180, kSmallestSweep_rad = 10 * kPi / 180;
constexpr double kSagitta_m = 0.15;  // that a sweep below kSweep_rad needs
constexpr double kCurvedShare = 0.7;

/// One place of a circle: what lies on it within kBin_m.
struct Bin
{
    double weight = 0, offset = 0;  ///< mean distance outwards
};

struct Circle
{
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double radius = 0;
    [[nodiscard]] Eigen::Vector2d at(double angle, double offset = 0) const
    {
        return center + (radius + offset) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
};

/// What lies on a circle, in bins all around from the angle -pi.
std::vector<Bin> binsOf(const std::vector<PlanPixel>& pixels, const std::vector<char>& used, const Circle& c)
{
    std::vector<Bin> bins(static_cast<std::size_t>(std::max(12.0, std::ceil(2 * kPi * c.radius / kBin_m))));
    const double cosine = std::cos(20 * kPi / 180);
    for (std::size_t i = 0; i < pixels.size(); ++i)
    {
        const Eigen::Vector2d arm = pixels[i].position - c.center;
        const double r = arm.norm(), offset = r - c.radius;
        if (used[i] || std::abs(offset) > 0.03 || std::abs(arm.dot(pixels[i].normal)) < cosine * r)
            continue;
        const double share = (std::atan2(arm.y(), arm.x()) + kPi) / (2 * kPi);
        Bin& b = bins[std::min(bins.size() - 1, static_cast<std::size_t>(share * static_cast<double>(bins.size())))];
        b.weight += pixels[i].weight;
        b.offset += pixels[i].weight * offset;
    }
    for (Bin& b : bins)
        if (b.weight > 0)
            b.offset /= b.weight;
    return bins;
}

/// Bins [first, first + count) in a ring, with values at both ends.
struct Stretch
{
    std::size_t first = 0, count = 0;
};

/// The stretch of bins on the circle around the bin `seed` (or the nearest one) without a gap wider than kGap_m.
Stretch stretchAround(const std::vector<Bin>& bins, std::size_t seed, double tolerance)
{
    const std::size_t n = bins.size();
    const auto isOn = [&](std::size_t i) { return bins[i % n].weight > 0 && std::abs(bins[i % n].offset) < tolerance; };
    // A face that merely crosses the circle is on it in a few bins; a piece beyond a gap has to be longer.
    constexpr std::size_t half = 5, enough = 8;
    std::vector<char> solid(n, 0);
    for (std::size_t i = 0; i < n; ++i)
    {
        std::size_t on = 0;
        for (std::size_t k = i + n - half; k <= i + n + half; ++k)
            on += isOn(k);
        solid[i] = isOn(i) && on >= enough;
    }
    std::size_t start = seed;
    for (std::size_t d = 0; d <= n / 2 && !solid[start % n]; ++d)
        start = solid[(seed + d) % n] ? seed + d : seed + n - d;
    start %= n;
    if (!solid[start])
        return {};
    const auto gap = static_cast<std::size_t>(kGap_m / kBin_m);
    std::size_t up = 0, down = 0;
    for (std::size_t i = 1; i < n && i - up <= gap; ++i)
        if (solid[(start + i) % n])
            up = i;
    while (up + 1 < n && isOn(start + up + 1))
        ++up;
    for (std::size_t i = 1; i < n - up && i - down <= gap; ++i)
        if (solid[(start + n - i) % n])
            down = i;
    while (up + down + 1 < n && isOn(start + n - down - 1))
        ++down;
    return {(start + n - down) % n, up + down + 1};
}

class Grower
{
public:
    Grower(const std::vector<PlanPixel>& pixels, const WallParams& params, const Context& context)
        : m_pixels(pixels), m_used(pixels.size(), 0), m_params(params), m_seed(context.seed)
    {
    }

    /// Grows the circle over all that lies on it; nothing when it is no wall-like curve.
    std::optional<CurvedRun> grow(Circle c, const Eigen::Vector2d& seed)
    {
        std::vector<Bin> bins;
        Stretch s;
        for (int round = 0; round < 8; ++round)
        {
            const double tolerance = round < 3 ? 0.02 : kTight_m;
            bins = binsOf(m_pixels, m_used, c);
            s = stretchAround(bins, binAt(bins, c, seed), tolerance);
            const double length = static_cast<double>(s.count) * 2 * kPi * c.radius / static_cast<double>(bins.size());
            if (length < 0.4)
                return std::nullopt;
            // What touches the circle at the ends (a straight wall that goes on) must not bend it.
            const bool isRing = s.count + static_cast<std::size_t>(kGap_m / kBin_m) > bins.size();
            const double trim = isRing ? 0.0 : std::min(std::sqrt(2 * c.radius * tolerance), 0.2 * length);
            std::vector<Eigen::Vector2d> places;
            for (std::size_t k = 0; k < s.count; ++k)
            {
                const std::size_t i = (s.first + k) % bins.size();
                const double at = (static_cast<double>(k) + 0.5) * length / static_cast<double>(s.count);
                if (bins[i].weight > 0 && std::abs(bins[i].offset) < tolerance && at >= trim && at <= length - trim)
                    places.push_back(c.at(angleOf(i, bins.size()), bins[i].offset));
            }
            CircleOptions options;
            options.tolerance_m = 2 * tolerance;
            options.minimumRadius_m = 0.5 * m_params.minimumArcRadius_m;
            options.maximumRadius_m = 1.5 * m_params.maximumArcRadius_m;
            options.trials = 60;
            options.seed = m_seed;
            const auto fit = fitCircle(places, {}, options);
            if (!fit)
                return std::nullopt;
            c = {fit->center, fit->radius_m};
        }
        if (c.radius < m_params.minimumArcRadius_m || c.radius > m_params.maximumArcRadius_m)
            return std::nullopt;
        bins = binsOf(m_pixels, m_used, c);
        s = stretchAround(bins, binAt(bins, c, seed), kTight_m);
        return accepted(c, bins, s);
    }
    /// Takes away what lies on a run.
    void use(const CurvedRun& run, double tolerance)
    {
        for (std::size_t i = 0; i < m_pixels.size(); ++i)
        {
            const Eigen::Vector2d arm = m_pixels[i].position - run.center;
            const double middle = (run.begin_rad + run.end_rad) / 2;
            if (std::abs(arm.norm() - run.radius_m) < tolerance &&
                std::abs(std::remainder(std::atan2(arm.y(), arm.x()) - middle, 2 * kPi)) <= run.sweep_rad() / 2)
                m_used[i] = 1;
        }
    }
    [[nodiscard]] bool isUsed(std::size_t pixel) const { return m_used[pixel] != 0; }

private:
    [[nodiscard]] static double angleOf(std::size_t bin, std::size_t count)
    {
        return 2 * kPi * (static_cast<double>(bin) + 0.5) / static_cast<double>(count) - kPi;
    }
    [[nodiscard]] static std::size_t binAt(const std::vector<Bin>& bins, const Circle& c, const Eigen::Vector2d& p)
    {
        const Eigen::Vector2d arm = p - c.center;
        const double share = (std::atan2(arm.y(), arm.x()) + kPi) / (2 * kPi);
        return std::min(bins.size() - 1, static_cast<std::size_t>(share * static_cast<double>(bins.size())));
    }
    /// Share of the stretch whose pieces are curved as the whole is, of those where enough was seen.
    [[nodiscard]] static double curvedShare(const Circle& c, const std::vector<Bin>& bins, const Stretch& s)
    {
        const double binLength = 2 * kPi * c.radius / static_cast<double>(bins.size());
        // A chord's sagitta of 12 mm is well above what a centroid of a plan pixel errs.
        const double piece = std::clamp(std::sqrt(8 * c.radius * 0.012), 0.4, 1.8);
        const auto count = static_cast<std::size_t>(piece / binLength) + 1;
        int all = 0, curved = 0;
        for (std::size_t k = 0; k + count <= s.count; k += std::max<std::size_t>(1, count / 4))
        {
            Parabola p;
            for (std::size_t m = 0; m < count; ++m)
                if (const Bin& b = bins[(s.first + k + m) % bins.size()]; b.weight > 0 && std::abs(b.offset) < 0.02)
                    p.add((static_cast<double>(m) + 0.5) * binLength - piece / 2, b.offset, 1);
            if (p.count * 10 < static_cast<int>(count) * 7)
                continue;
            if (const auto fit = p.solve())
                ++all, curved += std::abs(2 * (*fit)[2]) < 0.5 / c.radius;  // on a straight piece it is 1 / radius
        }
        return all > 0 ? static_cast<double>(curved) / all : 0.0;
    }
    [[nodiscard]] static std::optional<CurvedRun> accepted(const Circle& c, const std::vector<Bin>& bins,
                                                           const Stretch& s)
    {
        const double step = 2 * kPi / static_cast<double>(bins.size());
        CurvedRun run{c.center, c.radius, angleOf(s.first, bins.size()) - step / 2, 0, 0, {}};
        run.end_rad = run.begin_rad + step * static_cast<double>(s.count);
        double squares = 0;
        for (std::size_t k = 0; k < s.count; ++k)
            if (const Bin& b = bins[(s.first + k) % bins.size()]; b.weight > 0 && std::abs(b.offset) < 0.02)
            {
                squares += b.offset * b.offset;
                run.places.push_back(c.at(angleOf((s.first + k) % bins.size(), bins.size()), b.offset));
            }
        if (run.places.empty())
            return std::nullopt;
        run.rms_m = std::sqrt(squares / static_cast<double>(run.places.size()));
        const double sagitta = c.radius * (1 - std::cos(std::min(kPi, run.sweep_rad()) / 2));
        const bool turns =
            run.sweep_rad() >= kSweep_rad || (run.sweep_rad() >= kSmallestSweep_rad && sagitta >= kSagitta_m);
        if (!turns || run.rms_m > kTight_m || 2 * run.places.size() < s.count || curvedShare(c, bins, s) < kCurvedShare)
            return std::nullopt;
        return run;
    }

    const std::vector<PlanPixel>& m_pixels;
    std::vector<char> m_used;
    const WallParams& m_params;
    std::uint64_t m_seed;
};

}  // namespace

std::vector<CurvedRun> findCurvedRuns(const SurfaceCells& cells, const Level& level, const WallParams& params,
                                      const Context& context)
{
    std::vector<CurvedRun> runs;
    if (!params.curved)
        return runs;
    const std::vector<PlanPixel> pixels = verticalPixels(cells, level, context);
    context.checkCancelled();
    const std::vector<std::uint32_t> seeds = curvedPixels(pixels, cells.size_m, params, context);
    std::vector<Eigen::Vector2d> positions;
    for (const std::uint32_t i : seeds)
        positions.push_back(pixels[i].position);
    context.checkCancelled();
    const std::vector<int> cluster = dbscan(positions, std::max(0.15, 3 * cells.size_m), 3);
    std::map<int, std::vector<std::uint32_t>> members;
    for (std::size_t i = 0; i < cluster.size(); ++i)
        if (cluster[i] >= 0)
            members[cluster[i]].push_back(seeds[i]);

    Grower grower(pixels, params, context);
    for (auto& [id, left] : members)
    {
        constexpr std::size_t attempts = 12;
        for (std::size_t attempt = 0; attempt < attempts; ++attempt)
        {
            context.checkCancelled();
            std::erase_if(left, [&](std::uint32_t i) { return grower.isUsed(i); });
            if (static_cast<double>(left.size()) * cells.size_m < 0.25)
                break;
            std::vector<Eigen::Vector2d> points;
            for (const std::uint32_t i : left)
                points.push_back(pixels[i].position);
            CircleOptions options;
            options.tolerance_m = params.planeDistance_m;
            options.minimumRadius_m = params.minimumArcRadius_m;
            options.maximumRadius_m = params.maximumArcRadius_m;
            options.seed = context.seed;
            const auto fit = fitCircle(points, {}, options);
            if (!fit)
                break;
            const auto isOn = [&](std::uint32_t i)
            { return std::abs((pixels[i].position - fit->center).norm() - fit->radius_m) < params.planeDistance_m; };
            // The run grows from the middle one of the pixels on the circle.
            std::vector<std::uint32_t> on;
            std::copy_if(left.begin(), left.end(), std::back_inserter(on), isOn);
            if (on.empty())
                break;
            const Eigen::Vector2d seed = pixels[on[on.size() / 2]].position;
            if (const auto run = grower.grow({fit->center, fit->radius_m}, seed))
            {
                grower.use(*run, 1.8 * params.planeDistance_m);
                runs.push_back(*run);
            }
            std::erase_if(left, isOn);
        }
    }
    std::sort(runs.begin(), runs.end(),
              [](const CurvedRun& a, const CurvedRun& b)
              {
                  return std::tuple(-a.length_m(), a.center.x(), a.center.y()) <
                         std::tuple(-b.length_m(), b.center.x(), b.center.y());
              });
    return runs;
}

double alignRuns(std::vector<CurvedRun*>& runs, double limit_m)
{
    Eigen::Vector2d center = runs.front()->center;
    std::vector<double> radius;
    for (const CurvedRun* r : runs)
        radius.push_back((r->places[r->places.size() / 2] - center).norm());
    const auto size = static_cast<Eigen::Index>(2 + runs.size());
    double rms = 0;
    for (int round = 0; round < 20; ++round)
    {
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
        double squares = 0, count = 0;
        for (std::size_t k = 0; k < runs.size(); ++k)
            for (const Eigen::Vector2d& p : runs[k]->places)
            {
                const Eigen::Vector2d arm = p - center;
                const double residual = arm.norm() - radius[k];
                Eigen::VectorXd row = Eigen::VectorXd::Zero(size);
                row.head<2>() = -arm.normalized();
                row[static_cast<Eigen::Index>(2 + k)] = -1;
                normal += row * row.transpose();
                right -= residual * row;
                squares += residual * residual, count += 1;
            }
        rms = std::sqrt(squares / count);
        const Eigen::VectorXd step = normal.ldlt().solve(right);
        if (!step.allFinite())
            return std::numeric_limits<double>::infinity();
        center += step.head<2>();
        for (std::size_t k = 0; k < runs.size(); ++k)
            radius[k] += step[static_cast<Eigen::Index>(2 + k)];
        if (step.norm() < 1e-9)
            break;
    }
    if (rms > limit_m)
        return rms;
    for (std::size_t k = 0; k < runs.size(); ++k)
    {
        CurvedRun& r = *runs[k];
        const auto turned = [&](double angle)
        {
            const Eigen::Vector2d p = r.center + r.radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle));
            return angle + std::remainder(std::atan2(p.y() - center.y(), p.x() - center.x()) - angle, 2 * kPi);
        };
        const double begin = turned(r.begin_rad), end = turned(r.end_rad);
        r.begin_rad = begin, r.end_rad = std::min(end, begin + 2 * kPi);
        r.center = center;
        r.radius_m = radius[k];
    }
    return rms;
}

}  // namespace s2b

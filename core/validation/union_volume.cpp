// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/union_volume.h"

#include "core/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace s2b::validation
{

namespace
{

constexpr double kStep_m = 1e-3;

/// Which bodies are cut at height z.
std::vector<int> cutAt(const std::vector<Body>& bodies, double z)
{
    std::vector<int> cut;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (bodies[i].low_m <= z && z <= bodies[i].high_m)
            cut.push_back(static_cast<int>(i));
    return cut;
}

std::vector<Polygon> plansOf(const std::vector<Body>& bodies, const std::vector<int>& which)
{
    std::vector<Polygon> plans;
    for (const int i : which)
        for (const Polygon& p : bodies[static_cast<std::size_t>(i)].plan)
            plans.push_back(p);
    return plans;
}

double areaOf(const std::vector<Polygon>& polygons)
{
    double sum = 0.0;
    for (const Polygon& p : polygons)
        sum += area(p);
    return sum;
}

struct Areas
{
    double shared_m2 = 0.0;
    double covered_m2 = 0.0;
};

}  // namespace

std::optional<double> unionIou(const std::vector<Body>& truth, const std::vector<Body>& result)
{
    if (truth.empty())
        return std::nullopt;
    std::set<long long> heights;
    for (const auto* bodies : {&truth, &result})
        for (const Body& body : *bodies)
            for (const double z : {body.low_m, body.high_m})
                heights.insert(std::llround(z / kStep_m));
    const std::vector<long long> levels(heights.begin(), heights.end());

    // Between most levels the same bodies are cut as between some others.
    std::map<std::pair<std::vector<int>, std::vector<int>>, Areas> known;
    double shared = 0.0;
    double covered = 0.0;
    for (std::size_t i = 0; i + 1 < levels.size(); ++i)
    {
        const double height = static_cast<double>(levels[i + 1] - levels[i]) * kStep_m;
        const double middle = 0.5 * static_cast<double>(levels[i] + levels[i + 1]) * kStep_m;
        const std::vector<int> a = cutAt(truth, middle);
        const std::vector<int> b = cutAt(result, middle);
        const auto [at, isNew] = known.try_emplace({a, b});
        if (isNew)
        {
            const std::vector<Polygon> plansA = unite(plansOf(truth, a));
            const std::vector<Polygon> plansB = unite(plansOf(result, b));
            at->second.shared_m2 = areaOf(intersect(plansA, plansB));
            at->second.covered_m2 = areaOf(plansA) + areaOf(plansB) - at->second.shared_m2;
        }
        shared += at->second.shared_m2 * height;
        covered += at->second.covered_m2 * height;
    }
    return covered > 0.0 ? shared / covered : 0.0;
}

}  // namespace s2b::validation

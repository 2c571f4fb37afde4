// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/corners.h"

#include "core/geometry/rectangle.h"
#include "core/validation/matching.h"
#include "core/validation/statistics.h"

#include <algorithm>
#include <array>

namespace s2b::validation
{

namespace
{

constexpr double kFarthest_m = 0.20;
constexpr int kCorners = 8;

struct BoxCorners
{
    std::array<Eigen::Vector2d, 4> plan;
    double low_m = 0.0;
    double high_m = 0.0;
    Eigen::AlignedBox2d reach;  ///< with the largest distance around it
};

BoxCorners cornersOf(const Prism& prism)
{
    BoxCorners corners;
    corners.plan = minimumRectangle(prism.plan.outer).corners();
    corners.low_m = prism.low_m;
    corners.high_m = prism.high_m;
    for (const Eigen::Vector2d& p : corners.plan)
        corners.reach.extend(p);
    corners.reach.min().array() -= kFarthest_m;
    corners.reach.max().array() += kFarthest_m;
    return corners;
}

Eigen::Vector3d corner(const BoxCorners& box, int which, double bandLow_m, double bandHigh_m)
{
    const Eigen::Vector2d& p = box.plan[static_cast<std::size_t>(which % 4)];
    return {p.x(), p.y(), std::clamp(which < 4 ? box.low_m : box.high_m, bandLow_m, bandHigh_m)};
}

}  // namespace

std::map<int, Rates> cornerRates(const std::vector<Prism>& truth, const std::vector<Prism>& result)
{
    std::vector<BoxCorners> found;
    for (const Prism& p : result)
        found.push_back(cornersOf(p));

    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
        const BoxCorners box = cornersOf(truth[i]);
        const double low = truth[i].bandLow_m;
        const double high = truth[i].bandHigh_m;
        for (std::size_t j = 0; j < found.size(); ++j)
        {
            if (!box.reach.intersects(found[j].reach) ||
                std::min(found[j].high_m, high) < std::max(found[j].low_m, low))
                continue;
            for (int a = 0; a < kCorners; ++a)
                for (int b = 0; b < kCorners; ++b)
                {
                    const double distance = (corner(box, a, low, high) - corner(found[j], b, low, high)).norm();
                    if (distance < kFarthest_m)
                        candidates.push_back({static_cast<int>(i) * kCorners + a, static_cast<int>(j) * kCorners + b,
                                              kFarthest_m - distance});
                }
        }
    }
    std::map<int, std::size_t> hits{{5, 0}, {10, 0}, {20, 0}};
    std::map<std::pair<int, int>, double> worthOf;
    for (const Candidate& c : candidates)
        worthOf[{c.row, c.column}] = c.worth;
    for (const auto& pair : assign(candidates))
        for (auto& [centimetres, count] : hits)
            count += kFarthest_m - worthOf[pair] < centimetres / 100.0 ? 1 : 0;
    std::map<int, Rates> rates;
    for (const auto& [centimetres, count] : hits)
        rates[centimetres] = ratesOf(count, truth.size() * kCorners, result.size() * kCorners);
    return rates;
}

}  // namespace s2b::validation

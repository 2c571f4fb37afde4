// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/prism.h"

#include "core/geometry/polygon.h"

#include <algorithm>

namespace s2b::validation
{

namespace
{

double iou(double areaA, double lowA, double highA, double areaB, double lowB, double highB, double common_m2)
{
    const double height = std::min(highA, highB) - std::max(lowA, lowB);
    if (height <= 0.0 || common_m2 <= 0.0)
        return 0.0;
    const double common = common_m2 * height;
    return common / std::max(areaA * (highA - lowA) + areaB * (highB - lowB) - common, 1e-12);
}

}  // namespace

Polygon moved(const Polygon& polygon, const Eigen::Vector2d& shift)
{
    Polygon result = polygon;
    for (Eigen::Vector2d& p : result.outer)
        p += shift;
    for (auto& hole : result.holes)
        for (Eigen::Vector2d& p : hole)
            p += shift;
    return result;
}

Prism prismOf(const BimElement& element, const Eigen::Vector3d& shift)
{
    Prism prism;
    prism.plan = moved(element.plan, shift.head<2>());
    for (const Eigen::Vector2d& p : prism.plan.outer)
        prism.bounds.extend(p);
    prism.area_m2 = area(prism.plan);
    prism.low_m = element.low_m + shift.z();
    prism.high_m = element.high_m + shift.z();
    if (element.visibility)
    {
        prism.bandLow_m = element.visibility->bandLow_m.value_or(prism.bandLow_m);
        prism.bandHigh_m = element.visibility->bandHigh_m.value_or(prism.bandHigh_m);
    }
    const Eigen::Vector2d middle = centroid(prism.plan);
    prism.center = {middle.x(), middle.y(), 0.5 * (prism.low_m + prism.high_m)};
    return prism;
}

double commonArea(const Prism& a, const Prism& b)
{
    if (!a.bounds.intersects(b.bounds))
        return 0.0;
    double sum = 0.0;
    for (const Polygon& part : intersect(std::span(&a.plan, 1), std::span(&b.plan, 1)))
        sum += area(part);
    return sum;
}

std::vector<Overlap> overlapsOf(const std::vector<Prism>& truth, const std::vector<Prism>& result)
{
    std::vector<Overlap> overlaps;
    for (std::size_t i = 0; i < truth.size(); ++i)
        for (std::size_t j = 0; j < result.size(); ++j)
        {
            if (std::min(truth[i].high_m, result[j].high_m) <= std::max(truth[i].low_m, result[j].low_m))
                continue;
            const double shared = commonArea(truth[i], result[j]);
            if (shared > 0.0)
                overlaps.push_back({static_cast<int>(i), static_cast<int>(j), shared});
        }
    return overlaps;
}

double fullIou(const Prism& truth, const Prism& result, double area_m2)
{
    return iou(truth.area_m2, truth.low_m, truth.high_m, result.area_m2, result.low_m, result.high_m, area_m2);
}

double seenIou(const Prism& truth, const Prism& result, double area_m2)
{
    const auto low = [&](double z) { return std::max(z, truth.bandLow_m); };
    const auto high = [&](double z) { return std::min(z, truth.bandHigh_m); };
    return iou(truth.area_m2, low(truth.low_m), high(truth.high_m), result.area_m2, low(result.low_m),
               high(result.high_m), area_m2);
}

double shareInside(const Prism& part, const Prism& whole, double area_m2)
{
    const double height = std::min(part.high_m, whole.high_m) - std::max(part.low_m, whole.low_m);
    const double volume = part.volume_m3();
    return height <= 0.0 || volume <= 0.0 ? 0.0 : area_m2 * height / volume;
}

}  // namespace s2b::validation

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/overlap.h"

#include "core/base/error.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace s2b::validation
{

namespace
{

constexpr double kNear_m = 1.0;         ///< boxes nearer than this may be compared
constexpr double kAnotherUnit = 500.0;  ///< ratio of two models' sizes that no storey more or less explains
constexpr std::size_t kCloudSamples = 100000;

/// World coordinates. Empty without elements.
Eigen::AlignedBox3d boxOf(const Bim& bim)
{
    Eigen::AlignedBox3d box;
    for (const BimElement& e : bim.elements)
        for (const Eigen::Vector2d& p : e.plan.outer)
            for (const double z : {e.low_m, e.high_m})
                box.extend(bim.origin + Eigen::Vector3d(p.x(), p.y(), z));
    return box;
}

/// Around evenly taken points: enough to tell places apart.
Eigen::AlignedBox3d boxOf(const CloudView& cloud)
{
    Eigen::AlignedBox3d box;
    const std::size_t step = std::max<std::size_t>(1, cloud.count / kCloudSamples);
    for (std::size_t i = 0; i < cloud.count; i += step)
    {
        const Eigen::Vector3d p =
            Eigen::Vector3f(cloud.xyz[3 * i], cloud.xyz[3 * i + 1], cloud.xyz[3 * i + 2]).cast<double>();
        if (p.allFinite())
            box.extend(cloud.origin + p);
    }
    return box;
}

std::string lengthText(double length_m)
{
    char text[48];
    if (length_m < 1e4)
        std::snprintf(text, sizeof text, "%.1f m", length_m);
    else
        std::snprintf(text, sizeof text, "%.0f km", length_m / 1000.0);
    return text;
}

double sizeOf(const Eigen::AlignedBox3d& box)
{
    return box.sizes().head<2>().norm();
}

void compare(const Eigen::AlignedBox3d& a, const std::string& nameA, const Eigen::AlignedBox3d& b,
             const std::string& nameB, bool isSizeTelling)
{
    if (a.isEmpty() || b.isEmpty())
        return;
    const double ratio = sizeOf(a) / std::max(sizeOf(b), 1e-9);
    if (isSizeTelling && (ratio > kAnotherUnit || ratio < 1.0 / kAnotherUnit))
        throw Error(ErrorCode::BadFile, nameA + " is " + lengthText(sizeOf(a)) + " wide, " + nameB + " " +
                                            lengthText(sizeOf(b)) +
                                            ": the length unit of one of them is wrong, probably by 1000");
    const double distance = a.exteriorDistance(b);
    if (distance > kNear_m)
        throw Error(ErrorCode::BadFile, nameA + " and " + nameB + " lie " + lengthText(distance) +
                                            " apart, so there is nothing to compare: bring both into the same "
                                            "coordinates");
}

}  // namespace

void checkOverlap(const Bim& truth, const Bim& result, const CloudView* cloud)
{
    const Eigen::AlignedBox3d truthBox = boxOf(truth);
    compare(truthBox, truth.file, boxOf(result), result.file, true);
    // A cloud may well show much more than the model.
    if (cloud != nullptr)
        compare(truthBox, truth.file, boxOf(*cloud), "the cloud", false);
}

}  // namespace s2b::validation

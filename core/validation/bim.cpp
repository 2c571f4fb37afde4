// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/bim.h"

#include "core/base/error.h"
#include "core/base/nearest_name.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace s2b::validation
{

namespace
{

/// A building's walls, columns and doors are so high; in the wrong unit they are not.
constexpr double kLowest_m = 0.05;
constexpr double kHighest_m = 100.0;

bool isBody(ElementClass elementClass)
{
    return elementClass == ElementClass::Wall || elementClass == ElementClass::Column ||
           elementClass == ElementClass::Slab;
}

}  // namespace

Eigen::Vector3d centerOf(const Bim& bim)
{
    const bool hasBody = std::any_of(bim.elements.begin(), bim.elements.end(),
                                     [](const BimElement& e) { return isBody(e.elementClass); });
    Eigen::AlignedBox3d box;
    for (const BimElement& e : bim.elements)
    {
        if (hasBody && !isBody(e.elementClass))
            continue;
        for (const Eigen::Vector2d& p : e.plan.outer)
        {
            box.extend(Eigen::Vector3d(p.x(), p.y(), e.low_m));
            box.extend(Eigen::Vector3d(p.x(), p.y(), e.high_m));
        }
    }
    return box.isEmpty() ? bim.origin : Eigen::Vector3d(bim.origin + box.center());
}

void selectStoreys(Bim& bim, std::span<const std::string> names)
{
    if (names.empty())
        return;
    std::vector<bool> isChosen(bim.storeys.size(), false);
    for (const std::string& name : names)
    {
        bool isKnown = false;
        for (std::size_t i = 0; i < bim.storeys.size(); ++i)
            if (bim.storeys[i].name == name || bim.storeys[i].guid == name)
                isKnown = isChosen[i] = true;
        if (isKnown)
            continue;
        std::vector<std::string_view> known;
        for (const BimStorey& s : bim.storeys)
            known.emplace_back(s.name);
        throw Error(ErrorCode::BadParameter,
                    bim.file + " has no storey \"" + name + "\"; " +
                        (known.empty() ? "it has no storeys" : "choose from: " + joinNames(known)));
    }
    for (std::size_t i = 0; i < bim.storeys.size(); ++i)
    {
        bim.storeys[i].isChosen = isChosen[i];
        bim.storeys[i].isSurveyed = bim.storeys[i].isSurveyed && isChosen[i];
    }
}

int storeyAt(const Bim& bim, double z_m)
{
    int storey = bim.storeys.empty() ? -1 : 0;
    for (std::size_t i = 0; i < bim.storeys.size(); ++i)
        if (bim.storeys[i].elevation_m <= z_m)
            storey = static_cast<int>(i);
    return storey;
}

void checkSizes(const Bim& bim)
{
    std::vector<double> heights;
    for (const BimElement& e : bim.elements)
        if (e.elementClass == ElementClass::Wall || e.elementClass == ElementClass::Column ||
            e.elementClass == ElementClass::Door)
            heights.push_back(e.high_m - e.low_m);
    if (heights.empty())
        return;
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::nth_element(heights.begin(), middle, heights.end());
    if (*middle >= kLowest_m && *middle <= kHighest_m)
        return;
    char height[32];
    std::snprintf(height, sizeof height, "%.3g m", *middle);
    throw Error(ErrorCode::BadFile, "can't use " + bim.file + ": its walls, columns and doors are typically " + height +
                                        " high, so its length unit is wrong, probably by 1000; correct the unit in the "
                                        "file");
}

}  // namespace s2b::validation

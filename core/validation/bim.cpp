// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/bim.h"

#include "core/base/error.h"
#include "core/base/nearest_name.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <string_view>

namespace s2b::validation
{

namespace
{

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
        bim.storeys[i].isSurveyed = bim.storeys[i].isSurveyed && isChosen[i];
}

}  // namespace s2b::validation

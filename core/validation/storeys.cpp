// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/storeys.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace s2b::validation
{

namespace
{

constexpr double kHalfStorey_m = 1.2;
constexpr double kSameFloor_m = 0.5;  ///< a floor a little below a storey's elevation is that storey's

}  // namespace

std::vector<StoreyError> compareStoreys(const Bim& truth, const Bim& result)
{
    const double shift = result.origin.z() - truth.origin.z();
    std::vector<StoreyError> errors;
    for (std::size_t i = 0; i < truth.storeys.size(); ++i)
    {
        if (!truth.storeys[i].isSurveyed)
            continue;
        StoreyError error{static_cast<int>(i), -1, std::numeric_limits<double>::infinity()};
        for (std::size_t j = 0; j < result.storeys.size(); ++j)
        {
            const double d = std::abs(result.storeys[j].elevation_m + shift - truth.storeys[i].elevation_m);
            if (d >= error.error_m)
                continue;
            error.error_m = d;
            error.result = d <= kHalfStorey_m ? static_cast<int>(j) : -1;
        }
        errors.push_back(error);
    }
    return errors;
}

int extraStoreys(const Bim& truth, const Bim& result)
{
    const auto surveyed =
        std::count_if(truth.storeys.begin(), truth.storeys.end(), [](const BimStorey& s) { return s.isSurveyed; });
    const double shift = result.origin.z() - truth.origin.z();
    const auto found = std::count_if(result.storeys.begin(), result.storeys.end(),
                                     [&](const BimStorey& s)
                                     {
                                         const int at = storeyAt(truth, s.elevation_m + shift + kSameFloor_m);
                                         return at < 0 || truth.storeys[static_cast<std::size_t>(at)].isChosen;
                                     });
    return std::max(0, static_cast<int>(found - surveyed));
}

}  // namespace s2b::validation

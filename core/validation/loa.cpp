// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/loa.h"

#include "core/base/error.h"

#include <cmath>
#include <string>

namespace s2b::validation
{

namespace
{

[[noreturn]] void fail(const std::string& message)
{
    throw Error(ErrorCode::BadParameter, message);
}

bool isShare(double value)
{
    return value >= 0.0 && value <= 1.0;
}

}  // namespace

LoaBand bandOf(double deviation_m, const ValidationParams& params)
{
    constexpr LoaBand kBands[] = {LoaBand::Loa10, LoaBand::Loa20, LoaBand::Loa30, LoaBand::Loa40, LoaBand::Loa50};
    LoaBand best = LoaBand::Beyond;
    for (std::size_t i = 0; i < params.loaLimit_m.size() && deviation_m <= params.loaLimit_m[i]; ++i)
        best = kBands[i];
    return best;
}

bool keepsTolerance(double deviation_m, const ValidationParams& params)
{
    return deviation_m <= params.loaLimit_m[static_cast<std::size_t>(params.tolerance / 10 - 1)];
}

void checkParams(const ValidationParams& params)
{
    if (params.tolerance < 10 || params.tolerance > 50 || params.tolerance % 10 != 0)
        fail("validation.tolerance is " + std::to_string(params.tolerance) + "; it must be 10, 20, 30, 40 or 50");
    if (!(params.deviationRange_m > 0.0) || params.deviationRange_m > 10.0)
        fail("validation.deviationRange is " + std::to_string(params.deviationRange_m) +
             " m; it must be above 0 and at most 10");
    if (!isShare(params.minimumCoverage) || !isShare(params.minimumMatch))
        fail("validation.minimumCoverage and validation.minimumMatch must be from 0 to 1");
    for (std::size_t i = 0; i < params.loaLimit_m.size(); ++i)
        if (!(params.loaLimit_m[i] > 0.0) || (i > 0 && params.loaLimit_m[i] >= params.loaLimit_m[i - 1]))
            fail("the limits of the levels of accuracy must fall from LOA10 to LOA50 and be above 0");
}

}  // namespace s2b::validation

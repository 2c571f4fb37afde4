// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/loa.h"

namespace s2b::validation
{

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

}  // namespace s2b::validation

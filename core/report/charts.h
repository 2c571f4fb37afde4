// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/scene.h"

#include <string>

namespace s2b::report
{

/// Histogram of signed distances over [-range, range] with the tolerance's limits.
[[nodiscard]] std::string histogram(const Scene& scene, const validation::CloudDeviation& deviation,
                                    const validation::ValidationParams& params);

/// A bar of the shares of the LOA bands: from LOA50 on the left to elements beyond LOA10 and without data.
[[nodiscard]] std::string bandBar(const std::map<validation::LoaBand, int>& counts);

/// What the colours of bandBar() mean.
[[nodiscard]] std::string bandLegend(const validation::ValidationParams& params);

}  // namespace s2b::report

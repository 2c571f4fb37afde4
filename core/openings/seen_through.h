// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/sightlines.h"
#include "core/model/building.h"

#include <vector>

namespace s2b
{

/// Where rays passed through a wall, as squares of its middle plane: what they passed through is open, or glass.
class SeenThrough
{
public:
    /// Nothing was seen through: for clouds without stations.
    SeenThrough() = default;
    SeenThrough(const Wall& wall, const Sightlines& sightlines);

    [[nodiscard]] bool isKnown() const noexcept { return m_columns > 0; }
    /// Share of a part of the wall (along the axis, and up from its base) within 10 cm of which a ray passed. Of what
    /// lies behind a hole a thinned cloud keeps few points of one station, and they are spread.
    [[nodiscard]] double share(double begin, double end, double bottom, double top) const;

private:
    static constexpr double kStep_m = 0.05;
    [[nodiscard]] bool isNear(int x, int y) const;

    double m_begin = 0;
    int m_columns = 0, m_rows = 0;
    std::vector<char> m_passed;
};

}  // namespace s2b

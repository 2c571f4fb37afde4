// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/wall_top.h"

namespace s2b
{

double topAt(const Wall& wall, double s_m)
{
    constexpr double kStep_m = 1e-9;  // where two heights meet in one place the second one counts
    const auto& profile = wall.topProfile;
    if (profile.empty())
        return wall.base_m + wall.height.value_m;
    if (s_m <= profile.front().x())
        return profile.front().y();
    for (std::size_t i = 1; i < profile.size(); ++i)
    {
        const Eigen::Vector2d &a = profile[i - 1], &b = profile[i];
        if (s_m > b.x())
            continue;
        const double t = b.x() - a.x() < kStep_m ? 1.0 : (s_m - a.x()) / (b.x() - a.x());
        return a.y() + t * (b.y() - a.y());
    }
    return profile.back().y();
}

}  // namespace s2b

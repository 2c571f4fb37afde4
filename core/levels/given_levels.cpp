// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/levels/given_levels.h"

namespace s2b
{

std::vector<Level> levelsOf(const std::vector<Storey>& storeys, const std::vector<Level>& found)
{
    constexpr double kSame_m = 0.05;  // a height that was set this near to a found one means it
    std::vector<Level> levels;
    for (std::size_t i = 0; i < storeys.size(); ++i)
    {
        const Storey& storey = storeys[i];
        Level level;
        level.floor_m = storey.elevation_m;
        level.ceiling_m = storey.elevation_m + storey.height.value_m;
        level.ceilingSeen = storey.height.provenance != Provenance::Assumed;
        const auto same = std::find_if(found.begin(), found.end(), [&](const Level& f)
                                       { return std::abs(f.floor_m - storey.elevation_m) < kSame_m; });
        if (same != found.end())
        {
            level.floorArea_m2 = same->floorArea_m2;
            level.floorRms_m = same->floorRms_m;
            if (same->ceilingSeen && level.ceilingSeen)
                level.ceilings = same->ceilings;
            if (std::abs(same->ceiling_m - level.ceiling_m) < kSame_m)
                level.ceilingArea_m2 = same->ceilingArea_m2;
            else
                std::erase_if(level.ceilings, [&](double c) { return c > level.ceiling_m + kSame_m; });
        }
        if (level.ceilingSeen && !level.isCeiling(level.ceiling_m, kSame_m))
        {
            level.ceilings.push_back(level.ceiling_m);
            std::sort(level.ceilings.begin(), level.ceilings.end());
        }
        if (i + 1 < storeys.size() && level.ceilingSeen)
        {
            const double next = storeys[i + 1].elevation_m;
            std::erase_if(level.ceilings, [&](double c) { return c > level.ceiling_m && c > next - 0.03; });
            if (next > level.ceiling_m)
                level.ceilingLimit_m = (level.highestCeiling_m() + next) / 2;
        }
        levels.push_back(std::move(level));
    }
    return levels;
}

}  // namespace s2b

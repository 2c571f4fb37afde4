// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/levels/height_histogram.h"

#include <tuple>

namespace s2b
{

std::vector<HeightPeak> peaksOf(const HeightHistogram& histogram, double apart)
{
    const std::vector<double> s = histogram.smoothed(0.04);
    std::vector<HeightPeak> all;
    for (std::size_t i = 0; i < s.size(); ++i)
        if (s[i] > 0)
            all.push_back({histogram.z(i), s[i]});
    std::sort(all.begin(), all.end(),
              [](const HeightPeak& a, const HeightPeak& b) { return std::tie(b.area, a.z) < std::tie(a.area, b.z); });
    std::vector<HeightPeak> peaks;
    for (const HeightPeak& p : all)
        if (std::none_of(peaks.begin(), peaks.end(), [&](const HeightPeak& q) { return std::abs(p.z - q.z) < apart; }))
            peaks.push_back(p);
    return peaks;
}

double medianNear(std::vector<double> values, double centre, double reach)
{
    std::erase_if(values, [&](double v) { return std::abs(v - centre) > reach; });
    if (values.empty())
        return centre;
    const auto mid = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), mid, values.end());
    return *mid;
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace s2b
{

/// Area over height, one bin a `bin`; peaks are read off a smoothed copy.
class HeightHistogram
{
public:
    HeightHistogram(double low, double high, double bin)
        : m_low(low),
          m_bin(bin),
          m_area(static_cast<std::size_t>(std::max(1.0, std::ceil((high - low) / bin) + 3)), 0.0)
    {
    }
    void add(double z, double area)
    {
        const double i = (z - m_low) / m_bin + 1;
        if (i >= 0 && i < static_cast<double>(m_area.size()))
            m_area[static_cast<std::size_t>(i)] += area;
    }
    [[nodiscard]] double z(std::size_t i) const { return m_low + (static_cast<double>(i) - 0.5) * m_bin; }
    [[nodiscard]] double areaNear(double height, double reach) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < m_area.size(); ++i)
            if (std::abs(z(i) - height) <= reach)
                sum += m_area[i];
        return sum;
    }
    /// Area within `reach` of each bin.
    [[nodiscard]] std::vector<double> smoothed(double reach) const
    {
        const auto r = static_cast<std::ptrdiff_t>(std::lround(reach / m_bin));
        std::vector<double> s(m_area.size(), 0.0);
        for (std::size_t i = 0; i < s.size(); ++i)
            for (std::ptrdiff_t k = -r; k <= r; ++k)
            {
                const std::ptrdiff_t j = static_cast<std::ptrdiff_t>(i) + k;
                if (j >= 0 && j < static_cast<std::ptrdiff_t>(m_area.size()))
                    s[i] += m_area[static_cast<std::size_t>(j)];
            }
        return s;
    }

private:
    double m_low, m_bin;
    std::vector<double> m_area;
};

struct HeightPeak
{
    double z = 0, area = 0;
};

/// Local maxima, the largest first; a smaller one within `apart` of a larger one is part of it.
[[nodiscard]] std::vector<HeightPeak> peaksOf(const HeightHistogram& histogram, double apart);

/// Median of the values within `reach` of `centre`.
[[nodiscard]] double medianNear(std::vector<double> values, double centre, double reach);

}  // namespace s2b

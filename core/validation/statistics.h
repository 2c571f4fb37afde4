// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/validation/validation.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace s2b::validation
{

/// The middle value, or the mean of the two middle ones; nothing of nothing.
[[nodiscard]] inline std::optional<double> medianOf(std::vector<double> values)
{
    if (values.empty())
        return std::nullopt;
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

[[nodiscard]] inline std::optional<double> meanOf(const std::vector<double>& values)
{
    if (values.empty())
        return std::nullopt;
    double sum = 0.0;
    for (const double v : values)
        sum += v;
    return sum / static_cast<double>(values.size());
}

/// Precision, recall and their harmonic mean; 0 where there is nothing to divide by.
[[nodiscard]] inline Rates ratesOf(std::size_t correct, std::size_t truth, std::size_t result)
{
    Rates rates;
    const auto count = static_cast<double>(correct);
    rates.precision = result == 0 ? 0.0 : count / static_cast<double>(result);
    rates.recall = truth == 0 ? 0.0 : count / static_cast<double>(truth);
    const double sum = rates.precision + rates.recall;
    rates.f1 = sum > 0.0 ? 2.0 * rates.precision * rates.recall / sum : 0.0;
    return rates;
}

}  // namespace s2b::validation

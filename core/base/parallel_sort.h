// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"

#include <algorithm>
#include <vector>

namespace s2b
{

/// std::sort in quarters on the context's threads, which are merged then. Equal values come in an order that depends on
/// the values alone, never on the number of threads.
template <class T, class Less>
void parallelSort(std::vector<T>& values, const Context& context, Less less)
{
    constexpr std::size_t worthwhile = 1u << 16, parts = 4;
    if (values.size() < worthwhile)
    {
        std::sort(values.begin(), values.end(), less);
        return;
    }
    const auto part = [&](std::size_t k)
    { return values.begin() + static_cast<std::ptrdiff_t>(k * values.size() / parts); };
    parallelChunks(parts, 1, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t k = begin; k < end; ++k)
                           std::sort(part(k), part(k + 1), less);
                   });
    parallelChunks(parts / 2, 1, context,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t k = begin; k < end; ++k)
                           std::inplace_merge(part(2 * k), part(2 * k + 1), part(2 * k + 2), less);
                   });
    std::inplace_merge(values.begin(), part(parts / 2), values.end(), less);
}

}  // namespace s2b

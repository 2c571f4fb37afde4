// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel_sort.h"
#include "core/base/random.h"

#include <gtest/gtest.h>

#include <utility>

namespace s2b
{
namespace
{

TEST(ParallelSort, SortsAsStdSortDoesForAnyNumberOfThreads)
{
    for (const std::uint32_t count : {0u, 1u, 1000u, 65536u, 300001u})
    {
        std::vector<std::uint64_t> values;
        for (std::uint32_t i = 0; i < count; ++i)
            values.push_back(randomBits(i, 7, 11) % (count + 1));
        std::vector<std::uint64_t> sorted = values;
        std::sort(sorted.begin(), sorted.end());
        for (const unsigned threads : {1u, 3u})
        {
            Context context;
            context.threads = threads;
            std::vector<std::uint64_t> copy = values;
            parallelSort(copy, context, std::less<>());
            EXPECT_EQ(copy, sorted) << count << " values, " << threads << " threads";
        }
    }
}

/// Which of two equal values comes first is visible in what they carry.
TEST(ParallelSort, OrdersEqualValuesAlikeForAnyNumberOfThreads)
{
    std::vector<std::pair<std::uint64_t, std::uint32_t>> values;
    for (std::uint32_t i = 0; i < 200000; ++i)
        values.emplace_back(randomBits(i, 1, 2) % 50, i);
    const auto less = [](const auto& a, const auto& b) { return a.first < b.first; };
    Context one, many;
    one.threads = 1, many.threads = 4;
    auto a = values, b = values;
    parallelSort(a, one, less);
    parallelSort(b, many, less);
    EXPECT_EQ(a, b);
}

}  // namespace
}  // namespace s2b

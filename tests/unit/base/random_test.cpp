// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace s2b
{
namespace
{

TEST(RandomBits, DifferForEachSeedStreamAndCounter)
{
    std::set<std::uint64_t> seen;
    for (std::uint64_t seed = 0; seed < 10; ++seed)
        for (std::uint64_t stream = 0; stream < 10; ++stream)
            for (std::uint64_t counter = 0; counter < 10; ++counter)
                seen.insert(randomBits(seed, stream, counter));
    EXPECT_EQ(seen.size(), 1000u);
}

TEST(RandomShare, FillsTheUnitIntervalEvenly)
{
    std::array<int, 10> histogram{};
    for (std::uint64_t i = 0; i < 100000; ++i)
    {
        const double share = randomShare(1, 2, i);
        ASSERT_GE(share, 0.0);
        ASSERT_LT(share, 1.0);
        ++histogram[static_cast<std::size_t>(share * 10)];
    }
    // Ten bins of 10 000: a standard deviation of 95, so five of them.
    for (const int n : histogram)
        EXPECT_NEAR(n, 10000, 475);
}

}  // namespace
}  // namespace s2b

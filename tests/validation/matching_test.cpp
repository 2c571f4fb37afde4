// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/matching.h"

#include "core/base/random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace s2b
{
namespace
{

using ::testing::ElementsAre;
using ::testing::Pair;
using validation::assign;
using validation::Candidate;

TEST(Matching, TakesTheBestSumNotTheBestPair)
{
    // The best pair alone would leave the second row with nothing: 0.9 against 0.8 + 0.7.
    EXPECT_THAT(assign({{0, 0, 0.9}, {0, 1, 0.8}, {1, 0, 0.7}}), ElementsAre(Pair(0, 1), Pair(1, 0)));
}

TEST(Matching, NeverAssignsWhatIsNoCandidate)
{
    EXPECT_THAT(assign({{0, 0, 0.5}, {1, 0, 0.4}, {3, 7, 0.1}}), ElementsAre(Pair(0, 0), Pair(3, 7)));
    EXPECT_TRUE(assign({}).empty());
}

TEST(Matching, EqualsTheBestOfAllPermutations)
{
    for (std::uint64_t trial = 0; trial < 200; ++trial)
    {
        std::vector<Candidate> candidates;
        std::map<std::pair<int, int>, double> worth;
        for (int r = 0; r < 5; ++r)
            for (int c = 0; c < 6; ++c)
                if (randomShare(trial, 1, static_cast<std::uint64_t>(6 * r + c)) < 0.5)
                {
                    const double w = 0.01 + randomShare(trial, 2, static_cast<std::uint64_t>(6 * r + c));
                    candidates.push_back({r, c, w});
                    worth[{r, c}] = w;
                }
        std::vector<int> columns(6);
        std::iota(columns.begin(), columns.end(), 0);
        double best = 0.0;
        do
        {
            double sum = 0.0;
            for (int r = 0; r < 5; ++r)
                if (const auto at = worth.find({r, columns[static_cast<std::size_t>(r)]}); at != worth.end())
                    sum += at->second;
            best = std::max(best, sum);
        } while (std::ranges::next_permutation(columns).found);
        double sum = 0.0;
        for (const auto& pair : assign(candidates))
            sum += worth.at(pair);
        EXPECT_NEAR(sum, best, 1e-7) << "worths are compared in steps of 1e-9";
    }
}

}  // namespace
}  // namespace s2b

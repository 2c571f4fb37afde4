// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace s2b
{
namespace
{

using Chunks = std::set<std::pair<std::size_t, std::size_t>>;

Chunks chunksOf(std::size_t count, std::size_t chunk, unsigned threads)
{
    Chunks chunks;
    std::mutex mutex;
    parallelChunks(count, chunk, threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                       const std::lock_guard lock(mutex);
                       EXPECT_TRUE(chunks.emplace(begin, end).second) << "chunk " << begin << " came twice";
                   });
    return chunks;
}

TEST(ParallelChunks, CutsTheSameChunksForAnyNumberOfThreads)
{
    const Chunks expected{{0, 100}, {100, 200}, {200, 250}};
    for (const unsigned threads : {0u, 1u, 2u, 7u})
        EXPECT_EQ(chunksOf(250, 100, threads), expected) << threads << " threads";
}

TEST(ParallelChunks, VisitsEveryIndexOnce)
{
    std::vector<std::atomic<int>> visits(10007);
    parallelChunks(visits.size(), 64, 0,
                   [&](std::size_t begin, std::size_t end)
                   {
                       for (std::size_t i = begin; i < end; ++i)
                           ++visits[i];
                   });
    for (const std::atomic<int>& v : visits)
        ASSERT_EQ(v, 1);
}

TEST(ParallelChunks, CallsNothingForNoWork)
{
    EXPECT_TRUE(chunksOf(0, 100, 0).empty());
    EXPECT_EQ(chunksOf(1, 100, 0), (Chunks{{0, 1}}));
}

TEST(ParallelChunks, TakesAChunkOfZeroForOne)
{
    EXPECT_EQ(chunksOf(2, 0, 1), (Chunks{{0, 1}, {1, 2}}));
}

TEST(ParallelChunks, RethrowsWhatABodyThrows)
{
    for (const unsigned threads : {1u, 2u})
        EXPECT_THROW(parallelChunks(1000, 10, threads,
                                    [](std::size_t begin, std::size_t)
                                    {
                                        if (begin == 500)
                                            throw std::runtime_error("body");
                                    }),
                     std::runtime_error)
            << threads << " threads";
}

}  // namespace
}  // namespace s2b

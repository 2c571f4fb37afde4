// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>

namespace s2b
{

void parallelChunks(std::size_t count, std::size_t chunk, unsigned threads,
                    const std::function<void(std::size_t begin, std::size_t end)>& body)
{
    if (count == 0)
        return;
    chunk = std::max<std::size_t>(chunk, 1);
    const std::size_t chunks = (count + chunk - 1) / chunk;
    const auto run = [&](std::size_t c) { body(c * chunk, std::min(count, (c + 1) * chunk)); };
    if (chunks == 1 || threads == 1)
    {
        for (std::size_t c = 0; c < chunks; ++c)
            run(c);
        return;
    }
    tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads));
    arena.execute(
        [&]
        {
            tbb::parallel_for(
                tbb::blocked_range<std::size_t>(0, chunks, 1),
                [&](const tbb::blocked_range<std::size_t>& r)
                {
                    for (std::size_t c = r.begin(); c != r.end(); ++c)
                        run(c);
                },
                tbb::simple_partitioner());
        });
}

void parallelChunks(std::size_t count, std::size_t chunk, const Context& context,
                    const std::function<void(std::size_t begin, std::size_t end)>& body)
{
    parallelChunks(count, chunk, context.threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                       context.checkCancelled();
                       body(begin, end);
                   });
}

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/process_times.h"

#include <sys/resource.h>

#include <chrono>

namespace s2b::bench
{

Times now()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t)
    { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
    return {std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(),
            seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

}  // namespace s2b::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/process_memory.h"

#include <fstream>
#include <string>

namespace s2b::bench
{
namespace
{

/// A line "VmHWM:  123456 kB" of the process' status, in bytes; 0 where there is none.
double statusValue_b(const std::string& key)
{
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
    {
        if (word != key)
            continue;
        double kilobytes = 0.0;
        status >> kilobytes;
        return 1024.0 * kilobytes;
    }
    return 0.0;
}

}  // namespace

MemoryMeter::MemoryMeter()
{
    std::ofstream("/proc/self/clear_refs") << "5";  // the mark of the peak starts anew
    m_before_b = statusValue_b("VmRSS:");
}

double MemoryMeter::peak_b() const
{
    return statusValue_b("VmHWM:");
}

}  // namespace s2b::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace s2b::bench
{

struct Times
{
    double wall_s = 0.0;
    double cpu_s = 0.0;  ///< of all threads

    Times operator-(const Times& o) const { return {wall_s - o.wall_s, cpu_s - o.cpu_s}; }
    Times& operator+=(const Times& o)
    {
        wall_s += o.wall_s;
        cpu_s += o.cpu_s;
        return *this;
    }
};

/// Of this process; only differences mean something.
[[nodiscard]] Times now();

}  // namespace s2b::bench

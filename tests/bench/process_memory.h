// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace s2b::bench
{

/// What the process takes in memory from here on: peak_b() - before_b() is what the work in between needed.
class MemoryMeter
{
public:
    MemoryMeter();
    [[nodiscard]] double before_b() const { return m_before_b; }  ///< resident at the start
    [[nodiscard]] double peak_b() const;                          ///< the most that was resident since then

private:
    double m_before_b = 0.0;
};

}  // namespace s2b::bench

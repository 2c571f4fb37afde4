// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <vector>

namespace s2b::sim
{

/// A small stream of random numbers that is fixed by its key alone (splitmix64 in counter mode): the draws of one room,
/// one door or one ray do not depend on what was drawn before it, nor on which thread draws.
class Random
{
public:
    /// @param key  seed, then whatever tells this stream from others (purpose, storey, index ...).
    Random(std::initializer_list<std::uint64_t> key)
    {
        for (const std::uint64_t k : key)
            m_state = mix(m_state ^ (k + 0x9e3779b97f4a7c15ULL));
    }

    std::uint64_t next() { return mix(m_state += 0x9e3779b97f4a7c15ULL); }
    /// In [0, 1).
    double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    bool chance(double probability) { return uniform() < probability; }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(uniform() * static_cast<double>(count)); }
    template <class T>
    const T& pick(const std::vector<T>& values)
    {
        return values[below(values.size())];
    }
    /// Standard normal (Box-Muller).
    double gaussian()
    {
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        return radius * std::cos(2.0 * std::numbers::pi * uniform());
    }

    static std::uint64_t mix(std::uint64_t x)
    {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
        return x ^ (x >> 31);
    }

private:
    std::uint64_t m_state = 0;
};

}  // namespace s2b::sim

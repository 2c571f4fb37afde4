// SPDX-License-Identifier: GPL-3.0-or-later
/// Random draws without a state: each one is a function of what it is for, so that neither the order of the draws nor
/// the number of threads changes a result.
#pragma once

#include <cstdint>
#include <initializer_list>

namespace s2b
{

/// 64 well mixed bits of three numbers (the finaliser of SplitMix64, Steele et al. 2014, applied to each in turn).
[[nodiscard]] constexpr std::uint64_t randomBits(std::uint64_t seed, std::uint64_t stream,
                                                 std::uint64_t counter) noexcept
{
    std::uint64_t mixed = 0;
    for (const std::uint64_t part : {seed, stream, counter})
    {
        mixed += 0x9e3779b97f4a7c15u + part;
        mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9u;
        mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebu;
        mixed ^= mixed >> 31;
    }
    return mixed;
}

/// A number in [0, 1), of 53 random bits.
[[nodiscard]] constexpr double randomShare(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter) noexcept
{
    return static_cast<double>(randomBits(seed, stream, counter) >> 11) * 0x1.0p-53;
}

}  // namespace s2b

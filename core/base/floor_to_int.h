// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace s2b
{

/// Largest whole number that is not above v. Without the call that std::floor is on processors of the baseline.
/// @pre |v| < 2^31.
[[nodiscard]] inline int floorToInt(double v)
{
    const int towardsZero = static_cast<int>(v);
    return towardsZero - (static_cast<double>(towardsZero) > v ? 1 : 0);
}

}  // namespace s2b

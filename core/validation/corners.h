// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/validation/prism.h"
#include "core/validation/validation.h"

#include <map>
#include <vector>

namespace s2b::validation
{

/// How many of the eight corners of the boxes around the elements are found within 5, 10 and 20 cm: the 3D track of the
/// CV4AEC challenge (Armeni et al., CVPR 2024; github.com/GradientSpaces/cv4aec-challenge, 3d_matching_eval).
///
/// Corners are assigned once, so that the sum of their distances is the smallest, a distance above 20 cm counting as
/// 20 cm. A result's lower and upper corners are drawn to the heights that the survey saw of the truth.
///
/// Differs from the challenge's script, which takes the difference in x alone for the distance, puts the upper corners
/// at half of the height and widens walls that are not parallel to x or y in a wrong direction.
/// @return by distance in cm: 5, 10, 20.
[[nodiscard]] std::map<int, Rates> cornerRates(const std::vector<Prism>& truth, const std::vector<Prism>& result);

}  // namespace s2b::validation

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/point_cloud.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace s2b
{

/// Reads a LAS or LAZ file. The origin is the file's first point, rounded to 100 m where coordinates are large.
/// Classification codes are taken as values of Label. @throws Error{BadFile}.
/// @param colours  where not null: red, green, blue of each point.
/// @param sources  where not null: point source id of each point.
[[nodiscard]] PointCloud readLaz(const std::string& path, std::vector<std::array<std::uint8_t, 3>>* colours = nullptr,
                                 std::vector<std::uint16_t>* sources = nullptr);

}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloud/point_cloud.h"

#include <string>

namespace s2b
{

/// Reads a LAS or LAZ file. The origin is the file's first point, rounded to 100 m where coordinates are large.
/// Classification codes are taken as values of Label. @throws Error{BadFile}.
[[nodiscard]] PointCloud readLaz(const std::string& path);

}  // namespace s2b

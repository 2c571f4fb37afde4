// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/scene.h"

#include <string>

namespace s2b::report
{

/// elements.csv: RFC 4180, UTF-8, a header line, one row per element, worst first; an empty field is "no value".
[[nodiscard]] std::string makeCsv(const Scene& scene);

}  // namespace s2b::report

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/scene.h"

#include <string>

namespace s2b::report
{

/// report.json (docs/validation_report.md, docs/validation_report.schema.json).
[[nodiscard]] std::string makeJson(const ReportInput& input, const Scene& scene);

}  // namespace s2b::report

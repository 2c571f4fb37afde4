// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/validation/validation.h"

#include <string>
#include <utility>
#include <vector>

namespace s2b::report
{

/// What a report is made from. Everything is borrowed.
struct ReportInput
{
    const validation::Bim* truth = nullptr;
    const validation::Bim* result = nullptr;
    const validation::Validation* validation = nullptr;
    const validation::ValidationParams* params = nullptr;
    const CloudView* cloud = nullptr;    ///< may be null: no heat maps then
    const Building* building = nullptr;  ///< may be null: its evidence and diagnostics, when it was reconstructed
    std::string cloudName;
    std::string softwareVersion;
    std::vector<std::pair<std::string, std::string>> parameters;  ///< name, value: of the reconstruction
};

/// Writes report.html, report.json, elements.csv and issues.bcf into `folder`, which is made if need be. Each file is
/// written beside its place and renamed, so that an old report is whole until the new one is.
/// @throws Error{CannotWrite} that names the file; Cancelled. The same input gives the same bytes.
void writeReport(const ReportInput& input, const std::string& folder, const Context& context);

}  // namespace s2b::report

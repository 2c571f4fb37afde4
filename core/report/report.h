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
    const validation::Bim* truth = nullptr;  ///< may be null: one BIM against the points
    const validation::Bim* result = nullptr;
    const validation::Validation* validation = nullptr;
    const validation::ValidationParams* params = nullptr;
    const CloudView* cloud = nullptr;    ///< may be null: no heat maps then
    const Building* building = nullptr;  ///< may be null: its evidence and diagnostics, when it was reconstructed
    std::string cloudName;
    std::string softwareVersion;
    std::vector<std::pair<std::string, std::string>> parameters;  ///< name, value: of the reconstruction
    /// xs:dateTime of the issues. Part of the bytes, so the caller's to choose; the page shows it unless it is this
    /// one.
    std::string timestamp = "1970-01-01T00:00:00Z";
};

/// Writes report.html, report.json, elements.csv and issues.bcf into `folder`, which is made if need be (what stands in
/// them: docs/validation_report.md). All files are written beside their places first and renamed then, so that an old
/// report is whole until the new one is.
///
/// @pre result, validation and params are not null.
/// @throws Error{CannotWrite} that names the file; Cancelled (asked once per 2^16 points and per picture). Nothing is
///         left then. The same input gives the same bytes; files are named without their folders.
/// Cost: one pass over the points per storey, some 0.1 s for 10 million, and some 20 ms per element out of tolerance.
void writeReport(const ReportInput& input, const std::string& folder, const Context& context);

}  // namespace s2b::report

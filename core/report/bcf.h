// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/rasters.h"
#include "core/report/scene.h"

#include <map>
#include <string>

namespace s2b::report
{

/// issues.bcf: BCF 2.1 of buildingSMART, one topic per row that is out of tolerance, worst first. Topics, viewpoints
/// and their components are named by GUIDs that follow from the files' names and the element's id: the same issue keeps
/// its GUID from one report to the next.
/// @param snapshots  PNG by index in Scene::rows, of all rows that are out of tolerance
[[nodiscard]] std::string makeBcf(const ReportInput& input, const Scene& scene,
                                  const std::map<std::size_t, std::string>& snapshots);

/// A version 5 UUID (RFC 9562), "6ba7b810-9dad-11d1-80b4-00c04fd430c8".
[[nodiscard]] std::string nameUuid(const std::string& name);

}  // namespace s2b::report

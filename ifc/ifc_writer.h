// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace s2b::ifc
{

struct WriteOptions
{
    std::string schema = "IFC4";              ///< IFC4 or IFC4X3_ADD2
    std::string projectName = "Scan to BIM";  ///< UTF-8; part of the GUIDs' name space
    std::string timestamp =
        "1970-01-01T00:00:00";  ///< of the file header; part of the bytes, so the caller's to choose
    std::optional<int> epsg;    ///< projected coordinate system of the world coordinates: gives IfcMapConversion
    std::vector<std::pair<std::string, std::string>> parameters;  ///< recorded with the project: name, value
    std::map<ElementId, std::string> names;  ///< that people gave to elements; the others are named by class and id
    std::set<ElementId> placedByHand;        ///< elements that people moved or added: their evidence says so
};

/// Writes the building as IFC (D3.6, 5; docs/ifc.md). Written beside `path` and renamed: never a partial file, and an
/// existing file stays as it is on any error.
///
/// The same building and options give the same bytes.
/// @throws Error{CannotWrite} when the file can't be written, Error{BadParameter} for another schema, Error{Internal}
///         when the building holds a value that can't be written (NaN, no length); nothing is left then.
void writeIfc(const Building& building, const std::string& path, const WriteOptions& options);

}  // namespace s2b::ifc

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"
#include "ifc/ifc_writer.h"

namespace s2b::ifc
{

/// Everything that must hold before a file is written: finite numbers, positive sizes, ids that are unique and exist,
/// outlines with an area, names in UTF-8.
/// @throws Error{Internal} for the building's, Error{BadParameter} for the options' first fault, naming the element.
void checkWritable(const Building& building, const WriteOptions& options);

}  // namespace s2b::ifc

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ifc/properties.h"

#include <cmath>
#include <string>

namespace s2b::ifc
{

/// "240 mm"
[[nodiscard]] inline std::string millimetres(double length_m)
{
    return std::to_string(std::lround(1000.0 * length_m)) + " mm";
}

/// "900 x 2100 mm"
[[nodiscard]] inline std::string millimetres(double a_m, double b_m)
{
    return std::to_string(std::lround(1000.0 * a_m)) + " x " + millimetres(b_m);
}

/// Status of every Pset_*Common: what a scanner saw exists.
inline const Property kExisting = {"Status", {"IfcLabel", std::string("EXISTING")}, true};

}  // namespace s2b::ifc

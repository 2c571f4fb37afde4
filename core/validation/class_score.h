// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/validation/validation.h"

#include <vector>

namespace s2b::validation
{

/// The elements of one class, matched and scored; definitions in docs/validation.md.
struct ClassComparison
{
    ClassScore score;
    std::vector<ElementResult> truth;   ///< one per truth element of the class, in the order of the truth
    std::vector<ElementResult> others;  ///< result elements of the class without a partner, in their order
};

/// @param truth  elements without a Visibility count; elements of storeys that are not surveyed don't.
[[nodiscard]] ClassComparison compareClass(ElementClass elementClass, const Bim& truth, const Bim& result,
                                           const ValidationParams& params);

/// Whether a truth element is asked for.
[[nodiscard]] bool isAskedFor(const Bim& truth, const BimElement& element);

}  // namespace s2b::validation

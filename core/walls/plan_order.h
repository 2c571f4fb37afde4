// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floor_to_int.h"
#include "core/base/parallel_sort.h"
#include "core/cloud/surface_cells.h"

#include <cstdint>
#include <vector>

namespace s2b
{

/// A cell by its place in the plan: cells above each other have the same one.
struct PlanEntry
{
    std::uint64_t place = 0;  ///< by group, then y, then x
    std::uint32_t cell = 0;

    [[nodiscard]] std::uint32_t group() const { return static_cast<std::uint32_t>(place >> 56); }
};

/// @param group  less than 256
[[nodiscard]] inline PlanEntry planEntry(const SurfaceCells& cells, std::uint32_t cell, std::uint32_t group = 0)
{
    const auto along = [&](int axis)
    {
        const int i = floorToInt(static_cast<double>(cells.cells[cell].position[axis]) / cells.size_m);
        return static_cast<std::uint64_t>(i + (1 << 27)) & ((1u << 28) - 1);
    };
    return {std::uint64_t{group} << 56 | along(1) << 28 | along(0), cell};
}

inline void sortByPlace(std::vector<PlanEntry>& entries, const Context& context)
{
    parallelSort(entries, context, [](const PlanEntry& a, const PlanEntry& b)
                 { return a.place != b.place ? a.place < b.place : a.cell < b.cell; });
}

}  // namespace s2b

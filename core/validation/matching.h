// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

namespace s2b::validation
{

/// A pair that may be matched, and what it is worth.
struct Candidate
{
    int row = 0;
    int column = 0;
    double worth = 0.0;  ///< > 0, below 1e6
};

/// The assignment of rows to columns, each at most once, with the largest sum (Kuhn and Munkres' Hungarian method, of
/// dlib). Pairs that are no candidates are worth nothing and never assigned.
///
/// Worths are compared in steps of 1e-9. Of equally good assignments any, but always the same one.
/// @param candidates  each pair at most once.
/// @return pairs in ascending rows.
/// Cost: O(n^3) in the largest group of rows and columns that candidates connect: elements of one corner of a building,
/// not of the whole.
[[nodiscard]] std::vector<std::pair<int, int>> assign(const std::vector<Candidate>& candidates);

}  // namespace s2b::validation

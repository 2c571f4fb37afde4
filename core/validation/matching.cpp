// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/matching.h"

#include <dlib/matrix.h>
#include <dlib/optimization/max_cost_assignment.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>

namespace s2b::validation
{

namespace
{

constexpr double kStep = 1e-9;  ///< dlib's worths are whole numbers

/// Root of a node in a union-find forest.
int rootOf(std::vector<int>& parent, int node)
{
    while (parent[static_cast<std::size_t>(node)] != node)
    {
        auto& up = parent[static_cast<std::size_t>(node)];
        up = parent[static_cast<std::size_t>(up)];
        node = up;
    }
    return node;
}

/// Dense numbers of the rows or columns of a group.
class Numbers
{
public:
    int of(int name)
    {
        const auto [at, isNew] = m_numbers.try_emplace(name, static_cast<int>(m_names.size()));
        if (isNew)
            m_names.push_back(name);
        return at->second;
    }
    [[nodiscard]] int size() const { return static_cast<int>(m_names.size()); }
    [[nodiscard]] int name(long number) const { return m_names[static_cast<std::size_t>(number)]; }

private:
    std::map<int, int> m_numbers;
    std::vector<int> m_names;
};

void assignGroup(const std::vector<Candidate>& group, std::vector<std::pair<int, int>>& pairs)
{
    Numbers rows;
    Numbers columns;
    for (const Candidate& c : group)
    {
        rows.of(c.row);
        columns.of(c.column);
    }
    const long size = std::max(rows.size(), columns.size());
    dlib::matrix<std::int64_t> worth(size, size);
    worth = 0;
    for (const Candidate& c : group)
        worth(rows.of(c.row), columns.of(c.column)) = std::max<std::int64_t>(1, std::llround(c.worth / kStep));
    const std::vector<long> assigned = dlib::max_cost_assignment(worth);
    for (int r = 0; r < rows.size(); ++r)
    {
        const long c = assigned[static_cast<std::size_t>(r)];
        if (c < columns.size() && worth(r, c) > 0)
            pairs.emplace_back(rows.name(r), columns.name(c));
    }
}

}  // namespace

std::vector<std::pair<int, int>> assign(const std::vector<Candidate>& candidates)
{
    int rowCount = 0;
    int columnCount = 0;
    for (const Candidate& c : candidates)
    {
        rowCount = std::max(rowCount, c.row + 1);
        columnCount = std::max(columnCount, c.column + 1);
    }
    std::vector<int> parent(static_cast<std::size_t>(rowCount) + static_cast<std::size_t>(columnCount));
    std::iota(parent.begin(), parent.end(), 0);
    for (const Candidate& c : candidates)
    {
        const int a = rootOf(parent, c.row);
        const int b = rootOf(parent, rowCount + c.column);
        parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
    std::map<int, std::vector<Candidate>> groups;
    for (const Candidate& c : candidates)
        groups[rootOf(parent, c.row)].push_back(c);

    std::vector<std::pair<int, int>> pairs;
    for (const auto& [root, group] : groups)
        assignGroup(group, pairs);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace s2b::validation

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/simulator/random.h"

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <vector>

namespace s2b::sim
{

/// Which voxels have a point already. Open addressing; 8 bytes a slot, at most 2/3 full.
class VoxelSet
{
public:
    /// @param size_m  of a voxel; 0: every point is new. Voxel indices must fit 21 bits: 1 mm voxels reach 1 km.
    explicit VoxelSet(double size_m) : m_inverse(size_m > 0.0 ? 1.0 / size_m : 0.0), m_slots(1U << 16, kEmpty) {}

    /// @return whether the point is the first one in its voxel.
    bool insert(const Eigen::Vector3f& point)
    {
        if (m_inverse == 0.0)
            return true;
        std::uint64_t key = 0;
        for (int i = 0; i < 3; ++i)
            key = key << 21U |
                  (static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(point[i] * m_inverse)) + (1 << 20)) &
                   0x1fffffU);
        if (3 * m_count >= 2 * m_slots.size())
            grow();
        std::uint64_t& slot = m_slots[find(key)];
        if (slot == key)
            return false;
        slot = key;
        ++m_count;
        return true;
    }

private:
    static constexpr std::uint64_t kEmpty = ~0ULL;

    [[nodiscard]] std::size_t find(std::uint64_t key) const
    {
        std::size_t i = Random::mix(key) & (m_slots.size() - 1);
        while (m_slots[i] != kEmpty && m_slots[i] != key)
            i = (i + 1) & (m_slots.size() - 1);
        return i;
    }
    void grow()
    {
        std::vector<std::uint64_t> old(m_slots.size() * 2, kEmpty);
        old.swap(m_slots);
        for (const std::uint64_t key : old)
            if (key != kEmpty)
                m_slots[find(key)] = key;
    }

    double m_inverse;
    std::vector<std::uint64_t> m_slots;
    std::size_t m_count = 0;
};

}  // namespace s2b::sim

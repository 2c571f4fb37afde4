// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/degrade.h"

#include "core/base/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace s2b
{
namespace
{

enum Stream : std::uint64_t
{
    kFlip = 1,
    kFlipClass,
    kClutterPatch,
    kPatch,
    kBox
};

constexpr double kFlipShare = 0.05;
constexpr std::size_t kFlipClasses = 8;  // unassigned to beam
constexpr double kPatchShare = 0.10;
constexpr double kPatch_m = 0.5;
constexpr double kClutterPatch_m = 1.0;
constexpr std::size_t kBoxes = 25;
constexpr float kBoxHalf_m = 0.6F;
constexpr float kBoxBottom_m = 0.05F;  // the floor itself stays
constexpr float kBoxTop_m = 1.5F;

/// What a segmentation takes a class for.
constexpr std::array<Label, kLabelCount> kTakenFor{Label::Unassigned, Label::Unassigned, Label::Beam, Label::Furniture,
                                                   Label::Wall,       Label::Wall,       Label::Wall, Label::Ceiling,
                                                   Label::Floor,      Label::Ceiling,    Label::Wall};

std::uint64_t patchOf(const Eigen::Vector3f& fromLow, double size_m)
{
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
        key = key << 21 | (static_cast<std::uint64_t>(static_cast<double>(fromLow[axis]) / size_m) & 0x1fffff);
    return key;
}

void confuseLabels(PointCloud& cloud, std::uint64_t seed)
{
    Eigen::Vector3f low = cloud.points.front();
    for (const Eigen::Vector3f& p : cloud.points)
        low = low.cwiseMin(p);
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        Label& label = cloud.labels[i];
        const Eigen::Vector3f p = cloud.points[i] - low;
        if (randomShare(seed, kFlip, i) < kFlipShare)
            label = static_cast<Label>(randomBits(seed, kFlipClass, i) % kFlipClasses);
        if (label == Label::Unassigned && randomBits(seed, kClutterPatch, patchOf(p, kClutterPatch_m)) % 2 == 0)
            label = Label::Wall;
        if (randomShare(seed, kPatch, patchOf(p, kPatch_m)) < kPatchShare)
            label = kTakenFor[static_cast<std::size_t>(label)];
    }
}

/// A height that few floor points lie below: the lowest floor, whatever stray points there are.
float lowestFloor(const PointCloud& cloud)
{
    std::vector<float> heights;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        if (cloud.labels[i] == Label::Floor)
            heights.push_back(cloud.points[i].z());
    }
    if (heights.empty())
        return std::min_element(cloud.points.begin(), cloud.points.end(),
                                [](const auto& a, const auto& b) { return a.z() < b.z(); })
            ->z();
    const auto place = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 20);
    std::nth_element(heights.begin(), place, heights.end());
    return *place;
}

}  // namespace

void degrade(PointCloud& cloud, std::uint64_t seed, std::vector<std::uint16_t>* sources)
{
    if (cloud.points.empty())
        return;
    confuseLabels(cloud, seed);
    const float floor_m = lowestFloor(cloud);
    std::vector<Eigen::Vector2f> boxes;
    for (std::size_t k = 0; k < kBoxes; ++k)
        boxes.emplace_back(cloud.points[randomBits(seed, kBox, k) % cloud.size()].head<2>());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        const Eigen::Vector3f p = cloud.points[i];
        const bool isHidden = p.z() > floor_m + kBoxBottom_m && p.z() < floor_m + kBoxTop_m &&
                              std::any_of(
                                  boxes.begin(), boxes.end(), [&](const Eigen::Vector2f& box)
                                  { return (p.head<2>() - box).cwiseAbs().maxCoeff() < kBoxHalf_m; });
        if (isHidden)
            continue;
        if (sources)
            (*sources)[kept] = (*sources)[i];
        cloud.points[kept] = p;
        cloud.labels[kept++] = cloud.labels[i];
    }
    cloud.points.resize(kept);
    cloud.labels.resize(kept);
    if (sources)
        sources->resize(kept);
}

}  // namespace s2b

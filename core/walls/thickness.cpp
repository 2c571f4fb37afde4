// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/thickness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace s2b
{
namespace
{

bool isSameLine(const WallBody& a, const WallBody& b)
{
    return std::abs(a.t.x() * b.t.y() - a.t.y() * b.t.x()) < 1e-6;
}

void setThickness(WallBody& b, double thickness, ThicknessSource source)
{
    b.thicknessSource = source;
    if (b.lowSeen)
        b.high = b.low + thickness;
    else
        b.low = b.high - thickness;
}

constexpr double kSeenPast = 0.08;  // of the reveal's density: less is stray

/// How far behind the face of a one-sided body opening surfaces (jambs, sills, heads, frames, panes) were seen.
struct Reveal
{
    double most_m = 0.0;  ///< 97 % of them: without labels up to the frame
    double end_m = 0.0;   ///< the little that is seen past the frame, through the glass
};

std::optional<Reveal> revealOf(const WallBody& body, const SurfaceCells& cells, const CellIndex& index,
                               const Level& level, const WallParams& params)
{
    const double face = body.lowSeen ? body.low : body.high, sign = body.lowSeen ? 1.0 : -1.0;
    const Eigen::Vector2d n = body.n();
    constexpr double bin = 0.01, further_m = 0.3;
    std::vector<double> histogram(static_cast<std::size_t>(params.maximumThickness_m / bin) + 2, 0.0);
    double total = 0, beyond = 0;
    const auto look = [&](const SurfaceCell& c)
    {
        const double z = static_cast<double>(c.position.z());
        if (z < level.floor_m + 0.15 || z > level.ceiling_m - 0.1 || c.normal.isZero())
            return;
        const Eigen::Vector2d p = c.position.head<2>().cast<double>();
        const double depth = sign * (n.dot(p) - face), s = body.t.dot(p);
        if (depth < 0.03 || depth > params.maximumThickness_m + further_m || s < body.begin + 0.1 || s > body.end - 0.1)
            return;
        if (cells.labelsAreSure() && c.label != Label::Window &&
            c.label != Label::Wall)  // a leaf may stand open beyond the wall
            return;
        // Surfaces across the wall: jambs, sills, heads; and window frames and panes whatever their direction.
        const double across =
            std::abs(n.x() * static_cast<double>(c.normal.x()) + n.y() * static_cast<double>(c.normal.y()));
        if (across > 0.3 && !(cells.hasLabels && c.label == Label::Window))
            return;
        if (depth > params.maximumThickness_m)
        {
            beyond += 1;
            return;
        }
        histogram[static_cast<std::size_t>(depth / bin)] += 1;
        total += 1;
    };
    index.near(body.t * body.begin + n * face, body.t * body.end + n * face, params.maximumThickness_m + further_m,
               look);
    const double area = total * cells.size_m * cells.size_m;
    if (area < 0.08)
        return std::nullopt;
    Reveal reveal;
    double sum = 0;
    for (std::size_t i = 0; i < histogram.size() && reveal.most_m == 0.0; ++i)
        if ((sum += histogram[i]) >= 0.97 * total)
            reveal.most_m = (static_cast<double>(i) + 1) * bin;
    // A reveal ends somewhere; what goes on past the thickest wall is another room, or the world outside.
    if (reveal.most_m > params.maximumThickness_m - 0.05 && beyond > 0.1 * total)
        return std::nullopt;
    const double fewest = std::max(4.0, kSeenPast * 2 * total / (reveal.most_m / bin));
    for (std::size_t i = 1; i < histogram.size(); ++i)
        if (histogram[i - 1] + histogram[i] >= fewest)
            reveal.end_m = (static_cast<double>(histogram[i] > 0 ? i : i - 1) + 1) * bin;
    return reveal;
}

double weightedMedian(std::vector<std::pair<double, double>> values)
{
    std::sort(values.begin(), values.end());
    double total = 0, sum = 0;
    for (const auto& [v, w] : values)
        total += w;
    for (const auto& [v, w] : values)
    {
        sum += w;
        if (2 * sum >= total)
            return v;
    }
    return 0;
}

}  // namespace

void settleThickness(std::vector<WallBody>& bodies, const SurfaceCells& cells, const CellIndex& index,
                     const Level& level, const PlanMask& mask, const WallParams& params)
{
    std::vector<WallBody*> open;
    for (WallBody& b : bodies)
    {
        if (b.bothSeen())
            continue;
        // The same wall elsewhere: a body on the same line whose face is this one's.
        const WallBody* best = nullptr;
        double bestGap = 3.0;
        for (const WallBody& o : bodies)
        {
            if (!o.bothSeen() || !isSameLine(b, o))
                continue;
            const double difference = b.lowSeen ? std::abs(o.low - b.low) : std::abs(o.high - b.high);
            const double gap = std::max(o.begin - b.end, b.begin - o.end);
            if (difference < params.mergeOffset_m && gap < bestGap)
                bestGap = gap, best = &o;
        }
        if (best)
        {
            setThickness(b, best->thickness(), ThicknessSource::SameWall);
            continue;
        }
        open.push_back(&b);
    }
    // Kinds: behind an internal wall the building goes on, if not at once (a closet or shaft that was not scanned).
    const auto isExternal = [&](const WallBody& b)
    {
        constexpr double reach = 4.0, step = 0.1;
        const double face = b.lowSeen ? b.low : b.high, sign = b.lowSeen ? 1.0 : -1.0;
        const int samples = std::max(3, static_cast<int>((b.end - b.begin) / 0.2));
        int hits = 0;
        for (int i = 0; i < samples; ++i)
        {
            const Eigen::Vector2d from = b.t * (b.begin + (b.end - b.begin) * (i + 0.5) / samples) + b.n() * face;
            bool hit = false;
            for (double d = 0.1; d < reach && !hit; d += step)
                hit = mask.seen(from + b.n() * (sign * d), PlanMask::Ceiling) ||
                      (mask.mainLayer() == PlanMask::Floor && mask.seen(from + b.n() * (sign * d), PlanMask::Floor));
            hits += hit;
        }
        return 2 * hits < samples;
    };
    std::vector<std::pair<double, double>> internal, revealed;
    for (const WallBody& b : bodies)
        if (b.bothSeen())
            internal.emplace_back(b.thickness(), b.end - b.begin);
    std::vector<WallBody*> externalOpen, internalOpen, externalRevealed;
    for (WallBody* b : open)
    {
        const std::optional<Reveal> reveal = revealOf(*b, cells, index, level, params);
        const bool outside = isExternal(*b);
        if (reveal)
        {
            const double depth = outside && !cells.labelsAreSure() ? reveal->end_m : reveal->most_m;
            setThickness(*b, std::max(depth, params.minimumThickness_m), ThicknessSource::Reveals);
            if (outside)
            {
                revealed.emplace_back(depth, b->end - b->begin);
                externalRevealed.push_back(b);
            }
        }
        else
            (outside ? externalOpen : internalOpen).push_back(b);
    }
    double deepest = 0;
    if (cells.labelsAreSure())
    {
        // A reveal is seen up to a frame at most: the deepest one of the kind tells the thickness best.
        for (const auto& [depth, length] : revealed)
            deepest = std::max(deepest, depth);
        for (WallBody* b : externalRevealed)
            if (b->thickness() > 0.75 * deepest)
                setThickness(*b, deepest, ThicknessSource::Reveals);
    }
    else if (!revealed.empty())
    {
        // One may hide behind its frame, or go on with a leaf that stands open: what most of the kind say.
        deepest = weightedMedian(revealed);
        for (WallBody* b : externalRevealed)
            if (b->thickness() > 0.5 * deepest && b->thickness() < 1.5 * deepest)
                setThickness(*b, deepest, ThicknessSource::Reveals);
    }
    const double internalThickness = internal.empty() ? params.defaultThickness_m : weightedMedian(internal);
    // Without labels a reveal may end at a pane in the middle of the wall; an external wall is no thinner than the
    // others.
    if (!cells.labelsAreSure() && !internal.empty())
    {
        deepest = std::max(deepest, internalThickness);
        for (WallBody* b : externalRevealed)
            if (b->thickness() < internalThickness)
                setThickness(*b, internalThickness, ThicknessSource::OtherWalls);
    }
    const double externalThickness =
        !revealed.empty() ? deepest : (internal.empty() ? params.defaultExternalThickness_m : internalThickness);
    const auto from = [](bool isKnown) { return isKnown ? ThicknessSource::OtherWalls : ThicknessSource::Default; };
    for (WallBody* b : externalOpen)
        setThickness(*b, externalThickness, from(!revealed.empty() || !internal.empty()));
    for (WallBody* b : internalOpen)
        setThickness(*b, internalThickness, from(!internal.empty()));
}

}  // namespace s2b

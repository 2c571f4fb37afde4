// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/snapshot.h"

#include "core/report/canvas.h"
#include "core/report/text.h"

#include <algorithm>
#include <cmath>

namespace s2b::report
{
using namespace validation;
namespace
{

constexpr int kWidth = 800;
constexpr int kHeight = 600;
constexpr int kTop = 36;      ///< title
constexpr int kBottom = 556;  ///< colour bar and legend below
constexpr int kDivide = 330;  ///< plan above, faces of a wall below
constexpr Color kPaper{255, 255, 255, 255};
constexpr Color kInk{34, 40, 48, 255};
constexpr Color kFaint{150, 158, 168, 255};
constexpr Color kNeighbour{232, 236, 241, 200};
constexpr Color kResult{38, 96, 164, 255};
constexpr Color kResultFill{63, 127, 191, 60};
constexpr Color kTruth{30, 30, 30, 255};
constexpr Color kMissedFill{214, 64, 48, 90};
constexpr Color kExtraFill{122, 58, 160, 80};

Eigen::AlignedBox2i box(int x0, int y0, int x1, int y1)
{
    return {Eigen::Vector2i(x0, y0), Eigen::Vector2i(x1, y1)};
}

Eigen::AlignedBox2d around(const Scene& scene, const Row& row)
{
    Eigen::AlignedBox2d all;
    const auto extend = [&](const BimElement* element, const Eigen::Vector3d& shift)
    {
        if (!element)
            return;
        for (const Polygon& outline : outlinesOf(*element, shift))
        {
            for (const Eigen::Vector2d& p : outline.outer)
                all.extend(p);
        }
    };
    extend(row.truth, scene.truthShift);
    extend(row.result, scene.resultShift);
    if (all.isEmpty())
        all.extend(Eigen::Vector2d(0, 0));
    const double edge_m = std::max(0.4, 0.08 * all.sizes().maxCoeff());
    all.extend(Eigen::Vector2d(all.min().array() - edge_m));
    all.extend(Eigen::Vector2d(all.max().array() + edge_m));
    return all;
}

void drawScaleBar(Canvas& canvas, const Viewport& view)
{
    double bar_m = 0.1;
    for (const double step : {0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0})
    {
        if (step * view.pixelsPerMetre <= 140.0)
            bar_m = step;
    }
    const int length = static_cast<int>(std::lround(bar_m * view.pixelsPerMetre));
    const int right = view.pixels.max().x() - 10;
    const int y = view.pixels.max().y() - 12;
    const std::string text = plainNumber(bar_m, 1) + " M";
    canvas.fill(box(right - length - 4, y - 22, right + 4, y + 8), {255, 255, 255, 200});
    canvas.fill(box(right - length, y, right, y + 3), kInk);
    canvas.fill(box(right - length, y - 4, right - length + 2, y + 4), kInk);
    canvas.fill(box(right - 2, y - 4, right, y + 4), kInk);
    canvas.text({right - Canvas::textWidth(text), y - 19}, text, kInk);
}

void drawPlanPart(Canvas& canvas, const Scene& scene, const Row& row, const StoreyRasters& rasters, int bottom)
{
    const Viewport view = Viewport::fit(box(1, kTop, kWidth - 1, bottom), around(scene, row));
    if (row.level >= 0)
    {
        for (const std::size_t i : scene.levels[static_cast<std::size_t>(row.level)].rows)
        {
            const Row& other = scene.rows[i];
            if (!other.result || &other == &row || other.pair.elementClass == ElementClass::Slab ||
                other.pair.elementClass == ElementClass::Space)
                continue;
            for (const Polygon& outline : outlinesOf(*other.result, scene.resultShift))
            {
                canvas.polygon(view, outline, kNeighbour);
                canvas.outline(view, outline, kFaint, 1.0);
            }
        }
    }
    if (!rasters.slice.isEmpty())
        canvas.raster(view, rasters.slice, rasters.sliceImage);
    if (row.result)
    {
        for (const Polygon& outline : outlinesOf(*row.result, scene.resultShift))
        {
            canvas.polygon(view, outline, row.pair.outcome == Outcome::FalsePositive ? kExtraFill : kResultFill);
            canvas.outline(view, outline, kResult, 2.0);
        }
    }
    const bool isFloor = row.pair.elementClass == ElementClass::Slab;
    if (row.result)
        canvas.raster(view, isFloor ? rasters.floor : rasters.faces, isFloor ? rasters.floorImage : rasters.facesImage);
    if (row.truth)
    {
        for (const Polygon& outline : outlinesOf(*row.truth, scene.truthShift))
        {
            if (!row.result)
                canvas.polygon(view, outline, kMissedFill);
            canvas.outline(view, outline, kTruth, 2.0, 8.0);
        }
    }
    canvas.text({10, kTop + 8}, "PLAN", kInk);
    drawScaleBar(canvas, view);
}

void drawFaces(Canvas& canvas, const Scene& scene, const WallFaces& wall)
{
    const double height_m = wall.high_m - wall.low_m;
    const Polygon face{{{0, 0}, {wall.length_m, 0}, {wall.length_m, height_m}, {0, height_m}}, {}};
    Eigen::AlignedBox2d seen(Eigen::Vector2d(-0.1, -0.1), Eigen::Vector2d(wall.length_m + 0.1, height_m + 0.1));
    int left = 1;
    for (const auto& [raster, name] : {std::pair(&wall.left, "LEFT FACE"), std::pair(&wall.right, "RIGHT FACE")})
    {
        const Viewport view = Viewport::fit(box(left + 4, kDivide + 28, left + kWidth / 2 - 4, kBottom - 4), seen);
        canvas.polygon(view, face, {246, 246, 246, 255});
        if (!raster->isEmpty())
            canvas.raster(view, *raster, deviationImage(*raster, scene.colorRange_m));
        canvas.outline(view, face, kInk, 1.5);
        canvas.text({left + 9, kDivide + 8}, name, kInk);
        left += kWidth / 2;
    }
    canvas.fill(box(0, kDivide, kWidth, kDivide + 1), kFaint);
    canvas.fill(box(kWidth / 2, kDivide, kWidth / 2 + 1, kBottom), kFaint);
}

void drawTitle(Canvas& canvas, const Row& row)
{
    std::string title = std::string(className(row.pair.elementClass)) + " NO. " + std::to_string(row.number) + " : ";
    title += row.pair.outcome == Outcome::Matched ? verdictName(row.verdict) : outcomeName(row.pair.outcome);
    if (row.error_m)
        title += " : " + plainNumber(1000.0 * *row.error_m, 0) + " MM";
    canvas.fill(box(0, 0, kWidth, kTop - 2), kInk);
    canvas.text({10, 10}, title, kPaper);
}

void drawKey(Canvas& canvas, const Scene& scene, const Row& row)
{
    canvas.fill(box(0, kBottom, kWidth, kHeight), kPaper);
    canvas.fill(box(0, kBottom, kWidth, kBottom + 1), kFaint);
    const int y = kBottom + 12;
    int x = 12;
    Viewport view;
    view.pixels = box(0, 0, kWidth, kHeight);
    view.center = {kWidth / 2.0, -kHeight / 2.0};  // metres are pixels here
    if (row.truth)
    {
        canvas.line(view, {x * 1.0, -(y + 7.0)}, {x + 40.0, -(y + 7.0)}, kTruth, 2.0, 8.0);
        canvas.text({x + 48, y}, "TRUTH", kInk);
        x += 48 + Canvas::textWidth("TRUTH") + 24;
    }
    if (row.result)
    {
        canvas.fill(box(x, y, x + 40, y + 14), kResultFill);
        canvas.fill(box(x, y, x + 40, y + 2), kResult);
        canvas.fill(box(x, y + 12, x + 40, y + 14), kResult);
        canvas.text({x + 48, y}, "RESULT", kInk);
    }
    if (!scene.hasPoints)
        return;
    constexpr int kBar = 240;
    const int left = kWidth - kBar - 62;
    for (int i = 0; i < kBar; ++i)
        canvas.fill(box(left + i, y - 4, left + i + 1, y + 8), divergingColor(2.0 * i / (kBar - 1) - 1.0));
    const std::string end = plainNumber(1000.0 * scene.colorRange_m, 0);
    canvas.text({left - Canvas::textWidth("-" + end) / 2, y + 14}, "-" + end, kInk);
    canvas.text({left + kBar / 2 - 5, y + 14}, "0", kInk);
    canvas.text({left + kBar - Canvas::textWidth("+" + end) / 2, y + 14}, "+" + end + " MM", kInk);
}

}  // namespace

Image drawSnapshot(const Scene& scene, const Row& row, const StoreyRasters& rasters, const WallFaces* wall)
{
    Canvas canvas(kWidth, kHeight, kPaper);
    const bool hasFaces = wall && (!wall->left.isEmpty() || !wall->right.isEmpty());
    drawPlanPart(canvas, scene, row, rasters, hasFaces ? kDivide : kBottom);
    if (hasFaces)
        drawFaces(canvas, scene, *wall);
    drawTitle(canvas, row);
    drawKey(canvas, scene, row);
    return canvas.image();
}

}  // namespace s2b::report

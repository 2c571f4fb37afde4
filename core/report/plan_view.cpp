// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/plan_view.h"

#include "core/report/svg_sheet.h"
#include "core/report/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <format>

namespace s2b::report
{
using namespace validation;
namespace
{

constexpr double kPaperWidth_mm = 182.0;   ///< A4 less its margins
constexpr double kPaperHeight_mm = 205.0;  ///< leaves room for heading, caption and legend
constexpr double kMargin_mm = 7.0;
constexpr double kEdge_m = 1.0;

struct StyleText
{
    Style style;
    const char* css;
    const char* meaning;
};
constexpr std::array<StyleText, 6> kStyles{{
    {Style::Within, "within", "within tolerance"},
    {Style::OutOfTolerance, "out", "out of tolerance"},
    {Style::Missed, "missed", "missed (in the truth alone)"},
    {Style::FalsePositive, "extra", "false positive (in the result alone)"},
    {Style::NoData, "nodata", "too few points to judge"},
    {Style::NotSeen, "notseen", "not seen by the survey"},
}};

const char* cssOf(Style style)
{
    return kStyles[static_cast<std::size_t>(style)].css;
}

Eigen::AlignedBox2d widened(Eigen::AlignedBox2d box)
{
    box.extend(Eigen::Vector2d(box.min().array() - kEdge_m));
    box.extend(Eigen::Vector2d(box.max().array() + kEdge_m));
    return box;
}

/// From the back to the front: what fills much must not hide what fills little.
int layerOf(ElementClass elementClass)
{
    switch (elementClass)
    {
        case ElementClass::Slab:
        case ElementClass::Space:
            return 0;
        case ElementClass::Wall:
            return 1;
        case ElementClass::Column:
            return 2;
        case ElementClass::Door:
        case ElementClass::Window:
            return 3;
    }
    return 1;
}

Eigen::AlignedBox2d boxOf(const std::vector<Polygon>& outlines)
{
    Eigen::AlignedBox2d box;
    for (const Polygon& outline : outlines)
    {
        for (const Eigen::Vector2d& p : outline.outer)
            box.extend(p);
    }
    return box;
}

std::string titleOf(const Row& row)
{
    return std::to_string(row.number) + ": " + className(row.pair.elementClass) + " " + row.id + ", " +
           outcomeName(row.pair.outcome) + ", " + verdictName(row.verdict);
}

std::string elevationText(const Scene& scene, const Level& level)
{
    return number(level.elevation_m + scene.base.z(), 3) + " m";
}

void drawElements(Sheet& sheet, const Scene& scene, const Level& level)
{
    for (int layer = 0; layer <= 3; ++layer)
    {
        for (const std::size_t i : level.rows)
        {
            const Row& row = scene.rows[i];
            if (layerOf(row.pair.elementClass) != layer || row.pair.elementClass == ElementClass::Space)
                continue;
            const std::string kind =
                row.pair.elementClass == ElementClass::Slab ? "slab" : className(row.pair.elementClass);
            if (row.result)
                sheet.outlines(outlinesOf(*row.result, scene.resultShift),
                               std::format("class=\"e {} {}\"", cssOf(row.style), kind), titleOf(row));
            if (row.truth && !row.result)
                sheet.outlines(outlinesOf(*row.truth, scene.truthShift),
                               std::format("class=\"e {} {}\"", cssOf(row.style), kind), titleOf(row));
            else if (row.truth)
                sheet.outlines(outlinesOf(*row.truth, scene.truthShift), "class=\"truth\"");
        }
    }
}

/// The numbers of the table at what is out of tolerance.
void drawNumbers(Sheet& sheet, const Scene& scene, const Level& level)
{
    for (const std::size_t i : level.rows)
    {
        const Row& row = scene.rows[i];
        if (row.verdict != Verdict::OutOfTolerance || layerOf(row.pair.elementClass) == 0)
            continue;
        const Eigen::AlignedBox2d box = boxOf(outlinesOf(row.element(), scene.shiftOf(row)));
        if (box.isEmpty())
            continue;
        Eigen::Vector2d p = sheet.place(box.center());
        constexpr double kSmall_mm = 6.0;  // would be hidden: the number stands beside it
        if (sheet.length(box.sizes().maxCoeff()) < kSmall_mm)
            p.y() -= sheet.length(box.sizes().y()) / 2.0 + 2.2;
        const std::string text = std::to_string(row.number);
        const double half_mm = 0.9 + 0.75 * static_cast<double>(text.size());
        sheet.markup(std::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"3.2\" rx=\"1.6\" class=\"badge\"/>",
                                 plainNumber(p.x() - half_mm, 2), plainNumber(p.y() - 1.6, 2),
                                 plainNumber(2 * half_mm, 2)));
        sheet.text({p.x(), p.y() + 0.85}, text, "class=\"badgetext\" text-anchor=\"middle\"");
    }
}

std::size_t countOf(const Scene& scene, const Level& level, Style style)
{
    return static_cast<std::size_t>(std::count_if(level.rows.begin(), level.rows.end(),
                                                  [&](std::size_t i) { return scene.rows[i].style == style; }));
}

}  // namespace

Drawing drawPlan(const Scene& scene, const Level& level, const StoreyRasters& rasters)
{
    Drawing drawing;
    Eigen::AlignedBox2d box = planBox(scene, level);
    if (box.isEmpty())
        return drawing;
    Sheet sheet(widened(box), kPaperWidth_mm, kPaperHeight_mm, kMargin_mm);
    sheet.beginClip();
    drawElements(sheet, scene, level);
    if (!rasters.slice.isEmpty())
        sheet.image(rasters.slice, rasters.sliceImage, "points of the slice");  // darkens what is below it
    drawNumbers(sheet, scene, level);
    sheet.endClip();
    sheet.frame(scene.base.head<2>());
    sheet.scaleBar();
    drawing.svg = sheet.svg("Plan of " + level.name);

    drawing.caption =
        std::format("{}, floor at {}. Scale 1:{} on A4.", level.name, elevationText(scene, level), sheet.scale());
    if (!rasters.slice.isEmpty())
        drawing.caption +=
            std::format(" Grey: points {} to {} m above the floor.", number(kSliceHeight_m - kSliceHalf_m, 1),
                        number(kSliceHeight_m + kSliceHalf_m, 1));
    for (const auto& [style, what] :
         {std::pair(Style::OutOfTolerance, "out of tolerance"), std::pair(Style::Missed, "missed"),
          std::pair(Style::FalsePositive, "false positive"), std::pair(Style::NotSeen, "not seen")})
    {
        if (const std::size_t count = countOf(scene, level, style))
            drawing.caption += std::format(" {} {}.", count, what);
    }
    if (!level.isSurveyed)
        drawing.caption += " The survey did not cover this storey: nothing of it is asked for.";
    return drawing;
}

Drawing drawDeviations(const Scene& scene, const Level& level, const StoreyRasters& rasters, bool isFloor)
{
    Drawing drawing;
    const Raster& raster = isFloor ? rasters.floor : rasters.faces;
    const Eigen::AlignedBox2d box = planBox(scene, level);
    const bool hasAny = std::any_of(raster.count.begin(), raster.count.end(), [](std::uint32_t n) { return n > 0; });
    if (box.isEmpty() || !hasAny)
        return drawing;
    Sheet sheet(widened(box), kPaperWidth_mm, kPaperHeight_mm, kMargin_mm);

    // Faces are lines in a top view: each cell is drawn as wide as the eye can tell colours apart.
    Raster drawn = raster;
    constexpr double kLine_mm = 0.8;
    const double cell_m = kLine_mm * sheet.scale() / 1000.0;
    if (!isFloor && raster.cell_m < cell_m)
    {
        drawn = Raster::over(raster.box(), cell_m);
        for (int y = 0; y < raster.height; ++y)
        {
            for (int x = 0; x < raster.width; ++x)
            {
                const auto from =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width) + static_cast<std::size_t>(x);
                const std::ptrdiff_t to =
                    drawn.find(raster.low.x() + (x + 0.5) * raster.cell_m, raster.low.y() + (y + 0.5) * raster.cell_m);
                if (to < 0)
                    continue;
                drawn.count[static_cast<std::size_t>(to)] += raster.count[from];
                drawn.sum_m[static_cast<std::size_t>(to)] += raster.sum_m[from];
            }
        }
    }
    sheet.beginClip();
    sheet.image(drawn, deviationImage(drawn, scene.colorRange_m), "signed deviations");
    for (const std::size_t i : level.rows)
    {
        const Row& row = scene.rows[i];
        if (row.result && layerOf(row.pair.elementClass) > 0)
            sheet.outlines(outlinesOf(*row.result, scene.resultShift), "class=\"outline\"", titleOf(row));
    }
    sheet.endClip();
    sheet.frame(scene.base.head<2>());
    sheet.scaleBar();
    drawing.svg = sheet.svg("Deviations of " + level.name);
    drawing.caption =
        std::format("{}: {}, mean over {} cells. Scale 1:{} on A4.", level.name,
                    isFloor ? "points of the floor about the slab" : "points of walls and columns, from above",
                    number(100.0 * drawn.cell_m, 0) + " cm", sheet.scale());
    return drawing;
}

Drawing drawWall(const Scene& scene, const WallFaces& wall)
{
    Drawing drawing;
    if (wall.row < 0 || (wall.left.isEmpty() && wall.right.isEmpty()))
        return drawing;
    constexpr double kGap_mm = 4.0;
    constexpr double kHeight_mm = 60.0;
    constexpr double kWallMargin_mm = 5.0;
    const Row& row = scene.rows[static_cast<std::size_t>(wall.row)];
    const double height_m = wall.high_m - wall.low_m;

    // Side by side where that keeps the scale, else one above the other.
    const bool isBeside = wall.length_m < 3.0 * height_m;
    std::string both;
    int scale = 0;
    for (const auto& [raster, name] : {std::pair(&wall.left, "left face"), std::pair(&wall.right, "right face")})
    {
        const Eigen::AlignedBox2d box(Eigen::Vector2d(0, 0), Eigen::Vector2d(wall.length_m, height_m));
        Sheet sheet(box, isBeside ? (kPaperWidth_mm - kGap_mm) / 2.0 : kPaperWidth_mm, kHeight_mm, kWallMargin_mm);
        sheet.image(*raster, deviationImage(*raster, scene.colorRange_m), name);
        const Polygon face{{{0, 0}, {wall.length_m, 0}, {wall.length_m, height_m}, {0, height_m}}, {}};
        sheet.outlines({face}, "class=\"frame\"");
        sheet.text({kWallMargin_mm, kWallMargin_mm + sheet.length(height_m) + 3.4}, name, "class=\"axis\"");
        if (raster == &wall.right)
            sheet.scaleBar();
        both += sheet.svg(std::string(name) + " of " + row.id);
        scale = sheet.scale();
    }
    drawing.svg = both;
    const Deviation& deviation = *row.toResult;
    drawing.caption = std::format("No. {}, {} {}: {} points, mean {} mm, RMS {} mm, 95 % within {} mm. Scale 1:{}.",
                                  row.number, className(row.pair.elementClass), row.id, counted(deviation.points),
                                  millimetres(deviation.meanSigned_m, true), millimetres(deviation.rms_m),
                                  millimetres(deviation.p95_m), scale);
    return drawing;
}

std::string planLegend(const Scene& scene)
{
    std::string legend = "<ul class=\"legend\">";
    const auto item = [&](std::string_view shape, std::string_view meaning)
    {
        legend += std::format(
            "<li><svg width=\"9mm\" height=\"4.5mm\" viewBox=\"0 0 9 4.5\" aria-hidden=\"true\">{}</svg>{}</li>\n",
            shape, meaning);
    };
    if (scene.hasTruth)
        item("<path d=\"M0.5 0.5H8.5V4H0.5Z\" class=\"truth\"/>", "truth");
    for (const StyleText& style : kStyles)
    {
        const bool isOfTruth =
            style.style == Style::Missed || style.style == Style::FalsePositive || style.style == Style::NotSeen;
        if (scene.hasTruth || !isOfTruth)
            item(std::format("<path d=\"M0.5 0.5H8.5V4H0.5Z\" class=\"e {} wall\"/>", style.css), style.meaning);
    }
    item(
        "<rect x=\"2\" y=\"0.65\" width=\"5\" height=\"3.2\" rx=\"1.6\" class=\"badge\"/><text x=\"4.5\" y=\"3.1\" "
        "class=\"badgetext\" text-anchor=\"middle\">12</text>",
        "number in the table");
    return legend + "</ul>\n";
}

std::string sharedDefinitions()
{
    return "<svg width=\"0\" height=\"0\" style=\"position:absolute\" aria-hidden=\"true\"><defs>\n"
           "<pattern id=\"p-out\" width=\"1.5\" height=\"1.5\" patternUnits=\"userSpaceOnUse\" "
           "patternTransform=\"rotate(45)\"><rect width=\"1.5\" height=\"1.5\" fill=\"#ffe3ae\"/><rect width=\"0.55\" "
           "height=\"1.5\" fill=\"#d98a00\"/></pattern>\n"
           "<pattern id=\"p-missed\" width=\"1.3\" height=\"1.3\" patternUnits=\"userSpaceOnUse\" "
           "patternTransform=\"rotate(45)\"><rect width=\"1.3\" height=\"1.3\" fill=\"#fbd9d3\"/><path d=\"M0 0H1.3M0 "
           "0V1.3\" stroke=\"#c0281c\" stroke-width=\"0.5\"/></pattern>\n"
           "<pattern id=\"p-extra\" width=\"1.3\" height=\"1.3\" patternUnits=\"userSpaceOnUse\"><rect width=\"1.3\" "
           "height=\"1.3\" fill=\"#eadcf3\"/><circle cx=\"0.65\" cy=\"0.65\" r=\"0.36\" fill=\"#6b2f94\"/></pattern>\n"
           "<pattern id=\"p-nodata\" width=\"1.4\" height=\"1.4\" patternUnits=\"userSpaceOnUse\"><rect width=\"1.4\" "
           "height=\"1.4\" fill=\"#f1f1f1\"/><rect width=\"1.4\" height=\"0.35\" fill=\"#a5a5a5\"/></pattern>\n"
           "</defs></svg>\n";
}

std::string colorBar(const Scene& scene)
{
    constexpr int kSteps = 41;
    constexpr double kWidth_mm = 90.0;
    std::string svg =
        "<svg class=\"colorbar\" width=\"110mm\" height=\"11mm\" viewBox=\"-10 0 110 11\" role=\"img\" "
        "aria-label=\"colour scale of signed deviations\">";
    for (int i = 0; i < kSteps; ++i)
    {
        const double value = 2.0 * i / (kSteps - 1) - 1.0;
        svg += std::format("<rect x=\"{}\" y=\"0\" width=\"{}\" height=\"4\" fill=\"{}\"/>",
                           plainNumber(i * kWidth_mm / kSteps, 3), plainNumber(kWidth_mm / kSteps + 0.05, 3),
                           hex(divergingColor(value)));
    }
    for (const double value : {-1.0, -0.5, 0.0, 0.5, 1.0})
    {
        const double x = (value + 1.0) / 2.0 * kWidth_mm;
        svg += std::format(
            "<line x1=\"{0}\" x2=\"{0}\" y1=\"4\" y2=\"5.2\" class=\"tick\"/><text x=\"{0}\" y=\"8\" "
            "class=\"axis\" text-anchor=\"middle\">{1}</text>",
            plainNumber(x, 2), roundMillimetres(value * scene.colorRange_m, true));
    }
    svg +=
        "<text x=\"0\" y=\"10.8\" class=\"axis\">inside the element</text><text x=\"90\" y=\"10.8\" class=\"axis\" "
        "text-anchor=\"end\">outside, in front of its surface</text><text x=\"95\" y=\"8\" class=\"axis\">"
        "mm</text></svg>\n";
    return svg;
}

}  // namespace s2b::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/rasters.h"

#include <algorithm>
#include <cmath>

namespace s2b::report
{
using namespace validation;
namespace
{

constexpr double kEdge_m = 1.0;  ///< pictures reach this far over the elements
constexpr double kSliceCell_m = 0.02;
constexpr double kFaceCell_m = 0.025;
constexpr double kWallCell_m = 0.025;
constexpr double kLargestWallCell_m = 0.25;
constexpr double kPointsPerCell = 4.0;
constexpr double kFloorCell_m = 0.10;
constexpr double kFloorStep_m = 0.30;  ///< a slab's points this near to the floor are the floor's
constexpr std::size_t kChunk = 1U << 16U;

bool isUpright(ElementClass elementClass)
{
    return elementClass != ElementClass::Slab && elementClass != ElementClass::Space;
}

/// The longest edge of the outline's own rectangle: direction and middle line of a wall without an axis.
bool middleLine(const Polygon& plan, Eigen::Vector2d& start, Eigen::Vector2d& end)
{
    if (plan.outer.size() != 4)
        return false;
    const auto& p = plan.outer;
    const bool isFirstLonger = (p[1] - p[0]).norm() >= (p[2] - p[1]).norm();
    start = isFirstLonger ? (p[0] + p[3]) / 2.0 : (p[0] + p[1]) / 2.0;
    end = isFirstLonger ? (p[1] + p[2]) / 2.0 : (p[2] + p[3]) / 2.0;
    return true;
}

bool isInside(const std::vector<Eigen::Vector2d>& ring, const Eigen::Vector2d& p)
{
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const Eigen::Vector2d& a = ring[i];
        const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
        if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
    }
    return inside;
}

/// Empties the cells outside all of the outlines, or inside one of the others.
void keepWithin(Raster& raster, const std::vector<Polygon>& outlines, const std::vector<Polygon>& others)
{
    for (std::size_t i = 0; i < raster.count.size(); ++i)
    {
        if (raster.count[i] == 0)
            continue;
        const auto column = static_cast<double>(i % static_cast<std::size_t>(raster.width));
        const auto row = static_cast<double>(i / static_cast<std::size_t>(raster.width));
        const Eigen::Vector2d middle = raster.low + Eigen::Vector2d(column + 0.5, row + 0.5) * raster.cell_m;
        const auto isAround = [&](const Polygon& outline) { return isInside(outline.outer, middle); };
        if (std::none_of(outlines.begin(), outlines.end(), isAround) ||
            std::any_of(others.begin(), others.end(), isAround))
            raster.count[i] = 0;
    }
}

}  // namespace

Raster Raster::over(const Eigen::AlignedBox2d& box, double cell_m, std::size_t maximumCells)
{
    Raster raster;
    if (box.isEmpty() || !(box.sizes().minCoeff() >= 0.0))
        return raster;
    const double area_m2 = std::max(box.sizes().x(), cell_m) * std::max(box.sizes().y(), cell_m);
    raster.cell_m = std::max(cell_m, std::sqrt(area_m2 / static_cast<double>(maximumCells)));
    raster.low = box.min();
    raster.width = std::max(1, static_cast<int>(std::ceil(box.sizes().x() / raster.cell_m)));
    raster.height = std::max(1, static_cast<int>(std::ceil(box.sizes().y() / raster.cell_m)));
    const std::size_t cells = static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height);
    raster.count.assign(cells, 0);
    raster.sum_m.assign(cells, 0.0F);
    return raster;
}

std::vector<Polygon> outlinesOf(const BimElement& element, const Eigen::Vector3d& shift)
{
    std::vector<Polygon> outlines = element.footprint;
    if (outlines.empty())
        outlines.push_back(element.plan);
    for (Polygon& outline : outlines)
    {
        for (Eigen::Vector2d& p : outline.outer)
            p += shift.head<2>();
        for (auto& hole : outline.holes)
        {
            for (Eigen::Vector2d& p : hole)
                p += shift.head<2>();
        }
    }
    return outlines;
}

Eigen::AlignedBox2d planBox(const Scene& scene, const Level& level)
{
    Eigen::AlignedBox2d upright;
    Eigen::AlignedBox2d all;
    const auto extend = [&](const BimElement& element, const Eigen::Vector3d& shift)
    {
        for (const Polygon& outline : outlinesOf(element, shift))
        {
            for (const Eigen::Vector2d& p : outline.outer)
            {
                all.extend(p);
                if (isUpright(element.elementClass))
                    upright.extend(p);
            }
        }
    };
    for (const std::size_t i : level.rows)
    {
        if (scene.rows[i].truth)
            extend(*scene.rows[i].truth, scene.truthShift);
        if (scene.rows[i].result)
            extend(*scene.rows[i].result, scene.resultShift);
    }
    constexpr double kMuchLarger = 4.0;  // a slab of the site would make the building a dot
    return upright.isEmpty() || all.volume() < kMuchLarger * upright.volume() ? all : upright;
}

WallFaces wallFaces(const Scene& scene, std::size_t row)
{
    WallFaces faces;
    const BimElement& wall = scene.rows[row].element();
    const Eigen::Vector3d shift = scene.shiftOf(scene.rows[row]);
    Eigen::Vector2d start = Eigen::Vector2d::Zero();
    Eigen::Vector2d end = Eigen::Vector2d::Zero();
    if (wall.axis)
    {
        start = wall.axis->start;
        end = wall.axis->end;
    }
    else if (!middleLine(wall.plan, start, end))
        return faces;
    if (wall.elementClass != ElementClass::Wall || !((end - start).norm() > 0.0) || !(wall.high_m > wall.low_m))
        return faces;
    faces.row = static_cast<int>(row);
    faces.start = start + shift.head<2>();
    faces.length_m = (end - start).norm();
    faces.direction = (end - start) / faces.length_m;
    faces.low_m = wall.low_m + shift.z();
    faces.high_m = wall.high_m + shift.z();
    return faces;
}

StoreyRasters rasterize(const ReportInput& input, const Scene& scene, const Level& level, std::vector<WallFaces>& walls,
                        const Context& context)
{
    StoreyRasters rasters;
    Eigen::AlignedBox2d box = planBox(scene, level);
    if (!input.cloud || box.isEmpty())
        return rasters;
    box.extend(Eigen::Vector2d(box.min().array() - kEdge_m));
    box.extend(Eigen::Vector2d(box.max().array() + kEdge_m));
    rasters.slice = Raster::over(box, kSliceCell_m);
    const auto& toResult = input.validation->cloudToResult;
    const bool hasDistances =
        toResult && toResult->distance_m.size() == input.cloud->count && toResult->element.size() == input.cloud->count;
    std::vector<WallFaces*> wallOf(input.result->elements.size(), nullptr);
    if (hasDistances)
    {
        rasters.faces = Raster::over(box, kFaceCell_m);
        rasters.floor = Raster::over(box, kFloorCell_m);
        for (WallFaces& wall : walls)
        {
            const Eigen::AlignedBox2d face(Eigen::Vector2d(0.0, 0.0),
                                           Eigen::Vector2d(wall.length_m, wall.high_m - wall.low_m));
            const Row& row = scene.rows[static_cast<std::size_t>(wall.row)];
            const double sides_m2 = 2.0 * face.volume();
            // Large enough for a few points in each: a face should show as a surface.
            const double cell_m =
                row.toResult ? std::sqrt(kPointsPerCell * sides_m2 / static_cast<double>(row.toResult->points + 1))
                             : 0.0;
            wall.left = Raster::over(face, std::clamp(cell_m, kWallCell_m, kLargestWallCell_m));
            wall.right = wall.left;
            wallOf[static_cast<std::size_t>(scene.rows[static_cast<std::size_t>(wall.row)].pair.result)] = &wall;
        }
    }
    // Whose distances go where: the floor's, those of walls and columns of this level, or nowhere (a door's leaf).
    enum class Target : std::uint8_t
    {
        None,
        Floor,
        Faces
    };
    std::vector<Target> targetOf(wallOf.size(), Target::None);
    std::vector<Polygon> floorOutlines;
    std::vector<Polygon> wallOutlines;
    for (const std::size_t i : level.rows)
    {
        const Row& row = scene.rows[i];
        if (!row.result)
            continue;
        const bool isFace =
            row.pair.elementClass == ElementClass::Wall || row.pair.elementClass == ElementClass::Column;
        const bool isFloor = row.pair.elementClass == ElementClass::Slab;
        targetOf[static_cast<std::size_t>(row.pair.result)] = isFace    ? Target::Faces
                                                              : isFloor ? Target::Floor
                                                                        : Target::None;
        if (isFace || isFloor)
        {
            const auto outlines = outlinesOf(*row.result, scene.resultShift);
            std::vector<Polygon>& all = isFloor ? floorOutlines : wallOutlines;
            all.insert(all.end(), outlines.begin(), outlines.end());
        }
    }
    const Eigen::Vector3d shift = input.cloud->origin - scene.base;
    const double slice_m = level.elevation_m + kSliceHeight_m;
    for (std::size_t i = 0; i < input.cloud->count; ++i)
    {
        if (i % kChunk == 0)
            context.checkCancelled();
        const float* p = input.cloud->xyz + 3 * i;
        const double z = static_cast<double>(p[2]) + shift.z();
        if (z < level.elevation_m - kFloorStep_m || z > level.ceiling_m + kFloorStep_m)
            continue;
        const double x = static_cast<double>(p[0]) + shift.x();
        const double y = static_cast<double>(p[1]) + shift.y();
        if (std::abs(z - slice_m) <= kSliceHalf_m)
            rasters.slice.add(x, y, 0.0F);
        if (!hasDistances || toResult->element[i] < 0 || !std::isfinite(toResult->distance_m[i]))
            continue;
        const auto index = static_cast<std::size_t>(toResult->element[i]);
        if (index >= wallOf.size())
            continue;
        const float distance_m = toResult->distance_m[i];
        if (targetOf[index] == Target::Floor && std::abs(z - level.elevation_m) < kFloorStep_m)
            rasters.floor.add(x, y, distance_m);
        if (targetOf[index] != Target::Faces)
            continue;
        rasters.faces.add(x, y, distance_m);
        if (WallFaces* wall = wallOf[index])
        {
            const Eigen::Vector2d d = Eigen::Vector2d(x, y) - wall->start;
            const double along_m = d.dot(wall->direction);
            const bool isLeft = wall->direction.x() * d.y() - wall->direction.y() * d.x() > 0.0;
            // Seen from outside the wall, its start is on the right of its left face.
            if (isLeft)
                wall->left.add(wall->length_m - along_m, z - wall->low_m, distance_m);
            else
                wall->right.add(along_m, z - wall->low_m, distance_m);
        }
    }
    keepWithin(rasters.floor, floorOutlines, wallOutlines);  // elsewhere its edge is the nearest surface
    rasters.sliceImage = densityImage(rasters.slice);
    rasters.facesImage = deviationImage(rasters.faces, scene.colorRange_m);
    rasters.floorImage = deviationImage(rasters.floor, scene.colorRange_m);
    return rasters;
}

Image densityImage(const Raster& raster)
{
    // Full where one cell in fifty has more: a few dense spots near the scanner must not make the rest pale.
    std::vector<std::uint32_t> seen;
    std::copy_if(raster.count.begin(), raster.count.end(), std::back_inserter(seen),
                 [](std::uint32_t n) { return n > 0; });
    double full = 1.0;
    if (!seen.empty())
    {
        const auto place = seen.begin() + static_cast<std::ptrdiff_t>(seen.size() - 1 - seen.size() / 50);
        std::nth_element(seen.begin(), place, seen.end());
        full = std::max(1.0, static_cast<double>(*place));
    }
    Image image(raster.width, raster.height, Color{255, 255, 255, 0});
    for (int y = 0; y < raster.height; ++y)
    {
        for (int x = 0; x < raster.width; ++x)
        {
            const auto cell =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width) + static_cast<std::size_t>(x);
            if (raster.count[cell] == 0)
                continue;
            const double share = std::min(1.0, std::log1p(raster.count[cell]) / std::log1p(full));
            const auto shade = static_cast<std::uint8_t>(std::lround(225.0 - 105.0 * share));
            image.at(x, raster.height - 1 - y) = {shade, shade, static_cast<std::uint8_t>(std::min(255, shade + 8)),
                                                  255};
        }
    }
    return image;
}

Image deviationImage(const Raster& raster, double range_m)
{
    Image image(raster.width, raster.height, Color{255, 255, 255, 0});
    for (int y = 0; y < raster.height; ++y)
    {
        for (int x = 0; x < raster.width; ++x)
        {
            const auto cell =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width) + static_cast<std::size_t>(x);
            if (raster.count[cell] > 0)
                image.at(x, raster.height - 1 - y) =
                    divergingColor(static_cast<double>(raster.sum_m[cell]) / raster.count[cell] / range_m);
        }
    }
    return image;
}

}  // namespace s2b::report

// SPDX-License-Identifier: GPL-3.0-or-later
/// The points as pictures see them: counted and averaged in square cells.
#pragma once

#include "core/report/png.h"
#include "core/report/scene.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace s2b::report
{

/// A grid of square cells; rows from the bottom.
struct Raster
{
    Eigen::Vector2d low = Eigen::Vector2d::Zero();  ///< its lower-left corner [m]
    double cell_m = 0.0;
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> count;
    std::vector<float> sum_m;  ///< of signed distances

    /// Over a box, in cells of at least `cell_m`: larger ones where there would be more than `maximumCells`.
    static Raster over(const Eigen::AlignedBox2d& box, double cell_m, std::size_t maximumCells = 4'000'000);

    [[nodiscard]] bool isEmpty() const { return count.empty(); }
    /// Index of the cell around a place, or -1 outside.
    [[nodiscard]] std::ptrdiff_t find(double x, double y) const
    {
        const double u = (x - low.x()) / cell_m;
        const double v = (y - low.y()) / cell_m;
        if (!(u >= 0.0 && v >= 0.0 && u < width && v < height))
            return -1;
        return static_cast<std::ptrdiff_t>(v) * width + static_cast<std::ptrdiff_t>(u);
    }
    void add(double x, double y, float distance_m)
    {
        const std::ptrdiff_t i = find(x, y);
        if (i < 0)
            return;
        ++count[static_cast<std::size_t>(i)];
        sum_m[static_cast<std::size_t>(i)] += distance_m;
    }
    [[nodiscard]] Eigen::AlignedBox2d box() const
    {
        return {low, Eigen::Vector2d(low + Eigen::Vector2d(width, height) * cell_m)};
    }
};

/// What a storey's pictures are made from.
struct StoreyRasters
{
    Raster slice;  ///< all points of the slice
    Raster faces;  ///< deviations of upright elements
    Raster floor;  ///< deviations of the slab that one stands on
    Image sliceImage;
    Image facesImage;
    Image floorImage;
};

/// Both faces of a wall, spread out: x along the wall, y up, seen from the left and from the right.
struct WallFaces
{
    int row = -1;  ///< in Scene::rows
    Eigen::Vector2d start = Eigen::Vector2d::Zero();
    Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
    double length_m = 0.0;
    double low_m = 0.0;
    double high_m = 0.0;
    Raster left;
    Raster right;
};

/// Height above the floor of the slice that plans show, and half its thickness.
inline constexpr double kSliceHeight_m = 1.2;
inline constexpr double kSliceHalf_m = 0.1;

/// The plan's box of a level's elements, without an edge. Empty when it has none.
[[nodiscard]] Eigen::AlignedBox2d planBox(const Scene& scene, const Level& level);

/// An element's outline in plan, in the scene's frame.
[[nodiscard]] std::vector<Polygon> outlinesOf(const validation::BimElement& element, const Eigen::Vector3d& shift);

/// One pass over the points for one storey. `walls` are those of this level whose faces are asked for.
/// Cost: O(points); some 10 ns a point.
[[nodiscard]] StoreyRasters rasterize(const ReportInput& input, const Scene& scene, const Level& level,
                                      std::vector<WallFaces>& walls, const Context& context);

/// The axis, length and height of a row's wall, with empty rasters; row -1 when it is not a straight wall.
[[nodiscard]] WallFaces wallFaces(const Scene& scene, std::size_t row);

/// Point counts as shades of grey, transparent where there is none.
[[nodiscard]] Image densityImage(const Raster& raster);
/// Mean signed distances in the diverging colours, transparent where there are no points.
[[nodiscard]] Image deviationImage(const Raster& raster, double range_m);

}  // namespace s2b::report

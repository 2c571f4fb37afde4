// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/flattest_direction.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace s2b
{

FlattestDirection flattestDirection(const Eigen::Matrix3d& a)
{
    FlattestDirection result;
    const double xx = a(0, 0), xy = a(1, 0), xz = a(2, 0), yy = a(1, 1), yz = a(2, 1), zz = a(2, 2);
    // Characteristic polynomial: v^3 - trace v^2 + minors v - determinant.
    const double trace = xx + yy + zz;
    const double minors = xx * yy - xy * xy + xx * zz - xz * xz + yy * zz - yz * yz;
    const double determinant = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    if (!(trace > 0.0))
        return result;
    // Newton's steps from below the smallest root never pass it; few are needed where a patch is flat.
    double v = 0.0;
    for (int step = 0; step < 40; ++step)
    {
        const double slope = (3 * v - 2 * trace) * v + minors;
        if (!(slope > 0.0))
            break;
        const double by = (((v - trace) * v + minors) * v - determinant) / slope;
        v -= by;
        if (!(std::abs(by) > 1e-12 * trace))
            break;
    }
    result.least = std::max(0.0, v);
    const double sum = trace - result.least, product = std::max(0.0, minors - result.least * sum);
    const double root = sum + std::sqrt(std::max(0.0, sum * sum - 4 * product));
    result.middle = std::max(result.least, root > 0.0 ? 2 * product / root : 0.0);
    // Two rows of a - v span what is at right angles to the eigenvector: those that enclose the largest angle.
    const Eigen::Vector3d x(xx - v, xy, xz), y(xy, yy - v, yz), z(xz, yz, zz - v);
    const Eigen::Vector3d normals[] = {x.cross(y), y.cross(z), z.cross(x)};
    const double lengths[] = {normals[0].squaredNorm(), normals[1].squaredNorm(), normals[2].squaredNorm()};
    const auto longest = std::max_element(std::begin(lengths), std::end(lengths));
    if (*longest > 1e-24 * trace * trace * trace * trace)
        result.direction = normals[longest - std::begin(lengths)] / std::sqrt(*longest);
    return result;
}

}  // namespace s2b

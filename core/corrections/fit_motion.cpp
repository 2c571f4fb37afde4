// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/corrections/fit_motion.h"

#include <algorithm>

namespace s2b
{
namespace
{
using Points = Eigen::Matrix3Xd;

Points matrixOf(const std::vector<Eigen::Vector3d>& points)
{
    Points m(3, static_cast<Eigen::Index>(points.size()));
    for (Eigen::Index i = 0; i < m.cols(); ++i)
        m.col(i) = points[static_cast<std::size_t>(i)];
    return m;
}

Eigen::Affine3d affineFit(const Points& from, const Points& to)
{
    const Eigen::Vector3d a = from.rowwise().mean();
    const Eigen::Vector3d b = to.rowwise().mean();
    const Points x = from.colwise() - a;
    const Points y = to.colwise() - b;
    Eigen::Affine3d fit(Eigen::Affine3d::Identity());
    fit.linear() = x.transpose().completeOrthogonalDecomposition().solve(y.transpose()).transpose();
    fit.translation() = b - fit.linear() * a;
    return fit;
}
}  // namespace

std::optional<Eigen::Affine3d> fitMotion(const std::vector<Eigen::Vector3d>& from,
                                         const std::vector<Eigen::Vector3d>& to, double tolerance_m)
{
    if (from.size() != to.size() || from.empty())
        return std::nullopt;
    const Points a = matrixOf(from);
    const Points b = matrixOf(to);
    const Eigen::Affine3d none = Eigen::Affine3d::Identity();
    const Eigen::Affine3d shift(Eigen::Translation3d((b - a).rowwise().mean()));
    const auto fits = [&](const Eigen::Affine3d& m)
    { return m.matrix().allFinite() && ((m * a - b).colwise().norm().maxCoeff() <= tolerance_m); };
    for (const Eigen::Affine3d& m : {none, shift})
    {
        if (fits(m))
            return m;
    }
    for (const bool withScale : {false, true})
    {
        const Eigen::Affine3d m(Eigen::umeyama(a, b, withScale));
        if (fits(m))
            return m;
    }
    const Eigen::Affine3d m = affineFit(a, b);
    return fits(m) ? std::optional(m) : std::nullopt;
}
}  // namespace s2b

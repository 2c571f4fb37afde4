// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>

namespace s2b
{

/// y = a + b x + c x^2 by weighted least squares: add the values, then solve.
struct Parabola
{
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double squares = 0, weight = 0, low = 0, high = 0;
    int count = 0;

    void add(double x, double y, double w)
    {
        const Eigen::Vector3d row(1, x, x * x);
        normal += w * row * row.transpose();
        right += w * y * row;
        squares += w * y * y;
        weight += w;
        low = std::min(low, x), high = std::max(high, x);
        ++count;
    }
    /// (a, b, c); nothing for fewer than five values, or such as do not determine it.
    [[nodiscard]] std::optional<Eigen::Vector3d> solve() const
    {
        if (count < 5)
            return std::nullopt;
        const Eigen::Vector3d c = normal.ldlt().solve(right);
        return c.allFinite() ? std::optional(c) : std::nullopt;
    }
    /// Weighted RMS distance of the values from the solution.
    [[nodiscard]] double rms(const Eigen::Vector3d& c) const
    {
        return std::sqrt(std::max(0.0, squares - c.dot(right)) / weight);
    }
};

}  // namespace s2b

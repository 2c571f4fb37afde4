// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/sloped_top.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace s2b
{
namespace
{

constexpr double kLargestRms_m = 0.05;  // a row of a face is 0.1 m high: 0.03 m of it are rounding
constexpr double kOutlier_m = 0.15;
constexpr double kInlierShare = 0.85;
constexpr double kPieceShare = 0.75;
constexpr double kSeenShare = 0.6;
constexpr double kShortestWall_m = 1.0;
constexpr double kShortestPiece_m = 0.8;
constexpr double kSteepest = 2.75;  // 70 degrees: anything steeper is a step
constexpr std::size_t kStations = 60;

using Edge = std::vector<Eigen::Vector2d>;

struct Fit
{
    Edge edge;
    double rms_m = std::numeric_limits<double>::infinity();
    double inliers = 0.0;  ///< share
    double cost = std::numeric_limits<double>::infinity();
};

/// Least squares of the vertices' heights at given places, reweighted until outliers no longer count.
Fit fitAt(const std::vector<Eigen::Vector2d>& tops, const std::vector<double>& knots)
{
    const auto n = static_cast<Eigen::Index>(knots.size());
    Fit fit;
    for (const double s : knots)
        fit.edge.emplace_back(s, 0.0);
    Eigen::VectorXd z = Eigen::VectorXd::Zero(n);
    for (int round = 0; round < 6; ++round)
    {
        // At most four unknowns, and each point knows two of them.
        Eigen::MatrixXd a = 1e-9 * Eigen::MatrixXd::Identity(n, n);
        Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
        Eigen::Index piece = 0;
        for (const Eigen::Vector2d& p : tops)
        {
            while (piece + 2 < n && p.x() > knots[static_cast<std::size_t>(piece) + 1])
                ++piece;
            const double from = knots[static_cast<std::size_t>(piece)], to = knots[static_cast<std::size_t>(piece) + 1];
            const double v = (p.x() - from) / (to - from), u = 1.0 - v;
            const double off = (u * z[piece] + v * z[piece + 1] - p.y()) / kLargestRms_m;
            const double w = round == 0 ? 1.0 : 1.0 / (1.0 + off * off);
            a(piece, piece) += w * u * u;
            a(piece + 1, piece + 1) += w * v * v;
            a(piece, piece + 1) += w * u * v;
            a(piece + 1, piece) += w * u * v;
            b[piece] += w * u * p.y();
            b[piece + 1] += w * v * p.y();
        }
        z = a.ldlt().solve(b);
    }
    for (Eigen::Index i = 0; i < n; ++i)
        fit.edge[static_cast<std::size_t>(i)].y() = z[i];
    double square = 0.0;
    std::size_t good = 0;
    fit.cost = 0.0;
    for (const Eigen::Vector2d& p : tops)
    {
        const double off = topAt(fit.edge, p.x()) - p.y();
        fit.cost += std::min(off * off, kOutlier_m * kOutlier_m);
        if (std::abs(off) < kOutlier_m)
            square += off * off, ++good;
    }
    if (good > 0)
        fit.rms_m = std::sqrt(square / static_cast<double>(good));
    fit.inliers = static_cast<double>(good) / static_cast<double>(tops.size());
    return fit;
}

/// Every piece has to be seen for itself: a step is not a short slope.
bool isGood(const Fit& fit, const std::vector<Eigen::Vector2d>& tops)
{
    if (fit.rms_m > kLargestRms_m || fit.inliers < kInlierShare)
        return false;
    for (std::size_t i = 0; i + 1 < fit.edge.size(); ++i)
    {
        const Eigen::Vector2d &a = fit.edge[i], &b = fit.edge[i + 1];
        if (b.x() - a.x() < kShortestPiece_m || std::abs(b.y() - a.y()) > kSteepest * (b.x() - a.x()))
            return false;
        std::size_t all = 0, good = 0;
        for (const Eigen::Vector2d& p : tops)
            if (p.x() > a.x() && p.x() < b.x())
                ++all, good += std::abs(topAt(fit.edge, p.x()) - p.y()) < kOutlier_m;
        if (good == 0 || static_cast<double>(good) < kPieceShare * static_cast<double>(all))
            return false;
    }
    return true;
}

/// The best edge with its inner vertices on the stations, then moved to where they fit best.
Fit bestOf(const std::vector<Eigen::Vector2d>& tops, double begin, double end, std::size_t inner)
{
    if (inner == 0)
        return fitAt(tops, {begin, end});
    double step = std::max(0.1, (end - begin) / static_cast<double>(inner == 1 ? kStations : kStations / 2));
    std::vector<double> knots;
    Fit best;
    const auto consider = [&](const std::vector<double>& candidate)
    {
        for (std::size_t i = 0; i + 1 < candidate.size(); ++i)
            if (candidate[i + 1] - candidate[i] < kShortestPiece_m)
                return;
        Fit fit = fitAt(tops, candidate);
        if (fit.cost < best.cost)
            best = std::move(fit), knots = candidate;
    };
    for (double s = begin + step; s < end; s += step)
        if (inner == 1)
            consider({begin, s, end});
        else
            for (double t = s + step; t < end; t += step)
                consider({begin, s, t, end});
    for (; !knots.empty() && step > 0.01; step /= 2)
        for (std::size_t i = 1; i + 1 < knots.size(); ++i)
            for (const double by : {-step / 2, step / 2})
            {
                std::vector<double> moved = knots;
                moved[i] += by;
                consider(moved);
            }
    return best;
}

}  // namespace

double topAt(const std::vector<Eigen::Vector2d>& edge, double s)
{
    std::size_t i = 0;
    while (i + 2 < edge.size() && s > edge[i + 1].x())
        ++i;
    const Eigen::Vector2d &a = edge[i], &b = edge[i + 1];
    return a.y() + (b.y() - a.y()) * (s - a.x()) / (b.x() - a.x());
}

std::vector<Eigen::Vector2d> topBetween(const std::vector<Eigen::Vector2d>& edge, double begin, double end)
{
    constexpr double kSame_m = 1e-3;
    std::vector<Eigen::Vector2d> result = {{begin, topAt(edge, begin)}};
    for (const Eigen::Vector2d& p : edge)
        if (p.x() > begin + kSame_m && p.x() < end - kSame_m && p != edge.front() && p != edge.back())
            result.push_back(p);
    result.emplace_back(end, topAt(edge, end));
    return result;
}

std::vector<Eigen::Vector2d> fitSlopedTop(const std::vector<Eigen::Vector2d>& tops, double begin, double end,
                                          std::size_t places)
{
    if (end - begin < kShortestWall_m || static_cast<double>(tops.size()) < kSeenShare * static_cast<double>(places))
        return {};
    std::vector<double> heights;
    for (const Eigen::Vector2d& p : tops)
        heights.push_back(p.y());
    std::sort(heights.begin(), heights.end());
    const auto quantile = [&](double q)
    { return heights[static_cast<std::size_t>(q * static_cast<double>(heights.size() - 1))]; };
    if (quantile(0.95) - quantile(0.05) < 0.8 * kLeastTopRise_m)
        return {};
    // The fewest pieces that do.
    for (std::size_t inner = 0; inner < 3; ++inner)
    {
        const Fit fit = bestOf(tops, begin, end, inner);
        if (fit.edge.empty() || !isGood(fit, tops))
            continue;
        const auto [low, high] = std::minmax_element(fit.edge.begin(), fit.edge.end(),
                                                     [](const auto& a, const auto& b) { return a.y() < b.y(); });
        return high->y() - low->y() > kLeastTopRise_m ? fit.edge : Edge{};
    }
    return {};
}

}  // namespace s2b

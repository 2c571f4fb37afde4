// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/columns/profile_search.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace s2b
{
namespace
{

constexpr double kWidest_m = 0.04;     // how far a start may be off
constexpr double kNotch_m = 0.02;      // what plates leave between them at least
constexpr double kThinnest_m = 0.002;  // sheet steel

/// Plates that exist, with a notch between them.
bool isPossible(const ProfileHypothesis& h)
{
    const ProfileLengths& l = h.lengths;
    const double width = l[1] - l[0], depth = l[3] - l[2];
    if (!h.shape)
        return width > 0 && depth > 0;
    const double flanges = *h.shape == ProfileShape::I || *h.shape == ProfileShape::U ? 2.0 * l[5] : l[5];
    return l[4] > kThinnest_m && l[5] > kThinnest_m && width - l[4] > kNotch_m && depth - flanges > kNotch_m;
}

/// Mean of the squared distances, each at most that of `limit_m`.
double costOf(const ProfilePoints& local, const ProfileHypothesis& h, double limit_m)
{
    const std::vector<PlacedEdge> edges = placedEdges(h);
    double sum = 0;
    for (const Eigen::Vector2d& p : local)
        sum += std::min(nearestEdge(p, edges).square, limit_m * limit_m);
    return sum / static_cast<double>(local.size());
}

/// Moves the edges, and turns the section, to where the points within `reach_m` of them lie.
void improve(const ProfilePoints& local, ProfileHypothesis& h, double reach_m, bool mayTurn)
{
    const std::vector<ProfileEdge>& kind = edgesOf(h.shape);
    const std::vector<PlacedEdge> edges = placedEdges(h);
    using Vector = Eigen::Matrix<double, 7, 1>;
    Eigen::Matrix<double, 7, 7> a = Eigen::Matrix<double, 7, 7>::Zero();
    Vector b = Vector::Zero();
    const double reach = reach_m * reach_m;
    for (const Eigen::Vector2d& p : local)
    {
        const NearestEdge n = nearestEdge(p, edges);
        if (n.square >= reach)
            continue;
        const double w = (1 - n.square / reach) * (1 - n.square / reach);
        const ProfileEdge& e = kind[n.edge];
        Vector row;
        // Turning the points back by a small angle t moves x by t * y and y by -t * x.
        row << e.place, e.isVertical ? -p.y() : p.x();
        a += w * row * row.transpose();
        b += w * (e.isVertical ? p.x() : p.y()) * row;
    }
    // What no point says stays as it is.
    const double weak = 1e-3 * static_cast<double>(local.size());
    a.diagonal().array() += weak;
    b.head<6>() += weak * h.lengths;
    if (!mayTurn)
    {
        a.row(6).setZero();
        a.col(6).setZero();
        a(6, 6) = 1;
        b[6] = 0;
    }
    if (h.shape == ProfileShape::L)  // one thickness
    {
        a.row(4) += a.row(5);
        a.col(4) += a.col(5);
        b[4] += b[5];
        a.row(5).setZero();
        a.col(5).setZero();
        a(5, 5) = 1;
        b[5] = 0;
    }
    const Vector x = a.ldlt().solve(b);
    h.lengths = x.head<6>();
    if (h.shape == ProfileShape::L)
        h.lengths[5] = h.lengths[4];
    h.yaw_rad += x[6];
}

double quantile(std::vector<double> values, double share)
{
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace

std::vector<PlacedEdge> placedEdges(const ProfileHypothesis& h)
{
    std::vector<PlacedEdge> result;
    for (const ProfileEdge& e : edgesOf(h.shape))
        result.push_back({e.isVertical, e.place.dot(h.lengths), e.begin.dot(h.lengths), e.end.dot(h.lengths)});
    return result;
}

NearestEdge nearestEdge(const Eigen::Vector2d& p, const std::vector<PlacedEdge>& edges)
{
    NearestEdge nearest;
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
        const PlacedEdge& e = edges[i];
        const double off = (e.isVertical ? p.x() : p.y()) - e.place, along = e.isVertical ? p.y() : p.x();
        const double beyond = std::max({e.begin - along, along - e.end, 0.0});
        const double square = off * off + beyond * beyond;
        if (square < nearest.square)
            nearest = {i, square};
    }
    return nearest;
}

ProfilePoints turnedBack(const ProfilePoints& points, double yaw_rad)
{
    const Eigen::Rotation2Dd turn(-yaw_rad);
    ProfilePoints result;
    result.reserve(points.size());
    for (const Eigen::Vector2d& p : points)
        result.push_back(turn * p);
    return result;
}

void refineProfile(const ProfilePoints& points, ProfileHypothesis& h, std::span<const double> reaches_m, bool mayTurn)
{
    for (const double reach : reaches_m)
    {
        improve(turnedBack(points, h.yaw_rad), h, reach, mayTurn);
        if (!isPossible(h))
        {
            h.cost = std::numeric_limits<double>::infinity();
            return;
        }
    }
    h.cost = costOf(turnedBack(points, h.yaw_rad), h, kOutline_m);
}

ProfileHypothesis searchProfile(const ProfilePoints& points, std::optional<ProfileShape> shape, double yaw_rad)
{
    static constexpr std::array<double, 9> kReaches{kWidest_m, kWidest_m,  0.03,       0.03,      0.02,
                                                    0.02,      kOutline_m, kOutline_m, kOutline_m};
    const ProfilePoints local = turnedBack(points, yaw_rad);
    std::array<std::vector<double>, 2> along;
    for (const Eigen::Vector2d& p : local)
        along[0].push_back(p.x()), along[1].push_back(p.y());
    ProfileHypothesis start{shape, yaw_rad, ProfileLengths::Zero(), 0.0};
    start.lengths.head<4>() << quantile(along[0], 0.002), quantile(along[0], 0.998), quantile(along[1], 0.002),
        quantile(along[1], 0.998);
    std::vector<ProfileHypothesis> starts;
    if (!shape)
        starts.push_back(start);
    else
    {
        const double width = start.lengths[1] - start.lengths[0], depth = start.lengths[3] - start.lengths[2];
        for (const double web : {0.05, 0.15, 0.3, 0.45})
            for (const double flange : {0.06, 0.15, 0.28, 0.42})
            {
                start.lengths[4] = web * width;
                start.lengths[5] = flange * depth;
                if (shape == ProfileShape::L)
                {
                    if (flange != 0.06)
                        continue;
                    start.lengths[4] = start.lengths[5] = web * std::min(width, depth);
                }
                start.cost = costOf(local, start, kWidest_m);
                if (isPossible(start))
                    starts.push_back(start);
            }
        std::stable_sort(starts.begin(), starts.end(),
                         [](const ProfileHypothesis& a, const ProfileHypothesis& b) { return a.cost < b.cost; });
        starts.resize(std::min<std::size_t>(starts.size(), 3));
    }
    ProfileHypothesis best;
    for (ProfileHypothesis& h : starts)
    {
        refineProfile(points, h, kReaches, true);
        if (h.cost < best.cost)
            best = h;
    }
    best.shape = shape;
    return best;
}

}  // namespace s2b

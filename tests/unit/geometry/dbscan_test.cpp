// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/dbscan.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace
{

using namespace s2b;

/// DBSCAN as dbscan.h defines it, by looking at every pair.
template <class Point>
std::vector<int> bruteForce(const std::vector<Point>& points, double eps, int minPoints)
{
    const std::size_t n = points.size();
    const auto distance2 = [&](std::size_t a, std::size_t b)
    { return (points[a].template cast<double>() - points[b].template cast<double>()).squaredNorm(); };
    std::vector<char> core(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        int count = 0;
        for (std::size_t j = 0; j < n; ++j)
            count += distance2(i, j) <= eps * eps ? 1 : 0;
        core[i] = count >= minPoints;
    }
    std::vector<int> cluster(n, -1);  // of core points: the lowest core point that they are connected to
    for (std::size_t i = 0; i < n; ++i)
    {
        if (!core[i] || cluster[i] >= 0)
            continue;
        std::vector<std::size_t> open{i};
        cluster[i] = int(i);
        while (!open.empty())
        {
            const std::size_t p = open.back();
            open.pop_back();
            for (std::size_t q = 0; q < n; ++q)
            {
                if (core[q] && cluster[q] < 0 && distance2(p, q) <= eps * eps)
                {
                    cluster[q] = int(i);
                    open.push_back(q);
                }
            }
        }
    }
    for (std::size_t i = 0; i < n; ++i)
    {
        double nearest2 = eps * eps;
        for (std::size_t j = 0; !core[i] && j < n; ++j)
        {
            // The first of equally near ones stays.
            if (core[j] && (distance2(i, j) < nearest2 || (distance2(i, j) == nearest2 && cluster[i] < 0)))
            {
                nearest2 = distance2(i, j);
                cluster[i] = cluster[j];
            }
        }
    }
    std::vector<int> number(n, -1);
    std::vector<int> labels(n, -1);
    int next = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
        if (cluster[i] < 0)
            continue;
        int& known = number[std::size_t(cluster[i])];
        if (known < 0)
            known = next++;
        labels[i] = known;
    }
    return labels;
}

/// Blobs and background in a box of 4 m, some points on a lattice of 0.05 m so that distances of exactly eps occur.
template <class Point>
std::vector<Point> scene(unsigned seed, double shift = 0.0)
{
    using Scalar = typename Point::Scalar;
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> place(-2.0, 2.0);
    std::normal_distribution<double> spread(0.0, 0.12);
    std::vector<Point> points;
    const auto add = [&](auto make)
    {
        Point p;
        for (Eigen::Index d = 0; d < p.size(); ++d)
            p[d] = Scalar(make(d) + shift);
        points.push_back(p);
    };
    for (int blob = 0; blob < 6; ++blob)
    {
        const std::array<double, 3> center{place(generator), place(generator), place(generator)};
        for (int i = 0; i < 80; ++i)
            add([&](Eigen::Index d) { return center[std::size_t(d)] + spread(generator); });
    }
    for (int i = 0; i < 150; ++i)
        add([&](Eigen::Index) { return place(generator); });
    for (int i = 0; i < 120; ++i)
        add([&](Eigen::Index) { return 0.0625 * std::round(place(generator) * 4.0); });
    std::ranges::shuffle(points, generator);
    return points;
}

template <class Point>
class Dbscan : public testing::Test
{
};
using Points = testing::Types<Eigen::Vector2f, Eigen::Vector2d, Eigen::Vector3f, Eigen::Vector3d>;
TYPED_TEST_SUITE(Dbscan, Points);

TYPED_TEST(Dbscan, EqualsBruteForce)
{
    for (unsigned seed = 0; seed < 6; ++seed)
    {
        const std::vector<TypeParam> points = scene<TypeParam>(seed);
        // 0.0625 and 0.125 are distances of the lattice, exactly.
        for (const double eps : {0.0625, 0.125, 0.05 + 0.05 * double(seed)})
        {
            for (const int minPoints : {1, 2, 4, 9})
                ASSERT_EQ(dbscan(points, eps, minPoints), bruteForce(points, eps, minPoints))
                    << "seed " << seed << ", eps " << eps << ", minPoints " << minPoints;
        }
    }
}

TYPED_TEST(Dbscan, EqualsBruteForceFarFromTheOrigin)
{
    // Float points are then on a lattice of 6 cm, with many duplicates.
    const std::vector<TypeParam> points = scene<TypeParam>(7, 1e6);
    for (const double eps : {0.0625, 0.125, 0.3})
        ASSERT_EQ(dbscan(points, eps, 4), bruteForce(points, eps, 4)) << eps;
}

TYPED_TEST(Dbscan, ClustersDoNotDependOnTheOrderOfThePoints)
{
    std::vector<TypeParam> points = scene<TypeParam>(3);
    points.resize(points.size() / 2);
    const std::vector<int> labels = dbscan(points, 0.17, 5);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::shuffle(order, std::mt19937(11));
    std::vector<TypeParam> shuffled;
    for (const std::size_t i : order)
        shuffled.push_back(points[i]);
    const std::vector<int> shuffledLabels = dbscan(shuffled, 0.17, 5);
    // The partition is the same one, up to the numbers.
    std::vector<int> translation(points.size(), -2);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
        const int label = labels[order[i]];
        ASSERT_EQ(label < 0, shuffledLabels[i] < 0);
        if (label < 0)
            continue;
        int& expected = translation[std::size_t(label)];
        if (expected == -2)
            expected = shuffledLabels[i];
        ASSERT_EQ(shuffledLabels[i], expected);
    }
}

TYPED_TEST(Dbscan, HandlesNoneOneAndEqualPoints)
{
    using Vector = std::vector<TypeParam>;
    EXPECT_TRUE(dbscan(Vector{}, 0.1, 3).empty());
    EXPECT_EQ(dbscan(Vector(1, TypeParam::Ones()), 0.1, 1), std::vector<int>{0});
    EXPECT_EQ(dbscan(Vector(1, TypeParam::Ones()), 0.1, 2), std::vector<int>{-1});
    EXPECT_EQ(dbscan(Vector(5, TypeParam::Ones()), 1e-9, 5), std::vector<int>(5, 0));
    EXPECT_EQ(dbscan(Vector(5, TypeParam::Ones()), 1e-9, 6), std::vector<int>(5, -1));
    EXPECT_EQ(dbscan(Vector(2, TypeParam::Ones()), 0.1, -3), std::vector<int>(2, 0));
}

TYPED_TEST(Dbscan, NumbersClustersByTheirFirstPoint)
{
    std::vector<TypeParam> points(5, TypeParam::Zero());
    points[0][0] = 50;  // noise
    points[1][0] = 10;
    points[3][0] = 10;
    EXPECT_EQ(dbscan(points, 0.5, 2), (std::vector<int>{-1, 0, 1, 0, 1}));
}

TYPED_TEST(Dbscan, PointAtExactlyTheRadiusIsANeighbour)
{
    std::vector<TypeParam> points(2, TypeParam::Zero());
    points[1][0] = 0.5;
    EXPECT_EQ(dbscan(points, 0.5, 2), (std::vector<int>{0, 0}));
    EXPECT_EQ(dbscan(points, 0.4999, 2), (std::vector<int>{-1, -1}));
}

TYPED_TEST(Dbscan, RefusesBadPointsAndBadRadii)
{
    std::vector<TypeParam> points(3, TypeParam::Zero());
    for (const double eps : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_THROW((void)dbscan(points, eps, 1), Error) << eps;
    points[2][0] = 1000;
    EXPECT_THROW((void)dbscan(points, 1e-9, 1), Error);  // 1e12 cells along an axis
    points[1][1] = std::numeric_limits<typename TypeParam::Scalar>::quiet_NaN();
    EXPECT_THROW((void)dbscan(points, 0.1, 1), Error);
    points[1][1] = std::numeric_limits<typename TypeParam::Scalar>::infinity();
    EXPECT_THROW((void)dbscan(points, 0.1, 1), Error);
}

TEST(DbscanCost, IsNotQuadraticInTheNumberOfPointsWithinTheRadius)
{
    // All 400 000 points lie in a few cells, in two groups just farther apart than eps. 1.6e11 distances would take
    // minutes; the limit of the test runner would end it.
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> place(0.0, 0.4);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 400'000; ++i)
        points.emplace_back(place(generator) + (i % 2 == 0 ? 0.0 : 1.41), place(generator), place(generator));
    const std::vector<int> labels = dbscan(points, 1.0, 10);
    for (std::size_t i = 0; i < labels.size(); ++i)
        ASSERT_EQ(labels[i], int(i % 2));
}

}  // namespace

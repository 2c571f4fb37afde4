// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/columns/profile_fit.h"
#include "core/base/random.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <numbers>

namespace s2b
{
namespace
{

constexpr double kNoise_m = 0.003;
// The offset of a face is the mean of hundreds of points; a thin plate's faces share some of each other's.
constexpr double kSize_m = 0.0015;

/// Points on a section's outline, turned and moved, with noise across the faces; only those that `isSeen` keeps (in the
/// section's own directions).
std::vector<Eigen::Vector2d> pointsOn(
    const Section& section, const Eigen::Vector2d& center = {7.0, -3.0}, double yaw_rad = 0.0,
    double noise_m = kNoise_m,
    const std::function<bool(const Eigen::Vector2d&, const Eigen::Vector2d&)>& isSeen =
        [](const Eigen::Vector2d&, const Eigen::Vector2d&) { return true; })
{
    const std::vector<Eigen::Vector2d> ring = outlineOf(section);
    const Eigen::Rotation2Dd turn(yaw_rad);
    std::vector<Eigen::Vector2d> points;
    std::uint64_t draw = 0;
    const auto gauss = [&]
    {
        const double a = std::max(1e-12, randomShare(1, 2, ++draw)), b = randomShare(1, 2, ++draw);
        return std::sqrt(-2 * std::log(a)) * std::cos(2 * std::numbers::pi * b);
    };
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const Eigen::Vector2d a = ring[i], d = ring[(i + 1) % ring.size()] - a;
        const Eigen::Vector2d out = Eigen::Vector2d(d.y(), -d.x()).normalized();
        const int count = static_cast<int>(d.norm() * 2000);  // a column 2 m high at 3 cm spacing, or so
        for (int k = 0; k < count; ++k)
        {
            const Eigen::Vector2d p = a + d * ((k + randomShare(1, 2, ++draw)) / count);
            if (isSeen(p, out))
                points.push_back(center + turn * (p + out * (noise_m * gauss())));
        }
    }
    return points;
}

std::optional<ProfileFit> fit(const std::vector<Eigen::Vector2d>& points)
{
    return fitProfile(points, Eigen::Vector2d::UnitX(), {});
}

/// The same section in the same place, whatever its directions are called.
void expectSection(const std::optional<ProfileFit>& f, const ProfileSection& s, const Eigen::Vector2d& center,
                   double yaw, double tolerance = kSize_m)
{
    ASSERT_TRUE(f.has_value());
    EXPECT_EQ(shapeName(f->section.shape), shapeName(s.shape));
    EXPECT_NEAR(f->section.width_m, s.width_m, tolerance);
    EXPECT_NEAR(f->section.depth_m, s.depth_m, tolerance);
    EXPECT_NEAR(f->section.web_m, s.web_m, tolerance);
    EXPECT_NEAR(f->section.flange_m, s.flange_m, tolerance);
    EXPECT_LT((f->center - center).norm(), tolerance);
    const double period = s.shape == ProfileShape::I ? std::numbers::pi : 2 * std::numbers::pi;
    EXPECT_NEAR(std::remainder(f->yaw_rad - yaw, period), 0.0, 0.01);
}

const std::vector<ProfileSection> kSections{{ProfileShape::I, 0.30, 0.30, 0.011, 0.019},    // HE 300 B
                                            {ProfileShape::I, 0.19, 0.45, 0.0094, 0.0146},  // IPE 450
                                            {ProfileShape::L, 0.20, 0.20, 0.020, 0.020},    // rolled angle
                                            {ProfileShape::L, 0.60, 0.40, 0.18, 0.18},      // cast in a corner
                                            {ProfileShape::U, 0.10, 0.30, 0.010, 0.016},    // UPN 300
                                            {ProfileShape::U, 0.50, 0.60, 0.15, 0.15},
                                            {ProfileShape::T, 0.30, 0.15, 0.011, 0.019},
                                            {ProfileShape::T, 0.80, 0.60, 0.25, 0.20}};

TEST(ProfileFit, FindsEachShapeInEachDirection)
{
    for (const ProfileSection& s : kSections)
        for (const double yaw : {0.0, 0.4, std::numbers::pi / 2, 2.5, -1.9})
        {
            SCOPED_TRACE(std::string(shapeName(s.shape)) + " " + std::to_string(s.width_m) + " at " +
                         std::to_string(yaw));
            expectSection(fit(pointsOn(s, {7, -3}, yaw)), s, {7, -3}, yaw);
        }
}

TEST(ProfileFit, KeepsTheBuildingsDirection)
{
    const auto f = fit(pointsOn(kSections[0], {7, -3}, 0.3 * std::numbers::pi / 180.0));
    ASSERT_TRUE(f.has_value());
    EXPECT_EQ(f->yaw_rad, 0.0);
}

TEST(ProfileFit, IsNotMisledByStraysAndFillets)
{
    std::vector<Eigen::Vector2d> points = pointsOn(kSections[0]);
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count / 20; ++i)
        points.emplace_back(6.75 + 0.5 * randomShare(3, 1, i), -3.25 + 0.5 * randomShare(3, 2, i));
    // Fillets of 27 mm between web and flanges.
    for (std::size_t i = 0; i < count / 20; ++i)
    {
        const double a = std::numbers::pi / 2 * randomShare(3, 3, i);
        const Eigen::Vector2d p(0.0055 + 0.027 * (1 - std::sin(a)), -0.131 + 0.027 * (1 - std::cos(a)));
        points.emplace_back(Eigen::Vector2d(7, -3) +
                            Eigen::Vector2d(i % 2 ? p.x() : -p.x(), i % 4 < 2 ? p.y() : -p.y()));
    }
    expectSection(fit(points), kSections[0], {7, -3}, 0.0, 0.004);
}

TEST(ProfileFit, SaysNothingOfAnISeenFromOneSide)
{
    // It may as well be a U.
    for (const ProfileSection& s : {kSections[0], kSections[1]})
        EXPECT_FALSE(fit(pointsOn(s, {7, -3}, 0.0, kNoise_m, [](const Eigen::Vector2d& p, const Eigen::Vector2d& out)
                                  { return p.x() > 0 && out.x() > -0.5; })));
}

TEST(ProfileFit, SaysNothingOfPlatesSeenFromOneSide)
{
    // The backs of both legs are against walls: how thick they are isn't seen.
    EXPECT_FALSE(
        fit(pointsOn(kSections[3], {7, -3}, 0.0, kNoise_m, [](const Eigen::Vector2d&, const Eigen::Vector2d& out)
                     { return out.x() > -0.5 && out.y() > -0.5; })));
    // The web's back of a U.
    EXPECT_FALSE(fit(pointsOn(kSections[5], {7, -3}, 0.0, kNoise_m,
                              [](const Eigen::Vector2d&, const Eigen::Vector2d& out) { return out.x() > -0.5; })));
}

TEST(ProfileFit, SaysNothingOfPlatesThinnerThanTheNoise)
{
    EXPECT_FALSE(fit(pointsOn(ProfileSection{ProfileShape::I, 0.30, 0.30, 0.006, 0.010}, {7, -3}, 0.0, 0.008)));
}

TEST(ProfileFit, SaysNothingOfRectanglesAndCircles)
{
    for (const double yaw : {0.0, 0.4})
    {
        EXPECT_FALSE(fit(pointsOn(RectangleSection{0.4, 0.3}, {7, -3}, yaw)));
        EXPECT_FALSE(fit(pointsOn(RectangleSection{0.1, 0.1}, {7, -3}, yaw)));
        EXPECT_FALSE(fit(pointsOn(RectangleSection{0.4, 0.3}, {7, -3}, yaw, kNoise_m,
                                  [](const Eigen::Vector2d&, const Eigen::Vector2d& out)
                                  { return out.x() > 0.5 || out.y() > 0.5; })));
    }
    EXPECT_FALSE(fit(pointsOn(CircleSection{0.2})));
}

TEST(ProfileFit, SaysNothingOfACrossAndOfARectangleWithACableDuct)
{
    // A cross of four angles: none of the shapes.
    std::vector<Eigen::Vector2d> cross = pointsOn(RectangleSection{0.4, 0.02});
    for (const Eigen::Vector2d& p : pointsOn(RectangleSection{0.02, 0.4}))
        cross.push_back(p);
    EXPECT_FALSE(fit(cross));
    std::vector<Eigen::Vector2d> duct = pointsOn(RectangleSection{0.4, 0.4});
    for (const Eigen::Vector2d& p : pointsOn(RectangleSection{0.04, 0.04}, {7.22, -3.0}))
        duct.push_back(p);
    EXPECT_FALSE(fit(duct));
}

TEST(ProfileFit, HoldsFarFromTheOriginAndForAnyDegenerateInput)
{
    expectSection(fit(pointsOn(kSections[0], {1e5, -1e5})), kSections[0], {1e5, -1e5}, 0.0);
    EXPECT_FALSE(fit({}));
    EXPECT_FALSE(fit(std::vector<Eigen::Vector2d>(1, {1, 1})));
    EXPECT_FALSE(fit(std::vector<Eigen::Vector2d>(1000, {1, 1})));
    std::vector<Eigen::Vector2d> line;
    for (int i = 0; i < 1000; ++i)
        line.emplace_back(0.001 * i, 2.0);
    EXPECT_FALSE(fit(line));
}

}  // namespace
}  // namespace s2b

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/plane.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sample_consensus/sac_model_plane.h>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <memory>

namespace s2b
{

namespace
{

constexpr int kRefineRounds = 5;

/// The probability that the best plane is not missed, after which draws end early.
constexpr double kConfidence = 0.9999;

/// PCL seeds its draws with a constant or with chance; ours come from the run's seed. And it prints an error for each
/// draw of collinear points, which is no error here.
class PlaneModel : public pcl::SampleConsensusModelPlane<pcl::PointXYZ>
{
public:
    PlaneModel(const PointCloudConstPtr& cloud, std::uint64_t seed) : SampleConsensusModelPlane(cloud)
    {
        rng_alg_.seed(static_cast<std::uint32_t>(seed ^ (seed >> 32)));
    }

    /// Plane through three points that are not collinear, as PCL's coefficients; PCL's own call complains on stderr of
    /// draws that are merely narrow.
    [[nodiscard]] Eigen::VectorXf through(const pcl::Indices& samples) const
    {
        const Eigen::Vector3f a = at(samples[0]);
        const Eigen::Vector3f n = (at(samples[1]) - a).cross(at(samples[2]) - a).normalized();
        Eigen::VectorXf coefficients(4);
        coefficients << n, -n.dot(a);
        return coefficients;
    }

protected:
    [[nodiscard]] bool isSampleGood(const pcl::Indices& samples) const override
    {
        const Eigen::Vector3f a = at(samples[0]);
        const Eigen::Vector3f ab = at(samples[1]) - a;
        const Eigen::Vector3f ac = at(samples[2]) - a;
        return ab.cross(ac).norm() > 1e-4f * std::max(ab.squaredNorm(), ac.squaredNorm());
    }

private:
    [[nodiscard]] Eigen::Vector3f at(pcl::index_t i) const
    {
        return (*input_)[static_cast<std::size_t>(i)].getVector3fMap();
    }
};

/// The best of the drawn planes (PCL's RandomSampleConsensus prints when there is none). @return its inliers.
pcl::Indices drawPlane(PlaneModel& model, std::size_t pointCount, const PlaneOptions& options)
{
    Eigen::VectorXf best;
    std::size_t bestCount = 0;
    double needed = options.trials;
    for (int trial = 0; trial < options.trials && trial < needed; ++trial)
    {
        int iteration = trial;
        pcl::Indices samples;
        model.getSamples(iteration, samples);
        if (samples.empty())
            break;  // a thousand draws in a row were collinear
        const Eigen::VectorXf plane = model.through(samples);
        const std::size_t count = model.countWithinDistance(plane, options.tolerance_m);
        if (count <= bestCount)
            continue;
        best = plane;
        bestCount = count;
        const double allInliers = std::pow(static_cast<double>(count) / static_cast<double>(pointCount), 3);
        needed = std::log(1.0 - kConfidence) / std::log(std::max(1.0 - allInliers, 1e-12));
    }
    pcl::Indices inliers;
    if (bestCount > 0)
        model.selectWithinDistance(best, options.tolerance_m, inliers);
    return inliers;
}

/// Total least squares over some of the points. @return false when they are collinear.
bool fitToInliers(std::span<const Eigen::Vector3f> points, PlaneFit& plane)
{
    if (plane.inliers.size() < 3)
        return false;
    const Eigen::Vector3d reference = points[plane.inliers.front()].cast<double>();
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const std::size_t i : plane.inliers)
        mean += points[i].cast<double>() - reference;
    mean /= static_cast<double>(plane.inliers.size());
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const std::size_t i : plane.inliers)
    {
        const Eigen::Vector3d d = points[i].cast<double>() - reference - mean;
        moments += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
    if (!(solver.eigenvalues()[1] > 1e-12 * solver.eigenvalues()[2]))
        return false;
    plane.normal = solver.eigenvectors().col(0);
    Eigen::Index largest = 0;
    plane.normal.cwiseAbs().maxCoeff(&largest);
    if (plane.normal[largest] < 0.0)
        plane.normal = -plane.normal;
    plane.offset_m = plane.normal.dot(reference + mean);
    return true;
}

void gatherInliers(std::span<const Eigen::Vector3f> points, double tolerance, PlaneFit& plane)
{
    plane.inliers.clear();
    double squares = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double distance = plane.distance(points[i].cast<double>());
        if (std::abs(distance) > tolerance)
            continue;
        plane.inliers.push_back(i);
        squares += distance * distance;
    }
    const auto count = static_cast<double>(plane.inliers.size());
    plane.inlierShare = count / static_cast<double>(points.size());
    plane.rms_m = plane.inliers.empty() ? 0.0 : std::sqrt(squares / count);
}

}  // namespace

std::optional<PlaneFit> fitPlane(std::span<const Eigen::Vector3f> points, const PlaneOptions& options)
{
    if (points.size() < 3)
        return std::nullopt;
    // PCL's float planes lose millimetres far from the origin.
    const Eigen::Vector3f reference = points.front();
    auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    cloud->reserve(points.size());
    for (const Eigen::Vector3f& p : points)
        cloud->emplace_back(p.x() - reference.x(), p.y() - reference.y(), p.z() - reference.z());
    PlaneModel model(cloud, options.seed);

    PlaneFit plane;
    for (const auto i : drawPlane(model, points.size(), options))
        plane.inliers.push_back(static_cast<std::size_t>(i));
    for (int round = 0; round < kRefineRounds; ++round)
    {
        if (!fitToInliers(points, plane))
            return std::nullopt;
        const std::size_t before = plane.inliers.size();
        gatherInliers(points, options.tolerance_m, plane);
        if (plane.inliers.size() == before)
            break;
    }
    return plane;
}

}  // namespace s2b

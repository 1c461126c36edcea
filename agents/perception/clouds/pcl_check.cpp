#include "agents/perception/clouds/pcl_check.hpp"

#include <pcl/ModelCoefficients.h>
#include <pcl/common/common.h>
#include <pcl/filters/radius_outlier_removal.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/ndt.h>
#include <pcl/segmentation/sac_segmentation.h>
// Compiled here: PCL's library of it loads that of its features, 42 MB of which nothing is called.
#include <pcl/segmentation/impl/sac_segmentation.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#ifdef __AVX__
#error "PCL's libraries were built without AVX: with it Eigen aligns differently here, and programs crash"
#endif

namespace weft::agents::pcl_check {
namespace {

using PclCloud = pcl::PointCloud<pcl::PointXYZ>;

PclCloud::Ptr pcl_cloud(std::span<const Eigen::Vector3f> points) {
  auto cloud = PclCloud::Ptr(new PclCloud);
  cloud->reserve(points.size());
  for (const Eigen::Vector3f& point : points) {
    if (point.allFinite()) cloud->emplace_back(point.x(), point.y(), point.z());
  }
  return cloud;
}

Eigen::Matrix4f matrix_of(const Pose3& pose) {
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix.topLeftCorner<3, 3>() = pose.rotation.toRotationMatrix().cast<float>();
  matrix.topRightCorner<3, 1>() = pose.translation.cast<float>();
  return matrix;
}

Pose3 pose_of(const Eigen::Matrix4f& matrix) {
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>().cast<double>();
  return {Eigen::Quaterniond(rotation).normalized(), matrix.topRightCorner<3, 1>().cast<double>()};
}

constexpr double kMostCubes = 2147483647.0;  // PCL counts them with 32 bits

double cubes_spanned(const PclCloud& cloud, double voxel_m) {
  pcl::PointXYZ least;
  pcl::PointXYZ most;
  pcl::getMinMax3D(cloud, least, most);
  const Eigen::Vector3d span = (most.getVector3fMap() - least.getVector3fMap()).cast<double>() / voxel_m;
  return (span.array().floor() + 2.0).prod();
}

/// Lets one of PCL's registrations go from the guess.
template <class Registration>
Opinion opinion_of(Registration& registration, std::span<const Eigen::Vector3f> a, std::span<const Eigen::Vector3f> b,
                   const Pose3& guess) {
  const PclCloud::Ptr fixed = pcl_cloud(a);
  const PclCloud::Ptr moving = pcl_cloud(b);
  if (fixed->empty() || moving->empty()) return {guess, false, 0.0};
  registration.setInputTarget(fixed);
  registration.setInputSource(moving);
  PclCloud aligned;
  registration.align(aligned, matrix_of(guess));
  return {pose_of(registration.getFinalTransformation()), registration.hasConverged(),
          registration.getFitnessScore()};
}

}  // namespace

Pose3 FloorFound::level_from_frame() const {
  const Eigen::Quaterniond rotation = Eigen::Quaterniond::FromTwoVectors(normal, Eigen::Vector3d::UnitZ());
  return {rotation, {0.0, 0.0, height_m}};
}

std::optional<FloorFound> find_floor(std::span<const Eigen::Vector3f> points, const FloorSearch& search) {
  const PclCloud::Ptr cloud = pcl_cloud(points);
  const auto least =
      std::max(static_cast<double>(search.least_points), search.least_share * static_cast<double>(cloud->size()));
  if (static_cast<double>(cloud->size()) < least) return std::nullopt;
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setModelType(pcl::SACMODEL_PERPENDICULAR_PLANE);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setAxis(Eigen::Vector3f::UnitZ());
  segmentation.setEpsAngle(search.most_tilt_rad);
  segmentation.setDistanceThreshold(search.within_m);
  segmentation.setMaxIterations(200);
  segmentation.setOptimizeCoefficients(true);
  segmentation.setInputCloud(cloud);
  pcl::PointIndices inliers;
  pcl::ModelCoefficients plane;  // normal, then its distance: n x + d = 0
  segmentation.segment(inliers, plane);
  if (plane.values.size() != 4 || static_cast<double>(inliers.indices.size()) < least) return std::nullopt;
  const Eigen::Vector3d normal = Eigen::Vector3f(plane.values[0], plane.values[1], plane.values[2]).cast<double>();
  const double up = normal.z() < 0.0 ? -1.0 : 1.0;
  return FloorFound{up * normal.normalized(), up * static_cast<double>(plane.values[3]) / normal.norm(),
                    inliers.indices.size()};
}

Result<std::vector<Eigen::Vector3f>> voxel_grid(std::span<const Eigen::Vector3f> points, double voxel_m) {
  const PclCloud::Ptr cloud = pcl_cloud(points);
  if (cloud->empty()) return std::vector<Eigen::Vector3f>();
  if (const double cubes = cubes_spanned(*cloud, voxel_m); cubes > kMostCubes) {
    return fail(ErrorCode::invalid, "the cloud spans " + std::to_string(cubes) + " voxels of " +
                                        std::to_string(voxel_m) +
                                        " m, at most 2^31 can be numbered; take larger ones");
  }
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  const auto edge = static_cast<float>(voxel_m);
  grid.setInputCloud(cloud);
  grid.setLeafSize(edge, edge, edge);
  PclCloud thinned;
  grid.filter(thinned);
  std::vector<Eigen::Vector3f> means;
  means.reserve(thinned.size());
  for (const pcl::PointXYZ& point : thinned) means.emplace_back(point.getVector3fMap());
  return means;
}

std::vector<std::uint32_t> with_neighbours(std::span<const Eigen::Vector3f> points, double radius_m, int neighbours) {
  std::vector<std::uint32_t> finite;
  for (std::uint32_t at = 0; at < points.size(); ++at) {
    if (points[at].allFinite()) finite.push_back(at);
  }
  pcl::RadiusOutlierRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(pcl_cloud(points));
  removal.setRadiusSearch(radius_m);
  removal.setMinNeighborsInRadius(neighbours);
  pcl::Indices kept;
  removal.filter(kept);
  std::vector<std::uint32_t> indices;
  indices.reserve(kept.size());
  for (const auto index : kept) indices.push_back(finite[static_cast<std::size_t>(index)]);
  return indices;
}

Opinion register_p2d_ndt(std::span<const Eigen::Vector3f> a, std::span<const Eigen::Vector3f> b, const Pose3& guess,
                         double cell_m) {
  pcl::NormalDistributionsTransform<pcl::PointXYZ, pcl::PointXYZ> ndt;
  ndt.setResolution(static_cast<float>(cell_m));
  ndt.setStepSize(0.1);
  ndt.setTransformationEpsilon(1e-4);
  ndt.setMaximumIterations(40);
  return opinion_of(ndt, a, b, guess);
}

Opinion register_gicp(std::span<const Eigen::Vector3f> a, std::span<const Eigen::Vector3f> b, const Pose3& guess,
                      double farthest_m) {
  pcl::GeneralizedIterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> gicp;
  gicp.setMaxCorrespondenceDistance(farthest_m);
  gicp.setTransformationEpsilon(1e-5);
  gicp.setMaximumIterations(60);
  return opinion_of(gicp, a, b, guess);
}

}  // namespace weft::agents::pcl_check

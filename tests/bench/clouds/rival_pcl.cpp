// PCL's templates stay in this file, and with all of their bodies: its libraries need not be linked but the common
// one.
#define PCL_NO_PRECOMPILE
#include <pcl/compression/octree_pointcloud_compression.h>
#include <pcl/point_types.h>

#include <pcl/io/impl/entropy_range_coder.hpp>
#include <pcl/io/impl/octree_pointcloud_compression.hpp>
#include <sstream>

#include "tests/bench/clouds/rivals.hpp"

namespace weft::clouds {
namespace {

using Coder = pcl::io::OctreePointCloudCompression<pcl::PointXYZ>;

Coder coder(double step_m, double voxel_m) {
  constexpr bool kStatistics = false;
  constexpr bool kOnePointAVoxel = false;
  constexpr bool kColours = false;
  return {pcl::io::MANUAL_CONFIGURATION, kStatistics, step_m, voxel_m, kOnePointAVoxel, 1, kColours};
}

}  // namespace

std::string pcl_compressed(const Cloud& cloud, double quantum_m, int voxel_steps) {
  const auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  points->reserve(cloud.points.size());
  for (const Eigen::Vector3f& point : cloud.points) points->emplace_back(point.x(), point.y(), point.z());
  std::stringstream out;
  coder(quantum_m / 2, quantum_m / 2 * voxel_steps).encodePointCloud(points, out);
  return out.str();
}

std::size_t pcl_point_count(const std::string& compressed) {
  std::stringstream in(compressed);
  auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  coder(0.001, 0.01).decodePointCloud(in, points);  // the stream's own sizes replace these
  return points->size();
}

}  // namespace weft::clouds

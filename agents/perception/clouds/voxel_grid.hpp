#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

namespace weft::agents {

/// Returns the mean of the points in each occupied cube of `voxel_m`, in the order in which the cubes first occur.
/// Points that are not finite are left out.
std::vector<Eigen::Vector3f> voxel_means(std::span<const Eigen::Vector3f> points, double voxel_m);

}  // namespace weft::agents

#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/pose3.hpp"
#include "core/result.hpp"

/// Holds what the Point Cloud Library does for us, and the only file that includes it. It is compiled without flags
/// of an architecture: PCL's libraries and callers must agree on Eigen's alignment.
namespace weft::agents::pcl_check {

struct FloorSearch {
  double within_m = 0.03;      ///< of the plane
  double most_tilt_rad = 0.1;  ///< between its normal and z
  double least_share = 0.05;   ///< of the points that must lie on it
  std::size_t least_points = 200;
};

/// Describes a floor. Heights and tilts are of the frame that the points are in.
struct FloorFound {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< up
  double height_m = 0.0;                              ///< of the floor below the origin, negative above
  std::size_t points = 0;                             ///< that lie on it

  /// Returns the pose of the given frame above a floor at z = 0: level, heading kept.
  Pose3 level_from_frame() const;
};

/// Finds the plane across z that most points lie on, by consensus (SACMODEL_PERPENDICULAR_PLANE) and least squares.
/// None: too few lie on one. Draws from a fixed seed.
std::optional<FloorFound> find_floor(std::span<const Eigen::Vector3f> points, const FloorSearch& search);

/// Returns the mean of the points in each cube of `voxel_m`, > 0, as pcl::VoxelGrid has it. invalid: the cloud spans
/// more cubes than PCL can number.
Result<std::vector<Eigen::Vector3f>> voxel_grid(std::span<const Eigen::Vector3f> points, double voxel_m);

/// Returns the indices of the points that have at least `neighbours` others within `radius_m`, in order.
std::vector<std::uint32_t> with_neighbours(std::span<const Eigen::Vector3f> points, double radius_m, int neighbours);

/// Describes what another registration says.
struct Opinion {
  Pose3 a_from_b;
  bool has_converged = false;
  double fitness_m2 = 0.0;  ///< mean squared distance from b's points to the nearest of a's
};

/// Registers b's points to the cells of a (P2D-NDT, Magnusson 2009), as a second opinion.
Opinion register_p2d_ndt(std::span<const Eigen::Vector3f> a, std::span<const Eigen::Vector3f> b, const Pose3& guess,
                         double cell_m);

/// Registers two clouds plane to plane (GICP, Segal et al. 2009), as a rival of benches and studies.
Opinion register_gicp(std::span<const Eigen::Vector3f> a, std::span<const Eigen::Vector3f> b, const Pose3& guess,
                      double farthest_m);

}  // namespace weft::agents::pcl_check

#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "agents/control/grid/occupancy_grid.hpp"
#include "agents/control/grid/ray_lines.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Bounds how rays make a grid (Dayoub et al. 2013, III-A).
struct RayCastConfig {
  int n_min = 3;               ///< rays that a cell needs to be known; [1, 1000]
  double tau = 0.25;           ///< share of them that ends in an occupied cell; (0, 1]
  double range_m = 5.0;        ///< longer rays, measured in space, say nothing; (0, 100]
  double floor_m = 0.06;       ///< a point this near to z = 0 is floor; (0, 0.5]
  double body_height_m = 1.5;  ///< of the robot; (0, 5]
  double above_m = 0.2;        ///< what hangs higher than this above the body says nothing; [0, 2]
};
/// Returns every bound that does not hold, each error naming field, value and bound.
std::vector<Error> check(const RayCastConfig& config);

/// Holds points with the frame that has seen each, in a levelled frame: z is above the floor.
struct SeenCloud {
  struct Point {
    Eigen::Vector3f at = Eigen::Vector3f::Zero();
    std::uint16_t frame = 0;  ///< index into `cameras`
  };
  std::vector<Point> points;
  std::vector<Eigen::Vector3f> cameras;  ///< where the camera was, frame by frame
};

/// Counts rays from the camera of each frame to its points, seen from above, and makes an occupancy grid of them
/// (Elfes 1989 as Dayoub et al. use it). The cells that a ray crosses are passed, the one it ends in is hit. Differs
/// from the paper, which filters nothing by height, as beams and lintels would be walls: floor is passed and never
/// hit, what hangs higher than the robot does neither. A point below the floor is hit, and nothing before it is
/// passed: the ray went over an edge.
class RayCaster {
 public:
  /// The configuration has passed check().
  RayCaster(const Raster& raster, const RayCastConfig& config);

  /// Counts the rays of one cloud; points that are not finite are left out. invalid: a point names a frame without a
  /// camera; then none of the cloud is counted.
  Result<void> cast(const SeenCloud& cloud);
  /// Returns the grid of all that was cast: unknown with fewer than n_min rays, occupied from a share of tau on.
  OccupancyGrid grid() const;

 private:
  void count_frame(const SeenCloud& cloud, const std::uint32_t* first, const std::uint32_t* last,
                   const Eigen::Vector3f& camera);
  void count_ray(const Cell& from, const Cell& to, bool is_floor);
  void walk_lines(const Cell& from);

  Raster raster_;
  RayCastConfig config_;
  RayLines lines_;
  std::vector<std::uint32_t> hits_;    ///< by cell
  std::vector<std::uint32_t> passes_;  ///< by cell
  /// Holds, of one frame, how many rays pass the first so many cells of a line, line by line.
  std::vector<std::uint32_t> reach_;
  std::vector<int> longest_;  ///< of one frame, by line
  std::vector<int> used_;     ///< lines of one frame
};

}  // namespace weft::agents

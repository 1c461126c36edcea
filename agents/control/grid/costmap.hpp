#pragma once
#include <cstdint>
#include <vector>

#include "agents/control/grid/occupancy_grid.hpp"
#include "agents/perception/scan.hpp"
#include "core/result.hpp"
#include "core/time.hpp"

namespace weft::agents {

struct CostmapConfig {
  double side_m = 6.0;       ///< of the square around the robot; [1, 20]
  double cell_m = 0.05;      ///< [0.02, 0.25]
  double memory_s = 10.0;    ///< what was seen longer ago is forgotten; (0, 600]
  double near_m = 0.8;       ///< what stands this near to the robot's middle no camera sees: it is kept; [0, 3]
  double near_s = 60.0;      ///< for so long; [memory_s, 600]
  double footprint_m = 0.3;  ///< radius of the robot; where it stands is free; (0, 2]
};
/// Returns every bound that does not hold, each error naming field, value and bound.
std::vector<Error> check(const CostmapConfig& config);

/// Remembers for a while what scans have shown around a robot, in the frame of its odometry: a square that rolls with
/// it (Dayoub et al. 2013, III-D: an obstacle costmap from the pseudo-scan). A value. It is not inflated itself; who
/// plans takes the footprint off the room that clearance_of() gives.
class Costmap {
 public:
  /// The configuration has passed check().
  explicit Costmap(const CostmapConfig& config);

  /// Moves with the robot, clears along the rays of a scan from where low things are in view as far as they were
  /// clear, then marks where obstacles returned; the robot's own footprint is free.
  void take(const Pose2& odom_from_robot, const Scan& scan, SensorTime now);
  /// Forgets everything but what stands near the robot.
  void clear();
  /// Returns what is remembered, in the frame of the odometry.
  OccupancyGrid grid(SensorTime now) const;

 private:
  /// Holds when something was last said of a cell, and what.
  struct Seen {
    SensorTime at{};
    CellState state = CellState::unknown;
  };
  /// Returns the cell that a point of the plane lies in, counted from the frame's origin.
  Cell cell_of(const Eigen::Vector2d& odom_point) const;
  void roll_to(const Eigen::Vector2d& middle);
  bool is_kept(const Cell& cell) const;  ///< longer, as something stands there near the robot
  /// Notes what was seen of a cell, if the square holds it.
  void note(const Cell& cell, CellState state, SensorTime now);
  void note_footprint(const Eigen::Vector2d& middle, SensorTime now);
  std::size_t index(const Cell& cell) const;

  CostmapConfig config_;
  int side_;    ///< cells
  Cell first_;  ///< of the square, counted from the frame's origin
  Eigen::Vector2d robot_ = Eigen::Vector2d::Zero();
  std::vector<Seen> seen_;
};

}  // namespace weft::agents

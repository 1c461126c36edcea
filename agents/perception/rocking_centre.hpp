#pragma once
#include <Eigen/Core>

#include "agents/perception/attitude.hpp"
#include "agents/perception/motion.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

/// Learns the height above the floor of the point about which a body rocks: 0 for a chassis that tilts on its tyres,
/// the camera's own height for a mount that shakes. A view of the floor shows where the camera went; where the robot
/// went differs by that height times the change of tilt, half a millimetre for 0.6 m and 0.05 degrees. Wheels (or the
/// command) turn evenly and no robot slips sideways, so what moves with the tilt is rocking. Is a value.
class RockingCentre {
 public:
  /// Begins for a camera at that height; nothing is known yet but that the point lies between it and the floor.
  explicit RockingCentre(double camera_height_m = 0.6);

  /// Learns from the motion between two views, both seen, as `Attitude` has it (rocking about the floor), the change
  /// of attitude, and what moved the body meanwhile.
  void learn(const Pose2& previous_from_current, const Attitude& change, const Motion& motion);
  /// Returns the motion of the robot itself between two such views.
  Pose2 corrected(const Pose2& previous_from_current, const Attitude& change) const;

  /// Return the height in metres above the floor, and one sigma of it.
  double height_m() const;
  double sigma_m() const;

 private:
  Eigen::Vector3d solution() const;

  double camera_height_m_;
  /// Holds the information on (wheels' scale, heading of straight ahead, height), as a least-squares problem.
  Eigen::Matrix3d information_;
  Eigen::Vector3d weighted_;
};

}  // namespace weft::agents

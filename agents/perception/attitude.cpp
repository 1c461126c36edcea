#include "agents/perception/attitude.hpp"

namespace weft::agents {

Pose3 level_from_body(const Attitude& attitude) {
  Pose3 pose;
  pose.rotation = Eigen::AngleAxisd(attitude.pitch_rad, Eigen::Vector3d::UnitY()) *
                  Eigen::AngleAxisd(attitude.roll_rad, Eigen::Vector3d::UnitX());
  pose.translation = {0.0, 0.0, attitude.height_m};
  return pose;
}

}  // namespace weft::agents

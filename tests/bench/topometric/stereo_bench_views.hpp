#pragma once
#include <vector>

#include "agents/perception/stereo/stereo_rig.hpp"
#include "tests/support/stereo_room.hpp"

namespace weft::bench {

/// Holds pairs along a way through a room, with the depths of the left images and the true poses.
struct StereoViews {
  agents::Sensor sensor;
  agents::StereoRig rig;
  std::vector<agents::StereoPair> pairs;
  std::vector<std::vector<double>> depth_m;
  std::vector<Pose3> room_from_robot;
};
/// Returns views of that size, rendered once: a robot at 0.4 m/s and 0.2 rad/s, ten views a second.
const StereoViews& stereo_views(int width);

}  // namespace weft::bench

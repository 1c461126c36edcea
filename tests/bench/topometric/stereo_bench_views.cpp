#include "tests/bench/topometric/stereo_bench_views.hpp"

#include <map>

#include "agents/perception/stereo/rectifier.hpp"

namespace weft::bench {
namespace {

constexpr int kViews = 12;
constexpr double kStepM = 0.04;
constexpr double kStepRad = 0.02;

StereoViews rendered(int width) {
  StereoViews views;
  views.sensor = test::stereo_sensor(width, width * 3 / 4, 0.65 * width, 0.12);
  views.rig = agents::Rectifier::make(views.sensor)->rig();
  const test::StereoRoom room = test::crate_room(11);
  Pose2 at{1.0, 0.0, -0.1};
  for (int i = 0; i < kViews; ++i, at = at * se2_exp({kStepM, 0.0, kStepRad})) {
    test::StereoShot shot;
    shot.seed = static_cast<std::uint64_t>(100 + i);
    views.pairs.push_back(room.pair(views.sensor, lift(at), shot));
    views.depth_m.push_back(room.look(views.sensor.camera, lift(at) * views.sensor.camera.robot_from_camera).depth_m);
    views.room_from_robot.push_back(lift(at));
  }
  return views;
}

}  // namespace

const StereoViews& stereo_views(int width) {
  static std::map<int, StereoViews> views;
  const auto found = views.find(width);
  return found != views.end() ? found->second : views.emplace(width, rendered(width)).first->second;
}

}  // namespace weft::bench

#include <utility>

#include "agents/methods/topometric/free_space.hpp"
#include "agents/methods/topometric/sight.hpp"
#include "agents/methods/topometric/topometric.hpp"

namespace weft::agents {
namespace {

Pose3 moved_by(const Step& step) {
  return std::get<Metric3>(compose(Metric3{}, step.previous_from_current)).a_from_b;
}

/// Returns the pair that a sample shows; null: it shows none, or one that has been shown before.
const StereoPair* new_pair_of(const Rectifier& rectifier, const View* view, const Step& step) {
  if (view == nullptr || step.blind_reason == "frozen") return nullptr;
  const auto* const pair = std::get_if<StereoPair>(&view->data);
  return pair != nullptr && rectifier.fits(*pair) ? pair : nullptr;
}

}  // namespace

Step Topometric::observe(Odometry& s, const View* view, const Motion& motion) const {
  const Step step = odometry_.observe(s.open, view, motion);
  const Pose3 moved = moved_by(step);
  s.odometry_from_robot = s.odometry_from_robot * moved;
  s.time += motion.elapsed;
  s.scan.reset();
  s.has_seen = false;
  const bool is_placed = step.seen || step.blind_reason == "first_view";
  if (is_placed) {
    s.blind_m = 0.0;
  } else {
    s.blind_m += moved.translation.norm();
    if (s.window) s.window->go_blind(moved.translation.norm());
  }
  const Rectifier& rectifier = odometry_.stereo().rectifier();
  const StereoPair* const pair = new_pair_of(rectifier, view, step);
  if (pair == nullptr) return step;
  // A pair that cannot be matched shows nothing that stands there, even where corners of one image tell of motion.
  OrUnseen<Sight> sight = look_with(config_, rig(), rectifier.rectified(*pair), s.level_from_robot);
  if (!sight) return step;
  s.level_from_robot = sight->level_from_robot;
  s.scan = std::move(sight->scan);
  if (!s.costmap) s.costmap.emplace(config_.costmap);
  s.costmap->take(project(s.odometry_from_robot), *s.scan, s.time);
  if (!is_placed) return step;
  s.has_seen = step.seen;
  if (!s.window) s.window.emplace(config_.window, depth_noise());
  s.window->add({s.odometry_from_robot, std::move(sight->in_robot), rig().robot_from_camera.translation.cast<float>(),
                 clear_bearings(*s.scan, rig(), config_.scan.range_m)});
  return step;
}

}  // namespace weft::agents

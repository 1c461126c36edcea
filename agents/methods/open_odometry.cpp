#include "agents/methods/open_odometry.hpp"

#include <utility>

namespace weft::agents {
namespace {

bool is_same_image(const Image& a, const Image& b) {
  return a.pixels != nullptr && b.pixels != nullptr && (a.pixels == b.pixels || *a.pixels == *b.pixels);
}

}  // namespace

OpenOdometry::OpenOdometry(const OpenOdometryConfig& config, StereoOdometry stereo)
    : config_(config), stereo_(std::move(stereo)) {}

Result<OpenOdometry> OpenOdometry::make(const OpenOdometryConfig& config, const Sensor& sensor) {
  Result<StereoOdometry> stereo = StereoOdometry::make(config.seeing, sensor);
  if (!stereo) return fail(stereo.error());
  return OpenOdometry(config, std::move(*stereo));
}

Step OpenOdometry::observe(State& state, const View* view, const Motion& motion) const {
  Motion obeyed{motion.elapsed, state.lag.next(motion), std::nullopt};
  Step reckoned = dead_reckon(config_.blind, obeyed, "dropped_frame");
  const Pose2 expected = planar(reckoned.previous_from_current);
  const auto* pair = view != nullptr ? std::get_if<StereoPair>(&view->data) : nullptr;
  if (view != nullptr && pair == nullptr) reckoned.blind_reason = "not_a_pair";
  if (pair != nullptr && is_same_image(std::exchange(state.newest_left, pair->left), pair->left)) {
    reckoned.blind_reason = "frozen";
    pair = nullptr;
  }
  if (pair != nullptr) {
    const auto is_possible = [&](const Pose3& step, const Pose3& assumed) {
      return agrees(config_.gate, obeyed, project(assumed) * expected, project(step));
    };
    const OrUnseen<SeenMotion> seen = stereo_.observe(state.seen, *pair, motion.elapsed, is_possible);
    if (seen) {
      if (!seen->makes_up) state.lag.learn(project(seen->previous_from_current.a_from_b));
      return {seen->previous_from_current, true, {}};
    }
    reckoned.blind_reason = seen.error().reason;
  }
  stereo_.assume(state.seen, std::get<Metric3>(compose(Metric3{}, reckoned.previous_from_current)), motion.elapsed);
  return reckoned;
}

}  // namespace weft::agents

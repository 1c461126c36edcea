#include "clients/evaluate/topometric/raw_odometry.hpp"

#include <utility>
#include <variant>

namespace weft::evaluate::topometric {

using namespace agents;

Result<RawOdometry> RawOdometry::make(const StereoOdometryConfig& config, const Sensor& sensor) {
  Result<StereoOdometry> stereo = StereoOdometry::make(config, sensor);
  if (!stereo) return fail(stereo.error());
  return RawOdometry(std::move(*stereo));
}

void RawOdometry::take(const Sample& sample) {
  const View* const view = sample.of({});
  const auto* const pair = view == nullptr ? nullptr : std::get_if<StereoPair>(&view->data);
  const auto anything = [](const Pose3&, const Pose3&) { return true; };
  if (pair != nullptr) {
    if (const auto seen = stereo_.observe(state_, *pair, sample.motion.elapsed, anything)) {
      start_from_robot_ = start_from_robot_ * project(seen->previous_from_current.a_from_b);
      return;
    }
  }
  stereo_.assume(state_, Metric3{}, sample.motion.elapsed);
}

}  // namespace weft::evaluate::topometric

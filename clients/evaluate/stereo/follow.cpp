#include "clients/evaluate/stereo/follow.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "agents/perception/stereo/stereo_odometry.hpp"
#include "clients/evaluate/stereo/klt_pnp.hpp"

namespace weft::evaluate::stereo {
namespace {

using namespace agents;

/// Chains the steps of one method; where it is blind, the robot goes on as it did last.
class Chain {
 public:
  explicit Chain(std::function<double()> processor_s) : processor_s_(std::move(processor_s)) {}

  /// Adds a step: what `see` returns, timed, or what is assumed, which is returned.
  template <class See>
  std::optional<Pose3> add(Duration elapsed, const See& see) {
    const double began_s = processor_s_();
    const std::optional<Pose3> step = see();
    path_.took_s += processor_s_() - began_s;
    const double elapsed_s = std::max(1e-3, seconds(elapsed));
    if (step) rate_ = se3_log(*step) / elapsed_s;
    const Pose3 taken = step ? *step : se3_exp(elapsed_s * rate_);
    at_ = path_.start_from_robot.empty() ? Pose3{} : at_ * taken;
    path_.start_from_robot.push_back(at_);
    path_.seen += step ? 1U : 0U;
    return step ? std::nullopt : std::optional(taken);
  }
  Path finish() { return std::move(path_); }

 private:
  std::function<double()> processor_s_;
  Path path_;
  Pose3 at_;
  Vector6d rate_ = Vector6d::Zero();
};

/// Is the product's odometry.
class Ours {
 public:
  Ours(StereoOdometry odometry, const std::function<double()>& processor_s)
      : odometry_(std::move(odometry)), chain_(processor_s) {}

  void take(const StereoPair* pair, Duration elapsed) {
    const auto assumed = chain_.add(elapsed, [&]() -> std::optional<Pose3> {
      if (pair == nullptr) return std::nullopt;
      const auto seen = odometry_.observe(state_, *pair, elapsed, {});
      return seen ? std::optional(seen->previous_from_current.a_from_b) : std::nullopt;
    });
    if (!assumed) return;
    Metric3 step{*assumed, {}};
    const double off = kAssumedShare * se3_log(*assumed).norm() + kAssumedM;
    step.covariance = Matrix6d(off * off * Matrix6d::Identity());
    odometry_.assume(state_, step, elapsed);
  }
  Path finish() { return chain_.finish(); }

 private:
  static constexpr double kAssumedShare = 0.3;
  static constexpr double kAssumedM = 0.01;

  StereoOdometry odometry_;
  StereoOdometry::State state_;
  Chain chain_;
};

class Baseline {
 public:
  Baseline(const Rectifier& rectifier, const std::function<double()>& processor_s)
      : rectifier_(rectifier), klt_(rectifier.rig()), chain_(processor_s) {}

  void take(const StereoPair* pair, Duration elapsed) {
    chain_.add(elapsed, [&]() -> std::optional<Pose3> {
      if (pair == nullptr) return std::nullopt;
      const std::optional<Pose3> step = klt_.step(rectifier_.rectified(*pair));
      const Pose3& robot_from_camera = rectifier_.rig().robot_from_camera;
      return step ? std::optional(robot_from_camera * *step * robot_from_camera.inverse()) : std::nullopt;
    });
  }
  Path finish() { return chain_.finish(); }

 private:
  const Rectifier& rectifier_;
  KltPnp klt_;
  Chain chain_;
};

}  // namespace

Result<std::optional<Followed>> follow(const Recording& recording, const Following& following) {
  const auto odometry = StereoOdometry::make({}, recording.sensor);
  if (!odometry) return fail(odometry.error().code, recording.folder.string() + ": " + odometry.error().message);
  const auto body = play(recording, following.warn);
  if (!body) return fail(body.error());
  Ours ours(*odometry, following.processor_s);
  Baseline baseline(odometry->rectifier(), following.processor_s);
  Followed followed;
  Duration elapsed{};
  for (std::size_t i = 0; i < recording.pairs; ++i) {
    if (following.asked_to_stop()) return std::optional<Followed>();
    const Result<Sample> sample = (*body)->step({});
    if (!sample) return fail(sample.error());
    elapsed += sample->motion.elapsed;
    if (i % following.every != 0) continue;
    const auto* const pair = sample->views.empty() ? nullptr : std::get_if<StereoPair>(&sample->views.front().data);
    ours.take(pair, elapsed);
    baseline.take(pair, elapsed);
    followed.time_s.push_back(seconds(sample->time.time_since_epoch()));
    elapsed = {};
    following.followed(i + 1);
  }
  followed.ours = ours.finish();
  followed.baseline = baseline.finish();
  return std::optional(std::move(followed));
}

}  // namespace weft::evaluate::stereo

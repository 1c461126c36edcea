// Visual odometry of a pair beside what one puts together of OpenCV's parts, on the same rendered drive, one thread.
#include <cmath>

#include "agents/perception/stereo/stereo_odometry.hpp"
#include "clients/evaluate/stereo/klt_pnp.hpp"
#include "tests/bench/times.hpp"
#include "tests/bench/topometric/stereo_bench_views.hpp"

namespace weft::bench {
namespace {

using namespace agents;
using evaluate::stereo::KltCorners;
using evaluate::stereo::KltPnp;

constexpr Duration kBetweenViews = std::chrono::milliseconds(100);
constexpr int kDrives = 4;

/// Reports how far steps and whole drives are off, beside their time.
class Driven {
 public:
  explicit Driven(const StereoViews& views) : views_(views) {}

  void begin() { start_from_robot_ = {}; }
  void add(std::size_t view, const std::optional<Pose3>& step) {
    const Pose3 truth = views_.room_from_robot[view - 1].inverse() * views_.room_from_robot[view];
    ++steps_;
    seen_ += step ? 1 : 0;
    start_from_robot_ = start_from_robot_ * step.value_or(Pose3{});
    step_squares_ += se3_log(truth.inverse() * step.value_or(Pose3{})).head<3>().squaredNorm();
    if (view + 1 < views_.pairs.size()) return;
    const Pose3 way = views_.room_from_robot.front().inverse() * views_.room_from_robot[view];
    end_m_ += (way.inverse() * start_from_robot_).translation.norm();
    ++drives_;
  }
  void report(benchmark::State& state) const {
    state.counters["seen_%"] = 100.0 * seen_ / steps_;
    state.counters["step_mm"] = 1e3 * std::sqrt(step_squares_ / steps_);
    state.counters["end_mm"] = 1e3 * end_m_ / drives_;
  }

 private:
  const StereoViews& views_;
  Pose3 start_from_robot_;
  double steps_ = 0.0, seen_ = 0.0, drives_ = 0.0;
  double step_squares_ = 0.0, end_m_ = 0.0;
};

void weft_stereo_odometry(benchmark::State& state) {
  const StereoViews& views = stereo_views(static_cast<int>(state.range(0)));
  const StereoOdometry odometry = *StereoOdometry::make({}, views.sensor);
  Times times;
  Driven driven(views);
  for (auto _ : state) {
    StereoOdometry::State remembered;
    driven.begin();
    for (std::size_t i = 0; i < views.pairs.size(); ++i) {
      OrUnseen<SeenMotion> seen = tl::unexpected(Unseen{"not looked"});
      const Took took = timed([&] { seen = odometry.observe(remembered, views.pairs[i], kBetweenViews, {}); });
      if (i == 0) continue;
      times.add(took);
      driven.add(i, seen ? std::optional(seen->previous_from_current.a_from_b) : std::nullopt);
    }
  }
  times.report(state);
  driven.report(state);
}
BENCHMARK(weft_stereo_odometry)->Arg(320)->Arg(640)->Iterations(kDrives)->Unit(benchmark::kMillisecond);

void opencv_klt_pnp(benchmark::State& state, KltCorners corners) {
  const StereoViews& views = stereo_views(static_cast<int>(state.range(0)));
  const Pose3& robot_from_camera = views.rig.robot_from_camera;
  Times times;
  Driven driven(views);
  for (auto _ : state) {
    KltPnp klt(views.rig, corners);
    driven.begin();
    for (std::size_t i = 0; i < views.pairs.size(); ++i) {
      std::optional<Pose3> step;
      const Took took = timed([&] { step = klt.step(views.pairs[i]); });
      if (i == 0) continue;
      times.add(took);
      driven.add(i, step ? std::optional(robot_from_camera * *step * robot_from_camera.inverse()) : std::nullopt);
    }
  }
  times.report(state);
  driven.report(state);
}
BENCHMARK_CAPTURE(opencv_klt_pnp, fast, KltCorners::fast)
    ->Arg(320)
    ->Arg(640)
    ->Iterations(kDrives)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(opencv_klt_pnp, shi_tomasi, KltCorners::shi_tomasi)
    ->Arg(320)
    ->Arg(640)
    ->Iterations(kDrives)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace weft::bench

#pragma once
#include <benchmark/benchmark.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "agents/methods/floor/floor.hpp"
#include "agents/perception/opencv_view.hpp"
#include "tests/support/floor_drive.hpp"

/// Holds what the benches of the floor method look at, rendered once, and what they have in common.
namespace weft::bench {

/// Holds 30 views at 0.6 m/s and 30 fps with vibration.
struct Views {
  agents::Floor method = *agents::Floor::make({}, test::paper_camera());
  std::vector<agents::View> views;
  std::vector<agents::FloorContent> contents;
  agents::Motion motion;
};

inline const Views& views() {
  static const Views made = [] {
    Views v;
    const test::FlatFloor floor = test::FlatFloor::procedural(3, 6.0, 4.0);
    const test::FloorCamera eye(test::paper_camera());
    const test::Vibration vibration(1);
    for (int i = 0; i < 30; ++i) {
      test::Shot shot;
      shot.seed = static_cast<std::uint64_t>(i);
      agents::View view;
      view.frame = static_cast<std::uint64_t>(i);
      view.data = eye.render(floor, {1.2 + 0.02 * i, 2.0, 0.0}, vibration.at(i / 30.0), shot);
      v.views.push_back(view);
      v.contents.push_back(*v.method.extract({}, view));
    }
    v.motion.elapsed = from_seconds(1.0 / 30.0);
    v.motion.wheels = agents::WheelStep{0.0206, 0.0};
    return v;
  }();
  return made;
}

inline cv::Mat grey(const agents::View& view) {
  return agents::as_mat(std::get<agents::Image>(view.data));
}

inline constexpr double kStepM = 0.02;
inline const agents::FloorConfig kDefaults;

/// Computes the RMS error of the steps' lengths, beside their time: a faster stage that sees worse is no gain.
class LengthErrors {
 public:
  void add(double length_m) {
    sum_ += (length_m - kStepM) * (length_m - kStepM);
    ++count_;
  }
  void report(benchmark::State& state) const {
    state.counters["off_mm"] = 1e3 * std::sqrt(sum_ / static_cast<double>(std::max<std::size_t>(count_, 1)));
  }

 private:
  double sum_ = 0.0;
  std::size_t count_ = 0;
};

}  // namespace weft::bench

// Odometry by the floor beside plain OpenCV (FAST, pyramidal KLT, USAC homography).
#include "tests/bench/floor/plain_odometry.hpp"

namespace weft::bench {
namespace {

using namespace agents;

void odometry(benchmark::State& state) {
  const Views& v = views();
  Floor::Odometry odometry;
  LengthErrors errors;
  std::size_t i = 0;
  for (auto _ : state) {
    if (i == v.views.size()) {
      i = 0;
      odometry = {};
    }
    const Step step = v.method.observe(odometry, &v.views[i], v.motion);
    if (i++ > 0) errors.add(planar(step.previous_from_current).translation().norm());
  }
  errors.report(state);
}
BENCHMARK(odometry)->Unit(benchmark::kMillisecond);

void odometry_plain_opencv_fast_klt_homography(benchmark::State& state) {
  const Views& v = views();
  LengthErrors errors;
  PlainOdometry odometry;
  std::size_t i = 0;
  for (auto _ : state) {
    if (i == v.views.size()) {
      i = 0;
      odometry = {};
    }
    if (const auto length_m = odometry.length_m(grey(v.views[i++]))) errors.add(*length_m);
  }
  errors.report(state);
}
BENCHMARK(odometry_plain_opencv_fast_klt_homography)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace weft::bench

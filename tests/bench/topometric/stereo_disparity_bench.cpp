// Dense disparity beside OpenCV's semi-global matcher on the same rendered pairs, one thread.
#include <opencv2/calib3d.hpp>

#include "agents/perception/opencv_view.hpp"
#include "agents/perception/stereo/disparity.hpp"
#include "clients/evaluate/stereo/sgbm.hpp"
#include "tests/agents/perception/stereo/judged.hpp"
#include "tests/bench/times.hpp"
#include "tests/bench/topometric/stereo_bench_views.hpp"

namespace weft::bench {
namespace {

using namespace agents;

/// Reports what the maps are worth in the mean, beside their time.
class Worth {
 public:
  void add(const test::Judged& judged) {
    sum_.density += judged.density;
    sum_.off_2px += judged.off_2px;
    sum_.mean_px += judged.mean_px;
    ++count_;
  }
  void report(benchmark::State& state) const {
    state.counters["density_%"] = 100.0 * sum_.density / count_;
    state.counters["off_2px_%"] = 100.0 * sum_.off_2px / count_;
    state.counters["mean_px"] = sum_.mean_px / count_;
  }

 private:
  test::Judged sum_;
  double count_ = 0.0;
};

void weft_disparity(benchmark::State& state) {
  const StereoViews& views = stereo_views(static_cast<int>(state.range(0)));
  DisparityConfig config;
  config.disparities = static_cast<int>(state.range(1));
  std::size_t i = 0;
  Worth worth;
  Times times;
  for (auto _ : state) {
    const std::size_t at = i++ % views.pairs.size();
    OrUnseen<DisparityMap> map = tl::unexpected(Unseen{"not matched"});
    times.measure([&] { map = match_disparity(config, views.pairs[at]); });
    worth.add(test::judged(map.value(), views.rig, views.depth_m[at], config.disparities));
  }
  times.report(state);
  worth.report(state);
}
BENCHMARK(weft_disparity)->Args({320, 48})->Args({640, 64})->Iterations(48)->Unit(benchmark::kMillisecond);

void opencv_sgbm_3way(benchmark::State& state) {
  const StereoViews& views = stereo_views(static_cast<int>(state.range(0)));
  const int disparities = static_cast<int>(state.range(1));
  const cv::Ptr<cv::StereoSGBM> matcher = evaluate::stereo::sgbm_matcher(disparities);
  std::size_t i = 0;
  Worth worth;
  Times times;
  for (auto _ : state) {
    const std::size_t at = i++ % views.pairs.size();
    const StereoPair& pair = views.pairs[at];
    cv::Mat disparity;
    times.measure([&] { matcher->compute(as_mat(pair.left), as_mat(pair.right), disparity); });
    worth.add(test::judged(evaluate::stereo::sgbm_map(disparity), views.rig, views.depth_m[at], disparities));
  }
  times.report(state);
  worth.report(state);
}
BENCHMARK(opencv_sgbm_3way)->Args({320, 48})->Args({640, 64})->Iterations(48)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace weft::bench

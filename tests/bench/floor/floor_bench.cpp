// The floor method beside plain OpenCV on the same rendered views, one thread. Not part of ctest; run
// build/<preset>/bin/floor_bench.
#include <benchmark/benchmark.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/video/tracking.hpp>

#include "agents/methods/floor/floor.hpp"
#include "tests/support/floor_drive.hpp"

namespace {

using namespace weft;
using namespace weft::agents;

/// 30 views at 0.6 m/s and 30 fps with vibration.
struct Views {
  Floor method = *Floor::make({}, test::paper_camera());
  std::vector<View> views;
  std::vector<FloorContent> contents;
  Motion motion;
};

const Views& views() {
  static const Views made = [] {
    cv::setNumThreads(1);
    Views v;
    const test::FlatFloor floor = test::FlatFloor::procedural(3, 6.0, 4.0);
    const test::FloorCamera eye(test::paper_camera());
    const test::Vibration vibration(1);
    for (int i = 0; i < 30; ++i) {
      test::Shot shot;
      shot.seed = static_cast<std::uint64_t>(i);
      View view;
      view.frame = static_cast<std::uint64_t>(i);
      view.data = eye.render(floor, {1.2 + 0.02 * i, 2.0, 0.0}, vibration.at(i / 30.0), shot);
      v.views.push_back(view);
      v.contents.push_back(*v.method.extract({}, view));
    }
    v.motion.elapsed = from_seconds(1.0 / 30.0);
    v.motion.wheels = WheelStep{0.0206, 0.0};
    return v;
  }();
  return made;
}

cv::Mat grey(const View& view) {
  return as_mat(std::get<Image>(view.data));
}

void odometry(benchmark::State& state) {
  const Views& v = views();
  Floor::Odometry odometry;
  std::size_t i = 0;
  for (auto _ : state) {
    if (i == v.views.size()) {
      i = 0;
      odometry = {};
    }
    benchmark::DoNotOptimize(v.method.observe(odometry, &v.views[i++], v.motion));
  }
}
BENCHMARK(odometry)->Unit(benchmark::kMillisecond);

void odometry_plain_opencv_fast_klt_homography(benchmark::State& state) {
  const Views& v = views();
  std::vector<cv::Mat> last;
  std::size_t i = 0;
  for (auto _ : state) {
    i %= v.views.size();
    const cv::Mat image = grey(v.views[i++]);
    std::vector<cv::Mat> pyramid;
    cv::buildOpticalFlowPyramid(image, pyramid, {13, 13}, 3);
    if (i > 1) {
      std::vector<cv::KeyPoint> corners;
      cv::FAST(grey(v.views[i - 2]), corners, 20, true);
      cv::KeyPointsFilter::retainBest(corners, 160);
      std::vector<cv::Point2f> from;
      std::vector<cv::Point2f> to;
      cv::KeyPoint::convert(corners, from);
      std::vector<std::uint8_t> found;
      std::vector<float> error;
      cv::calcOpticalFlowPyrLK(last, pyramid, from, to, found, error, {13, 13}, 3);
      benchmark::DoNotOptimize(cv::findHomography(from, to, cv::USAC_PROSAC, 1.5));
    }
    last = std::move(pyramid);
  }
}
BENCHMARK(odometry_plain_opencv_fast_klt_homography)->Unit(benchmark::kMillisecond);

void extract(benchmark::State& state) {
  const Views& v = views();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(v.method.extract({}, v.views[i++ % v.views.size()]));
}
BENCHMARK(extract)->Unit(benchmark::kMillisecond);

/// What teaching foretells, besides extract and relate.
void foresee(benchmark::State& state, Prospect prospect) {
  const Views& v = views();
  std::size_t i = 0;
  for (auto _ : state) {
    const View& view = v.views[i++ % v.views.size()];
    benchmark::DoNotOptimize(v.method.foresee(view, {prospect, {0.0, 0.05, 0.03}, i}));
  }
}
BENCHMARK_CAPTURE(foresee, half_light, Prospect::half_light)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(foresee, worn, Prospect::worn)->Unit(benchmark::kMillisecond);

void extract_plain_opencv_orb_on_the_image(benchmark::State& state) {
  const Views& v = views();
  const auto orb = cv::ORB::create(600);
  std::size_t i = 0;
  for (auto _ : state) {
    std::vector<cv::KeyPoint> keypoints;
    cv::Mat descriptors;
    orb->detectAndCompute(grey(v.views[i++ % v.views.size()]), {}, keypoints, descriptors);
    benchmark::DoNotOptimize(descriptors);
  }
}
BENCHMARK(extract_plain_opencv_orb_on_the_image)->Unit(benchmark::kMillisecond);

void relate(benchmark::State& state, bool guided) {
  const Views& v = views();
  const auto apart = static_cast<std::size_t>(state.range(0));
  const std::optional<Relation> guess =
      Metric2{{0.02 * static_cast<double>(apart) + 0.03, 0.02, 0.03}, Eigen::Matrix3d::Zero()};
  std::size_t i = 0;
  for (auto _ : state) {
    const std::size_t a = i++ % (v.contents.size() - apart);
    const auto related = v.method.relate(v.contents[a], v.contents[a + apart], guided ? guess : std::nullopt);
    if (!related) state.SkipWithError("refused");
    benchmark::DoNotOptimize(related);
  }
}
BENCHMARK_CAPTURE(relate, guided, true)->Arg(5)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(relate, unguided, false)->Arg(5)->Arg(20)->Unit(benchmark::kMillisecond);

void relate_plain_opencv_matcher_homography(benchmark::State& state) {
  const Views& v = views();
  const auto orb = cv::ORB::create(600);
  std::vector<std::vector<cv::KeyPoint>> keypoints(v.views.size());
  std::vector<cv::Mat> descriptors(v.views.size());
  for (std::size_t k = 0; k < v.views.size(); ++k)
    orb->detectAndCompute(grey(v.views[k]), {}, keypoints[k], descriptors[k]);
  const auto apart = static_cast<std::size_t>(state.range(0));
  const cv::BFMatcher matcher(cv::NORM_HAMMING, true);
  std::size_t i = 0;
  for (auto _ : state) {
    const std::size_t a = i++ % (v.views.size() - apart);
    std::vector<cv::DMatch> matches;
    matcher.match(descriptors[a], descriptors[a + apart], matches);
    std::vector<cv::Point2f> from;
    std::vector<cv::Point2f> to;
    for (const cv::DMatch& m : matches) {
      from.push_back(keypoints[a][static_cast<std::size_t>(m.queryIdx)].pt);
      to.push_back(keypoints[a + apart][static_cast<std::size_t>(m.trainIdx)].pt);
    }
    benchmark::DoNotOptimize(cv::findHomography(from, to, cv::USAC_PROSAC, 3.0));
  }
}
BENCHMARK(relate_plain_opencv_matcher_homography)->Arg(5)->Arg(20)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();

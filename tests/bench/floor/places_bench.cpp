// What places hold and how two are held against each other, beside plain OpenCV (ORB, matcher, USAC homography).
#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/video/tracking.hpp>

#include "tests/bench/floor/views.hpp"

namespace weft::bench {
namespace {

using namespace agents;

void extract(benchmark::State& state) {
  const Views& v = views();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(v.method.extract({}, v.views[i++ % v.views.size()]));
}
BENCHMARK(extract)->Unit(benchmark::kMillisecond);

/// Measures what teaching foretells, besides extract and relate.
void simulate_revisit(benchmark::State& state, Floor::Condition condition) {
  const Views& v = views();
  std::size_t i = 0;
  for (auto _ : state) {
    const View& view = v.views[i++ % v.views.size()];
    benchmark::DoNotOptimize(v.method.simulate_view(view, {condition, {0.0, 0.05, 0.03}, i}));
  }
}
BENCHMARK_CAPTURE(simulate_revisit, half_light, Floor::half_light)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(simulate_revisit, worn, Floor::worn)->Unit(benchmark::kMillisecond);

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
}  // namespace weft::bench

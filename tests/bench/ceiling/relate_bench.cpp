// A place's content and the relation of two of them, beside plain OpenCV: SIFT, brute force, a rigid motion by
// RANSAC.
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>

#include "tests/bench/ceiling/views.hpp"

namespace weft::bench {
namespace {

using namespace agents;

constexpr std::size_t kPlacesApart = 7;  // views: 0.42 m, as places lie

void extract(benchmark::State& state) {
  const CeilingViews& v = views();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(v.method.extract({}, v.views[i]));
    i = (i + 1) % v.views.size();
  }
}
BENCHMARK(extract)->Unit(benchmark::kMillisecond);

/// Relates pairs of views and counts those that are refused or off by more than 2 cm. `is_guided`: by a guess 0.1 m
/// off.
void relate(benchmark::State& state, bool is_guided) {
  const CeilingViews& v = views();
  const Pose2 truth{kViewStepM * kPlacesApart, 0.0, 0.0};
  std::optional<Relation> guess;
  if (is_guided) {
    const Eigen::Matrix3d covariance = Eigen::Vector3d(0.01, 0.01, 0.0025).asDiagonal();
    guess = Metric2{truth * Pose2{0.08, -0.06, 0.03}, covariance};
  }
  std::size_t i = 0;
  double wrong = 0.0;
  for (auto _ : state) {
    const auto related = v.method.relate(v.contents[i], v.contents[i + kPlacesApart], guess);
    const bool is_right = related && (truth.inverse() * planar(related->a_from_b)).translation().norm() < 0.02;
    wrong += is_right ? 0.0 : 1.0;
    i = (i + 1) % (v.contents.size() - kPlacesApart);
  }
  state.counters["wrong_or_refused"] = benchmark::Counter(wrong, benchmark::Counter::kAvgIterations);
}
BENCHMARK_CAPTURE(relate, guided, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(relate, unguided, false)->Unit(benchmark::kMillisecond);

void plain_sift_brute_force_ransac(benchmark::State& state) {
  const CeilingViews& v = views();
  const cv::Ptr<cv::SIFT> sift = cv::SIFT::create(300);
  const cv::BFMatcher matcher(cv::NORM_L2, true);
  std::size_t i = 0;
  for (auto _ : state) {
    std::array<std::vector<cv::KeyPoint>, 2> points;
    std::array<cv::Mat, 2> descriptors;
    for (std::size_t k = 0; k < 2; ++k)
      sift->detectAndCompute(grey(v.views[i + k * kPlacesApart]), cv::noArray(), points[k], descriptors[k]);
    std::vector<cv::DMatch> matches;
    matcher.match(descriptors[0], descriptors[1], matches);
    std::vector<cv::Point2f> from;
    std::vector<cv::Point2f> to;
    for (const cv::DMatch& match : matches) {
      from.push_back(points[0][static_cast<std::size_t>(match.queryIdx)].pt);
      to.push_back(points[1][static_cast<std::size_t>(match.trainIdx)].pt);
    }
    benchmark::DoNotOptimize(cv::estimateAffinePartial2D(from, to));
    i = (i + 1) % (v.views.size() - kPlacesApart);
  }
}
BENCHMARK(plain_sift_brute_force_ransac)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace weft::bench

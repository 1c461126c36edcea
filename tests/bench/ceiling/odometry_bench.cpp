// Odometry by the ceiling beside plain OpenCV: corners, pyramidal KLT, a rigid motion by RANSAC at one height.
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#include <optional>

#include "tests/bench/ceiling/views.hpp"

namespace weft::bench {
namespace {

using namespace agents;

/// Computes the RMS error of the steps' lengths, beside their time: what is faster and sees worse is no gain.
class StepErrors {
 public:
  void add(double length_m) {
    sum_ += (length_m - kViewStepM) * (length_m - kViewStepM);
    ++count_;
  }
  void report(benchmark::State& state) const {
    state.counters["off_mm"] = 1e3 * std::sqrt(sum_ / static_cast<double>(std::max<std::size_t>(count_, 1)));
  }

 private:
  double sum_ = 0.0;
  std::size_t count_ = 0;
};

void observe(benchmark::State& state) {
  const CeilingViews& v = views();
  Ceiling::Odometry odometry;
  StepErrors errors;
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
BENCHMARK(observe)->Unit(benchmark::kMillisecond);

enum class Corners : std::uint8_t { harris, fast };

std::vector<cv::Point2f> corners_of(const cv::Mat& image, Corners kind) {
  constexpr int most = 100;
  std::vector<cv::Point2f> found;
  if (kind == Corners::harris) {
    cv::goodFeaturesToTrack(image, found, most, 0.01, 8.0, cv::noArray(), 3, true, 0.04);
    return found;
  }
  std::vector<cv::KeyPoint> corners;
  cv::FAST(image, corners, 20, true);
  cv::KeyPointsFilter::retainBest(corners, most);
  cv::KeyPoint::convert(corners, found);
  return found;
}

/// Returns how far the camera went, were everything on the ceiling; none: too little was found again.
std::optional<double> plain_length_m(const cv::Mat& last, const cv::Mat& image, Corners kind) {
  const CameraModel& camera = views().method.camera();
  const cv::Matx33d matrix(camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0);
  const std::vector<double> lens(camera.distortion.begin(), camera.distortion.end());
  std::vector<cv::Point2f> from = corners_of(last, kind);
  if (from.size() < 4) return std::nullopt;
  std::vector<cv::Point2f> to;
  std::vector<std::uint8_t> found;
  std::vector<float> error;
  cv::calcOpticalFlowPyrLK(last, image, from, to, found, error);
  cv::undistortPoints(from, from, matrix, lens);
  cv::undistortPoints(to, to, matrix, lens);
  const cv::Mat homography = cv::findHomography(from, to, cv::USAC_PROSAC, 1.5 / camera.fx);
  if (homography.empty()) return std::nullopt;
  const double away_m = kCeilingM - camera.robot_from_camera.translation.z();
  return away_m * std::hypot(homography.at<double>(0, 2), homography.at<double>(1, 2));
}

void plain(benchmark::State& state, Corners kind) {
  const CeilingViews& v = views();
  StepErrors errors;
  std::size_t i = 1;
  for (auto _ : state) {
    if (i == v.views.size()) i = 1;
    if (const auto length_m = plain_length_m(grey(v.views[i - 1]), grey(v.views[i]), kind)) errors.add(*length_m);
    ++i;
  }
  errors.report(state);
}
BENCHMARK_CAPTURE(plain, opencv_harris_klt_usac, Corners::harris)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plain, opencv_fast_klt_usac, Corners::fast)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace weft::bench

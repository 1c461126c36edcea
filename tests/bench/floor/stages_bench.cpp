#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/video/tracking.hpp>

#include "agents/perception/direct_alignment.hpp"
#include "agents/perception/homography.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/tracking_levels.hpp"
#include "tests/bench/floor/views.hpp"

namespace weft::bench {
namespace {

using namespace agents;

// Stages of odometry, each followed by what plain OpenCV takes for the same.

void stage_prepare(benchmark::State& state) {
  const Views& v = views();
  std::size_t i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(prepare_tracking(std::get<Image>(v.views[i++ % v.views.size()].data),
                                              kDefaults.window_px, kDefaults.pyramid_levels));
}
BENCHMARK(stage_prepare)->Unit(benchmark::kMillisecond);

void stage_prepare_plain_opencv(benchmark::State& state) {
  const Views& v = views();
  std::size_t i = 0;
  for (auto _ : state) {
    std::vector<cv::Mat> pyramid;
    cv::buildOpticalFlowPyramid(grey(v.views[i++ % v.views.size()]), pyramid,
                                {kDefaults.window_px, kDefaults.window_px}, kDefaults.pyramid_levels);
    benchmark::DoNotOptimize(pyramid);
  }
}
BENCHMARK(stage_prepare_plain_opencv)->Unit(benchmark::kMillisecond);

void stage_corners(benchmark::State& state) {
  const Views& v = views();
  std::vector<TrackingImage> images;
  for (const View& view : v.views)
    images.push_back(prepare_tracking(std::get<Image>(view.data), kDefaults.window_px, kDefaults.pyramid_levels));
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(find_corners(images[i++ % images.size()], CornerConfig{}));
}
BENCHMARK(stage_corners)->Unit(benchmark::kMillisecond);

void stage_corners_plain_opencv_fast(benchmark::State& state) {
  const Views& v = views();
  std::size_t i = 0;
  for (auto _ : state) {
    std::vector<cv::KeyPoint> corners;
    cv::FAST(grey(v.views[i++ % v.views.size()]), corners, CornerConfig{}.threshold, true);
    cv::KeyPointsFilter::retainBest(corners, CornerConfig{}.count);
    benchmark::DoNotOptimize(corners);
  }
}
BENCHMARK(stage_corners_plain_opencv_fast)->Unit(benchmark::kMillisecond);

/// Holds corners of each view and where they are expected in the next, as odometry expects them.
struct Followed {
  std::vector<TrackingImage> images;
  std::vector<std::vector<Eigen::Vector2d>> from;
  std::vector<std::vector<Eigen::Vector2d>> expected;
};
const Followed& followed() {
  static const Followed made = [] {
    const Views& v = views();
    Followed f;
    PlanarState moved;
    moved.a_from_b = {0.0206, 0.0, 0.0};
    for (const View& view : v.views) {
      f.images.push_back(prepare_tracking(std::get<Image>(view.data), kDefaults.window_px, kDefaults.pyramid_levels));
      f.from.push_back(find_corners(f.images.back(), CornerConfig{}));
      f.expected.emplace_back();
      for (const Eigen::Vector2d& pixel : f.from.back()) {
        const CameraModel& camera = v.method.camera();
        f.expected.back().push_back(pixel_from_normalised(
            camera, reproject(camera, camera, moved, normalised_from_pixel(camera, pixel)).in_b));
      }
    }
    return f;
  }();
  return made;
}

void stage_track(benchmark::State& state) {
  const Followed& f = followed();
  std::size_t i = 0;
  for (auto _ : state) {
    const std::size_t k = i++ % (f.images.size() - 1);
    benchmark::DoNotOptimize(track_corners(f.images[k], f.images[k + 1], f.from[k], f.expected[k]));
  }
}
BENCHMARK(stage_track)->Unit(benchmark::kMillisecond);

void stage_track_plain_opencv_klt(benchmark::State& state) {
  const Followed& f = followed();
  std::size_t i = 0;
  for (auto _ : state) {
    const std::size_t k = i++ % (f.images.size() - 1);
    std::vector<cv::Point2f> from;
    for (const Eigen::Vector2d& p : f.from[k])
      from.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
    std::vector<cv::Point2f> to;
    std::vector<std::uint8_t> found;
    std::vector<float> error;
    cv::calcOpticalFlowPyrLK(f.images[k].levels().pyramid, f.images[k + 1].levels().pyramid, from, to, found, error,
                             {kDefaults.window_px, kDefaults.window_px}, kDefaults.pyramid_levels);
    benchmark::DoNotOptimize(to);
  }
}
BENCHMARK(stage_track_plain_opencv_klt)->Unit(benchmark::kMillisecond);

/// Returns the tracks of one pair of views, the best first.
std::vector<PlanePair> pairs_of(std::size_t k) {
  const Followed& f = followed();
  const CameraModel& camera = views().method.camera();
  const std::vector<Track> tracks = track_corners(f.images[k], f.images[k + 1], f.from[k], f.expected[k]);
  std::vector<PlanePair> pairs;
  for (std::size_t i = 0; i < tracks.size(); ++i)
    if (tracks[i].found)
      pairs.push_back(
          {normalised_from_pixel(camera, f.from[k][i]), normalised_from_pixel(camera, tracks[i].pixel), 0.15});
  return pairs;
}

void stage_homography(benchmark::State& state) {
  std::vector<Eigen::Vector2d> a;
  std::vector<Eigen::Vector2d> b;
  for (const PlanePair& pair : pairs_of(3)) {
    a.push_back(pair.in_a);
    b.push_back(pair.in_b);
  }
  for (auto _ : state) benchmark::DoNotOptimize(robust_homography(a, b, 1.5 / 460.0));
}
BENCHMARK(stage_homography)->Unit(benchmark::kMillisecond);

void stage_homography_plain_opencv_usac(benchmark::State& state) {
  std::vector<cv::Point2f> a;
  std::vector<cv::Point2f> b;
  for (const PlanePair& pair : pairs_of(3)) {
    a.emplace_back(static_cast<float>(460.0 * pair.in_a.x()), static_cast<float>(460.0 * pair.in_a.y()));
    b.emplace_back(static_cast<float>(460.0 * pair.in_b.x()), static_cast<float>(460.0 * pair.in_b.y()));
  }
  for (auto _ : state) benchmark::DoNotOptimize(cv::findHomography(a, b, cv::USAC_PROSAC, 1.5));
}
BENCHMARK(stage_homography_plain_opencv_usac)->Unit(benchmark::kMillisecond);

void stage_fit_of_six_degrees_of_freedom(benchmark::State& state) {
  const std::vector<PlanePair> pairs = pairs_of(3);
  const CameraModel& camera = views().method.camera();
  AttitudePrior prior;
  prior.information = 1e6 * Matrix6d::Identity();
  PlanarState start;
  start.a_from_b = {0.0206, 0.0, 0.0};
  for (auto _ : state) benchmark::DoNotOptimize(fit_planar_motion(camera, camera, pairs, prior, start));
}
BENCHMARK(stage_fit_of_six_degrees_of_freedom)->Unit(benchmark::kMillisecond);

void fallback_direct_alignment(benchmark::State& state) {
  const CameraModel& camera = views().method.camera();
  AttitudePrior prior;
  prior.information = 1e6 * Matrix6d::Identity();
  PlanarState start;
  start.a_from_b = {0.103, 0.0, 0.0};
  for (auto _ : state)
    benchmark::DoNotOptimize(align_directly(camera, std::get<Image>(views().views[2].data),
                                            std::get<Image>(views().views[7].data), prior, start, {}));
}
BENCHMARK(fallback_direct_alignment)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace weft::bench

// The floor method beside plain OpenCV on the same rendered views, one thread. Not part of ctest; run
// build/<preset>/bin/floor_bench.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/video/tracking.hpp>

#include "agents/methods/floor/floor.hpp"
#include "agents/perception/direct_alignment.hpp"
#include "agents/perception/homography.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/tracking_levels.hpp"
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

constexpr double kStepM = 0.02;
const FloorConfig kDefaults;

/// RMS of the steps' lengths against the truth, beside their time: a faster stage that sees worse is no gain.
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

/// How far the camera went along the floor, by the decomposition whose normal is nearest to the mount's.
double length_of(const cv::Mat& homography, const CameraModel& camera) {
  std::vector<cv::Mat> rotations;
  std::vector<cv::Mat> translations;
  std::vector<cv::Mat> normals;
  cv::decomposeHomographyMat(homography, cv::Mat::eye(3, 3, CV_64F), rotations, translations, normals);
  const Eigen::Vector3d down = camera.robot_from_camera.rotation.inverse() * -Eigen::Vector3d::UnitZ();
  double best = -1.0;
  double length_m = 0.0;
  for (std::size_t k = 0; k < normals.size(); ++k) {
    const Eigen::Map<const Eigen::Vector3d> normal(normals[k].ptr<double>());
    const Eigen::Map<const Eigen::Vector3d> moved(translations[k].ptr<double>());
    if (normal.dot(down) <= best) continue;
    best = normal.dot(down);
    length_m = camera.robot_from_camera.translation.z() * moved.norm();
  }
  return length_m;
}

void odometry_plain_opencv_fast_klt_homography(benchmark::State& state) {
  const Views& v = views();
  const CameraModel& camera = v.method.camera();
  const cv::Matx33d matrix(camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0);
  const std::vector<double> lens(camera.distortion.begin(), camera.distortion.end());
  LengthErrors errors;
  std::vector<cv::Mat> last;
  std::size_t i = 0;
  for (auto _ : state) {
    i %= v.views.size();
    const cv::Mat image = grey(v.views[i++]);
    std::vector<cv::Mat> pyramid;
    cv::buildOpticalFlowPyramid(image, pyramid, {kDefaults.window_px, kDefaults.window_px}, kDefaults.pyramid_levels);
    if (i > 1) {
      std::vector<cv::KeyPoint> corners;
      cv::FAST(grey(v.views[i - 2]), corners, CornerConfig{}.threshold, true);
      cv::KeyPointsFilter::retainBest(corners, CornerConfig{}.count);
      std::vector<cv::Point2f> from;
      std::vector<cv::Point2f> to;
      cv::KeyPoint::convert(corners, from);
      std::vector<std::uint8_t> found;
      std::vector<float> error;
      cv::calcOpticalFlowPyrLK(last, pyramid, from, to, found, error, {kDefaults.window_px, kDefaults.window_px},
                               kDefaults.pyramid_levels);
      cv::undistortPoints(from, from, matrix, lens);
      cv::undistortPoints(to, to, matrix, lens);
      errors.add(length_of(cv::findHomography(from, to, cv::USAC_PROSAC, 1.5 / camera.fx), camera));
    }
    last = std::move(pyramid);
  }
  errors.report(state);
}
BENCHMARK(odometry_plain_opencv_fast_klt_homography)->Unit(benchmark::kMillisecond);

/// What 1 m/s at the views' 30 a second costs a view: odometry, and localisation every 0.1 m of travel. The views are
/// 0.02 m apart, so it is due at every fifth.
void odometry_and_localisation_every_tenth_of_a_metre(benchmark::State& state) {
  const Views& v = views();
  Floor::Odometry odometry;
  std::size_t i = 0;
  for (auto _ : state) {
    if (i == v.views.size()) {
      i = 0;
      odometry = {};
    }
    benchmark::DoNotOptimize(v.method.observe(odometry, &v.views[i], v.motion));
    if (i % 5 == 4) {
      const auto content = v.method.extract(odometry, v.views[i]);
      const std::optional<Relation> guess = Metric2{{0.05, 0.02, 0.03}, Eigen::Matrix3d::Zero()};
      benchmark::DoNotOptimize(v.method.relate(v.contents[i - 4], *content, guess));
    }
    ++i;
  }
}
BENCHMARK(odometry_and_localisation_every_tenth_of_a_metre)->Unit(benchmark::kMillisecond);

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

/// Corners of each view and where they are expected in the next, as odometry expects them.
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

/// Tracks of one pair of views, the best first.
std::vector<FloorPair> pairs_of(std::size_t k) {
  const Followed& f = followed();
  const CameraModel& camera = views().method.camera();
  const std::vector<Track> tracks = track_corners(f.images[k], f.images[k + 1], f.from[k], f.expected[k]);
  std::vector<FloorPair> pairs;
  for (std::size_t i = 0; i < tracks.size(); ++i)
    if (tracks[i].found)
      pairs.push_back(
          {normalised_from_pixel(camera, f.from[k][i]), normalised_from_pixel(camera, tracks[i].pixel), 0.15});
  return pairs;
}

void stage_homography(benchmark::State& state) {
  std::vector<Eigen::Vector2d> a;
  std::vector<Eigen::Vector2d> b;
  for (const FloorPair& pair : pairs_of(3)) {
    a.push_back(pair.in_a);
    b.push_back(pair.in_b);
  }
  for (auto _ : state) benchmark::DoNotOptimize(robust_homography(a, b, 1.5 / 460.0));
}
BENCHMARK(stage_homography)->Unit(benchmark::kMillisecond);

void stage_homography_plain_opencv_usac(benchmark::State& state) {
  std::vector<cv::Point2f> a;
  std::vector<cv::Point2f> b;
  for (const FloorPair& pair : pairs_of(3)) {
    a.emplace_back(static_cast<float>(460.0 * pair.in_a.x()), static_cast<float>(460.0 * pair.in_a.y()));
    b.emplace_back(static_cast<float>(460.0 * pair.in_b.x()), static_cast<float>(460.0 * pair.in_b.y()));
  }
  for (auto _ : state) benchmark::DoNotOptimize(cv::findHomography(a, b, cv::USAC_PROSAC, 1.5));
}
BENCHMARK(stage_homography_plain_opencv_usac)->Unit(benchmark::kMillisecond);

void stage_fit_of_six_degrees_of_freedom(benchmark::State& state) {
  const std::vector<FloorPair> pairs = pairs_of(3);
  const CameraModel& camera = views().method.camera();
  SwayPrior prior;
  prior.information = 1e6 * Matrix6d::Identity();
  PlanarState start;
  start.a_from_b = {0.0206, 0.0, 0.0};
  for (auto _ : state) benchmark::DoNotOptimize(fit_planar_motion(camera, camera, pairs, prior, start));
}
BENCHMARK(stage_fit_of_six_degrees_of_freedom)->Unit(benchmark::kMillisecond);

void fallback_direct_alignment(benchmark::State& state) {
  const CameraModel& camera = views().method.camera();
  SwayPrior prior;
  prior.information = 1e6 * Matrix6d::Identity();
  PlanarState start;
  start.a_from_b = {0.103, 0.0, 0.0};
  for (auto _ : state)
    benchmark::DoNotOptimize(align_directly(camera, std::get<Image>(views().views[2].data),
                                            std::get<Image>(views().views[7].data), prior, start, {}));
}
BENCHMARK(fallback_direct_alignment)->Unit(benchmark::kMillisecond);

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

// What a robot's whole repeat step costs a view at 1 m/s and 30 views a second: the navigator as an agent has it,
// beside plain OpenCV that does odometry on every view and matches it with the map every 0.1 m.
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
#include <stdexcept>

#include "agents/navigation/navigator_of.hpp"
#include "clients/evaluate/taught_map.hpp"
#include "tests/bench/floor/plain_odometry.hpp"

namespace weft::bench {
namespace {

using namespace agents;

constexpr double kViewsApartM = 1.0 / 30.0;
constexpr int kDriveViews = 120;  // 4 m

/// Renders a straight drive; another pass shakes otherwise and runs 2 cm aside.
std::vector<View> rendered(std::uint64_t pass) {
  const test::FlatFloor floor = test::FlatFloor::procedural(3, 6.0, 4.0);
  const test::FloorCamera eye(test::paper_camera());
  const test::Vibration vibration(pass);
  std::vector<View> views;
  for (int i = 0; i < kDriveViews; ++i) {
    test::Shot shot;
    shot.seed = 1000 * pass + static_cast<std::uint64_t>(i);
    View view;
    view.frame = static_cast<std::uint64_t>(i);
    view.data = eye.render(floor, {0.8 + kViewsApartM * i, 2.0 + 0.02 * static_cast<double>(pass), 0.0},
                           vibration.at(i / 30.0), shot);
    views.push_back(std::move(view));
  }
  return views;
}

Motion motion_of_a_view() {
  Motion motion;
  motion.elapsed = from_seconds(1.0 / 30.0);
  motion.wheels = WheelStep{1.03 * kViewsApartM, 0.0};
  return motion;
}

/// Makes every third view tell where it is: at 1 m/s and 30 views a second views are 0.033 m apart, so that it is
/// every 0.1 m and not, by a hair, every fourth.
NavigationConfig every_tenth_of_a_metre() {
  NavigationConfig config;
  config.locate.every_m = 0.09;
  return config;
}

/// Holds a map of the first pass, and a robot that drives the second one by it.
class Repeating {
 public:
  Repeating() {
    const std::vector<View> taught = rendered(0);
    const auto teacher = make_navigator(method_, NavigationConfig{});
    teacher->begin_teach({run_, teacher_});
    for (const View& view : taught)
      take(teacher->step({view.frame, time_of(view), {view}, motion_, true, false}, map_.view()).kept);
    take(teacher->end_teach(map_.view()));
    views_ = rendered(1);
    restart();
  }

  /// Takes the next view; returns whether the robot found where it is by it.
  bool step() {
    const View& view = views_[at_++];
    return navigator_->step({view.frame, time_of(view), {view}, motion_, false, false}, map_.view()).fix.has_value();
  }
  bool is_over() const { return at_ == views_.size(); }
  void restart() {
    navigator_ = make_navigator(method_, every_tenth_of_a_metre());
    navigator_->seek(std::nullopt);
    for (at_ = 0; !navigator_->estimate() && !is_over();) step();
    if (!navigator_->estimate()) throw std::runtime_error("the robot does not find itself");
    const Result<Route> route = map_.route(navigator_->estimate()->place, last_, Floor::name);
    if (!route) throw std::runtime_error(route.error().message);
    navigator_->follow(*route);
  }

 private:
  static SensorTime time_of(const View& view) {
    return SensorTime{} + from_seconds(static_cast<double>(view.frame) / 30.0);
  }
  void take(const std::vector<Kept>& kept) {
    if (!kept.empty()) last_ = kept.back().place.id;
    if (const auto taken = map_.take(run_, teacher_, Floor::name, kept); !taken)
      throw std::runtime_error(taken.error().message);
  }

  const ExperienceId run_{1};
  const RobotId teacher_{{1}};
  Floor method_ = *Floor::make({}, test::paper_camera());
  Motion motion_ = motion_of_a_view();
  evaluate::TaughtMap map_;
  PlaceId last_;
  std::vector<View> views_;
  std::unique_ptr<Navigator> navigator_;
  std::size_t at_ = 0;
};

void repeat_step_of_the_navigator(benchmark::State& state) {
  Repeating robot;
  double fixes = 0.0;
  for (auto _ : state) {
    if (robot.is_over()) {
      state.PauseTiming();
      robot.restart();
      state.ResumeTiming();
    }
    fixes += robot.step() ? 1.0 : 0.0;
  }
  state.counters["fixes_per_m"] = fixes / (kViewsApartM * static_cast<double>(state.iterations()));
}
BENCHMARK(repeat_step_of_the_navigator)->Unit(benchmark::kMillisecond);

/// Holds the map of the plain way: one stored image a place, every 0.2 m.
struct PlainMap {
  cv::Ptr<cv::ORB> orb = cv::ORB::create(600);
  std::vector<std::vector<cv::KeyPoint>> keypoints;
  std::vector<cv::Mat> descriptors;
};

PlainMap plain_map() {
  PlainMap map;
  const std::vector<View> taught = rendered(0);
  for (std::size_t i = 0; i < taught.size(); i += 6) {
    map.keypoints.emplace_back();
    map.descriptors.emplace_back();
    map.orb->detectAndCompute(grey(taught[i]), {}, map.keypoints.back(), map.descriptors.back());
  }
  return map;
}

bool is_found(const PlainMap& map, std::size_t place, const cv::Mat& image) {
  std::vector<cv::KeyPoint> keypoints;
  cv::Mat descriptors;
  map.orb->detectAndCompute(image, {}, keypoints, descriptors);
  std::vector<cv::DMatch> matches;
  cv::BFMatcher(cv::NORM_HAMMING, true).match(map.descriptors[place], descriptors, matches);
  std::vector<cv::Point2f> from;
  std::vector<cv::Point2f> to;
  for (const cv::DMatch& match : matches) {
    from.push_back(map.keypoints[place][static_cast<std::size_t>(match.queryIdx)].pt);
    to.push_back(keypoints[static_cast<std::size_t>(match.trainIdx)].pt);
  }
  cv::Mat inliers;
  if (from.size() < 4 || cv::findHomography(from, to, cv::USAC_PROSAC, 3.0, inliers).empty()) return false;
  return cv::countNonZero(inliers) >= 24;
}

void repeat_step_of_plain_opencv(benchmark::State& state) {
  const PlainMap map = plain_map();
  const std::vector<View> views = rendered(1);
  PlainOdometry odometry;
  double fixes = 0.0;
  std::size_t i = 0;
  for (auto _ : state) {
    if (i == views.size()) {
      i = 0;
      odometry = {};
    }
    benchmark::DoNotOptimize(odometry.length_m(grey(views[i])));
    if (i % 3 == 2) fixes += is_found(map, std::min(i / 6, map.descriptors.size() - 1), grey(views[i])) ? 1.0 : 0.0;
    ++i;
  }
  state.counters["fixes_per_m"] = fixes / (kViewsApartM * static_cast<double>(state.iterations()));
}
BENCHMARK(repeat_step_of_plain_opencv)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace weft::bench

// How long the method takes for a whole view of 480 x 360 pixels, with a look for where the robot is and a decision
// of steering each 0.1 m, beside what OpenCV's parts and a filter as AMCL writes it take on the same views. A
// simulated hall, one thread, processor time. Usage: view_bench [METRES]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <numeric>
#include <opencv2/calib3d.hpp>
#include <string>
#include <vector>

#include "agents/bodies/sim/sim_body.hpp"
#include "agents/methods/topometric/topometric.hpp"
#include "agents/perception/opencv_view.hpp"
#include "clients/evaluate/stereo/klt_pnp.hpp"
#include "clients/evaluate/stereo/sgbm.hpp"
#include "tests/agents/bodies/sim/scenes.hpp"
#include "tests/bench/times.hpp"
#include "tests/bench/topometric/baselines.hpp"

namespace weft::bench {
namespace {

using namespace agents;

constexpr Pose2 kStart{3.0, 1.8, 0.0};
constexpr double kEveryM = 0.1;
constexpr double kSpeedM_s = 0.4;
constexpr double kChartEveryM = 3.0;  // a chart stays until the robot is six hops from its centre

/// Collects processor times, milliseconds.
class Milliseconds {
 public:
  void add(double ms) { all_.push_back(ms); }
  double sum() const { return std::accumulate(all_.begin(), all_.end(), 0.0); }
  double at(double share) const {
    std::vector<double> sorted = all_;
    std::sort(sorted.begin(), sorted.end());
    return sorted.empty() ? 0.0 : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  }
  void print(const char* what) const {
    std::printf("%-44s %8.2f ms (99 %%: %.2f), %zu times\n", what, at(0.5), at(0.99), all_.size());
  }

 private:
  std::vector<double> all_;
};

sim::Site wide_hall() {
  sim::Site site = sim::scene_in(WEFT_SITES "/topometric/", "hall.toml");
  site.stereo_camera.width = 480;
  site.stereo_camera.height = 360;
  site.stereo_camera.focal_px = 312.0;
  return site;
}

/// Holds a robot in the hall on one day, and the method that sees through its pair.
struct Robot {
  Robot(const sim::Site& site, std::uint64_t seed, std::uint64_t day) {
    sim::SimBodyConfig config;
    config.site = site;
    config.robot = "r1";
    config.seed = seed;
    config.day = day;
    body = sim::make_sim_body(config).value();
    body->put(kStart, {});
    method = std::make_unique<Topometric>(Topometric::make({}, body->rig()).value());
  }
  /// Takes the next sample. Returns the time that the method takes for it; none where it has no view.
  std::optional<double> next() {
    sample = body->step({kSpeedM_s, 0.0}).value();
    view = sample.of("stereo");
    const Took took = timed([&] { step = method->observe(odometry, view, sample.motion); });
    return view != nullptr ? std::optional(took.processor_ms) : std::nullopt;
  }

  std::unique_ptr<sim::SimulatedBody> body;
  std::unique_ptr<Topometric> method;
  Topometric::Odometry odometry;
  Sample sample;
  const View* view = nullptr;
  Step step;
};

/// Teaches a straight way: a place each half metre, where it truly is.
std::vector<ChartPlace<TopometricContent>> taught(const sim::Site& site, double metres) {
  Robot robot(site, 1, 0);
  std::vector<Pose2> site_from_places;
  std::vector<std::shared_ptr<const TopometricContent>> contents;
  while (robot.body->site_from_robot().x < kStart.x + metres + 2.0) {
    const auto has_view = robot.next();
    const Pose2 at = robot.body->site_from_robot();
    if (!has_view || at.x < kStart.x + 0.5 * static_cast<double>(contents.size() + 1)) continue;
    const OrRefusal<TopometricContent> content = robot.method->extract(robot.odometry, *robot.view);
    if (!content) continue;
    contents.push_back(std::make_shared<const TopometricContent>(*content));
    site_from_places.push_back(at);
  }
  const std::size_t centre = contents.size() / 2;
  std::vector<ChartPlace<TopometricContent>> places;
  for (std::size_t i = 0; i < contents.size(); ++i) {
    const std::size_t depth = i > centre ? i - centre : centre - i;
    if (depth > Topometric::chart_size.hops) continue;
    places.push_back({{ExperienceId{7}, static_cast<std::uint32_t>(i)},
                      static_cast<std::uint32_t>(depth),
                      Metric3{lift(site_from_places[centre].inverse() * site_from_places[i]), {}},
                      contents[i]});
  }
  return places;
}

/// Measures what the same views take with parts as they are usually put together.
class Baseline {
 public:
  Baseline(const StereoRig& rig, const OccupancyGrid& grid)
      : klt_(rig, evaluate::stereo::KltCorners::fast),
        matcher_(evaluate::stereo::sgbm_matcher(64)),
        distances_(distance_to_occupied(grid, 1.0)) {
    constexpr std::size_t count = 2000;
    for (std::size_t i = 0; i < count; ++i) particles_.add({}, 1.0 / static_cast<double>(count));
  }
  void look(const StereoPair& pair) {
    ms.add(timed([&] {
             cv::Mat disparity;
             matcher_->compute(as_mat(pair.left), as_mat(pair.right), disparity);
             klt_.step(pair);
           }).processor_ms);
  }
  void weigh(const Scan& scan) {
    filter_ms.add(timed([&] { amcl_weigh(distances_, scan, 60, 0.1, particles_); }).processor_ms);
  }

  Milliseconds ms, filter_ms;

 private:
  evaluate::stereo::KltPnp klt_;
  cv::Ptr<cv::StereoSGBM> matcher_;
  DistanceMap distances_;
  ParticleSet particles_;
};

/// Holds what the parts of a drive took.
struct Parts {
  Milliseconds observe, locate, steer, chart;
  std::size_t fixes = 0;
};

/// Looks for where the robot is and steers, as navigation does each 0.1 m.
void look_and_steer(Robot& robot, const TopometricChart& chart, TopometricBelief& belief, const Step& since,
                    Parts& parts) {
  parts.locate.add(timed([&] {
                     const OrRefusal<TopometricContent> seen = robot.method->extract(robot.odometry, *robot.view);
                     if (!seen) return;
                     Located<TopometricBelief> located = robot.method->locate(chart, belief, since, *seen);
                     parts.fixes += located.fix ? 1U : 0U;
                     belief = std::move(located.belief);
                   }).processor_ms);
  Ahead ahead;
  for (int k = 0; k <= 10; ++k) ahead.robot_from_path.push_back({0.5 * k, 0.0, 0.0});
  ahead.to_end_m = 5.0;
  ahead.speed_m_s = kSpeedM_s;
  ahead.aside_m = 1.0;
  const Around<Topometric> around{&chart, &belief, belief.estimate().chart_from_robot};
  parts.steer.add(
      timed([&] { static_cast<void>(robot.method->steer(robot.odometry, &around, ahead)); }).processor_ms);
}

void print(const Parts& ours, const Baseline& baseline, std::size_t views, double driven_m) {
  ours.observe.print("a view: odometry, depth, scan");
  ours.locate.print("each 0.1 m: extract and locate");
  ours.steer.print("each 0.1 m: steer");
  ours.chart.print("a chart, every 3 m");
  baseline.ms.print("baseline: SGBM, FAST + KLT + PnP");
  baseline.filter_ms.print("baseline, each 0.1 m: AMCL's weights");
  const auto all = static_cast<double>(views);
  const double a_view_ms = (ours.observe.sum() + ours.locate.sum() + ours.steer.sum()) / all;
  const double chart_ms = ours.chart.at(0.5) * driven_m / kChartEveryM / all;
  const double theirs_ms = (baseline.ms.sum() + baseline.filter_ms.sum()) / all;
  std::printf(
      "%zu fixes of %.1f m; a view in the mean: %.2f ms and %.2f of charts, %.0f a second; baseline %.2f ms: ratio "
      "%.2f\n",
      ours.fixes, driven_m, a_view_ms, chart_ms, 1e3 / (a_view_ms + chart_ms), theirs_ms,
      (a_view_ms + chart_ms) / theirs_ms);
}

}  // namespace

int run(double metres) {
  const sim::Site site = wide_hall();
  const auto places = taught(site, metres);
  Robot robot(site, 2, 1);
  const Topometric& method = *robot.method;
  Parts parts;
  std::optional<TopometricChart> chart;
  for (int i = 0; i < 5; ++i) parts.chart.add(timed([&] { chart.emplace(method.chart(places)); }).processor_ms);
  const Metric2 first{{-0.5, 0.0, 0.0}, Eigen::Vector3d(0.01, 0.01, 0.0025).asDiagonal()};
  TopometricBelief belief = method.begin(*chart, {places.front().id, first, 0.0});
  Baseline baseline(method.rig(), chart->grid);
  Relation since = Metric3{};
  double since_m = 0.0;
  double driven_m = 0.0;
  std::size_t views = 0;
  while (driven_m < metres) {
    const std::optional<double> ms = robot.next();
    since = compose(since, robot.step.previous_from_current);
    const double step_m = distance_m(robot.step.previous_from_current);
    since_m += step_m;
    driven_m += step_m;
    if (!ms) continue;
    ++views;
    parts.observe.add(*ms);
    baseline.look(std::get<StereoPair>(robot.view->data));
    if (since_m < kEveryM) continue;
    if (robot.odometry.scan) baseline.weigh(*robot.odometry.scan);
    look_and_steer(robot, *chart, belief, {since, true, {}}, parts);
    since = Metric3{};
    since_m = 0.0;
  }
  print(parts, baseline, views, driven_m);
  return 0;
}

}  // namespace weft::bench

int main(int count, char** arguments) {
  const double metres = count > 1 ? std::strtod(arguments[1], nullptr) : 5.0;
  if (!(metres >= 1.0 && metres <= 6.0)) {
    std::fprintf(stderr, "view_bench: %s: metres are from 1 to 6\n", arguments[1]);
    return 2;
  }
  try {
    return weft::bench::run(metres);
  } catch (const std::exception& wrong) {  // OpenCV's
    std::fprintf(stderr, "view_bench: %s\n", wrong.what());
    return 1;
  }
}

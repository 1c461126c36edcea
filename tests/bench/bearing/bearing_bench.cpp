// The bearing method beside plain OpenCV on the same rendered views of 320 x 240, one thread. Not part of ctest; run
// build/<preset>/bin/bearing_bench.
#include <benchmark/benchmark.h>

#include <cmath>
#include <opencv2/core/utility.hpp>
#include <opencv2/features2d.hpp>

#include "agents/methods/bearing/bearing.hpp"
#include "agents/perception/looming.hpp"
#include "agents/perception/opencv_view.hpp"
#include "tests/support/aisle.hpp"

namespace {

using namespace weft;
using namespace weft::agents;

constexpr int kPlaces = 21;  // 0.2 m apart, the chart's centre in the middle
constexpr int kMiddle = kPlaces / 2;
constexpr double kFirstM = 5.0;

/// Holds an aisle that was taught, and views of a robot that drives through it 3 cm aside.
struct Aisle {
  test::Lookout lookout{test::aisle_site()};
  Bearing method = *Bearing::make({}, lookout.camera());
  std::vector<View> taught, seen;
  std::vector<BearingContent> contents;
  Bearing::Chart chart;
  Bearing::Chart learned;  ///< of places that have learned as much as they have room for
  Motion motion;
};

/// Returns places where the stock changed so often that they have no room left.
std::vector<ChartPlace<BearingContent>> learned_over_changes(const Aisle& aisle,
                                                             std::vector<ChartPlace<BearingContent>> around) {
  sim::Site site = test::aisle_site();
  site.change.stock = 0.4;
  for (site.change.seed = 1; site.change.seed <= 3; ++site.change.seed) {
    test::Lookout lookout(site, site.change.seed);
    for (std::size_t i = 0; i < around.size(); ++i) {
      const View view = lookout.from({kFirstM + 0.2 * static_cast<double>(i), 6.0, 0.0});
      const auto learned =
          aisle.method.learn(*around[i].content, *aisle.method.extract({}, view), AlongPath{0.0, 1e-4, 0.0, 1e-4});
      if (learned) around[i].content = std::make_shared<const BearingContent>(*learned);
    }
  }
  return around;
}

const Aisle& aisle() {
  static const Aisle made = [] {
    cv::setNumThreads(1);
    Aisle aisle;
    std::vector<ChartPlace<BearingContent>> around;
    for (int i = 0; i < kPlaces; ++i) {
      const double ahead_m = 0.2 * (i - kMiddle);
      aisle.taught.push_back(aisle.lookout.from({kFirstM + 0.2 * i, 6.0, 0.0}));
      aisle.contents.push_back(*aisle.method.extract({}, aisle.taught.back()));
      PlaceId id;
      id.index = static_cast<std::uint32_t>(i);
      around.push_back(
          {id, 0, AlongPath{ahead_m, 1e-4}, std::make_shared<const BearingContent>(aisle.contents.back())});
      aisle.seen.push_back(aisle.lookout.from({kFirstM + 0.2 * i + 0.07, 6.03, 0.01}));
    }
    aisle.chart = aisle.method.chart(around);
    aisle.learned = aisle.method.chart(learned_over_changes(aisle, around));
    aisle.motion.elapsed = from_seconds(0.1);
    aisle.motion.wheels = WheelStep{0.05, 0.0};
    return aisle;
  }();
  return made;
}

/// Returns where the view was taken, along the chart.
double seen_at_m(std::size_t i) {
  return 0.2 * (static_cast<double>(i) - kMiddle) + 0.07;
}

void whole_step_in(benchmark::State& state, const Bearing::Chart& chart) {
  const Aisle& a = aisle();
  Bearing::Odometry odometry;
  std::size_t i = 0;
  std::size_t fixes = 0;
  double squares = 0.0;
  for (auto _ : state) {
    const std::size_t at = 4 + i++ % (kPlaces - 8);
    const Step step = a.method.observe(odometry, &a.seen[at], a.motion);
    benchmark::DoNotOptimize(step);
    benchmark::DoNotOptimize(a.method.expose(odometry, a.seen[at]));
    const auto content = a.method.extract(odometry, a.seen[at]);
    const auto located =
        a.method.locate(chart, {AlongPath{seen_at_m(at) + 0.03, 0.01}}, Step{AlongPath{}, true, {}}, *content);
    if (!located.fix) continue;
    ++fixes;
    const double told_m = 0.2 * (static_cast<double>(located.fix->place.index) - kMiddle) +
                          std::get<AlongPath>(located.fix->place_from_robot).distance_m;
    squares += (told_m - seen_at_m(at)) * (told_m - seen_at_m(at));
  }
  state.counters["off_mm"] = 1e3 * std::sqrt(squares / static_cast<double>(std::max<std::size_t>(fixes, 1)));
  state.counters["fixes"] = static_cast<double>(fixes) / static_cast<double>(state.iterations());
}
void whole_step(benchmark::State& state) {
  whole_step_in(state, aisle().chart);
}
BENCHMARK(whole_step)->Unit(benchmark::kMillisecond);

void whole_step_where_places_have_learned(benchmark::State& state) {
  whole_step_in(state, aisle().learned);
}
BENCHMARK(whole_step_where_places_have_learned)->Unit(benchmark::kMillisecond);

void learn_from_a_view(benchmark::State& state) {
  const Aisle& a = aisle();
  std::vector<BearingContent> views;
  for (const View& view : a.seen) views.push_back(*a.method.extract({}, view));
  std::size_t i = 0;
  for (auto _ : state) {
    const std::size_t at = i++ % kPlaces;
    benchmark::DoNotOptimize(a.method.learn(a.contents[at], views[at], AlongPath{0.07, 1e-4, 0.01, 1e-4}));
  }
}
BENCHMARK(learn_from_a_view)->Unit(benchmark::kMillisecond);

void extract(benchmark::State& state) {
  const Aisle& a = aisle();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(a.method.extract({}, a.seen[i++ % kPlaces]));
}
BENCHMARK(extract)->Unit(benchmark::kMillisecond);

void expose(benchmark::State& state) {
  const Aisle& a = aisle();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(a.method.expose({}, a.seen[i++ % kPlaces]));
}
BENCHMARK(expose)->Unit(benchmark::kMillisecond);

void one_vote(benchmark::State& state) {
  const Aisle& a = aisle();
  std::size_t i = 0;
  for (auto _ : state) {
    const BearingContent& one = a.contents[i++ % (kPlaces - 1)];
    benchmark::DoNotOptimize(vote_heading(one.features, a.contents[i % kPlaces].features, 320.0, {}));
  }
}
BENCHMARK(one_vote)->Unit(benchmark::kMillisecond);

/// Does what a robot would do with OpenCV alone: as many ORB corners, matched with those of the nearest place, most
/// frequent shift of the matches; one place instead of up to seven.
void opencv_step(benchmark::State& state) {
  const Aisle& a = aisle();
  const cv::Ptr<cv::ORB> orb = cv::ORB::create(300);
  const cv::BFMatcher matcher(cv::NORM_HAMMING, true);
  std::vector<std::vector<cv::KeyPoint>> points(kPlaces);
  std::vector<cv::Mat> descriptors(kPlaces);
  for (std::size_t i = 0; i < kPlaces; ++i)
    orb->detectAndCompute(as_mat(std::get<Image>(a.taught[i].data)), cv::noArray(), points[i], descriptors[i]);
  std::size_t i = 0;
  for (auto _ : state) {
    const std::size_t at = 4 + i++ % (kPlaces - 8);
    std::vector<cv::KeyPoint> found;
    cv::Mat described;
    orb->detectAndCompute(as_mat(std::get<Image>(a.seen[at].data)), cv::noArray(), found, described);
    std::vector<cv::DMatch> matches;
    matcher.match(described, descriptors[at], matches);
    std::array<int, 64> bins{};
    for (const cv::DMatch& match : matches) {
      const float shift = found[static_cast<std::size_t>(match.queryIdx)].pt.x -
                          points[at][static_cast<std::size_t>(match.trainIdx)].pt.x;
      ++bins[static_cast<std::size_t>(std::clamp(32.0F + shift / 5.0F, 0.0F, 63.0F))];
    }
    benchmark::DoNotOptimize(std::max_element(bins.begin(), bins.end()));
  }
}
BENCHMARK(opencv_step)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();

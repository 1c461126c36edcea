// How long a chart, a look among particles and a decision of steering take, on made-up clouds. Usage: map_bench
// [ROUNDS]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tests/agents/methods/topometric/localised_drive.hpp"
#include "tests/bench/times.hpp"

namespace weft::bench {
namespace {

using namespace agents;

void print(const char* what, std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  const auto at = [&](double share) { return ms[static_cast<std::size_t>(share * double(ms.size() - 1))]; };
  std::printf("%-44s %8.3f ms (90 %%: %.3f)\n", what, at(0.5), at(0.9));
}

void bench_chart(const TaughtSite& taught, int rounds) {
  const Topometric method = made_method();
  TopometricConfig config;
  config.chart.apart_m = 0.0;
  config.chart.most_clouds = 12;
  const Topometric of_twelve = made_method(config);
  const auto around = taught.around(18);
  std::vector<double> usual;
  std::vector<double> twelve;
  for (int i = 0; i < rounds; ++i) {
    usual.push_back(timed([&] { static_cast<void>(method.chart(around)); }).processor_ms);
    twelve.push_back(timed([&] { static_cast<void>(of_twelve.chart(around)); }).processor_ms);
  }
  std::printf("%zu places around, %zu points each\n", around.size(), around.front().content->cloud.points.size());
  print("chart, as it is set", usual);
  print("chart of 12 clouds", twelve);
}

void bench_locate(const MadeSite& site, const TaughtSite& taught, bool uses_features) {
  TopometricConfig config;
  config.belief.uses_features = uses_features;
  LocalisedDrive drive(site, taught, config, 1001);
  drive.begin({3.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, 0.05, 0.03);
  Random random(5);
  std::vector<double> ms;
  while (drive.truth().x < 14.0) {
    drive.next({0.1, 0.0, -0.5 * drive.estimate().heading});
    const TopometricContent seen = site.view_from(drive.truth(), random);
    Metric2 step;
    step.a_from_b = {0.1, 0.0, 0.0};
    step.covariance = Eigen::Vector3d(4e-6, 4e-6, 4e-6).asDiagonal();
    ms.push_back(timed([&] {
                   static_cast<void>(drive.method().locate(drive.chart(), drive.belief(), {step, true, {}}, seen));
                 }).processor_ms);
  }
  print(uses_features ? "locate, scan and features" : "locate, scan alone", ms);
}

void bench_steer(const MadeSite& site, const TaughtSite& taught, int rounds) {
  const Topometric method = made_method();
  const TopometricChart chart = method.chart(taught.around(18));
  const TopometricBelief belief;
  Random random(6);
  Topometric::Odometry odometry;
  odometry.costmap.emplace(CostmapConfig{});
  std::vector<double> free_ms;
  std::vector<double> held_ms;
  for (int i = 0; i < rounds; ++i) {
    odometry.time += from_seconds(0.1);
    const Pose2 robot{9.0 + 0.01 * (i % 50), 0.0, 0.0};
    const Scan scan = site.scan_from(robot, random);
    odometry.odometry_from_robot = lift(robot);
    odometry.costmap->take(robot, scan, odometry.time);
    Ahead ahead;
    for (int k = 0; k <= 10; ++k) ahead.robot_from_path.push_back({0.5 * k, 0.0, 0.0});
    ahead.aside_m = i % 2 == 0 ? 0.0 : 1.0;
    const Around<Topometric> around{&chart, &belief, taught.site_from_places[18].inverse() * robot};
    (i % 2 == 0 ? free_ms : held_ms).push_back(timed([&] {
                                                 static_cast<void>(method.steer(odometry, &around, ahead));
                                               }).processor_ms);
  }
  print("steer", free_ms);
  print("steer, within 0.8 m beside the way", held_ms);
}

}  // namespace

int run(int rounds) {
  const MadeSite site = niched_corridor();
  Random random(21);
  TaughtSite taught;
  taught.teach_straight(site, {}, 18.0, random);
  bench_chart(taught, rounds);
  bench_locate(site, taught, true);
  bench_locate(site, taught, false);
  bench_steer(site, taught, 4 * rounds);
  return 0;
}

}  // namespace weft::bench

int main(int count, char** arguments) {
  return weft::bench::run(count > 1 ? std::max(1, std::atoi(arguments[1])) : 20);
}

// Images a second of the simulated camera, beside a plain cv::warpPerspective of the same size in the same run.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "agents/bodies/sim/sim_body.hpp"

namespace weft::agents::sim {
namespace {

enum class Scenery { open, aisle };

Site site_with(Scenery scenery) {
  Site site;
  site.name = "bench";
  site.floor.x_max = 40.0;
  for (const double x : {3.0, 7.5, 12.0, 16.5}) {
    for (const double y : {2.0, 6.0, 10.0}) site.lamps.push_back({x, y, 6.0, 0.9});
  }
  if (scenery == Scenery::aisle) {
    for (const double y : {4.2, 7.8}) {
      site.boxes.push_back({Box::Kind::rack, "rack", {20.0, y, 0.0}, 39.0, 1.0, 4.0});
    }
  }
  site.robots.push_back({"r1", {2.0, 6.0, 0.0}, 1});
  return site;
}

/// Drives there and back, so that the floor is sometimes new and sometimes known.
void simulated_camera(benchmark::State& state) {
  SimBodyConfig config;
  config.site = site_with(static_cast<Scenery>(state.range(0)));
  config.robot = "r1";
  auto body = make_sim_body(config);
  if (!body) {
    state.SkipWithError(body.error().message.c_str());
    return;
  }
  int frame = 0;
  for (auto _ : state) {
    const double forth = (frame++ / 600) % 2 == 0 ? 1.0 : -1.0;
    auto sample = (*body)->step({0.55 * forth, 0.05 * std::sin(frame * 0.05)});
    benchmark::DoNotOptimize(sample);
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(simulated_camera)
    ->Arg(static_cast<int>(Scenery::open))
    ->Arg(static_cast<int>(Scenery::aisle))
    ->ArgName("racks")
    ->Unit(benchmark::kMillisecond)
    ->MinTime(5.0);

void warp_perspective(benchmark::State& state) {
  cv::Mat floor(4096, 4096, CV_8U);
  cv::randu(floor, 0, 255);
  const cv::Matx33d floor_from_image(5.0, 0.4, 200.0, -0.4, 5.0, 300.0, 0.0, 4e-4, 1.0);
  cv::Mat image;
  cv::setNumThreads(1);
  for (auto _ : state) {
    cv::warpPerspective(floor, image, floor_from_image, {752, 480}, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
    benchmark::DoNotOptimize(image.data);
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(warp_perspective)->Unit(benchmark::kMillisecond)->MinTime(2.0);

}  // namespace
}  // namespace weft::agents::sim

BENCHMARK_MAIN();

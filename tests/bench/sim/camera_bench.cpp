// Images a second of the simulated camera, beside a plain cv::warpPerspective of the same size in the same run.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "agents/bodies/sim/changes.hpp"
#include "agents/bodies/sim/floor/procedural.hpp"
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
void drive(benchmark::State& state, const SimBodyConfig& config) {
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

void simulated_camera(benchmark::State& state) {
  SimBodyConfig config;
  config.site = site_with(static_cast<Scenery>(state.range(0)));
  config.robot = "r1";
  drive(state, config);
}
BENCHMARK(simulated_camera)
    ->Arg(static_cast<int>(Scenery::open))
    ->Arg(static_cast<int>(Scenery::aisle))
    ->ArgName("racks")
    ->Unit(benchmark::kMillisecond)
    ->MinTime(5.0);

/// Measures a camera over a floor uneven by so many millimetres, whose shutter rolls for so many milliseconds.
void harder_camera(benchmark::State& state) {
  SimBodyConfig config;
  config.site = site_with(Scenery::open);
  config.site.disturbances.unevenness_m = 1e-3 * static_cast<double>(state.range(0));
  config.site.disturbances.rolling_shutter_s = 1e-3 * static_cast<double>(state.range(1));
  config.robot = "r1";
  drive(state, config);
}
BENCHMARK(harder_camera)
    ->ArgsProduct({{0, 2}, {0, 20}})
    ->ArgNames({"uneven_mm", "rolling_ms"})
    ->Unit(benchmark::kMillisecond)
    ->MinTime(2.0);

/// Measures a width of image; 60 images a second at 320 x 240 and 15 at 640 x 480 are asked for.
void forward_camera(benchmark::State& state) {
  SimBodyConfig config;
  config.site = site_with(Scenery::aisle);
  config.site.movers.push_back({Mover::Kind::person, {{5.0, 5.0}, {15.0, 6.5}}, 1.0, 0.0});
  config.site.movers.push_back({Mover::Kind::forklift, {{12.0, 6.0}, {30.0, 6.0}}, 1.5, 0.0});
  ForwardCameraSetup& camera = config.site.forward_camera;
  camera.focal_px *= static_cast<double>(state.range(0)) / camera.width;
  camera.width = static_cast<int>(state.range(0));
  camera.height = 3 * camera.width / 4;
  config.site.robots.front().looks = {Gaze::ahead};
  config.robot = "r1";
  drive(state, config);
}
BENCHMARK(forward_camera)->Arg(320)->Arg(640)->ArgName("width")->Unit(benchmark::kMillisecond);

/// Measures 640 x 480 under a concrete ceiling with ducts and pipes, and under corrugated steel through a fisheye; 25
/// images a second are asked for.
void ceiling_camera(benchmark::State& state) {
  SimBodyConfig config;
  config.site = site_with(Scenery::open);
  config.site.hall.ceiling.kind = state.range(0) == 0 ? CeilingKind::concrete : CeilingKind::sheet;
  config.site.ceiling_camera.lens = state.range(0) == 0 ? LensModel::radtan : LensModel::equidistant;
  config.site.hall.ceiling.sprinklers_every_m = 3.0;
  config.site.ducts.push_back({1.0, 5.0, 39.0, 5.0, 0.6, 0.8, 0.5});
  config.site.pipes.push_back({1.0, 7.0, 39.0, 7.0, 0.5, 0.15});
  config.site.robots.front().looks = {Gaze::up};
  config.robot = "r1";
  drive(state, config);
}
BENCHMARK(ceiling_camera)->Arg(0)->Arg(1)->ArgName("fisheye")->Unit(benchmark::kMillisecond);

/// Measures it with every light and wear at once, but for the colour, which costs only when floor is made.
void changed_camera(benchmark::State& state) {
  SimBodyConfig config;
  config.site = site_with(Scenery::open);
  for (const char* light : {"halved", "moving-shadow", "glare", "lens-dirt"}) {
    config.site = *under_light(config.site, light);
  }
  for (const char* wear : {"dirt", "wet", "line", "pallet"}) config.site = *with_wear(config.site, wear);
  config.robot = "r1";
  drive(state, config);
}
BENCHMARK(changed_camera)->Unit(benchmark::kMillisecond)->MinTime(5.0);

/// Measures one tile of new floor, 0.64 m squared, white light and coloured.
void new_floor(benchmark::State& state) {
  FloorSetup setup;
  setup.material = floor_kinds()[static_cast<std::size_t>(state.range(0))];
  state.SetLabel(setup.material);
  const auto floor = make_procedural_floor(setup, state.range(1) == 0 ? 0.0 : 0.6);
  std::vector<std::uint8_t> texels(static_cast<std::size_t>(kTileTexels) * kTileTexels);
  TileKey key;
  for (auto _ : state) {
    (*floor)->fill(key, texels);
    ++key.x;
    benchmark::DoNotOptimize(texels.data());
  }
}
BENCHMARK(new_floor)
    ->ArgsProduct({{0, 1, 2, 3, 4, 5}, {0, 1}})
    ->ArgNames({"kind", "coloured"})
    ->Unit(benchmark::kMillisecond);

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

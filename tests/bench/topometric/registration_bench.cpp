// Registration of two clouds as stereo sees a room, about 20k points each, beside PCL's NDT and GICP from the same
// guess, one thread; how far each is off is beside its time. Usage: registration_bench [SEEDS]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <vector>

#include "agents/perception/clouds/ndt.hpp"
#include "agents/perception/clouds/pcl_check.hpp"
#include "clients/evaluate/registration/trials.hpp"
#include "tests/bench/times.hpp"

namespace weft::bench {
namespace {

using namespace agents;
using namespace evaluate::registration;

struct TwoPlaces {
  MadePlace a;
  MadePlace b;
  Pose3 truth;
  Pose3 guess;
  StereoRig rig;
};

/// Makes two places of a room 0.5 m apart, and a guess 0.1 m and 2 degrees off.
TwoPlaces two_places(std::uint64_t seed) {
  Random random(seed);
  StereoRig rig;
  rig.every_px = 3;
  const Scene scene = made_scene(SceneKind::room, random);
  std::vector<MadePlace> places = run_through(scene, scene.start, 2.0, 0.5, rig, random);
  const Pose3 truth = places[0].world_from_place.inverse() * places[1].world_from_place;
  return {places[0], places[1], truth, truth * lift({0.08, -0.06, 0.035}), rig};
}

/// Collects what one way of registering takes, and how far it is off.
struct Way {
  const char* name;
  std::function<std::optional<Pose3>(const TwoPlaces&)> run;
  std::vector<double> ms{};
  std::vector<double> off_mm{};
  std::size_t refused = 0;

  void measure(const TwoPlaces& places, int times) {
    double least_ms = 1e9;
    std::optional<Pose3> pose;
    for (int at = 0; at < times; ++at) {
      least_ms = std::min(least_ms, timed([&] { pose = run(places); }).processor_ms);
    }
    ms.push_back(least_ms);
    if (!pose) {
      ++refused;
      return;
    }
    off_mm.push_back(1e3 * off(places.truth, *pose).metres());
  }
  static double middle(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  }
  void print() const {
    std::printf("%-34s %8.2f ms of processor, %6.1f mm off, %zu refused\n", name, middle(ms), middle(off_mm),
                refused);
  }
};

std::optional<Pose3> with_ndt(const TwoPlaces& places, bool has_prior) {
  const NdtConfig config;
  const NdtMap a = ndt_map(places.a.cloud.framed(places.rig.noise()), config.cells);
  const NdtMap b = ndt_map(places.b.cloud.framed(places.rig.noise()), config.cells);
  EdgePrior prior;
  prior.sigma_m = 0.1;
  prior.sigma_rad = 0.035;
  const auto registered = has_prior ? register_with_prior(a, b, {places.guess, prior.covariance()}, config)
                                    : register_from_guess(a, b, places.guess, config);
  if (!registered) return std::nullopt;
  return registered->a_from_b.a_from_b;
}

}  // namespace
}  // namespace weft::bench

int main(int argc, char** argv) {
  using namespace weft;
  using namespace weft::bench;
  const long seeds = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 7;
  if (seeds < 1 || seeds > 1000) {
    std::fprintf(stderr, "registration_bench: %s: seeds are 1 to 1000\n", argv[1]);
    return 2;
  }
  std::vector<Way> ways;
  ways.push_back({"cells alone, of both", [](const TwoPlaces& places) -> std::optional<Pose3> {
                    const agents::NdtConfig config;
                    agents::ndt_map(places.a.cloud.framed(places.rig.noise()), config.cells);
                    agents::ndt_map(places.b.cloud.framed(places.rig.noise()), config.cells);
                    return places.guess;
                  }});
  ways.push_back({"D2D MAP-NDT, cells included", [](const TwoPlaces& places) { return with_ndt(places, true); }});
  ways.push_back({"D2D-NDT from a guess", [](const TwoPlaces& places) { return with_ndt(places, false); }});
  ways.push_back({"PCL NDT, cells of 1 m", [](const TwoPlaces& places) -> std::optional<Pose3> {
                    return agents::pcl_check::register_p2d_ndt(places.a.cloud.points, places.b.cloud.points,
                                                               places.guess, 1.0)
                        .a_from_b;
                  }});
  ways.push_back({"PCL GICP, 0.5 m at most", [](const TwoPlaces& places) -> std::optional<Pose3> {
                    return agents::pcl_check::register_gicp(places.a.cloud.points, places.b.cloud.points,
                                                            places.guess, 0.5)
                        .a_from_b;
                  }});
  std::vector<double> points;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(seeds); ++seed) {
    const TwoPlaces places = two_places(seed);
    points.push_back(static_cast<double>(places.a.cloud.points.size() + places.b.cloud.points.size()) / 2.0);
    for (Way& way : ways) way.measure(places, way.name[0] == 'P' ? 1 : 5);
  }
  std::printf("medians of %ld pairs, %.0f points each\n", seeds, Way::middle(points));
  for (const Way& way : ways) way.print();
}

#include "clients/evaluate/ceiling/scenes.hpp"

#include <utility>

#include "clients/evaluate/ceiling/navigators.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "core/random.hpp"

namespace weft::evaluate::ceiling {
namespace {

using agents::sim::Site;

constexpr double kWholeLineM = 1e6;
constexpr double kMeasuredWithinM = 0.02;
constexpr double kCalibratedFromM = 9.0;  // of the loop
constexpr double kCalibratedToM = 21.0;

/// Reads a site and a line beside it of which at most so many metres are driven.
Result<Scene> read_driven(const std::filesystem::path& folder, const std::string& site, const std::string& line,
                          double metres, std::string& all) {
  Result<Scene> scene = read_scene(folder, site, line, all);
  if (scene) scene->line = floor::stretch(scene->line, 0.0, metres);
  return scene;
}

}  // namespace

Result<Scenes> read_scenes(const std::filesystem::path& folder, double metres) {
  std::string all;
  Result<Scene> straight = read_driven(folder, "hall", "straight", metres, all);
  if (!straight) return fail(straight.error());
  Result<Scene> loop = read_driven(folder, "hall", "loop", kWholeLineM, all);
  if (!loop) return fail(loop.error());
  Result<Scene> lamps = read_driven(folder, "lamps", "lamps", metres, all);
  if (!lamps) return fail(lamps.error());
  for (const Scene* scene : {&*straight, &*lamps})
    if (const Result<void> good = check_robots(folder, scene->site, {"r1", "r2"}); !good) return fail(good.error());
  Scene calibration{loop->site, floor::stretch(loop->line, kCalibratedFromM, kCalibratedToM)};
  return Scenes{std::move(*straight), std::move(*loop), std::move(*lamps), std::move(calibration), sha256_of(all)};
}

agents::CeilingConfig settings_in(const Site& site, std::uint64_t seed) {
  Random tape = Random(seed).fork(1);
  agents::CeilingConfig settings;
  settings.height_m = site.hall.ceiling_m + kMeasuredWithinM * tape.normal();
  settings.height_sigma_m = kMeasuredWithinM;
  return settings;
}

floor::Drive drive_of(const Site& site, const Driven& driven, const Calibrated& given) {
  floor::Drive drive;
  drive.body.site = site;
  drive.body.robot = driven.robot;
  drive.body.seed = driven.seed;
  drive.body.day = driven.day;
  drive.body.truth_path = driven.scratch.string();
  drive.asked_to_stop = driven.asked_to_stop;
  drive.camera = given.camera;
  drive.navigator = ceiling_navigator(given.settings);
  return drive;
}

}  // namespace weft::evaluate::ceiling

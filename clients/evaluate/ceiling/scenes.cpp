#include "clients/evaluate/ceiling/scenes.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "clients/evaluate/ceiling/navigators.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/line.hpp"
#include "core/random.hpp"

namespace weft::evaluate::ceiling {
namespace {

using agents::sim::RobotStart;
using agents::sim::Site;

constexpr double kWholeLineM = 1e6;
constexpr double kMeasuredWithinM = 0.02;
constexpr double kCalibratedFromM = 9.0;  // of the loop
constexpr double kCalibratedToM = 21.0;

/// Reads a site and a line beside it, and adds their texts to `all`.
Result<Scene> read_scene(const std::filesystem::path& folder, const std::string& site, const std::string& line,
                         double metres, std::string& all) {
  const std::filesystem::path site_file = folder / (site + ".toml");
  const Result<std::string> site_text = read_text(site_file, "site of the study; give its folder with --scenes");
  if (!site_text) return fail(site_text.error());
  Result<Site> parsed = agents::sim::parse_site(*site_text, site_file.string());
  if (!parsed) return fail(parsed.error());
  const std::filesystem::path line_file = folder / (line + ".line");
  const Result<std::string> line_text = read_text(line_file, "line of the study; give its folder with --scenes");
  if (!line_text) return fail(line_text.error());
  const auto points = parse_line(*line_text, line_file.string());
  if (!points) return fail(points.error());
  all += *site_text + "\n" + *line_text + "\n";
  return Scene{std::move(*parsed), floor::stretch(*points, 0.0, metres)};
}

auto find_start(auto& site, const std::string& robot) {
  const auto found = std::find_if(site.robots.begin(), site.robots.end(),
                                  [&robot](const RobotStart& start) { return start.name == robot; });
  assert(found != site.robots.end());
  return found;
}

}  // namespace

Result<Scenes> read_scenes(const std::filesystem::path& folder, double metres) {
  std::string all;
  Result<Scene> straight = read_scene(folder, "hall", "straight", metres, all);
  if (!straight) return fail(straight.error());
  Result<Scene> loop = read_scene(folder, "hall", "loop", kWholeLineM, all);
  if (!loop) return fail(loop.error());
  Result<Scene> lamps = read_scene(folder, "lamps", "lamps", metres, all);
  if (!lamps) return fail(lamps.error());
  for (const Scene* scene : {&*straight, &*lamps})
    for (const char* const robot : {"r1", "r2"})
      if (std::none_of(scene->site.robots.begin(), scene->site.robots.end(),
                       [robot](const RobotStart& start) { return start.name == robot; }))
        return fail(ErrorCode::invalid, folder.string() + ": site " + scene->site.name + " has no robot " + robot +
                                            ", which drives in it");
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

Site with_start(Site site, const std::string& robot, const Pose2& site_from_robot) {
  find_start(site, robot)->site_from_robot = site_from_robot;
  return site;
}

const RobotStart& start_of(const Site& site, const std::string& robot) {
  return *find_start(site, robot);
}

}  // namespace weft::evaluate::ceiling

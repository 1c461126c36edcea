#include "clients/evaluate/bearing/trials.hpp"

#include "clients/evaluate/files.hpp"
#include "clients/evaluate/line.hpp"

namespace weft::evaluate::bearing {

using agents::sim::Mover;
using agents::sim::Site;

namespace {

const Pose2 kAMetreAside{0.0, -1.0, 0.0};
const Pose2 kAside{0.0, -1.5, 0.0};
const Pose2 kBehindAndAside{-0.9, -0.8, 0.0};  // IV-B

void as_it_is(Site&) {}

void true_wheels(Site& site) {
  site.disturbances.wheel_scale_error = 0.0;
  site.disturbances.wheel_asymmetry = 0.0;
}

/// Makes wheels a tenth to an eighth longer or shorter than at teaching, by the seed, and one larger than the other.
void bad_wheels(Site& site) {
  site.disturbances.wheel_scale_error = 0.10;
  site.disturbances.wheel_asymmetry = 0.05;
}

void true_camera(Site& site) {
  site.disturbances.focal_error = 0.0;
}

/// Gives the robot another camera of the make, whose data sheet is as far off as data sheets are.
void other_camera(Site& site) {
  site.disturbances.focal_error = 0.02;
}

/// Gives the robot a camera of another make: wider, finer, with more of the lens, 10 cm higher and level.
void other_make(Site& site) {
  agents::sim::ForwardCameraSetup& camera = site.forward_camera;
  camera.width = 400;
  camera.height = 300;
  camera.focal_px = 400.0;
  camera.k1 = -0.15;
  camera.height_m += 0.1;
  camera.pitch_rad = 0.0;
}

template <auto... Changes>
void all_of(Site& site) {
  (Changes(site), ...);
}

void no_encoders(Site& site) {
  site.base.has_encoders = false;
}

void other_stock_and_people(Site& site) {
  site.change.stock = 0.3;
  const auto walks = [&](std::vector<agents::SitePoint> way, double speed_m_s, double begins_m) {
    Mover person{Mover::Kind::person, std::move(way), speed_m_s, begins_m};
    person.is_solid = false;  // this method sees people as what hides the way, not as what stands in it
    site.movers.push_back(person);
  };
  walks({{4.0, 2.6}, {26.0, 2.6}}, 1.0, 6.0);
  walks({{26.0, 13.2}, {4.0, 13.2}}, 1.2, 3.0);
  walks({{26.6, 4.0}, {26.6, 12.0}}, 0.8, 0.0);
}

}  // namespace

void dark(Site& site) {
  site.change.ambient = 0.02;
  site.change.lamps_failed = 1.0;
  site.forward_camera.headlight = 2.0;
}

void half_of_the_lamps(Site& site) {
  dark(site);
  site.change.lamps_failed = 0.5;
}

Drive drive_of(const Scene& scene, std::uint64_t seed, std::uint64_t day,
               const std::function<bool()>& asked_to_stop) {
  Drive drive;
  drive.body.site = scene.site;
  drive.body.site.change.seed = seed;
  drive.body.robot = scene.site.robots.front().name;
  drive.body.seed = seed;
  drive.body.day = day;
  drive.asked_to_stop = asked_to_stop;
  return drive;
}

Result<Scene> read_scene(const std::filesystem::path& folder, const std::string& site_name,
                         const std::string& line_name) {
  const std::filesystem::path site_file = folder / (site_name + ".toml");
  const Result<std::string> site_text = read_text(site_file, "site file; deploy/sites/bearing has them");
  if (!site_text) return fail(site_text.error());
  Result<Site> site = agents::sim::parse_site(*site_text, site_file.string());
  if (!site) return fail(site.error());
  const std::filesystem::path line_file = folder / (line_name + ".line");
  const Result<std::string> line_text = read_text(line_file, "line to drive along; deploy/sites/bearing has them");
  if (!line_text) return fail(line_text.error());
  auto line = parse_line(*line_text, line_file.string());
  if (!line) return fail(line.error());
  return Scene{std::move(*site), std::move(*line), sha256_of(*site_text + *line_text)};
}

const std::vector<Trial>& trials() {
  static const std::vector<Trial> all = {
      {"oval", "10 m oval, 1 m off", "oval", "oval", kAMetreAside, 20, Parts::all, as_it_is, as_it_is},
      {"oval-as-published", "oval, 1 m off, distance by wheels alone", "oval", "oval", kAMetreAside, 20,
       Parts::heading_only, as_it_is, as_it_is},
      {"oval-profile-only", "oval, profile only", "oval", "oval", {}, 5, Parts::profile_only, as_it_is, as_it_is},
      {"oval-behind", "oval, 0.9 m behind and 0.8 m aside", "oval", "oval", kBehindAndAside, 5, Parts::all, as_it_is,
       as_it_is},
      {"corners", "rectangle with sharp turns", "oval", "corners", {}, 2, Parts::all, as_it_is, as_it_is},
      {"corners-vision-only",
       "rectangle with sharp turns, vision only",
       "oval",
       "corners",
       {},
       2,
       Parts::vision_only,
       as_it_is,
       as_it_is},
      {"oval-bad-wheels", "oval, 1 m off, wheels off by 10 %, asymmetric by 5 %", "oval", "oval", kAMetreAside, 20,
       Parts::all, true_wheels, bad_wheels},
      {"oval-no-encoders", "oval, 1 m off, distance by command", "oval", "oval", kAMetreAside, 20, Parts::all,
       no_encoders, no_encoders},
      {"oval-other-camera", "oval, 1 m off, focal length 2 % off the teacher's", "oval", "oval", kAMetreAside, 20,
       Parts::all, true_camera, other_camera},
      {"oval-other-make", "oval, 1 m off, a camera of another make than the teacher's", "oval", "oval", kAMetreAside,
       20, Parts::all, as_it_is, other_make},
      {"lemniscate", "17 m lemniscate, 1 m off", "lemniscate", "lemniscate", kAMetreAside, 19, Parts::all, as_it_is,
       as_it_is},
      {"lemniscate-bad-wheels", "lemniscate, 1 m off, wheels off by 10 %, asymmetric by 5 %", "lemniscate",
       "lemniscate", kAMetreAside, 19, Parts::all, true_wheels, bad_wheels},
      {"yard-day", "60 m, 1.5 m off, by day", "yard", "yard", kAside, 7, Parts::all, as_it_is, as_it_is},
      {"yard-dark", "60 m, 1.5 m off, in the dark with a headlight", "yard", "yard", kAside, 7, Parts::all, dark,
       dark},
      {"yard-half", "60 m, 1.5 m off, half of the lamps back on", "yard", "yard", kAside, 7, Parts::all,
       half_of_the_lamps, half_of_the_lamps},
      {"yard-bad-wheels", "60 m, 1.5 m off, wheels off by 10 %, asymmetric by 5 %", "yard", "yard", kAside, 7,
       Parts::all, true_wheels, bad_wheels},
      {"yard-dark-bad-wheels", "60 m, 1.5 m off, in the dark, wheels off by 10 %, asymmetric by 5 %", "yard", "yard",
       kAside, 7, Parts::all, all_of<dark, true_wheels>, all_of<dark, bad_wheels>},
      {"yard-half-bad-wheels", "60 m, 1.5 m off, half of the lamps, wheels off by 10 %, asymmetric by 5 %", "yard",
       "yard", kAside, 7, Parts::all, all_of<half_of_the_lamps, true_wheels>, all_of<half_of_the_lamps, bad_wheels>},
      {"yard-changed", "60 m, 1.5 m off, 30 % of the stock changed, 3 people", "yard", "yard", kAside, 7, Parts::all,
       as_it_is, other_stock_and_people},
  };
  return all;
}

}  // namespace weft::evaluate::bearing

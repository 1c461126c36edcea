#include "clients/evaluate/floor/scenario.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <system_error>
#include <utility>

#include "agents/bodies/sim/changes.hpp"

namespace weft::evaluate::floor {
namespace {

using namespace agents;

constexpr double kRadADegree = std::numbers::pi / 180.0;
constexpr double kCalibrationM = 8.0;
constexpr std::uint64_t kOtherRobot = 17;  // added to a robot's own seed

double heading_of(const SitePoint& a, const SitePoint& b) {
  return std::atan2(b.y - a.y, b.x - a.x);
}

}  // namespace

Result<std::vector<std::string>> photographs_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code problem;
  for (const auto& entry : std::filesystem::directory_iterator(folder, problem)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".png" || ending == ".jpg" || ending == ".jpeg") names.push_back(entry.path().stem().string());
  }
  if (problem || names.empty()) {
    return fail(ErrorCode::not_found, folder.string() + ": holds no .png or .jpg photograph of a floor");
  }
  std::sort(names.begin(), names.end());
  return names;
}

const std::vector<std::string>& lights() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names = sim::light_names();
    names.insert(names.end(), sim::wear_names().begin() + 1, sim::wear_names().end());  // "same" is in both
    return names;
  }();
  return all;
}

bool repeats_itself(const std::string& kind) {
  return kind == "tiles";
}

bool is_textured(const std::string& kind) {
  return kind != "epoxy" && !repeats_itself(kind);
}

bool was_set_by(const std::string& kind) {
  return kind == "epoxy" || kind == "polished-concrete";
}

Result<Scenario> Scenario::make(const Stage& stage, const std::string& kind, std::uint64_t seed) {
  Stage here = stage;
  if (here.floors_dir) {
    here.site.floor.photograph = kind;
  } else {
    Result<sim::Site> laid = sim::on_floor(std::move(here.site), kind);
    if (!laid) return fail(laid.error());
    here.site = std::move(*laid);
  }
  here.site.floor.seed += seed;
  return Scenario(std::move(here), seed);
}

Drive Scenario::drive_in(sim::Site site, std::uint64_t day) const {
  Drive drive;
  drive.body.robot = site.robots.front().name;
  drive.body.site = std::move(site);
  drive.body.seed = seed_;
  drive.body.day = day;
  drive.body.floors_dir = stage_.floors_dir;
  drive.body.truth_path = stage_.scratch.string();
  drive.asked_to_stop = stage_.asked_to_stop;
  return drive;
}

Drive Scenario::first() const {
  return drive_in(stage_.site, 0);
}

Drive Scenario::for_calibration() const {
  sim::Site site = stage_.site;
  const std::vector<SitePoint> line = calibration_line();
  site.robots.front().site_from_robot = {line[0].x, line[0].y, heading_of(line[0], line[1])};
  return drive_in(std::move(site), 0);
}

std::vector<SitePoint> Scenario::calibration_line() const {
  return stretch(second_part(), 0.0, kCalibrationM);
}

Drive Scenario::with_wrong_mount() const {
  sim::Site site = stage_.site;
  site.disturbances.mount_error_m = 0.005;
  site.disturbances.mount_error_rad = 0.5 * kRadADegree;
  return drive_in(std::move(site), 0);
}

Drive Scenario::fast() const {
  sim::Site site = stage_.site;
  site.camera.fps = 15.0;
  site.disturbances.exposure_s = 0.010;  // twice the site's usual one, as the images come at half the rate
  site.hand.speed_m_s = 1.5;
  site.base.max_speed_m_s = 2.0;
  const std::vector<SitePoint> straight = fast_line();
  site.robots.front().site_from_robot = {straight[0].x, straight[0].y, heading_of(straight[0], straight[1])};
  return drive_in(std::move(site), 0);
}

std::vector<SitePoint> Scenario::fast_line() const {
  return longest_straight(stage_.line);
}

Drive Scenario::at_rate(double fps) const {
  sim::Site site = stage_.site;
  site.camera.fps = fps;
  return drive_in(std::move(site), 0);
}

Result<Drive> Scenario::second(const std::string& light) const {
  const std::vector<std::string>& wears = sim::wear_names();
  const bool is_wear = std::find(wears.begin() + 1, wears.end(), light) != wears.end();
  Result<sim::Site> site = is_wear ? sim::with_wear(stage_.site, light) : sim::under_light(stage_.site, light);
  if (!site) return fail(site.error());
  sim::RobotStart& start = site->robots.front();
  start.name = "beside";
  start.seed += kOtherRobot;
  start.site_from_robot = start.site_from_robot * Pose2{0.0, 0.1, 0.05};
  return drive_in(std::move(*site), 1);
}

Drive Scenario::other_on_second_part() const {
  sim::Site site = stage_.site;
  sim::RobotStart& start = site.robots.front();
  const std::vector<SitePoint> part = second_part();
  start.name = "other";
  start.seed += 2 * kOtherRobot;
  start.site_from_robot = {part[0].x, part[0].y, heading_of(part[0], part[1])};
  return drive_in(std::move(site), 2);
}

std::vector<SitePoint> Scenario::line_beginning(double metres) const {
  return stretch(stage_.line, 0.0, metres);
}
std::vector<SitePoint> Scenario::first_part() const {
  return stretch(stage_.line, 0.0, 0.60 * length_of(stage_.line));
}
std::vector<SitePoint> Scenario::second_part() const {
  return stretch(stage_.line, 0.45 * length_of(stage_.line), length_of(stage_.line));
}

double length_of(const std::vector<SitePoint>& line) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
    sum += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  return sum;
}

std::vector<SitePoint> stretch(const std::vector<SitePoint>& line, double from_m, double to_m) {
  std::vector<SitePoint> part;
  double along = 0.0;
  for (std::size_t i = 1; i < line.size() && along < to_m; ++i) {
    const SitePoint& a = line[i - 1];
    const SitePoint& b = line[i];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const auto at = [&](double metres) {
      const double share = (metres - along) / length;
      return SitePoint{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    };
    if (length > 0.0 && along + length > from_m) {
      if (part.empty()) part.push_back(at(std::max(from_m, along)));
      part.push_back(along + length > to_m ? at(to_m) : b);
    }
    along += length;
  }
  return part;
}

std::vector<SitePoint> longest_straight(const std::vector<SitePoint>& line) {
  constexpr double kStraight = 5.0 * kRadADegree;
  std::vector<SitePoint> best;
  for (std::size_t from = 0; from + 1 < line.size(); ++from) {
    const double heading = heading_of(line[from], line[from + 1]);
    std::vector<SitePoint> part = {line[from]};
    for (std::size_t i = from + 1; i < line.size(); ++i) {
      if (std::abs(wrap_angle(heading_of(line[i - 1], line[i]) - heading)) > kStraight) break;
      part.push_back(line[i]);
    }
    if (length_of(part) > length_of(best)) best = std::move(part);
  }
  return best;
}

}  // namespace weft::evaluate::floor

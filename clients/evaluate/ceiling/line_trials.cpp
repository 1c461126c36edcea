#include "clients/evaluate/ceiling/line_trials.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "clients/evaluate/ceiling/calibrated.hpp"
#include "clients/evaluate/ceiling/published_line.hpp"
#include "clients/evaluate/ceiling/true_heights.hpp"
#include "clients/evaluate/floor/measures.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "core/random.hpp"

namespace weft::evaluate::ceiling {
namespace {

using namespace agents;

constexpr double kMountOffRad = 0.3 * std::numbers::pi / 180.0;

/// Returns where a robot is put down to repeat: a hand's breadth beside the beginning.
Pose2 beside_beginning(const Way& way) {
  return beginning_of(way.scene.line) * Pose2{0.0, 0.1, 0.05};
}

/// Has a robot find itself beside the line's beginning and drive to its end in that site, on another day.
Result<std::optional<floor::Repeated>> repeat_in(const sim::Site& site, const Way& way, Driven driven,
                                                 const Calibrated& given) {
  driven.day = 1;
  const sim::Site beside = with_start(site, driven.robot, beside_beginning(way));
  return floor::repeat(drive_of(beside, driven, given), way.taught);
}

/// Adds what the drive to teach shows: speeds, with all heights and as if all were one plane, and the heights.
void add_teaching(const Way& way, Score& score) {
  const double ours = floor::speed_error(way.trace()).percent;
  const double flat = floor::speed_error(with_odometry(way.trace(), way.watch->one_plane())).percent;
  score.values["speed_percent"] = ours;
  score.values["one_plane_percent"] = flat;
  score.values["one_plane_times"] = flat / ours;
  const HeightErrors heights =
      judge_heights(way.scene.site, way.watch->camera(), way.watch->heights().seen(), way.trace());
  score.values["heights"] = static_cast<double>(heights.all);
  score.values["heights_hanging"] = static_cast<double>(heights.hanging_m.size());
  score.values["height_quartile_m"] = upper_quartile(heights.hanging_m);
  score.values["height_beyond_percent"] =
      heights.all > 0 ? 100.0 * static_cast<double>(heights.beyond) / static_cast<double>(heights.all)
                      : Score::kNothing;
}

}  // namespace

Result<std::optional<Measured>> measure_line(const Way& way, const Driven& driven) {
  const auto repeated = repeat_in(way.scene.site, way, driven, way.given);
  if (!repeated) return fail(repeated.error());
  if (!*repeated) return std::optional<Measured>();
  Driven next_day = driven;
  next_day.day = 1;
  const double metres = floor::length_of(way.scene.line);
  const auto published =
      drive_as_published(drive_of(way.scene.site, next_day, way.given).body, metres, driven.asked_to_stop);
  if (!published) return fail(published.error());
  if (!*published) return std::optional<Measured>();
  Measured measured;
  Score& score = measured.score;
  add_path(way, **repeated, score);
  add_teaching(way, score);
  add_held({&way.trace(), &(*repeated)->trace}, score);
  const BesideErrors beside = errors_of(**published);
  score.values["published_rms_mm"] = 1e3 * beside.rms_m;
  score.values["published_worst_mm"] = 1e3 * beside.worst_m;
  measured.shown["ours"] = beside_of(way, **repeated);
  for (const BesideLine& at : **published) measured.shown["published"].push_back({at.along_m, 1e3 * at.left_m});
  return std::optional(std::move(measured));
}

Result<std::optional<Measured>> measure_other(const Way& way, const Driven& driven, const Scenes& scenes) {
  Driven other = driven;
  other.robot = "r2";
  const auto given = calibrated(scenes, way.scene.site, other);
  if (!given) return fail(given.error());
  if (!*given) return std::optional<Measured>();
  sim::Site moved = way.scene.site;
  Random random = Random(driven.seed).fork(2);
  const double towards = random.uniform(-std::numbers::pi, std::numbers::pi);
  for (sim::RobotStart& start : moved.robots) {
    if (start.name != other.robot) continue;
    sim::CeilingCameraSetup camera = start.ceiling_camera.value_or(moved.ceiling_camera);
    camera.tilt_error_forward_rad = kMountOffRad * std::cos(towards);
    camera.tilt_error_left_rad = kMountOffRad * std::sin(towards);
    start.ceiling_camera = camera;
  }
  const auto repeated = repeat_in(moved, way, other, **given);
  if (!repeated) return fail(repeated.error());
  if (!*repeated) return std::optional<Measured>();
  Measured measured;
  add_path(way, **repeated, measured.score);
  add_held({&(*repeated)->trace}, measured.score);
  measured.score.values["centroid_rms_mm"] =
      1e3 * centroid_rms_m((*repeated)->trace, way.taught.places.site_from_place, way.watch->camera(),
                           *(*given)->camera, way.given.settings.height_m);
  measured.shown["ours"] = beside_of(way, **repeated);
  return std::optional(std::move(measured));
}

Result<std::optional<Measured>> measure_change(const Way& way, const Driven& driven) {
  sim::Site site = way.scene.site;
  const Pose2 site_from_line = beginning_of(way.scene.line);
  const double metres = floor::length_of(way.scene.line);
  const auto at = [&](double along_m, double left_m) {
    const Eigen::Vector2d point = site_from_line * Eigen::Vector2d(along_m, left_m);
    return SitePoint{point.x(), point.y()};
  };
  const SitePoint right = at(0.5 * metres, -2.0);
  const SitePoint left = at(0.5 * metres, 3.0);
  sim::Duct duct;
  duct.x0 = right.x;
  duct.y0 = right.y;
  duct.x1 = left.x;
  duct.y1 = left.y;
  site.change.ducts.push_back(duct);
  site.change.skylight = 4.0;
  sim::Mover person;
  person.way = {at(0.0, 1.4), at(metres, 1.4)};
  sim::Mover forklift;
  forklift.kind = sim::Mover::Kind::forklift;
  forklift.way = {at(metres, 2.8), at(0.0, 2.8)};
  forklift.forks_m = 3.0;
  site.movers.push_back(person);
  site.movers.push_back(forklift);
  const auto repeated = repeat_in(site, way, driven, way.given);
  if (!repeated) return fail(repeated.error());
  if (!*repeated) return std::optional<Measured>();
  Measured measured;
  add_path(way, **repeated, measured.score);
  add_held({&(*repeated)->trace}, measured.score);
  measured.shown["ours"] = beside_of(way, **repeated);
  return std::optional(std::move(measured));
}

Eigen::Vector2d middle_of_view(const CameraModel& camera, double ceiling_m) {
  const Eigen::Vector3d axis = camera.robot_from_camera.rotation * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d& eye = camera.robot_from_camera.translation;
  return eye.head<2>() + (ceiling_m - eye.z()) / axis.z() * axis.head<2>();
}

double centroid_rms_m(const floor::Trace& trace, const std::map<PlaceId, Pose2>& site_from_place,
                      const CameraModel& taught_by, const CameraModel& driven_by, double ceiling_m) {
  const Eigen::Vector2d middle_a = middle_of_view(taught_by, ceiling_m);
  const Eigen::Vector2d middle_b = middle_of_view(driven_by, ceiling_m);
  double squares = 0.0;
  double fixes = 0.0;
  for (const floor::Moment& moment : trace.moments) {
    if (!moment.fix) continue;
    const Pose2 place_from_robot = site_from_place.at(moment.fix->place).inverse() * moment.site_from_robot;
    const Eigen::Vector2d said = place_from_robot * middle_b - middle_a;
    squares += (said - place_from_robot.translation()).squaredNorm();
    fixes += 1.0;
  }
  return fixes > 0.0 ? std::sqrt(squares / fixes) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace weft::evaluate::ceiling

#include "clients/evaluate/ceiling/way.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "clients/evaluate/floor/measures.hpp"
#include "clients/evaluate/floor/taught_path.hpp"

namespace weft::evaluate::ceiling {

using namespace agents;

Result<std::optional<Way>> teach_way(const Scene& scene, const Driven& driven, const Calibrated& given) {
  Way way;
  way.scene = {with_start(scene.site, driven.robot, beginning_of(scene.line)), scene.line};
  way.given = given;
  floor::Drive drive = drive_of(way.scene.site, driven, given);
  drive.navigator = [&way](const CameraModel& camera,
                           std::shared_ptr<floor::SeenStep> seen) -> Result<std::unique_ptr<Navigator>> {
    Result<std::shared_ptr<DriveWatch>> watch = DriveWatch::make(way.given.settings, camera);
    if (!watch) return fail(watch.error());
    way.watch = std::move(*watch);
    return ceiling_navigator(way.given.settings, DriveWatch::look_of(way.watch))(camera, std::move(seen));
  };
  const Result<bool> taught = floor::teach(drive, way.scene.line, way.taught);
  if (!taught) return fail(taught.error());
  if (!*taught) return std::optional<Way>();
  return std::optional(std::move(way));
}

void add_path(const Way& way, const floor::Repeated& repeated, Score& score) {
  constexpr double degrees = 180.0 / std::numbers::pi;
  const floor::PathErrors path = floor::path_errors(floor::off_path(repeated.trace, floor::TaughtPath(way.trace())));
  const Pose2 goal_from_robot =
      way.taught.places.site_from_place.at(way.taught.last).inverse() * repeated.trace.moments.back().site_from_robot;
  const auto if_arrived = [&](double value) { return repeated.arrived ? value : Score::kNothing; };
  score.values["arrived"] = repeated.arrived ? 1.0 : 0.0;
  score.values["lateral_rms_mm"] = if_arrived(1e3 * path.lateral_rmse_m);
  score.values["lateral_worst_mm"] = if_arrived(1e3 * path.lateral_worst_m);
  score.values["goal_mm"] = if_arrived(1e3 * goal_from_robot.translation().norm());
  score.values["goal_deg"] = if_arrived(degrees * std::abs(wrap_angle(goal_from_robot.heading)));
  score.values["fixes"] = floor::fixes(repeated.trace);
  score.values["wrong_fixes"] = floor::wrong_fixes(repeated.trace, way.taught.places.site_from_place);
}

void add_held(const std::vector<const floor::Trace*>& traces, Score& score) {
  for (const auto& [metres, name] : {std::pair(1.0, "held_1m_percent"), std::pair(10.0, "held_10m_percent")}) {
    std::vector<double> all;
    for (const floor::Trace* const trace : traces) {
      const std::vector<double> some = floor::distances2(floor::stretches(*trace, metres));
      all.insert(all.end(), some.begin(), some.end());
    }
    score.values[name] = floor::held_percent(all);
  }
}

std::vector<std::array<double, 2>> beside_of(const Way& way, const floor::Repeated& repeated) {
  std::vector<std::array<double, 2>> points;
  for (const floor::OffPath& off : floor::off_path(repeated.trace, floor::TaughtPath(way.trace())))
    points.push_back({off.driven_m, 1e3 * off.lateral_m});
  return points;
}

}  // namespace weft::evaluate::ceiling

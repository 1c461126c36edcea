#include "clients/evaluate/floor/shown.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "clients/evaluate/floor/measures.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate::floor {
namespace {

using ShownJson = nlohmann::json;

/// Returns the true way, site frame; empty of a run that never began.
ShownJson true_path(const Trace& trace) {
  ShownJson points = ShownJson::array();
  if (trace.moments.size() < 2) return points;
  for (const Moment& moment : trace.moments) points.push_back({moment.site_from_robot.x, moment.site_from_robot.y});
  return points;
}

/// Returns the way by odometry, laid on the truth at its start.
ShownJson inferred_path(const Trace& trace) {
  const Moment& first = trace.moments.front();
  const Pose2 site_from_start = first.site_from_robot * first.start_from_robot.inverse();
  ShownJson points = ShownJson::array();
  for (const Moment& moment : trace.moments) {
    const Pose2 pose = site_from_start * moment.start_from_robot;
    points.push_back({pose.x, pose.y});
  }
  return points;
}

/// Returns the path of a repeat as its fixes state it, by the true poses of the places.
ShownJson fixed_path(const Trace& trace, const PlaceSet& places) {
  ShownJson points = ShownJson::array();
  for (const Moment& moment : trace.moments) {
    if (!moment.fix) continue;
    const Pose2 pose = places.site_from_place.at(moment.fix->place) * moment.fix->measured;
    points.push_back({pose.x, pose.y});
  }
  return points;
}

/// Returns means over whole seconds, views without a motion counted as 0.
ShownJson matches_of(const Trace& trace) {
  std::map<int, std::pair<double, double>> by_second;  // sum and count
  for (const Moment& moment : trace.moments) {
    auto& [sum, count] = by_second[static_cast<int>(moment.true_s)];
    sum += static_cast<double>(moment.matches);
    count += 1.0;
  }
  ShownJson means = ShownJson::array();
  for (const auto& [second, of] : by_second) means.push_back({second + 0.5, of.first / of.second});
  return means;
}

ShownJson speeds_of(const Trace& trace) {
  ShownJson speeds = ShownJson::array();
  for (const SpeedWindow& window : speed_windows(trace))
    speeds.push_back({window.true_s, window.v_m_s, window.v_true_m_s});
  return speeds;
}

ShownJson off_of(const Shown& shown) {
  ShownJson off = ShownJson::array();
  for (const OffPath& now : off_path(shown.repeated, TaughtPath(shown.taught)))
    off.push_back({now.true_s, now.driven_m, now.lateral_m, now.heading_rad});
  return off;
}

/// Returns the runs at several frame rates, the fastest first.
ShownJson rates_of(const Shown& shown) {
  ShownJson rates = ShownJson::array();
  for (auto at = shown.at_rates.rbegin(); at != shown.at_rates.rend(); ++at) {
    ShownJson speeds = ShownJson::array();
    for (const SpeedWindow& window : speed_windows(at->second)) speeds.push_back({window.true_s, window.v_m_s});
    rates.push_back({{"fps", at->first},
                     {"matches", matches_of(at->second)},
                     {"speeds", std::move(speeds)},
                     {"path", true_path(at->second)},
                     {"odometry", inferred_path(at->second)}});
  }
  return rates;
}

ShownJson json_of(const Shown& shown, double camera_height_m) {
  const PlaceSet places = places_of(shown.taught);
  const std::vector<FixedStretch> stretches = fixed_stretches(shown.repeated, places.start_from_place);
  ShownJson between_fixes = ShownJson::array();
  for (const FixedStretch& stretch : stretches)
    between_fixes.push_back({stretch.true_s, stretch.v_odometry_m_s, stretch.v_fixes_m_s});
  return {{"floor", shown.kind},
          {"camera_height_m", camera_height_m},
          {"speeds", speeds_of(shown.taught)},
          {"speed_percent", speed_error(shown.taught).percent},  // NaN becomes null
          {"taught", true_path(shown.taught)},
          {"odometry", inferred_path(shown.taught)},
          {"repeated", true_path(shown.repeated)},
          {"fixes", static_cast<std::size_t>(fixes(shown.repeated))},
          {"fixed", fixed_path(shown.repeated, places)},
          {"between_fixes", std::move(between_fixes)},
          {"apart_percent", consistency_percent(stretches)},
          {"off", off_of(shown)},
          {"rates", rates_of(shown)},
          {"two_taught", {true_path(shown.two_taught.at(0)), true_path(shown.two_taught.at(1))}},
          {"two_repeated", true_path(shown.two_repeated)}};
}

}  // namespace

Result<void> write_pictured(const std::filesystem::path& folder, const Pictured& pictured) {
  ShownJson document = {{"about", pictured.about},
                        {"of_first", pictured.of_first},
                        {"seeds", {pictured.seeds.first, pictured.seeds.last}},
                        {"lights", pictured.lights},
                        {"floors", ShownJson::array()},
                        {"shown", ShownJson::array()}};
  for (const Shown& shown : pictured.kinds) {
    document["floors"].push_back(shown.kind);
    document["shown"].push_back(json_of(shown, pictured.camera_height_m));
  }
  return write_series(folder, "floor", document);
}

}  // namespace weft::evaluate::floor

#include "clients/evaluate/floor/score.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "clients/evaluate/floor/measures.hpp"

namespace weft::evaluate::floor {
namespace {

constexpr double kDegreesARad = 180.0 / std::numbers::pi;

double driven_m(const Trace& trace) {
  return trace.moments.empty() ? 0.0 : metres_driven(trace).back();
}

void add_held(const Trace& trace, Score& score) {
  score.held_1m_percent = held_percent(distances2(stretches(trace, 1.0)));
  score.held_10m_percent = held_percent(distances2(stretches(trace, 10.0)));
}

}  // namespace

const std::vector<Column>& columns() {
  static const std::vector<Column> all = {
      {"metres", "driven m", &Score::metres, 0},
      {"speed_percent", "speed %", &Score::speed_percent, 2},
      {"speed_stamped_percent", "by stamps %", &Score::speed_stamped_percent, 2},
      {"speed_wrong_mount_percent", "wrong mount %", &Score::speed_wrong_mount_percent, 2},
      {"speed_fast_percent", "1.5 m/s %", &Score::speed_fast_percent, 2},
      {"arrived", "arrived", &Score::arrived, 2},
      {"consistency_percent", "consistency %", &Score::consistency_percent, 2},
      {"blind_m", "blind m", &Score::blind_m, 2},
      {"lateral_rmse_mm", "path mm", &Score::lateral_rmse_mm, 1},
      {"lateral_worst_mm", "path worst mm", &Score::lateral_worst_mm, 1},
      {"heading_rms_deg", "heading deg", &Score::heading_rms_deg, 2},
      {"goal_mm", "goal mm", &Score::goal_mm, 1},
      {"goal_deg", "goal deg", &Score::goal_deg, 2},
      {"fixes", "fixes", &Score::fixes, 0},
      {"wrong_fixes", "wrong", &Score::wrong_fixes, 0},
      {"held_1m_percent", "held 1 m %", &Score::held_1m_percent, 0},
      {"held_10m_percent", "held 10 m %", &Score::held_10m_percent, 0},
      {"seconds", "took s", &Score::seconds, 0},
  };
  return all;
}

Score score_of_mapping(const Trace& taught, const Trace& wrong_mount, const Trace& fast) {
  Score score;
  const SpeedError error = speed_error(taught);
  score.metres = driven_m(taught) + driven_m(wrong_mount) + driven_m(fast);
  score.speed_percent = error.percent;
  score.speed_stamped_percent = error.stamped_percent;
  score.speed_wrong_mount_percent = speed_error(wrong_mount).percent;
  score.speed_fast_percent = speed_error(fast).percent;
  add_held(taught, score);
  score.refusals = taught.refusals;
  return score;
}

Score score_of_repeat(const Taught& taught, const Repeated& repeated) {
  Score score;
  const Trace& trace = repeated.trace;
  score.metres = driven_m(trace);
  score.arrived = repeated.arrived ? 1.0 : 0.0;
  score.consistency_percent = consistency_percent(fixed_stretches(trace, taught.places.start_from_place));
  score.blind_distances_m = blind_distances(trace, taught.places.site_from_place);
  score.blind_m = *std::max_element(score.blind_distances_m.begin(), score.blind_distances_m.end());
  const PathErrors path = path_errors(off_path(trace, TaughtPath(taught.traces.front())));
  score.lateral_rmse_mm = 1e3 * path.lateral_rmse_m;
  score.lateral_worst_mm = 1e3 * path.lateral_worst_m;
  score.heading_rms_deg = kDegreesARad * path.heading_rms_rad;
  const Pose2 goal_from_robot =
      taught.places.site_from_place.at(taught.last).inverse() * trace.moments.back().site_from_robot;
  score.goal_mm = 1e3 * std::hypot(goal_from_robot.x, goal_from_robot.y);
  score.goal_deg = kDegreesARad * std::abs(goal_from_robot.heading);
  score.fixes = fixes(trace);
  add_held(trace, score);
  score.wrong_fixes = wrong_fixes(trace, taught.places.site_from_place);
  score.refusals = trace.refusals;
  return score;
}

}  // namespace weft::evaluate::floor

#include "clients/evaluate/topometric/bounds.hpp"

namespace weft::evaluate::topometric {

const std::vector<Bound>& bounds() {
  using enum Bound::Sense;
  constexpr double open = Score::kNothing;
  // clang-format off
  static const std::vector<Bound> all = {
      {"O1", "open odometry, mean error", "m", "< 2.5", trial::kDeliveries, "open_m", at_most, 1.0, 2.5, 2},
      {"O2", "raw odometry, times open", "", "7", trial::kDeliveries, "raw_times_open", at_least, 5.0, 3.0, 1},
      {"O3", "blind samples", "%", "", trial::kDeliveries, "blind_percent", between, 3.0, 15.0, 1},
      {"O3", "steps called seen and off", "%", "", trial::kDeliveries, "wrong_seen_percent", at_most, 0.1, 0.3, 2},
      {"O3", "fixes from covered or dark views", "", "", trial::kDeliveries, "fixes_hidden", at_most, 0.0, 0.0, 0},
      {"O3", "places kept from covered or dark views", "", "", trial::kMap, "kept_hidden", at_most, 0.0, 0.0, 0},
      {"O3", "edges over blind ways that do not say so", "", "", trial::kMap, "unmarked_blind", at_most, 0.0, 0.0, 0},
      {"Z1", "dense depth off by > 1 px, level11", "%", "", trial::kDepth, "dense_wrong_percent", at_most, 5.0, 7.0, 1},
      {"Z1", "dense depth, hall: density", "%", "", trial::kDepth, "hall_dense_percent", at_least, 85.0, 80.0, 1},
      {"L1", "located: mean error", "m", "", trial::kDeliveries, "located_mean_m", at_most, 0.05, 0.08, 3},
      {"L1", "located: 95 % of errors", "m", "", trial::kDeliveries, "located_p95_m", at_most, 0.12, 0.20, 3},
      {"L1", "located: 95 % of headings", "deg", "", trial::kDeliveries, "located_p95_deg", at_most, 1.5, 3.0, 2},
      {"L1", "another robot's map: mean error", "m", "", trial::kOtherRobot, "located_mean_m", at_most, 0.05, 0.08, 3},
      {"L1", "another robot's map: 95 % of errors", "m", "", trial::kOtherRobot, "located_p95_m", at_most, 0.12, 0.20, 3},
      {"L3", "another robot's map: 95 % region holds", "%", "", trial::kOtherRobot, "held_fixes_percent", at_least, 85.0, 75.0, 1},
      {"L2", "jump at a change of charts, median", "m", "", trial::kDeliveries, "jump_median_m", at_most, 0.03, open, 3},
      {"L2", "jump at a change of charts, largest", "m", "", trial::kDeliveries, "jump_largest_m", at_most, 0.08, 0.08, 3},
      {"L2", "stands at a change of charts", "s", "each time", trial::kDeliveries, "switch_stands_s", at_most, 0.0, 1.0, 2},
      {"L3", "fixes whose 95 % region holds, at most", "%", "", trial::kDeliveries, "held_fixes_percent", at_most, 99.0, 100.0, 1},
      {"L3", "fixes whose 95 % region holds, at least", "%", "", trial::kDeliveries, "held_fixes_percent", at_least, 85.0, 75.0, 1},
      {"G1", "grid: precision of occupied", "%", "drawn", trial::kMap, "grid_precision_percent", at_least, 90.0, 82.0, 1},
      {"G1", "grid: recall of occupied", "%", "drawn", trial::kMap, "grid_recall_percent", at_least, 85.0, 75.0, 1},
      {"G2", "walls of two runs: thickness registered, of guessed", "", "drawn", trial::kMap, "wall_ratio", at_most, 0.7, 0.999, 2},
      {"E1", "edges: across, registered of before", "", "", trial::kMap, "across_ratio", at_most, 0.8, 1.0, 2},
      {"E1", "edges: along, registered of before", "", "", trial::kMap, "along_ratio", at_most, 1.05, 1.1, 2},
      {"E1", "edges that grew by > 1 cm", "%", "", trial::kMap, "grew_percent", at_most, 3.0, 6.0, 1},
      {"E1", "stitches between runs", "m", "", trial::kMap, "stitch_m", at_most, 0.04, 0.08, 3},
      {"E1", "stitches between runs", "deg", "", trial::kMap, "stitch_deg", at_most, 0.5, 1.0, 2},
      {"D1", "goals reached", "%", "all", trial::kDeliveries, "reached_percent", at_least, 100.0, 100.0, 0},
      {"D1", "mean speed", "m/s", "0.09", trial::kDeliveries, "mean_speed_m_s", at_least, 0.30, 0.25, 2},
      {"D1", "goal, median of deliveries", "m", "", trial::kDeliveries, "goal_median_m", at_most, 0.08, open, 3},
      {"D1", "goal, farthest of deliveries", "m", "", trial::kDeliveries, "goal_largest_m", at_most, 0.15, 0.15, 3},
      {"D1", "goal heading, median of deliveries", "deg", "", trial::kDeliveries, "goal_median_deg", at_most, 3.0, open, 1},
      {"D1", "goal heading, largest of deliveries", "deg", "", trial::kDeliveries, "goal_largest_deg", at_most, 5.0, 5.0, 1},
      {"D1", "routes blocked where nothing stands", "", "", trial::kDeliveries, "blocked", at_most, 0.0, 0.0, 0},
      {"S1", "shortcut: driven, of the way taught", "", "drawn", trial::kShortcut, "driven_share", at_most, 0.75, 0.85, 2},
      {"S2", "one way: return reached", "%", "1 trip", trial::kOneWay, "back_reached", at_least, 100.0, 100.0, 0},
      {"S2", "one way: return, 95 % of errors", "m", "", trial::kOneWay, "back_located_p95_m", at_most, 0.20, 0.35, 3},
      {"B1", "obstacles: contacts", "", "", trial::kObstacles, "contacts", at_most, 0.0, 0.0, 0},
      {"B1", "obstacles: least clearance", "m", "", trial::kObstacles, "clearance_m", at_least, 0.10, 0.05, 3},
      {"B1", "obstacles: goals reached", "%", "1 person", trial::kObstacles, "reached_percent", mean_at_least, 80.0, open, 0},
      {"B1", "blocked: said, from 1.5 m on", "s", "", trial::kBlocked, "told_s", at_most, 40.0, 60.0, 1},
      {"B1", "blocked: other way taken", "", "", trial::kBlocked, "went_round", at_least, 1.0, 1.0, 0},
      {"B1", "blocked: contacts", "", "", trial::kBlocked, "contacts", at_most, 0.0, 0.0, 0},
      {"K1", "put down: found within 40 s", "%", "", trial::kKidnapped, "found_percent", at_least, 90.0, open, 0},
      {"K1", "put down: found within 40 s, of all", "%", "", trial::kKidnapped, "found_percent", mean_at_least, 83.0, open, 0},
      {"K1", "put down: wrong", "", "", trial::kKidnapped, "wrong", at_most, 0.0, 0.0, 0},
      {"M1", "merge: joined", "", "", trial::kMerge, "joined", at_least, 1.0, 1.0, 0},
      {"M1", "merge: wrong stitches", "", "", trial::kMerge, "wrong", at_most, 0.0, 0.0, 0},
      {"M1", "aisles that look alike: wrong stitches", "", "", trial::kAliasing, "wrong", at_most, 0.0, 0.0, 0},
      {"P1", "processor time a view, median", "ms", "", trial::kDeliveries, "median_ms", at_most, 18.0, 25.0, 1},
      {"P1", "processor time a view, 99 %", "ms", "", trial::kDeliveries, "p99_ms", at_most, 60.0, 80.0, 1},
      {"D1", "half an hour without help: goals reached", "%", "all", trial::kNight, "reached_percent", at_least, 100.0, 100.0, 0},
      {"D1", "half an hour without help: minutes", "min", "30", trial::kNight, "minutes", at_least, 30.0, 30.0, 1},
  };
  // clang-format on
  return all;
}

}  // namespace weft::evaluate::topometric

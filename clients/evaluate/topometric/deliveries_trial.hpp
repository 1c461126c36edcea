#pragma once
#include <optional>
#include <vector>

#include "clients/evaluate/topometric/delivery.hpp"
#include "clients/evaluate/topometric/scenes.hpp"
#include "clients/evaluate/topometric/score.hpp"

namespace weft::evaluate::topometric {

/// Says how long a robot delivers.
struct DeliveryPlan {
  double most_m = 156.0;  ///< by odometry; the goal under way then is the last
  double most_s = 1e9;    ///< of the body's time, likewise
  std::size_t blackouts = 6;
  double blackouts_to_s = 400.0;
  std::vector<PlaceId> goals;  ///< in turn; empty: what the site's stations are nearest to
};

/// Sends r1 to the goals in turn on the day after it was taught level11. It is told at which place it was switched
/// on, and nothing afterwards. None: stopped.
Result<std::optional<Measured>> measure_deliveries(const agents::sim::Site& site, const Driven& driven,
                                                   const Taught& taught, const DeliveryPlan& plan);

/// Adds what drives to goals have come to: reached_percent, mean_speed_m_s, goal_median_m, goal_largest_m,
/// goal_median_deg, goal_largest_deg (of goals that were reached), blocked.
void add_deliveries(const std::vector<Delivery>& deliveries, const Moments& moments, const Taught& taught,
                    Score& score);

/// Adds how well it knew where it was: located_mean_m, located_p95_m, located_p95_deg, switches, jump_m,
/// switch_stands_s, held_fixes_percent, fix_nees, fixes.
void add_located(const Moments& moments, const TruePlaces& places, Score& score);

/// Adds what navigating has cost: median_ms, p99_ms, of samples with a view.
void add_processor(const Moments& moments, Score& score);

}  // namespace weft::evaluate::topometric

#pragma once
// Private to config.cpp.
#include <numbers>

#include "agents/methods/topometric/config.hpp"
#include "agents/perception/out_of_bounds.hpp"

namespace weft::agents {

/// Lists the settings of charts, of what is believed in them and of driving there (see each_setting.hpp).
template <class Config, class Section>
void each_map_setting(Config& config, const Section& section) {
  const auto chart = section("chart");
  chart("side_m", config.chart.side_m, Low::closed, 4, 40);
  chart("cell_m", config.chart.cell_m, Low::closed, 0.02, 0.25);
  chart("within_m", config.chart.within_m, Low::open, 0, 20);
  chart("apart_m", config.chart.apart_m, Low::closed, 0, 5);
  chart("apart_rad", config.chart.apart_rad, Low::closed, 0, std::numbers::pi);
  chart("most_clouds", config.chart.most_clouds, Low::closed, 1, 200);
  chart("seen_within_m", config.chart.seen_within_m, Low::open, 0, 100);
  chart("tau", config.chart.tau, Low::open, 0, 1);
  chart("behind_m", config.chart.behind_m, Low::closed, 0, 1);
  chart("driven_m", config.chart.driven_m, Low::closed, 0, 1);
  const auto belief = section("belief");
  belief("least_sigma_m", config.belief.least_sigma_m, Low::open, 0, 1);
  belief("least_sigma_rad", config.belief.least_sigma_rad, Low::open, 0, 1);
  belief("particles", config.belief.particles, Low::closed, 10, 100000);
  belief("sure_seed_m", config.belief.sure_seed_m, Low::open, 0, 5);
  belief("most_sigma_m", config.belief.most_sigma_m, Low::open, 0, 5);
  belief("most_sigma_rad", config.belief.most_sigma_rad, Low::open, 0, 1);
  belief("least_share", config.belief.least_share, Low::closed, 0, 1);
  belief("least_likelihood", config.belief.least_likelihood, Low::closed, 0, 1);
  belief("least_known", config.belief.least_known, Low::closed, 0, 1);
  belief("sure_features", config.belief.sure_features, Low::closed, 3, 300);
  belief("fits_after_doubt", config.belief.fits_after_doubt, Low::closed, 0, 100);
  belief("map_sigma_m", config.belief.map_sigma_m, Low::closed, 0, 0.5);
  belief("map_sigma_rad", config.belief.map_sigma_rad, Low::closed, 0, 0.5);
  belief("drift_m", config.belief.drift_m, Low::closed, 0, 0.2);
  belief("drift_rad", config.belief.drift_rad, Low::closed, 0, 0.2);
  belief("overruled_sigmas", config.belief.overruled_sigmas, Low::open, 0, 20);
  belief("uses_features", config.belief.uses_features, Low::closed, 0, 1);
  belief("feature_reach_m", config.belief.feature_reach_m, Low::open, 0, 10);
  belief("feature_turn_rad", config.belief.feature_turn_rad, Low::open, 0, std::numbers::pi);
  belief("looks_alike", config.belief.looks_alike, Low::closed, 1, 100);
  const auto steer = section("steer");
  steer("around_m", config.steer.around_m, Low::closed, 3, 40);
  steer("turn_first_rad", config.steer.turn_first_rad, Low::open, 0, 3);
  steer("turned_rad", config.steer.turned_rad, Low::open, 0, 3);
  steer("precise_m", config.steer.precise_m, Low::open, 0, 0.1);
  steer("precise_from_m", config.steer.precise_from_m, Low::open, 0, 2);
  steer("gain_1_s", config.steer.gain_1_s, Low::open, 0, 5);
  steer("slowest_m_s", config.steer.slowest_m_s, Low::open, 0, 0.5);
  steer("most_unseen_m", config.steer.most_unseen_m, Low::open, 0, 20);
  const auto plan = section("plan");
  plan("pending_m", config.plan.pending_m, Low::open, 0, 10);
  plan("pending_m_s", config.plan.pending_m_s, Low::open, 0, 2);
  plan("no_plan_s", config.plan.no_plan_s, Low::open, 0, 60);
  plan("recover_turns", config.plan.recover_turns, Low::closed, 0, 5);
  plan("recover_rad_s", config.plan.recover_rad_s, Low::open, 0, 3);
}

}  // namespace weft::agents

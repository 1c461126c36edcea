#pragma once
// Private to config.cpp.
#include <numbers>

#include "agents/methods/topometric/config.hpp"
#include "agents/methods/topometric/each_map_setting.hpp"
#include "agents/perception/out_of_bounds.hpp"

/// Lists the settings once, for whoever checks or reads them: `section("a.b")` returns the `in` of the table b in the
/// table a, and `in(name, value, Low, low, high)` is called for each of its settings.
namespace weft::agents {

template <class Config, class Section>
void each_odometry_setting(Config& open, const Section& section) {
  const auto seeing = section("odometry");
  seeing("corners", open.seeing.corners, Low::closed, 40, 2000);
  seeing("window_px", open.seeing.window_px, Low::closed, 7, 31);
  seeing("pyramid_levels", open.seeing.pyramid_levels, Low::closed, 1, 5);
  seeing("nearest_m", open.seeing.nearest_m, Low::closed, 0.05, 10);
  seeing("fewest_inliers", open.seeing.fewest_inliers, Low::closed, 6, 1000);
  seeing("fewest_inliers_share", open.seeing.fewest_inliers_share, Low::closed, 0, 1);
  seeing("least_spread", open.seeing.least_spread, Low::closed, 0, 0.3);
  seeing("most_residual_px", open.seeing.most_residual_px, Low::closed, 0.1, 10);
  seeing("keyframe_share", open.seeing.keyframe_share, Low::closed, 0.1, 0.95);
  seeing("keyframe_rad", open.seeing.keyframe_rad, Low::closed, 0.01, 2);
  seeing("keyframe_nearer", open.seeing.keyframe_nearer, Low::closed, 0.01, 1);
  seeing("patience", open.seeing.patience, Low::closed, 0, 100);
  const auto blind = section("odometry.blind");
  blind("command_distance_share", open.blind.command_distance_share, Low::open, 0, 1);
  blind("command_heading_share", open.blind.command_heading_share, Low::open, 0, 1);
  const auto gate = section("odometry.gate");
  gate("share", open.gate.share, Low::open, 0, 2);
  gate("metres", open.gate.metres, Low::open, 0, 1);
  gate("radians", open.gate.radians, Low::open, 0, 1);
  gate("command_factor", open.gate.command_factor, Low::closed, 1, 20);
}

template <class Config, class Section>
void each_sight_setting(Config& config, const Section& section) {
  const auto disparity = section("disparity");
  disparity("disparities", config.disparity.disparities, Low::closed, 16, 128);
  disparity("small_penalty", config.disparity.small_penalty, Low::closed, 1, 39);
  disparity("large_penalty", config.disparity.large_penalty, Low::closed, 1, 39);
  disparity("uniqueness", config.disparity.uniqueness, Low::closed, 0, 0.5);
  disparity("least_texture", config.disparity.least_texture, Low::closed, 0, 200);
  disparity("least_patch_px", config.disparity.least_patch_px, Low::closed, 0, 100000);
  disparity("patch_step_px", config.disparity.patch_step_px, Low::closed, 0, 16);
  disparity("least_light", config.disparity.least_light, Low::closed, 0, 255);
  disparity("least_likeness", config.disparity.least_likeness, Low::closed, 0, 1);
  disparity("least_matched", config.disparity.least_matched, Low::closed, 0, 1);
  const auto sight = section("sight");
  sight("disparity_sigma_px", config.sight.disparity_sigma_px, Low::open, 0, 5);
  sight("range_m", config.sight.range_m, Low::open, 0, 20);
  sight("most_depth_sigma_m", config.sight.most_depth_sigma_m, Low::open, 0, 2);
  sight("every_px", config.sight.every_px, Low::closed, 1, 8);
  sight("highest_m", config.sight.highest_m, Low::open, 0.2, 10);
  sight("floor_within_m", config.sight.floor_within_m, Low::open, 0, 0.5);
  sight("fewest_floor_points", config.sight.fewest_floor_points, Low::closed, 10, 100000);
  sight("most_floor_tilt_rad", config.sight.most_floor_tilt_rad, Low::open, 0, 0.5);
  const auto scan = section("scan");
  scan("slice_from_m", config.scan.slice_from_m, Low::open, 0, 1);
  scan("body_height_m", config.scan.body_height_m, Low::open, 0, 5);
  scan("bin_rad", config.scan.bin_rad, Low::open, 0, 0.2);
  scan("rank", config.scan.rank, Low::closed, 1, 20);
  scan("range_m", config.scan.range_m, Low::open, 0, 100);
  scan("past_m", config.scan.past_m, Low::closed, 0, 100);
  scan("floor_m", config.scan.floor_m, Low::open, 0, 1);
  scan("floor_from_m", config.scan.floor_from_m, Low::open, 0, 5);
  scan("floor_gap_m", config.scan.floor_gap_m, Low::open, 0, 2);
  scan("edge_sigma_m", config.scan.edge_sigma_m, Low::open, 0, 2);
  scan("edge_step_m", config.scan.edge_step_m, Low::open, 0, 2);
}

template <class Config, class Section>
void each_place_setting(Config& config, const Section& section) {
  const auto window = section("window");
  window("frames", config.window.frames, Low::closed, 2, 32);
  window("spacing_m", config.window.spacing_m, Low::open, 0, 2);
  window("spacing_rad", config.window.spacing_rad, Low::open, 0, 1.5);
  window("voxel_m", config.window.voxel_m, Low::closed, 0.01, 0.5);
  window("least_frames", config.window.least_frames, Low::closed, 1, 32);
  window("most_blind_m", config.window.most_blind_m, Low::closed, 0, 10);
  const auto place = section("place");
  place("most_points", config.place.most_points, Low::closed, 100, 60000);
  place("fewest_points", config.place.fewest_points, Low::closed, 1, 60000);
  place("corners", config.place.corners, Low::closed, 50, 5000);
  place("features", config.place.features, Low::closed, 20, 300);
  place("fewest_features", config.place.fewest_features, Low::closed, 3, 300);
  place("corner_sigma_px", config.place.corner_sigma_px, Low::open, 0, 5);
  place("feature_range_m", config.place.feature_range_m, Low::open, 0, 100);
  place("feature_sigma_m", config.place.feature_sigma_m, Low::open, 0, 5);
  place("cell_m", config.place.cell_m, Low::closed, 0.01, 0.5);
}

template <class Config, class Section>
void each_relate_setting(Config& config, const Section& section) {
  const auto relate = section("relate");
  relate("most_bits", config.relate.most_bits, Low::closed, 10, 128);
  relate("ratio", config.relate.ratio, Low::open, 0, 1);
  relate("ratio_guided", config.relate.ratio_guided, Low::open, 0, 1);
  relate("fewest_matches", config.relate.fewest_matches, Low::closed, 4, 300);
  relate("hypotheses", config.relate.hypotheses, Low::closed, 50, 20000);
  relate("inlier_sigmas", config.relate.inlier_sigmas, Low::closed, 1, 10);
  relate("feature_sigma_m", config.relate.feature_sigma_m, Low::open, 0, 0.5);
  relate("fewest_inliers", config.relate.fewest_inliers, Low::closed, 4, 300);
  relate("fewest_inliers_share", config.relate.fewest_inliers_share, Low::closed, 0, 1);
  relate("fewest_guided", config.relate.fewest_guided, Low::closed, 4, 300);
  relate("inflation", config.relate.inflation, Low::closed, 1, 100);
  relate("gate_sigmas", config.relate.gate_sigmas, Low::closed, 1, 10);
  relate("gate_m", config.relate.gate_m, Low::open, 0, 2);
  relate("gate_rad", config.relate.gate_rad, Low::open, 0, 1);
  relate("most_sigma_m", config.relate.most_sigma_m, Low::open, 0, 1);
  relate("most_heading_rad", config.relate.most_heading_rad, Low::open, 0, 3.2);
  relate("most_through", config.relate.most_through, Low::closed, 0, 1);
  relate("fewest_standing", config.relate.fewest_standing, Low::closed, 10, 60000);
  relate("opinion_m", config.relate.opinion_m, Low::open, 0, 1);
  relate("opinion_rad", config.relate.opinion_rad, Low::open, 0, 1);
  relate("opinion_cell_m", config.relate.opinion_cell_m, Low::closed, 0.1, 2);
  relate("level_sigma_m", config.relate.level_sigma_m, Low::open, 0, 0.5);
  relate("level_sigma_rad", config.relate.level_sigma_rad, Low::open, 0, 0.2);
  relate("unseen_sigma_m", config.relate.unseen_sigma_m, Low::open, 0, 1);
  relate("unseen_sigma_rad", config.relate.unseen_sigma_rad, Low::open, 0, 0.5);
  const auto ndt = section("ndt");
  ndt("most_steps", config.ndt.most_steps, Low::closed, 1, 100);
  ndt("inflation", config.ndt.inflation, Low::closed, 0.01, 1000);
  ndt("least_overlap", config.ndt.least_overlap, Low::closed, 0, 1);
  ndt("least_matched", config.ndt.least_matched, Low::closed, 6, 10000);
  ndt("slides_m", config.ndt.slides_m, Low::open, 0, 1);
  ndt("prior_gate", config.ndt.prior_gate, Low::open, 0, 1000);
  const auto cells = section("ndt.cells");
  cells("finest_m", config.ndt.cells.finest_m, Low::closed, 0.05, 2);
  cells("levels", config.ndt.cells.levels, Low::closed, 1, 5);
  cells("least_points", config.ndt.cells.least_points, Low::closed, 3, 100);
  cells("least_sigma_m", config.ndt.cells.least_sigma_m, Low::open, 0, 0.5);
  cells("thickest", config.ndt.cells.thickest, Low::open, 0, 10);
  cells("tilt_share", config.ndt.cells.tilt_share, Low::closed, 0, 10);
  const auto cost = section("ndt.cost");
  cost("weight", config.ndt.cost.weight, Low::open, 0, 10);
  cost("softness", config.ndt.cost.softness, Low::open, 0, 10);
}

template <class Config, class Section>
void each_filter_setting(Config& filter, const Section& section) {
  const auto own = section("filter");
  own("update_m", filter.update_m, Low::closed, 0, 10);
  own("update_rad", filter.update_rad, Low::closed, 0, std::numbers::pi);
  own("resample_below", filter.resample_below, Low::open, 0, 1);
  const auto blur = section("filter.blur");
  blur("least_effective", filter.blur.least_effective, Low::closed, 0, 0.99);
  blur("most", filter.blur.most, Low::closed, 0, 6);
  blur("seeking", filter.blur.seeking, Low::closed, 0, 6);
  blur("steps", filter.blur.steps, Low::closed, 0, 50);
  const auto kld = section("filter.kld");
  kld("epsilon", filter.kld.epsilon, Low::open, 0, 1);
  kld("z", filter.kld.z, Low::open, 0, 5);
  kld("cell_m", filter.kld.cell_m, Low::open, 0, 5);
  kld("cell_rad", filter.kld.cell_rad, Low::open, 0, std::numbers::pi);
  kld("most", filter.kld.most, Low::closed, 10, 1e6);
  kld("least", filter.kld.least, Low::closed, 10, 1e6);
  const auto likelihood = section("filter.likelihood");
  likelihood("hit_share", filter.likelihood.hit_share, Low::open, 0, 0.9999);
  likelihood("beams", filter.likelihood.beams, Low::closed, 1, 1000);
  likelihood("worth_beams", filter.likelihood.worth_beams, Low::open, 0, 1000);
  likelihood("most_m", filter.likelihood.most_m, Low::open, 0, 10);
  likelihood("edge_share", filter.likelihood.edge_share, Low::open, 0, 0.9999);
  likelihood("neutral", filter.likelihood.neutral, Low::closed, 0, 1);
  const auto recovery = section("filter.recovery");
  recovery("slow", filter.recovery.slow, Low::open, 0, 1);
  recovery("fast", filter.recovery.fast, Low::open, 0, 1);
  recovery("patience", filter.recovery.patience, Low::closed, 1, 10);
}

template <class Config, class Section>
void each_driving_setting(Config& config, const Section& section) {
  const auto rays = section("rays");
  rays("n_min", config.rays.n_min, Low::closed, 1, 1000);
  rays("tau", config.rays.tau, Low::open, 0, 1);
  rays("range_m", config.rays.range_m, Low::open, 0, 100);
  rays("floor_m", config.rays.floor_m, Low::open, 0, 0.5);
  rays("body_height_m", config.rays.body_height_m, Low::open, 0, 5);
  rays("above_m", config.rays.above_m, Low::closed, 0, 2);
  const auto costmap = section("costmap");
  costmap("side_m", config.costmap.side_m, Low::closed, 1, 20);
  costmap("cell_m", config.costmap.cell_m, Low::closed, 0.02, 0.25);
  costmap("memory_s", config.costmap.memory_s, Low::open, 0, 600);
  costmap("near_m", config.costmap.near_m, Low::closed, 0, 3);
  costmap("near_s", config.costmap.near_s, Low::open, 0, 600);
  costmap("footprint_m", config.costmap.footprint_m, Low::open, 0, 2);
  const auto local = section("local");
  local("footprint_m", config.local.footprint_m, Low::open, 0, 2);
  local("carrot_m", config.local.carrot_m, Low::open, 0, 3);
  local("at_goal_m", config.local.at_goal_m, Low::open, 0, 1);
  local("turn_first_rad", config.local.turn_first_rad, Low::open, 0, 3);
  const auto path = section("local.path");
  path("comfort_m", config.local.path.comfort_m, Low::closed, 0, 2);
  path("cost_of_narrow", config.local.path.cost_of_narrow, Low::closed, 0, 20);
  path("goal_within_m", config.local.path.goal_within_m, Low::closed, 0, 2);
  const auto arcs = section("local.arcs");
  arcs("fastest_m_s", config.local.arcs.fastest_m_s, Low::open, 0, 3);
  arcs("acceleration_m_s2", config.local.arcs.acceleration_m_s2, Low::open, 0, 3);
  arcs("deceleration_m_s2", config.local.arcs.deceleration_m_s2, Low::open, 0, 3);
  arcs("fastest_rad_s", config.local.arcs.fastest_rad_s, Low::open, 0, 5);
  arcs("acceleration_rad_s2", config.local.arcs.acceleration_rad_s2, Low::open, 0, 10);
  arcs("delay_s", config.local.arcs.delay_s, Low::closed, 0, 1);
  arcs("margin_m", config.local.arcs.margin_m, Low::closed, 0, 1);
  arcs("period_s", config.local.arcs.period_s, Low::open, 0, 1);
  arcs("horizon_s", config.local.arcs.horizon_s, Low::open, 0, 5);
  arcs("speeds", config.local.arcs.speeds, Low::closed, 2, 100);
  arcs("turns", config.local.arcs.turns, Low::closed, 3, 101);
  arcs("cost_of_heading_m", config.local.arcs.cost_of_heading_m, Low::closed, 0, 5);
  arcs("comfort_m", config.local.arcs.comfort_m, Low::closed, 0, 1);
  arcs("cost_of_narrow", config.local.arcs.cost_of_narrow, Low::closed, 0, 10);
}

template <class Config, class Section>
void each_topometric_setting(Config& config, const Section& section) {
  each_odometry_setting(config.open, section);
  each_sight_setting(config, section);
  each_place_setting(config, section);
  each_relate_setting(config, section);
  each_filter_setting(config.filter, section);
  each_driving_setting(config, section);
  each_map_setting(config, section);
}

}  // namespace weft::agents

#pragma once
#include <string>
#include <vector>

#include "agents/control/grid/costmap.hpp"
#include "agents/control/grid/local_plan.hpp"
#include "agents/control/grid/ray_cast.hpp"
#include "agents/methods/open_odometry.hpp"
#include "agents/methods/topometric/belief.hpp"
#include "agents/methods/topometric/chart.hpp"
#include "agents/methods/topometric/plan.hpp"
#include "agents/methods/topometric/steer_config.hpp"
#include "agents/perception/clouds/cloud_window.hpp"
#include "agents/perception/clouds/ndt.hpp"
#include "agents/perception/particles/particle_filter.hpp"
#include "agents/perception/pseudo_scan.hpp"
#include "agents/perception/stereo/disparity.hpp"
#include "core/config/config.hpp"

namespace weft::agents {

/// Bounds what of a pair's depths is used.
struct SightConfig {
  double disparity_sigma_px = 0.3;   ///< (0, 5] of dense matching
  double range_m = 5.0;              ///< (0, 20] what is farther is not used,
  double most_depth_sigma_m = 0.2;   ///< (0, 2] nor what is less certain along its ray
  int every_px = 2;                  ///< [1, 8] of the rows and columns, the first of so many becomes a point
  double highest_m = 2.2;            ///< (0.2, 10] above the floor; what is higher is not stored
  double floor_within_m = 0.1;       ///< (0, 0.5] of where the floor was last, for a point to count as floor
  int fewest_floor_points = 150;     ///< [10, 100000] that show the floor in one view
  double most_floor_tilt_rad = 0.1;  ///< (0, 0.5] between what a mount says and a floor
};

/// Bounds what a place must show, and how much of it is stored.
struct PlaceConfig {
  int most_points = 16000;        ///< [100, 60000] stored: those that were seen from nearest
  int fewest_points = 400;        ///< [1, 60000] a place with fewer, and with too few features, is too_blank
  int corners = 500;              ///< [50, 5000] looked for in a view
  int features = 300;             ///< [20, 300] stored, the strongest of each part of the view
  int fewest_features = 25;       ///< [3, 300]
  double corner_sigma_px = 0.3;   ///< (0, 5] of a corner's disparity
  double feature_range_m = 16.0;  ///< (0, 100] of features
  double feature_sigma_m = 1.5;   ///< (0, 5] of features along their rays, at most
  double cell_m = 0.08;           ///< [0.01, 0.5] of a descriptor's cell, in space; it sees 4 x 4
};

/// Bounds when two places are taken for related.
struct RelateConfig {
  int most_bits = 90;                 ///< [10, 128] of 256 that may differ between descriptors of one point
  double ratio = 1.0;                 ///< (0, 1] best against second best, without a guess
  double ratio_guided = 1.0;          ///< (0, 1]
  int fewest_matches = 40;            ///< [4, 300] without a guess
  int hypotheses = 600;               ///< [50, 20000] drawn
  double inlier_sigmas = 3.0;         ///< [1, 10]
  double feature_sigma_m = 0.02;      ///< (0, 0.5] of a feature in each direction, beside that of its depth
  int fewest_inliers = 25;            ///< [4, 300] without a guess
  double fewest_inliers_share = 0.3;  ///< [0, 1] of the matches, without a guess
  int fewest_guided = 12;             ///< [4, 300] inliers with a guess
  double inflation = 2.0;             ///< [1, 100] of the features' covariance
  double gate_sigmas = 4.0;           ///< [1, 10] what is seen may be off a guess
  double gate_m = 0.1;                ///< (0, 2] at least
  double gate_rad = 0.05;             ///< (0, 1] at least
  double most_sigma_m = 0.1;          ///< (0, 1] of a relation's position: beyond it, it slides
  double most_heading_rad = 1.7;      ///< (0, 3.2] without a guess: corners look alike from one side alone
  double most_through = 0.05;         ///< [0, 1] of the points of each in cells that rays of the other passed
  int fewest_standing = 200;          ///< [10, 60000] points above the floor for a second opinion
  double opinion_m = 0.1;             ///< (0, 1] from the second opinion
  double opinion_rad = 0.05;          ///< (0, 1]
  double opinion_cell_m = 0.5;        ///< [0.1, 2] its cells
  double level_sigma_m = 0.015;       ///< (0, 0.5] heights of two floors that were seen
  double level_sigma_rad = 0.006;     ///< (0, 0.2] their tilts
  double unseen_sigma_m = 0.1;        ///< (0, 1] the same where a floor was not seen
  double unseen_sigma_rad = 0.05;     ///< (0, 0.5]
};

/// Returns a filter of more particles than others need: 300 lose half their spread along a bare corridor, in 4 m, by
/// being drawn again and again. A scan counts for little: one after the other they end where a floor's texture fades
/// and where the map's walls are thick, and err alike.
inline ParticleFilterConfig topometric_filter() {
  ParticleFilterConfig filter;
  filter.kld.least = 1000;
  filter.likelihood.worth_beams = 1.0;
  return filter;
}

/// Returns a plan with room to spare beside the body: depth, belief and steering are each off by a few centimetres.
inline LocalPlanConfig topometric_local_plan() {
  LocalPlanConfig config;
  config.footprint_m = 0.40;
  return config;
}

/// Holds the settings of the method `topometric`. Each bound stands beside its number; `check` enforces it.
struct TopometricConfig {
  OpenOdometryConfig open{};  ///< table "odometry", with tables "blind" and "gate"
  DisparityConfig disparity{};
  SightConfig sight{};
  CloudWindowConfig window{};
  PseudoScanConfig scan{};  ///< its field of view and its sigma follow from the pair
  PlaceConfig place{};
  RelateConfig relate{};
  NdtConfig ndt{};  ///< with tables "cells" and "cost"
  RayCastConfig rays{};
  TopometricChartConfig chart{};
  ParticleFilterConfig filter = topometric_filter();  ///< with tables "blur", "kld", "likelihood", "recovery"
  TopometricBeliefConfig belief{};
  CostmapConfig costmap{};
  LocalPlanConfig local = topometric_local_plan();  ///< with tables "path" and "arcs"
  TopometricSteerConfig steer{};
  PlanConfig plan{};
};

/// Returns every setting that breaks its bound: name, value, bound. Empty when all is well.
std::vector<std::string> check(const TopometricConfig& config);

/// Reads the settings from a TOML table: a table for each part, keys as they are named here; reports what is wrong
/// into its document.
TopometricConfig read_topometric_config(const config::Table& table);

}  // namespace weft::agents

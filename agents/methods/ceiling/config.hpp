#pragma once
#include <string>
#include <vector>

#include "agents/methods/dead_reckoning.hpp"
#include "agents/perception/corner_tracks.hpp"
#include "core/camera/camera_file.hpp"
#include "core/config/config.hpp"

namespace weft::agents {

/// Holds the settings of the method `ceiling`. Each bound stands beside its number; `check` enforces it.
struct CeilingConfig {
  // Scale: where the ceiling is
  double height_m = 0.0;         ///< 0 or [1, 40]: of the ceiling above the floor; 0: wheels are to tell
  double height_sigma_m = 0.05;  ///< [0.001, 2] of what is stated
  double wheels_scale = 0.03;    ///< [0.001, 0.2] 1 sigma of the wheels' scale, a share
  double wheels_way_m = 5.0;     ///< [1, 100] driven until wheels have told the height

  // Odometry
  CornerDetector detector = CornerDetector::harris;  ///< "harris" (Lucas et al., II.B) or "fast"
  int corners = 200;                                 ///< [40, 1000] followed from each keyframe
  int window_px = 13;                                ///< odd, [7, 31]: of the tracker
  int pyramid_levels = 2;                            ///< [0, 5]
  int fewest_tracks = 12;                            ///< [8, 500] consistent ones; fewer is blind
  double fewest_tracks_share = 0.35;                 ///< [0, 1] of those that were found
  double inlier_px = 1.5;                            ///< [0.2, 10]
  double track_sigma_px = 0.15;   ///< [0.01, 2] noise of a track; larger residuals enlarge the covariance
  double grey_noise = 2.0;        ///< [0, 30] grey levels: of the camera's pixels, standard deviation
  double off_axis_rad = 1.2;      ///< [0.3, 1.5] of corners: how far out the lens is known well
  double off_vertical_rad = 1.2;  ///< [0.3, 1.5] of corners: lower ones tell of other things than a ceiling
  double keyframe_heights = 0.1;  ///< [0.01, 1] travelled until the next keyframe, in heights of the ceiling
  double keyframe_rad = 0.25;     ///< [0.01, 1] turned
  double keyframe_share = 0.5;    ///< [0.1, 0.95] of the keyframe's corners still tracked

  // Lamps
  int lamp_grey = 250;      ///< [128, 255] from there on a pixel is a lamp's
  int lamp_rim_px = 3;      ///< [1, 20] a corner so near to a lamp's rim is the rim's
  int lamp_bloom_px = 9;    ///< [1, 60] so far out a lamp's light spreads over what is beside it
  double mid_grey = 110.0;  ///< [30, 220] what is no lamp is exposed to

  // Heights
  double height_from_m = 0.15;     ///< [0.05, 2] of travel before heights are estimated
  double hangs_sigma_m = 0.8;      ///< [0.05, 5] how far things hang below the ceiling, mostly
  double flat_sigma_m = 0.02;      ///< [0.001, 0.5] how even the ceiling itself is
  double least_above_m = 0.3;      ///< [0.05, 5] above the camera; what is lower is no part of a ceiling
  double heights_tilt_rad = 0.01;  ///< [1e-4, 0.1] sigma of the mount's tilt from which on heights are believed

  // Mount and its vibration
  double vibration_tilt_rad = 0.0009;  ///< [1e-6, 0.05] RMS of pitch and roll
  double vibration_height_m = 0.001;   ///< [1e-6, 0.05] RMS

  // How well the camera is known, 1 sigma each; a calibration that states its own sigmas brings them
  double focal_share = 0.003;       ///< [1e-7, 0.1] of the focal length
  double mount_tilt_rad = 0.006;    ///< [1e-6, 0.2] of the mount's pitch and roll, before driving has shown them
  double mount_yaw_rad = 0.003;     ///< [1e-6, 0.1] of the mount's heading
  double mount_position_m = 0.003;  ///< [1e-6, 0.1] of the mount ahead and aside, each

  // Agreement
  double wheels_share = 0.35;   ///< [1e-6, 2] how far vision may leave wheels or command: share of the motion
  double wheels_m = 0.06;       ///< [1e-6, 1] plus this
  double wheels_rad = 0.06;     ///< [1e-6, 1] plus this
  double command_factor = 3.0;  ///< [1, 20] looser by this where only the command is known

  DeadReckoningConfig blind;  ///< when vision is blind

  // Content
  int features = 300;            ///< [50, 300] kept of a view
  int fewest_features = 30;      ///< [12, 300] fewer is too_blank
  double reach_heights = 1.2;    ///< [0.3, 3] ceiling used, to each side of the robot, in heights above the camera
  double px_per_height = 300.0;  ///< [50, 1000] of the rectified ceiling: pixels over the height above the floor

  // Relating two contents
  double gate_m = 0.25;                ///< [0.02, 2] how far a guess may be off, at least
  double gate_rad = 0.18;              ///< [0.02, 1.5]
  double widest_gate_m = 1.0;          ///< [0.02, 5] whatever the guess's covariance says
  int most_bits = 80;                  ///< [10, 128] of 256 that may differ between descriptors of one point
  double ratio = 0.95;                 ///< [1e-6, 1] best against second best, guided
  double ratio_unguided = 0.90;        ///< [1e-6, 1]
  int fewest_matches = 16;             ///< [8, 1000]
  double consensus_px = 3.0;           ///< [0.1, 50] inlier distance before the attitude is known, rectified pixels
  int hypotheses = 600;                ///< [50, 20000] drawn
  int fewest_inliers = 14;             ///< [8, 1000] after refinement
  double fewest_inliers_share = 0.15;  ///< [0, 1] of the matches
  double least_spread = 0.3;           ///< [0, 1] without a guess: the inliers' area against the shared ceiling's
  double feature_sigma_px = 0.7;       ///< [0.05, 10] of a feature on the rectified ceiling
  double inlier_sigmas = 3.0;          ///< [1, 10]
  double kappa = 0.15;                 ///< [0, 1] overlap: the share of b's view seen in a
  double most_tilt_rad = 0.03;         ///< [1e-6, 0.3] between two contents; beyond it the relation is not_rigid
  double most_scale_sigmas = 4.0;      ///< [1, 10] two contents' heights against what is known of them
  double most_residual_px = 3.0;       ///< [0.1, 100] mean of the inliers'
  double most_repeated = 0.6;          ///< [0, 10] share of features that meet their like elsewhere, against here
};

/// Returns every setting that breaks its bound: name, value, bound. Empty when all is well.
std::vector<std::string> check(const CeilingConfig& config);

/// Reads the settings from a TOML table, key by key as they are named here; reports what is wrong into its document.
CeilingConfig read_ceiling_config(const config::Table& table);

/// Returns the settings with what a calibration states of itself in place of those that were not set.
CeilingConfig informed(CeilingConfig config, const CalibrationSigma& known);

}  // namespace weft::agents

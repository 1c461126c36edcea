#pragma once
#include <string>
#include <vector>

#include "agents/methods/dead_reckoning.hpp"
#include "core/camera/camera_file.hpp"
#include "core/config/config.hpp"

namespace weft::agents {

/// Holds the settings of the method `floor`. Symbols are those of Gadd & Newman, Table I. Each bound stands beside
/// its number; `check` enforces it.
struct FloorConfig {
  // Odometry
  int corners = 160;                  ///< [40, 1000] tracked from each keyframe
  int window_px = 13;                 ///< odd, [7, 31]: of the tracker
  int pyramid_levels = 2;             ///< [0, 5]
  int fewest_tracks = 20;             ///< [12, 500] consistent ones; fewer is blind
  double fewest_tracks_share = 0.35;  ///< [0, 1] of those that were found
  double homography_px = 1.5;         ///< [0.2, 10] inlier threshold
  double track_sigma_px = 0.15;       ///< [0.01, 2] noise of a track; larger residuals enlarge the covariance
  double grey_noise = 2.0;            ///< [0, 30] grey levels: of the camera's pixels, standard deviation
  double keyframe_m = 0.20;           ///< [0.01, 1] travelled until the next keyframe
  double keyframe_rad = 0.15;         ///< [0.01, 1] turned
  double keyframe_share = 0.5;        ///< [0.1, 0.95] of the keyframe's corners still tracked

  // Mount and its vibration
  double vibration_tilt_rad = 0.0009;  ///< [1e-6, 0.05] RMS of pitch and roll
  double vibration_height_m = 0.001;   ///< [1e-6, 0.05] RMS
  double load_m = 0.0025;              ///< [1e-6, 0.1] 1 sigma of how far load lowers or raises a camera

  // How well the camera is known, 1 sigma each (docs/decisions/060-what-a-calibration-leaves.md); a calibration that
  // states its own sigmas brings them
  double focal_share = 0.003;         ///< [1e-7, 0.1] of the focal length
  double centre_px = 1.0;             ///< [1e-7, 50] of the optical centre, across and down each
  double distortion_px = 0.5;         ///< [1e-7, 50] of where the lens puts a ray that ends in the image's corner
  double mount_tilt_rad = 0.006;      ///< [1e-6, 0.1] of the mount's pitch and roll, before driving has shown them
  double mount_yaw_rad = 0.003;       ///< [1e-6, 0.1] of the mount's heading
  double mount_position_m = 0.0018;   ///< [1e-6, 0.1] of the mount ahead and aside, each
  double mount_height_m = 0.0018;     ///< [1e-6, 0.1] of the mount
  double measured_scale = 0.0;        ///< [0, 0.1] of distances driven straight on; 0: nobody has measured one
  double measured_heading_rad = 0.0;  ///< [0, 0.1] of the direction of driving straight on; 0: likewise

  // Decomposition and agreement
  double normal_angle_rad = 0.35;        ///< [1e-6, 1.2] alpha_R, against the mount's normal
  double along_normal_heights = 0.10;    ///< [1e-6, 1] alpha_t
  double decompose_from_heights = 0.10;  ///< [0, 1] shorter motions say too little about the normal
  double wheels_share = 0.35;   ///< [1e-6, 2] how far vision may leave wheels or command: share of the motion
  double wheels_m = 0.04;       ///< [1e-6, 1] plus this
  double wheels_rad = 0.06;     ///< [1e-6, 1] plus this
  double command_factor = 3.0;  ///< [1, 20] looser by this where only the command is known

  DeadReckoningConfig blind;  ///< when vision is blind

  // Content
  int features = 600;                     ///< [100, 2000] kept of a view
  int fewest_features = 80;               ///< [30, 1000] fewer is too_blank
  double far_m = 1.5;                     ///< [0.5, 4] floor used, ahead
  double half_width_m = 0.9;              ///< [0.2, 3] floor used, to each side
  double metres_per_pixel = 0.003;        ///< [0.001, 0.02] of the rectified floor
  double patch_metres_per_pixel = 0.018;  ///< [0.005, 0.1], >= metres_per_pixel

  // Relating two contents
  double gate_m = 0.15;                ///< [0.02, 1] how far a guess may be off, at least
  double gate_rad = 0.18;              ///< [0.02, 1.5]
  double widest_gate_m = 0.60;         ///< [0.02, 2] whatever the guess's covariance says
  int most_bits = 80;                  ///< [10, 128] of 256 between descriptors of one point
  double ratio = 0.95;                 ///< [1e-6, 1] best against second best, guided
  double ratio_unguided = 0.90;        ///< [1e-6, 1]
  int fewest_matches = 24;             ///< [8, 1000]
  double consensus_m = 0.022;          ///< [1e-6, 0.2] inlier distance before the attitude is known
  int hypotheses = 600;                ///< [50, 20000] drawn
  int fewest_inliers = 20;             ///< psi: [12, 1000] after refinement
  double fewest_inliers_share = 0.12;  ///< psi as a share of the matches, [0, 1]
  double least_spread = 0.4;           ///< [0, 1] without a guess: the inliers' area against the shared floor's
  double feature_sigma_m = 0.0015;     ///< [1e-6, 0.05] of a feature on the floor
  double inlier_sigmas = 3.0;          ///< [1, 10]
  double kappa = 0.15;                 ///< [0, 1] overlap: the share of b's view seen in a
  double most_tilt_rad = 0.03;         ///< [1e-6, 0.2] between two contents; beyond it the relation is not_rigid
  double most_height_offset_m = 0.03;  ///< [1e-6, 0.2]
  double eta_px = 100.0;               ///< [0.1, 1000] Huber threshold of h_distance
  double most_residual = 16.0;         ///< [1e-6, 1e4] h_distance
  double most_repeated = 0.7;          ///< [0, 10] features that meet their like elsewhere, against the inliers
};

/// Returns every setting that breaks its bound: name, value, bound. Empty when all is well.
std::vector<std::string> check(const FloorConfig& config);

/// Reads the settings from a TOML table, key by key as they are named here; reports what is wrong into its document.
FloorConfig read_floor_config(const config::Table& table);

/// Returns the settings with what a calibration states of itself in place of those that were not set; its yaw_rad and
/// scale_share are of what is seen while driving (measured_heading_rad, measured_scale).
FloorConfig informed(FloorConfig config, const CalibrationSigma& known);

}  // namespace weft::agents

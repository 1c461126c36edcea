#pragma once
#include <vector>

#include "agents/perception/clouds/cloud_window.hpp"
#include "clients/evaluate/registration/scene.hpp"

namespace weft::evaluate::registration {

/// Describes a stereo pair that looks ahead, and how its disparities are off. No image is matched here: this is for
/// the registration alone, whose input has the errors that matching was measured to have.
struct StereoRig {
  double focal_px = 312.0;
  double baseline_m = 0.12;
  int width_px = 480;
  int height_px = 360;
  int every_px = 3;             ///< of the rays, each way
  double height_m = 0.6;        ///< above the floor
  double range_m = 5.0;         ///< farther depths are not used
  double ceiling_m = 2.2;       ///< points above are not kept
  double pixel_sigma_px = 0.2;  ///< of each disparity
  double patch_sigma_px = 0.2;  ///< what neighbours have in common, over 16 pixels
  double bias_sigma_px = 0.05;  ///< what all of a rig's have in common
  double wild_share = 0.03;     ///< are off by up to 6 pixels

  agents::DepthNoise noise() const;
};

/// Holds what a place keeps, and where it truly is.
struct MadePlace {
  agents::PlaceCloud cloud;
  Pose3 world_from_place;
};

/// Drives straight on from `start` and returns a place every `spacing_m`, the first when the window is full. Frames
/// are joined by visual odometry, whose steps are off by 1 mm and 0.05 degrees.
std::vector<MadePlace> run_through(const Scene& scene, const Pose2& start, double length_m, double spacing_m,
                                   const StereoRig& rig, Random& random);

}  // namespace weft::evaluate::registration

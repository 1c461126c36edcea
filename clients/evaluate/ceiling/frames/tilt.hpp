#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "agents/perception/camera_model.hpp"
#include "agents/perception/view.hpp"

namespace weft::evaluate::ceiling {

/// Holds corners of one ceiling in two views of one camera, undistorted and normalised, in the same order.
struct SeenTwice {
  std::vector<Eigen::Vector2d> in_a;
  std::vector<Eigen::Vector2d> in_b;
};

/// Follows corners from view to view; pairs are of views between which they have moved by `apart_rad` in the median.
/// Few where nothing moves.
std::vector<SeenTwice> seen_twice(const agents::CameraModel& camera, const std::vector<agents::Image>& frames,
                                  double apart_rad = 0.25);

/// States how a camera leans against its mount as it is given, as MountTilt has it.
struct FoundTilt {
  double pitch_rad = 0.0;
  double roll_rad = 0.0;
  /// States what is left in the mean of all corners, pixels, none counted for more than `kMostLeftPx`.
  double left_px = 0.0;
};
inline constexpr double kMostLeftPx = 4.0;

/// Returns the mean of what one rigid motion each leaves of the pairs when the camera leans so: as little as noise
/// where that is right, because only then all that is seen slides over one level plane (Gadd & Newman, eq. 2: the
/// normal is seen in the perspective of a motion). Pixels.
double left_px(const agents::CameraModel& camera, const std::vector<SeenTwice>& pairs, double away_m);

/// Finds the tilt within 40 degrees of the given mount from what was seen alone; none of fewer than three pairs.
std::optional<FoundTilt> find_tilt(const agents::CameraModel& camera, const std::vector<SeenTwice>& pairs,
                                   double away_m);

/// Returns the sum of the ways between the views of each pair, each as the first view's robot has it: metres.
Eigen::Vector2d travelled(const agents::CameraModel& camera, const std::vector<SeenTwice>& pairs, double away_m);

}  // namespace weft::evaluate::ceiling
